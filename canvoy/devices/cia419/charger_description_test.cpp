// Chargers with less in their description than the profile has, and with more.
#include <gtest/gtest.h>

#include "canvoy/canopen/testing/cable.hpp"
#include "canvoy/devices/cia418/battery_device.hpp"
#include "canvoy/devices/cia419/charger_device.hpp"
#include "canvoy/devices/cia419/charger_test.hpp"

namespace canvoy::cia419::charger_description_test {
namespace {

constexpr auto common =
    describe(cia301::identity({.product_code = 419}), cia301::heartbeat_producer(1000),
             cia301::heartbeat_consumers(1), cia301::emergency(), cia301::error_behavior());
constexpr auto with_two_rpdos = describe(charger({.rpdo2 = true}), common);
constexpr auto with_own_pdos =
    describe(charger({.rpdo2 = true, .rpdo3 = true, .tpdo2 = true, .tpdo3 = true}), common,
             cia301::rpdo({.number = 4, .entries = 1}), cia301::tpdo({.number = 4, .entries = 1}));
constexpr auto layout_with_two_rpdos = lay_out_device<with_two_rpdos>();
constexpr auto layout_with_own_pdos = lay_out_device<with_own_pdos>();

template <const auto& layout>
struct Pair {
  explicit Pair(const ChargerSettings& settings = {})
      : charger(cable.port(0), 5, bench.charger_hardware(), settings) {
    cable.connect(0, charger.node());
    cable.connect(1, battery.node());
  }
  void write(Node& node, std::uint16_t index, std::uint8_t sub, std::uint32_t value) {
    std::uint8_t bytes[4];
    store(bytes, value);
    const Result<Entry> entry = node.dictionary().find(index, sub);
    ASSERT_TRUE(entry);
    ASSERT_EQ(
        node.dictionary().write(*entry, std::span(bytes).first(entry->row->capacity), Source::sdo),
        AbortCode::none);
  }
  std::uint64_t number(std::uint16_t index, std::uint8_t sub) {
    return charger.node().dictionary().number(index, sub);
  }

  Bench bench;
  Cable cable;
  ChargerDevice<layout> charger;
  cia418::BatteryDevice<> battery{cable.port(1), 10, bench.battery_hardware(), {}};
};

/// It receives no requested current.
struct PairWithTwoRpdos : Pair<layout_with_two_rpdos> {
  PairWithTwoRpdos() : Pair({.limits = {.current_without_request_ampere = 20}}) {}
};

TEST(ChargerDescription, WithoutAThirdRpdoTheSecondIsLinkedAndTheConfiguredCurrentFlows) {
  PairWithTwoRpdos sut;
  sut.cable.start_all();
  sut.cable.run_for(5s);
  EXPECT_EQ(sut.number(0x1400, 1), 0x8000'0000u);
  EXPECT_EQ(sut.number(0x1401, 1), 0x28Au);
  EXPECT_EQ(sut.number(0x1800, 1), 0x20Au);
  EXPECT_EQ(sut.bench.delivered, 20);
}

TEST(ChargerDescription, WithoutTheTpdoThatTheBatteryWouldTakeNothingIsToldBeforeCurrentFlows) {
  PairWithTwoRpdos sut;
  sut.battery.node().start(sut.cable.now);
  sut.write(sut.battery.node(), 0x1400, 1, 0x8000'0000);
  sut.charger.node().start(sut.cable.now);
  sut.cable.run_for(5s);
  EXPECT_EQ(sut.number(0x1800, 1), 0x8000'0000u);
  EXPECT_EQ(sut.bench.delivered, 20);
}

TEST(ChargerDescription, WithoutTimeLeavesTheClockAlone) {
  Bench bench;
  ChargerHardware hardware = bench.charger_hardware();
  unsigned asked = 0;
  auto clock = [&] {
    ++asked;
    return std::optional(TimeOfDay{});
  };
  hardware.time_of_day = Callback<std::optional<TimeOfDay>()>::of(clock);
  Cable cable;
  ChargerDevice<layout_with_two_rpdos> sut(cable.port(0), 5, hardware);
  cable.connect(0, sut.node());
  cable.start_all();
  cable.run_for(3min);
  EXPECT_EQ(asked, 0u);
  EXPECT_EQ(cable.count(0x100), 0u);
}

TEST(ChargerDescription, WithPdosOfItsMakerKeepsThemAsTheyAre) {
  Pair<layout_with_own_pdos> sut;
  sut.cable.start_all();
  Node& node = sut.charger.node();
  sut.write(node, 0x1603, 1, 0x6081'0008);
  sut.write(node, 0x1603, 0, 1);
  sut.write(node, 0x1403, 5, 100);
  sut.write(node, 0x1403, 1, 0x50A);
  sut.write(node, 0x1803, 1, 0x4000'048A);
  sut.cable.run_for(5s);
  ASSERT_EQ(sut.bench.delivered, 40);
  sut.cable.send("50A#1E");
  EXPECT_EQ(sut.bench.delivered, 40) << "its coming is none of the battery's";
  sut.cable.run_for(1s);
  EXPECT_EQ(sut.cable.last(0x085), "085#50 82 11 04 00 00 00 00");
  EXPECT_EQ(sut.bench.delivered, 40) << "nor is its absence";
  EXPECT_EQ(sut.number(0x1403, 1), 0x50Au);
  EXPECT_EQ(sut.number(0x1803, 1), 0x4000'048Au);
  sut.bench.plugged = false;
  sut.cable.run_for(1s);
  EXPECT_EQ(sut.number(0x1403, 1), 0x50Au);
  EXPECT_EQ(sut.number(0x1803, 1), 0x4000'048Au);
}

}  // namespace
}  // namespace canvoy::cia419::charger_description_test
