// The services of a device depend on the contents of its dictionary.
#include "canvoy/canopen/device/device_node.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "canvoy/canopen/testing/wire.hpp"

namespace canvoy::device_node_test {
namespace {

constexpr ObjectRow variable(std::uint16_t index) {
  return {.index = index, .entry_count = 1};
}
constexpr EntryRow number(DataType type, std::int64_t initial = 0) {
  return {.type = type, .access = Access::rw, .initial = initial};
}

constexpr auto plain_layout = partial(
    lay_out(std::to_array<ObjectRow>({variable(0x1000), variable(0x1001)}),
            std::to_array<EntryRow>({number(DataType::unsigned32), number(DataType::unsigned8)})));

// 1012h: a consumer; 1028h: receives node 2 of the nodes 1 to 3.
constexpr auto layout =
    partial(lay_out(std::to_array<ObjectRow>({variable(0x1000),
                                              variable(0x1001),
                                              variable(0x100C),
                                              variable(0x100D),
                                              variable(0x1012),
                                              {.index = 0x1028, .entry_count = 4}}),
                    std::to_array<EntryRow>({number(DataType::unsigned32),
                                             number(DataType::unsigned8),
                                             number(DataType::unsigned16, 100),
                                             number(DataType::unsigned8, 2),
                                             number(DataType::unsigned32, 0x8000'0100),
                                             {.access = Access::const_, .initial = 3},
                                             {.sub_first = 1,
                                              .sub_last = 1,
                                              .type = DataType::unsigned32,
                                              .access = Access::rw,
                                              .initial = 0x8000'0000},
                                             {.sub_first = 2,
                                              .sub_last = 2,
                                              .type = DataType::unsigned32,
                                              .access = Access::rw,
                                              .initial = 0x82},
                                             {.sub_first = 3,
                                              .sub_last = 3,
                                              .type = DataType::unsigned32,
                                              .access = Access::rw,
                                              .initial = 0x8000'0000}})));

template <class Device>
concept HasTime = requires(Device device) { device.time_stamp(); };
template <class Device>
concept HasGuarding = requires(Device device) { device.node_guarding(); };
template <class Device>
concept HasEmergencyConsumer = requires(Device device) { device.emergency_consumer(); };

TEST(DeviceNode, HasTheServicesThatItsDictionaryAsksForAndNoOthers) {
  using Plain = DeviceNode<plain_layout>;
  using Full = DeviceNode<layout>;
  EXPECT_TRUE(HasTime<Full> && HasGuarding<Full> && HasEmergencyConsumer<Full>);
  EXPECT_FALSE(HasTime<Plain> || HasGuarding<Plain> || HasEmergencyConsumer<Plain>);
}

/// A device of which the test is the bus.
template <const auto& tables>
struct Bench {
  static bool take(void* context, const Frame& frame) {
    static_cast<Bench*>(context)->sent.push_back(wire_text(frame));
    return true;
  }
  void receive(std::string_view frame) { device.node().receive(wire_frame(frame), Time{}); }
  std::vector<std::string> take_sent() { return std::exchange(sent, {}); }

  std::vector<std::string> sent;
  DeviceNode<tables> device{{this, &Bench::take, nullptr}, 5};
};

TEST(DeviceNode, ServesTimeGuardingAndEmergenciesOfOthers) {
  Bench<layout> bench;
  bench.device.node().start(Time{});
  EXPECT_EQ(bench.take_sent(), std::vector<std::string>({"705#00"}));
  unsigned code = 0;
  auto heard = [&](NodeId node_id, const Emergency& emergency) {
    code = emergency.code + node_id * 0x10000U;
  };
  bench.device.emergency_consumer().on_emergency(
      Callback<void(NodeId, const Emergency&)>::of(heard));
  bench.receive("082#30 81 11 00 00 00 00 00");
  EXPECT_EQ(code, 0x2'8130U);
  bench.receive("100#00 2E 93 02 31 3D");
  EXPECT_EQ(bench.device.time_stamp().clock(Time{}),
            (TimeOfDay{.milliseconds = 43'200'000, .days = 15665}));
  bench.receive("705#R1");
  EXPECT_EQ(bench.take_sent(), std::vector<std::string>({"705#7F"}));
  bench.device.node().advance(Time(200ms));
  EXPECT_TRUE(bench.device.node_guarding().is_master_lost());
  EXPECT_EQ(bench.device.dictionary().number(0x1001, 0), 0x11U);
}

TEST(DeviceNode, HasARouteForEachServiceAndAllThat1028hMayName) {
  Bench<layout> bench;
  bench.device.node().start(Time{});
  bench.receive("605#23 28 10 01 81 00 00 00");
  bench.receive("605#23 28 10 03 83 00 00 00");
  EXPECT_EQ(bench.take_sent(), std::vector<std::string>({"705#00", "585#60 28 10 01 00 00 00 00",
                                                         "585#60 28 10 03 00 00 00 00"}));
  EXPECT_TRUE(bench.device.node().router().add(0x123, {})) << "that of SYNC is left";
}

// A multiplexed RPDO in destination address mode, one TPDO in source address mode with a list.
constexpr auto mpdo_layout = partial(lay_out(
    std::to_array<ObjectRow>({{.index = 0x1400, .entry_count = 1},
                              {.index = 0x1600, .entry_count = 2},
                              {.index = 0x1800, .entry_count = 1},
                              {.index = 0x1A00, .entry_count = 2},
                              {.index = 0x1FA0, .entry_count = 2},
                              {.index = 0x2000, .entry_count = 1}}),
    std::to_array<EntryRow>({
        {.sub_first = 1, .sub_last = 1, .type = DataType::unsigned32, .initial = 0x205},
        number(DataType::unsigned8, 0xFF),
        {.sub_first = 1, .sub_last = 1, .type = DataType::unsigned32, .access = Access::rw},
        {.sub_first = 1, .sub_last = 1, .type = DataType::unsigned32, .initial = 0x185},
        number(DataType::unsigned8, 0xFE),
        {.sub_first = 1, .sub_last = 1, .type = DataType::unsigned32, .access = Access::rw},
        number(DataType::unsigned8, 1),
        {.sub_first = 1, .sub_last = 1, .type = DataType::unsigned32, .initial = 0x02'2000'01},
        {.sub_first = 1,
         .sub_last = 2,
         .type = DataType::unsigned16,
         .access = Access::rw | Access::rpdo | Access::tpdo},
    })));

TEST(DeviceNode, HasMultiplexedPdosWhereItsDictionaryHasThem) {
  static_assert(DeviceNode<mpdo_layout>::has_mpdo_consumer);
  static_assert(DeviceNode<mpdo_layout>::has_mpdo_producer);
  static_assert(!DeviceNode<layout>::has_mpdo_consumer);
  static_assert(!DeviceNode<layout>::has_mpdo_producer);
  Bench<mpdo_layout> bench;
  bench.device.node().start(Time{});
  bench.receive("000#01 00");
  EXPECT_EQ(bench.take_sent(), std::vector<std::string>({"705#00", "185#05 00 20 01 00 00 00 00",
                                                         "185#05 00 20 02 00 00 00 00"}));
  bench.receive("205#85 00 20 02 34 12 00 00");
  EXPECT_EQ(bench.take_sent(), std::vector<std::string>({"185#05 00 20 02 34 12 00 00"}));
}

// The 4th RPDO and the 3rd TPDO, and none below them.
constexpr auto gaps_layout = partial(lay_out(
    std::to_array<ObjectRow>({{.index = 0x1403, .entry_count = 2},
                              {.index = 0x1603, .entry_count = 2},
                              {.index = 0x1802, .entry_count = 2},
                              {.index = 0x1A02, .entry_count = 2},
                              {.index = 0x2000, .entry_count = 1}}),
    std::to_array<EntryRow>({
        {.sub_first = 1, .sub_last = 1, .type = DataType::unsigned32, .initial = 0x205},
        {.sub_first = 2, .sub_last = 2, .initial = 255},
        number(DataType::unsigned8, 1),
        {.sub_first = 1, .sub_last = 1, .type = DataType::unsigned32, .initial = 0x2000'00'08},
        {.sub_first = 1, .sub_last = 1, .type = DataType::unsigned32, .initial = 0x185},
        {.sub_first = 2, .sub_last = 2, .initial = 255},
        number(DataType::unsigned8, 1),
        {.sub_first = 1, .sub_last = 1, .type = DataType::unsigned32, .initial = 0x2000'00'08},
        {.access = Access::rw | Access::rpdo | Access::tpdo},
    })));

TEST(DeviceNode, MayHavePdosWithGapsInTheirNumbers) {
  Bench<gaps_layout> bench;
  bench.device.node().start(Time{});
  bench.receive("000#01 00");
  EXPECT_EQ(bench.take_sent(), std::vector<std::string>({"705#00", "185#00"}));
  bench.receive("205#2A");
  EXPECT_EQ(bench.device.dictionary().number(0x2000, 0), 0x2AU);
}

// RPDOs 300 and 302, and TPDO 512, the last possible one.
constexpr auto high_layout = partial(lay_out(
    std::to_array<ObjectRow>({{.index = 0x152B, .entry_count = 2},
                              {.index = 0x152D, .entry_count = 2},
                              {.index = 0x172B, .entry_count = 2},
                              {.index = 0x172D, .entry_count = 2},
                              {.index = 0x19FF, .entry_count = 2},
                              {.index = 0x1BFF, .entry_count = 2},
                              {.index = 0x2000, .entry_count = 1},
                              {.index = 0x2001, .entry_count = 1}}),
    std::to_array<EntryRow>({
        {.sub_first = 1,
         .sub_last = 1,
         .type = DataType::unsigned32,
         .access = Access::rw,
         .initial = 0x205},
        {.sub_first = 2, .sub_last = 2, .initial = 255},
        {.sub_first = 1,
         .sub_last = 1,
         .type = DataType::unsigned32,
         .access = Access::rw,
         .initial = 0x206},
        {.sub_first = 2, .sub_last = 2, .initial = 255},
        number(DataType::unsigned8, 1),
        {.sub_first = 1, .sub_last = 1, .type = DataType::unsigned32, .initial = 0x2000'00'08},
        number(DataType::unsigned8, 1),
        {.sub_first = 1, .sub_last = 1, .type = DataType::unsigned32, .initial = 0x2001'00'08},
        {.sub_first = 1,
         .sub_last = 1,
         .type = DataType::unsigned32,
         .access = Access::rw,
         .initial = 0x185},
        {.sub_first = 2, .sub_last = 2, .initial = 255},
        number(DataType::unsigned8, 1),
        {.sub_first = 1, .sub_last = 1, .type = DataType::unsigned32, .initial = 0x2000'00'08},
        {.access = Access::rw | Access::rpdo | Access::tpdo},
        {.access = Access::rw | Access::rpdo | Access::tpdo},
    })));

TEST(DeviceNode, HasRoomForPdosFromItsLowestToItsHighestNumberAlone) {
  static_assert(DeviceNode<high_layout>::rpdo_count == 3, "300, 302, and what is between them");
  static_assert(DeviceNode<high_layout>::tpdo_count == 1);
  static_assert(DeviceNode<plain_layout>::rpdo_count == 0);
  Bench<high_layout> bench;
  std::vector<unsigned> numbers;
  auto happened = [&](std::uint16_t number) { numbers.push_back(number); };
  bench.device.rpdos().received = Callback<void(std::uint16_t)>::of(happened);
  bench.device.tpdos().before_transmit = Callback<void(std::uint16_t)>::of(happened);
  bench.device.node().start(Time{});
  bench.receive("000#01 00");
  EXPECT_EQ(bench.take_sent(), std::vector<std::string>({"705#00", "185#00"}));
  bench.receive("206#2B");
  EXPECT_EQ(bench.device.dictionary().number(0x2001, 0), 0x2BU);
  bench.receive("205#2A");
  EXPECT_EQ(bench.device.dictionary().number(0x2000, 0), 0x2AU);
  bench.device.node().advance(Time{});
  EXPECT_EQ(bench.take_sent(), std::vector<std::string>({"185#2A"}));
  EXPECT_EQ(numbers, std::vector<unsigned>({512, 302, 300, 512}));
  for (const auto number : std::to_array<std::uint16_t>({0, 1, 299, 303, 512})) {
    EXPECT_FALSE(bench.device.rpdos().has(number)) << number;
    EXPECT_FALSE(bench.device.rpdos().request(number)) << number;
    EXPECT_EQ(bench.device.tpdos().trigger(number), number == 512) << number;
  }
}

TEST(DeviceNode, TakesTheParametersOfPdosWithHighNumbers) {
  Bench<high_layout> bench;
  bench.device.node().start(Time{});
  bench.receive("000#01 00");
  bench.take_sent();
  bench.receive("605#23 2D 15 01 06 02 00 80");
  bench.receive("206#2B");
  EXPECT_EQ(bench.device.dictionary().number(0x2001, 0), 0U) << "it is off";
  bench.receive("605#23 2D 15 01 16 02 00 00");
  bench.receive("216#2C");
  EXPECT_EQ(bench.device.dictionary().number(0x2001, 0), 0x2CU);
  EXPECT_EQ(bench.take_sent(), std::vector<std::string>(
                                   {"585#60 2D 15 01 00 00 00 00", "585#60 2D 15 01 00 00 00 00"}));
  bench.receive("605#23 FF 19 01 86 01 00 80");
  EXPECT_EQ(bench.take_sent(), std::vector<std::string>({"585#60 FF 19 01 00 00 00 00"}));
  bench.receive("605#23 FF 19 01 86 01 00 00");
  bench.device.node().advance(Time{});
  EXPECT_EQ(bench.take_sent(), std::vector<std::string>({"186#00", "585#60 FF 19 01 00 00 00 00"}))
      << "it begins with what it carries";
}

}  // namespace
}  // namespace canvoy::device_node_test
