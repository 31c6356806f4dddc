// Virtual inputs by multiplexed PDOs at the wire: each record in two parts, in both modes, and a
// controller that combines them. The layout of the frames is that of CiA 301, 7.2.3.
#include "canvoy/devices/cia417/virtual_io/virtual_mpdo.hpp"

#include <gtest/gtest.h>

#include "canvoy/canopen/device/device_node.hpp"
#include "canvoy/canopen/testing/cable.hpp"
#include "canvoy/devices/cia417/panel/input_panel_device.hpp"
#include "canvoy/devices/cia417/panel/panel_description.hpp"

namespace canvoy::cia417::virtual_mpdo_test {
namespace {

constexpr VirtualInput buttons[] = {{.function = BasicFunction::standard_hall_call,
                                     .sub_function = hall_up,
                                     .lifts = lift_bit(1),
                                     .floor = 3,
                                     .doors = source_door(1)},
                                    {.function = BasicFunction::standard_hall_call,
                                     .sub_function = hall_down,
                                     .lifts = lift_bit(1),
                                     .floor = 3,
                                     .doors = source_door(1)}};

/// PDO 2 with 500h + node-ID is multiplexed, that of 6010h is not valid.
template <MpdoMode mode>
constexpr auto panel_parts() {
  DeviceDescription<64> parts;
  parts.add(panel<PanelOptions{.inputs = 2, .low_pdo_numbers = true, .valid_tpdo = false}>());
  parts.add(cia301::identity({}));
  parts.add(cia301::heartbeat_producer(0));
  parts.add(cia301::tpdo({.number = 2,
                          .entries = 1,
                          .cob_id = canvoy::plus_node_id(0x500),
                          .transmission_type = 254,
                          .multiplexed = mode}));
  parts.add(cia301::scanner_lists(1));
  parts.add(record_parts_object);
  return parts;
}
template <MpdoMode mode>
constexpr auto described = panel_parts<mode>();
template <MpdoMode mode>
constexpr auto panel_layout = lay_out_device<described<mode>>();

/// A call controller that receives node 22 by a multiplexed PDO.
template <MpdoMode mode>
constexpr auto controller_parts() {
  DeviceDescription<64> parts;
  parts.add(lift_device<VirtualDevice::call_controller>({0x6010, 0x6011}));
  parts.add(cia301::identity({}));
  parts.add(cia301::heartbeat_producer(0));
  parts.add(cia301::rpdo(
      {.number = 1, .entries = 1, .cob_id = 0x516, .transmission_type = 254, .multiplexed = mode}));
  parts.add(cia301::dispatching_lists(1));
  parts.add(received_parts_object);
  return parts;
}
template <MpdoMode mode>
constexpr auto described_controller = controller_parts<mode>();
template <MpdoMode mode>
constexpr auto controller_layout = lay_out_device<described_controller<mode>>();

/// Panel 22 (16h) and controller 1 on a cable.
template <MpdoMode mode>
class MpdoBench {
 public:
  MpdoBench() {
    cable.connect(0, panel.node());
    cable.connect(1, controller.node());
    controller.node().dictionary().attach(hook_);
    cable.start_all();
    write(panel.node(), 0x1FA0, 1, 0x02'5F10'01);
    write(controller.node(), 0x1FD0, 1, 0x02'5F11'2B'5F10'01'16);
  }
  void start() {
    cable.send("000#01 00");
    cable.run_for(1s);
    told();
    heard.clear();
  }
  void level(std::uint32_t input, bool high) {
    unit.set_level(input, high, cable.now);
    cable.run_for(0ms);
  }
  static void write(Node& node, std::uint16_t index, std::uint8_t sub, std::uint64_t number) {
    const Result<Entry> entry = node.dictionary().find(index, sub);
    ASSERT_TRUE(entry);
    std::array<std::uint8_t, 8> bytes;
    store(bytes.data(), number);
    const std::span<const std::uint8_t> value = std::span(bytes).first(entry->row->capacity);
    ASSERT_EQ(node.dictionary().write(*entry, value, Source::sdo), AbortCode::none);
  }

  /// Multiplexed PDOs since the last call.
  std::vector<std::string> told() {
    std::vector<std::string> frames;
    for (const Cable::Heard& each : cable.heard) {
      if (each.frame.id == 0x516) frames.push_back(wire_text(each.frame).substr(4));
    }
    cable.clear();
    return frames;
  }

  Cable cable;
  DeviceNode<panel_layout<mode>> panel{cable.port(0), 22};
  InputPanelArrays<panel_layout<mode>, 2> arrays;
  InputPanelUnit unit{panel.node(), panel.tpdos(), arrays.spans(), {.inputs = buttons}};
  VirtualMpdoProducer sut{
      panel.node(), panel.tpdos(), panel.mpdo_producer(), unit.mapping(), {.number = 2}};
  DeviceNode<controller_layout<mode>> controller{cable.port(1), 1};
  VirtualMpdoConsumer consumer{controller.node()};
  std::vector<std::uint64_t> heard;  ///< what came into 6010h of the controller

 private:
  void came(const Entry& entry, Source) {
    heard.push_back(controller.dictionary().number(entry.index, 0));
  }
  Hook hook_{.first = 0x6010, .last = 0x6010, .after_write = callback<&MpdoBench::came>(*this)};
};
using Frames = std::vector<std::string>;
using Heard = std::vector<std::uint64_t>;

TEST(VirtualMpdo, InDestinationAddressModeARecordGoesToTheSubIndicesOfItsPanel) {
  MpdoBench<MpdoMode::destination> bench;
  bench.start();
  bench.level(0, true);
  EXPECT_EQ(bench.told(), (Frames{"80 11 5F 2B 02 01 01 03", "80 11 5F 2C 10 01 01 11"}));
  EXPECT_EQ(bench.heard, (Heard{0x0110'0301'0102}));
  bench.level(0, false);
  EXPECT_EQ(bench.told(), (Frames{"80 11 5F 2B 02 01 01 03", "80 11 5F 2C 10 00 02 13"}));
  EXPECT_EQ(bench.heard, (Heard{0x0110'0301'0102, 0x0010'0301'0102}));
}

TEST(VirtualMpdo, InSourceAddressModeAPartThatIsTheSameIsNotSentAgain) {
  MpdoBench<MpdoMode::source> bench;
  bench.start();
  bench.level(0, true);
  EXPECT_EQ(bench.told(), (Frames{"16 10 5F 01 02 01 01 03", "16 10 5F 02 10 01 01 11"}));
  bench.level(0, false);
  EXPECT_EQ(bench.told(), (Frames{"16 10 5F 02 10 00 02 13"}));
  bench.level(1, true);
  EXPECT_EQ(bench.told(), (Frames{"16 10 5F 01 02 02 01 03", "16 10 5F 02 10 01 03 10"}));
  EXPECT_EQ(bench.heard, (Heard{0x0110'0301'0102, 0x0010'0301'0102, 0x0110'0301'0202}));
}

/// Six changes at once, beyond the queue of two, with an inhibit time of 10 ms.
template <MpdoMode mode>
void expect_that_none_is_lost() {
  MpdoBench<mode> bench;
  MpdoBench<mode>::write(bench.panel.node(), 0x1801, 1, 0x8000'0516);
  MpdoBench<mode>::write(bench.panel.node(), 0x1801, 3, 100);
  MpdoBench<mode>::write(bench.panel.node(), 0x1801, 1, 0x516);
  bench.start();
  for (unsigned change = 0; change < 6; ++change) {
    bench.unit.set_level(change % 2, change / 2 != 1, bench.cable.now);
  }
  bench.cable.run_for(1s);
  ASSERT_GE(bench.heard.size(), 4u);
  EXPECT_EQ(bench.heard[0], 0x0110'0301'0102u);
  EXPECT_EQ(bench.heard[1], 0x0110'0301'0202u);
  std::uint64_t last[2] = {};
  for (const std::uint64_t record : bench.heard) last[record >> 8 & 1 ? 0 : 1] = record;
  EXPECT_EQ(last[0] >> 40, 1u);
  EXPECT_EQ(last[1] >> 40, 1u);
  EXPECT_EQ(bench.unit.waiting(), 0u);
  EXPECT_EQ(bench.controller.node().counters().malformed, 0u);
}
TEST(VirtualMpdo, NoneIsLostWhenManyChangeAtOnceInDestinationAddressMode) {
  expect_that_none_is_lost<MpdoMode::destination>();
}
TEST(VirtualMpdo, NoneIsLostWhenManyChangeAtOnceInSourceAddressMode) {
  expect_that_none_is_lost<MpdoMode::source>();
}

template <MpdoMode mode>
void expect_that_a_restart_tells_the_states() {
  MpdoBench<mode> bench;
  bench.start();
  bench.level(0, true);
  bench.cable.send("000#80 16");
  bench.level(0, false);
  bench.level(1, true);
  bench.heard.clear();
  bench.cable.send("000#01 16");
  bench.cable.run_for(1s);
  ASSERT_GE(bench.heard.size(), 2u);
  EXPECT_EQ(bench.heard[bench.heard.size() - 2], 0x0010'0301'0102u);
  EXPECT_EQ(bench.heard.back(), 0x0110'0301'0202u);
}
TEST(VirtualMpdo, StatesAreToldWhenTheNodeBecomesOperationalInDestinationAddressMode) {
  expect_that_a_restart_tells_the_states<MpdoMode::destination>();
}
TEST(VirtualMpdo, StatesAreToldWhenTheNodeBecomesOperationalInSourceAddressMode) {
  expect_that_a_restart_tells_the_states<MpdoMode::source>();
}

TEST(VirtualMpdo, WhereAPdoCarriesTheObjectItIsTaken) {
  MpdoBench<MpdoMode::destination> bench;
  MpdoBench<MpdoMode::destination>::write(bench.panel.node(), 0x1800, 1, 0x496);
  bench.start();
  bench.level(0, true);
  EXPECT_EQ(bench.cable.last(0x496), "496#02 01 01 03 10 01");
  EXPECT_EQ(bench.told(), Frames{});
}

TEST(VirtualMpdo, PartsThatDoNotBelongTogetherAreNoRecord) {
  MpdoBench<MpdoMode::destination> bench;
  bench.start();
  bench.cable.send("516#80 11 5F 2B 02 01 01 03");
  bench.cable.send("516#80 11 5F 2C 10 01 01 12");
  EXPECT_EQ(bench.heard, Heard{});
  EXPECT_EQ(bench.controller.node().counters().malformed, 1u);
  bench.cable.send("516#80 11 5F 2C 10 01 01 11");
  EXPECT_EQ(bench.heard, (Heard{0x0110'0301'0102}));
  bench.cable.send("516#80 11 5F 2A 10 01 01 11");
  EXPECT_EQ(bench.heard.size(), 1u) << "of another node";
}

TEST(VirtualMpdo, APartThatIsLostIsFoundByTheCheckForEveryByteOfTheRecord) {
  for (unsigned byte = 0; byte < 4; ++byte) {
    for (unsigned value = 0; value <= 0xFF; ++value) {
      const std::uint64_t record = 0x0110'0301'0102;
      const std::uint64_t other = (record & ~(0xFFULL << (8 * byte))) | std::uint64_t{value}
                                                                            << (8 * byte);
      std::uint64_t joined = 0;
      const bool is_same = other == record;
      EXPECT_EQ(join({split(other, 1).first, split(record, 2).second}, joined), is_same);
    }
  }
}

}  // namespace
}  // namespace canvoy::cia417::virtual_mpdo_test
