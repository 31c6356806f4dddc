#include "canvoy/profiles/model/device_values.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "canvoy/profiles/cia301.hpp"
#include "canvoy/profiles/model/layout.hpp"
#include "canvoy/profiles/testing/device_memory.hpp"

namespace canvoy::device_values_test {
namespace {

constexpr ObjectInfo brightness_object = {
    .index = 0x6100,
    .name = "brightness",
    .entry = {.type = DataType::unsigned8, .access = Access::rw, .value = {.unit = Unit::percent}}};
constexpr EntryInfo colour_entries[] = {cia301::highest_sub_index,
                                        {.sub_first = 1, .name = "red", .access = Access::rw},
                                        {.sub_first = 2, .name = "green", .access = Access::rw},
                                        {.sub_first = 3, .name = "blue", .access = Access::rw}};
constexpr ObjectInfo colour_object = {
    .index = 0x6101, .code = ObjectCode::record, .name = "colour", .subs = colour_entries};
/// At the same index, of another profile.
constexpr ObjectInfo other_object = {.index = 0x6100, .name = "speed", .entry = {}};

constexpr Quantity<brightness_object> brightness;
constexpr Number<colour_object, "red"> red;
constexpr Number<colour_object, "green"> green;
constexpr Number<colour_object, "blue"> blue;
constexpr Number<other_object> speed;

constexpr auto description = describe(brightness_object, Part(colour_object).up_to(2));
constexpr auto layout = lay_out_device<description>();

struct Memory {
  DeviceMemory memory{layout.tables()};
  Dictionary& dictionary() { return memory.dictionary; }
};
struct Lamp : DeviceValues<Lamp, layout> {
  Memory& node() { return memory; }
  AbortCode write(std::uint16_t index, std::uint8_t sub, std::uint8_t value) {
    const std::uint8_t bytes[] = {value};
    return memory.dictionary().write(index, sub, bytes, Source::sdo);
  }
  Memory memory;
};

TEST(DeviceValues, AreReadAndWrittenByHandle) {
  Lamp lamp;
  lamp[brightness] = 80;
  EXPECT_EQ(lamp.memory.dictionary().number(0x6100, 0), 80U);
  EXPECT_EQ(lamp.write(0x6101, 2, 7), AbortCode::none);
  EXPECT_EQ(lamp[green].value(), 7);
}

TEST(DeviceValues, AreToldOfWhenTheBusWritesThem) {
  Lamp lamp;
  std::vector<double> told;
  {
    const auto watch =
        lamp.on(brightness, [&told](auto value) { told.push_back(value.value().value_or(-1)); });
    lamp[brightness] = 5;
    EXPECT_TRUE(told.empty()) << "the device's own writes are its own business";
    EXPECT_EQ(lamp.write(0x6100, 0, 30), AbortCode::none);
    EXPECT_EQ(told, std::vector<double>{30});
    EXPECT_EQ(lamp.write(0x6101, 1, 1), AbortCode::none);
  }
  EXPECT_EQ(lamp.write(0x6100, 0, 40), AbortCode::none);
  EXPECT_EQ(told, std::vector<double>{30}) << "nobody listens any more";
}

TEST(DeviceValues, AreToldOfByTheirSubIndex) {
  Lamp lamp;
  unsigned reds = 0;
  const auto watch = lamp.on(red, [&reds](const auto&) { ++reds; });
  EXPECT_EQ(lamp.write(0x6101, 2, 1), AbortCode::none);
  EXPECT_EQ(reds, 0U);
  EXPECT_EQ(lamp.write(0x6101, 1, 1), AbortCode::none);
  EXPECT_EQ(reds, 1U);
}

TEST(DeviceValues, AreThoseOfTheDescription) {
  using detail::presence;
  using detail::Presence;
  const auto presence_of = [](auto handle) {
    using Place = typename decltype(handle)::Place;
    return presence(description, Place::object, Place::entry);
  };
  EXPECT_EQ(presence_of(brightness), Presence::there);
  EXPECT_EQ(presence_of(green), Presence::there);
  EXPECT_EQ(presence_of(blue), Presence::no_entry) << "the device has two colours";
  EXPECT_EQ(presence_of(speed), Presence::no_object) << "another object has this index";
}

}  // namespace
}  // namespace canvoy::device_values_test
