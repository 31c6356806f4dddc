#include "canvoy/canopen/remote/identity.hpp"

#include <gtest/gtest.h>

#include "canvoy/canopen/dictionary/dictionary_layout.hpp"
#include "canvoy/canopen/sdo/sdo_server.hpp"
#include "canvoy/canopen/testing/wire.hpp"

namespace canvoy::identity_test {
namespace {

constexpr EntryRow name(std::string_view initial) {
  return {.type = DataType::visible_string,
          .access = Access::const_,
          .capacity = 4,
          .initial_text = initial};
}
constexpr auto layout =
    lay_out(std::to_array<ObjectRow>({{.index = 0x1008, .entry_count = 1},
                                      {.index = 0x1009, .entry_count = 1},
                                      {.index = 0x100A, .entry_count = 1},
                                      {.index = 0x1018, .entry_count = 3}}),
            std::to_array<EntryRow>(
                {name("abcd"),
                 name("1.0"),
                 name("2.0"),
                 {.access = Access::const_, .initial = 4},
                 {.sub_first = 1, .sub_last = 1, .type = DataType::unsigned32, .initial = 0x123},
                 {.sub_first = 2, .sub_last = 4, .type = DataType::unsigned32, .initial = 7}}));
constexpr auto layout_without =
    lay_out(std::to_array<ObjectRow>({{.index = 0x1000, .entry_count = 1}}),
            std::to_array<EntryRow>({{.type = DataType::unsigned32}}));

struct NamedNode : WireNode {
  explicit NamedNode(const IdentityValues& given, const DictionaryTables& tables = layout.tables())
      : WireNode(tables, 5), server(node, 0, buffer), sut(node, given) {
    boot();
  }
  /// Reads an entry by SDO.
  std::string read(const char* request) {
    receive(request);
    const std::string answer = sent.empty() ? "" : wire_text(sent.back().frame);
    sent.clear();
    return answer;
  }
  std::uint8_t buffer[16] = {};
  SdoServer server;
  Identity sut;
};

TEST(Identity, IsThatOfTheDescriptionWhereTheApplicationGivesNone) {
  NamedNode node({});
  EXPECT_EQ(node.read("605#40 18 10 01 00 00 00 00"), "585#43 18 10 01 23 01 00 00");
  EXPECT_EQ(node.read("605#40 18 10 04 00 00 00 00"), "585#43 18 10 04 07 00 00 00");
  EXPECT_EQ(node.read("605#40 08 10 00 00 00 00 00"), "585#43 08 10 00 61 62 63 64");
}

TEST(Identity, OfOneDeviceIsWhatTheApplicationGives) {
  NamedNode node({.vendor_id = 0x11223344,
                  .product_code = 0,
                  .revision = 0x00010002,
                  .serial_number = 0xFFFFFFFF,
                  .device_name = "x",
                  .hardware_version = "C2",
                  .software_version = "3.14"});
  EXPECT_EQ(node.read("605#40 18 10 01 00 00 00 00"), "585#43 18 10 01 44 33 22 11");
  EXPECT_EQ(node.read("605#40 18 10 02 00 00 00 00"), "585#43 18 10 02 00 00 00 00");
  EXPECT_EQ(node.read("605#40 18 10 03 00 00 00 00"), "585#43 18 10 03 02 00 01 00");
  EXPECT_EQ(node.read("605#40 18 10 04 00 00 00 00"), "585#43 18 10 04 FF FF FF FF");
  EXPECT_EQ(node.read("605#40 08 10 00 00 00 00 00"), "585#4F 08 10 00 78 00 00 00");
  EXPECT_EQ(node.read("605#40 09 10 00 00 00 00 00"), "585#4B 09 10 00 43 32 00 00");
  EXPECT_EQ(node.read("605#40 0A 10 00 00 00 00 00"), "585#43 0A 10 00 33 2E 31 34");
}

TEST(Identity, StaysThroughResets) {
  for (const char* reset : {"000#81 05", "000#82 05"}) {
    NamedNode node({.serial_number = 0x55});
    node.receive(reset);
    EXPECT_EQ(node.read("605#40 18 10 04 00 00 00 00"), "585#43 18 10 04 55 00 00 00");
    EXPECT_EQ(node.read("605#40 18 10 03 00 00 00 00"), "585#43 18 10 03 07 00 00 00");
  }
}

TEST(Identity, CannotBeWrittenBySdo) {
  NamedNode node({.serial_number = 0x55});
  EXPECT_EQ(node.read("605#23 18 10 04 01 00 00 00"), "585#80 18 10 04 02 00 01 06");
  EXPECT_EQ(node.read("605#23 08 10 00 01 00 00 00"), "585#80 08 10 00 02 00 01 06");
}

TEST(Identity, CutsANameToTheRoomOfItsEntry) {
  NamedNode node({.device_name = "too long"});
  EXPECT_EQ(node.read("605#40 08 10 00 00 00 00 00"), "585#43 08 10 00 74 6F 6F 20");
}

TEST(Identity, DoesWithoutObjectsThatTheDeviceLacks) {
  NamedNode node({.serial_number = 1, .device_name = "x"}, layout_without.tables());
  EXPECT_EQ(node.read("605#40 18 10 04 00 00 00 00"), "585#80 18 10 04 00 00 02 06");
}

}  // namespace
}  // namespace canvoy::identity_test
