// Objects that an SDO client creates and destroys by 6020h (CiA 417-4, 4.2.6), frame by frame.
#include "canvoy/devices/cia417/kit/object_creation.hpp"

#include <gtest/gtest.h>

#include "canvoy/canopen/device/device_node.hpp"
#include "canvoy/canopen/testing/cable.hpp"
#include "canvoy/devices/cia417/panel/panel_description.hpp"
#include "canvoy/profiles/model/layout.hpp"

namespace canvoy::cia417::object_creation_test {
namespace {

/// Room for parameters of four groups with eight inputs each, and groups that are always there.
constexpr auto creating_device() {
  DeviceDescription<64> parts;
  parts.add(panel<PanelOptions{.inputs = 8, .parameters = false}>());
  parts.add(object_creation_object);
  parts.add(Part(input_parameter_1_object).only(0, 4).up_to(8));
  parts.add(cia301::identity({}));
  parts.add(cia301::heartbeat_producer(0));
  return parts;
}
constexpr auto device_parts = creating_device();
constexpr auto device_layout = lay_out_device<device_parts>();

constexpr CreatableObjects creatable[] = {
    {.first = 0x6120, .last = 0x6123, .highest_sub = 8, .specified = Access::rw}};

class ObjectCreationTest : public testing::Test {
 protected:
  ObjectCreationTest() {
    cable.connect(0, device.node());
    cable.start_all();
  }
  std::string ask(std::string_view request) {
    cable.clear();
    cable.send("605#" + std::string(request));
    return cable.last(0x585);
  }
  /// Writes index, sub-index, access and action; answers the abort code, or "".
  std::string request(unsigned index, unsigned sub, unsigned access, unsigned action) {
    char text[40];
    std::snprintf(text, sizeof text, "23 20 60 00 %02X %02X %02X %02X", access << 6 | action, sub,
                  index & 0xFF, index >> 8);
    const std::string answer = ask(text);
    return answer.starts_with("585#60") ? "" : answer.substr(16);
  }
  std::string create(unsigned index, unsigned sub, unsigned access = 0) {
    return request(index, sub, access, 1);
  }
  std::string destroy(unsigned index, unsigned sub) { return request(index, sub, 0, 2); }

  static constexpr const char* read_first = "40 20 61 01 00 00 00 00";
  static constexpr const char* write_first = "23 20 61 01 12 34 56 78";

  Cable cable;
  DeviceNode<device_layout> device{cable.port(0), 5};
  std::array<CreatedObject, 3> memory{};
  ObjectCreation sut{device.node(), creatable, memory};
};

const std::string not_supported = "30 00 09 06";
const std::string no_resources = "05 00 04 05";
const std::string not_there = "00 00 02 06";

TEST_F(ObjectCreationTest, WhatIsNotCreatedIsNotThere) {
  EXPECT_EQ(ask(read_first), "585#80 20 61 01 00 00 02 06");
  EXPECT_EQ(ask(write_first), "585#80 20 61 01 00 00 02 06");
  EXPECT_EQ(ask("40 20 61 00 00 00 00 00"), "585#80 20 61 00 00 00 02 06");
  EXPECT_EQ(ask("40 00 61 00 00 00 00 00"), "585#4F 00 61 00 08 00 00 00") << "others are";
}

TEST_F(ObjectCreationTest, WhatIsCreatedWorksAsItsIndexSays) {
  EXPECT_EQ(create(0x6120, 1), "");
  EXPECT_EQ(ask(read_first), "585#43 20 61 01 FF FF FF FF");
  EXPECT_EQ(ask(write_first), "585#60 20 61 01 00 00 00 00");
  EXPECT_EQ(ask(read_first), "585#43 20 61 01 12 34 56 78");
  EXPECT_EQ(ask("40 20 61 02 00 00 00 00"), "585#80 20 61 02 11 00 09 06") << "another is not";
  EXPECT_EQ(ask("40 21 61 01 00 00 00 00"), "585#80 21 61 01 00 00 02 06");
}

TEST_F(ObjectCreationTest, SubIndex0TellsTheHighestThatIsThere) {
  EXPECT_EQ(create(0x6120, 7), "");
  EXPECT_EQ(create(0x6120, 3), "");
  EXPECT_EQ(ask("40 20 61 00 00 00 00 00"), "585#4F 20 61 00 07 00 00 00");
  EXPECT_EQ(destroy(0x6120, 7), "");
  EXPECT_EQ(ask("40 20 61 00 00 00 00 00"), "585#4F 20 61 00 03 00 00 00");
}

TEST_F(ObjectCreationTest, ReadingGivesTheLastOneThatWasCreated) {
  EXPECT_EQ(ask("40 20 60 00 00 00 00 00"), "585#43 20 60 00 00 00 00 00");
  EXPECT_EQ(create(0x6120, 1), "");
  EXPECT_EQ(create(0x6122, 8, 3), "");
  EXPECT_EQ(create(0x6155, 1), not_supported);
  EXPECT_EQ(destroy(0x6120, 1), "");
  EXPECT_EQ(ask("40 20 60 00 00 00 00 00"), "585#43 20 60 00 C1 08 22 61");
}

TEST_F(ObjectCreationTest, ADestroyedObjectIsGoneAndComesBackWithItsDefault) {
  EXPECT_EQ(create(0x6120, 1), "");
  ask(write_first);
  EXPECT_EQ(destroy(0x6120, 1), "");
  EXPECT_EQ(ask(read_first), "585#80 20 61 01 00 00 02 06");
  EXPECT_EQ(create(0x6120, 1), "");
  EXPECT_EQ(ask(read_first), "585#43 20 61 01 FF FF FF FF");
}

TEST_F(ObjectCreationTest, WhatTheDeviceDoesNotSupportIsRefused) {
  EXPECT_EQ(create(0x6100, 1), not_supported) << "it is there for good";
  EXPECT_EQ(destroy(0x6100, 1), not_supported);
  EXPECT_EQ(create(0x6124, 1), not_supported);
  EXPECT_EQ(create(0x611F, 1), not_supported);
  EXPECT_EQ(create(0x6120, 0), not_supported);
  EXPECT_EQ(create(0x6120, 9), not_supported);
  EXPECT_EQ(destroy(0x6120, 1), not_there);
}

TEST_F(ObjectCreationTest, WithoutRoomForAnotherOneItIsRefused) {
  for (unsigned sub = 1; sub <= 3; ++sub) EXPECT_EQ(create(0x6121, sub), "");
  EXPECT_EQ(create(0x6121, 4), no_resources);
  EXPECT_EQ(create(0x6121, 3), "") << "it is there already";
  EXPECT_EQ(destroy(0x6121, 2), "");
  EXPECT_EQ(create(0x6121, 4), "");
}

TEST_F(ObjectCreationTest, TheAccessIsTheOneThatWasAskedFor) {
  const struct {
    unsigned access;
    bool reads;
    bool writes;
  } rows[] = {{0, true, true}, {1, true, false}, {2, false, true}, {3, true, true}};
  for (const auto& row : rows) {
    EXPECT_EQ(create(0x6120, 1, row.access), "");
    const std::string read = ask(read_first);
    const std::string written = ask(write_first);
    EXPECT_EQ(read.substr(0, 6), row.reads ? "585#43" : "585#80") << row.access;
    EXPECT_EQ(written.substr(0, 6), row.writes ? "585#60" : "585#80") << row.access;
    EXPECT_EQ(read == "585#80 20 61 01 01 00 01 06", !row.reads) << "write only";
    EXPECT_EQ(written == "585#80 20 61 01 02 00 01 06", !row.writes) << "read only";
  }
}

TEST_F(ObjectCreationTest, OfTheLowestByteOnlyBits7And6And1And0Count) {
  for (unsigned byte = 0; byte <= 0xFF; ++byte) {
    char text[40];
    std::snprintf(text, sizeof text, "23 20 60 00 %02X 01 23 61", byte);
    const bool was_there = sut.is_created(0x6123, 1);
    const std::string answer = ask(text);
    const unsigned action = byte & 3;
    const bool expected = action == 1 || (action == 2 && was_there);
    EXPECT_EQ(answer.starts_with("585#60"), expected) << byte;
    EXPECT_EQ(sut.is_created(0x6123, 1), action == 1 || (was_there && action != 2)) << byte;
  }
}

TEST_F(ObjectCreationTest, AResetOfTheNodeDestroysAllAndOneOfTheCommunicationNone) {
  EXPECT_EQ(create(0x6120, 1), "");
  cable.send("000#82 05");
  EXPECT_TRUE(sut.is_created(0x6120, 1));
  cable.send("000#81 05");
  EXPECT_FALSE(sut.is_created(0x6120, 1));
  EXPECT_EQ(ask("40 20 60 00 00 00 00 00"), "585#43 20 60 00 00 00 00 00");
}

}  // namespace
}  // namespace canvoy::cia417::object_creation_test
