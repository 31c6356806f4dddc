// Complete panels on a cable: their contents, and their messages for a call controller. Bytes are
// typed from CiA 417-4, 4.3.1 and 4.4.1.
#include "canvoy/devices/cia417/panel/lift_panel_device.hpp"

#include <gtest/gtest.h>

#include "canvoy/canopen/testing/cable.hpp"

namespace canvoy::cia417::lift_panel_device_test {
namespace {

/// A panel at place 0 of a cable, as node 22 (16h).
template <class Device>
class LiftPanelBench {
 public:
  template <class Panel>
  explicit LiftPanelBench(const Panel& what) : device(cable.port(0), 22, {}, what) {
    cable.connect(0, device.node());
    cable.start_all();
    cable.send("000#01 16");
    cable.run_for(10ms);
    cable.clear();
  }
  /// Presses and lets go; answers the first of the two records.
  std::string press(std::uint32_t input) {
    cable.clear();
    device.inputs().set_level(input, true, cable.now);
    cable.run_for(0ms);
    const std::string told = cable.last(0x496);
    device.inputs().set_level(input, false, cable.now);
    cable.run_for(0ms);
    return told.empty() ? told : told.substr(4);
  }

  Cable cable;
  Device device;
};

TEST(LandingPanelDevice, HasButtonsUpAndDownAndAKeyAndTheirLamps) {
  LiftPanelBench<LandingPanelDevice<>> bench(LandingPanel{
      .lifts = 0x03, .floor = 7, .doors = 0b0010, .highest_floor = 10, .fire_key = true});
  EXPECT_EQ(bench.press(0), "02 01 03 07 20 01");
  EXPECT_EQ(bench.press(1), "02 02 03 07 20 01");
  EXPECT_EQ(bench.press(2), "0E 0C 03 07 20 81");
  EXPECT_EQ(bench.press(3), "");
  bench.cable.send("400#02 02 01 07 20 01");
  EXPECT_TRUE(bench.device.outputs().view(1).on) << "for any of its lifts";
  EXPECT_FALSE(bench.device.outputs().view(0).on);
  bench.cable.send("400#40 04 02 FF F0 01");
  EXPECT_EQ(bench.device.outputs().view(3).sub_function, 4) << "position indicator";
  EXPECT_EQ(bench.device.outputs().find(BasicFunction::position_indicator, 0, 7), 3u);
  EXPECT_EQ(bench.device.outputs().find(BasicFunction::arrival_indication, 0, 7), 7u);
}

TEST(LandingPanelDevice, HasThePdosOfCia417Part3) {
  LiftPanelBench<LandingPanelDevice<>> bench(LandingPanel{.floor = 7, .highest_floor = 10});
  struct Expected {
    const char* object;
    const char* value;
  };
  // Inputs go by TPDO 130 (1881h, 480h + node-ID), outputs come by RPDO 257 (1500h, 400h).
  constexpr Expected objects[] = {
      {"81 18 01", "43 81 18 01 96 04 00 00"}, {"81 1A 01", "43 81 1A 01 30 00 10 60"},
      {"00 15 01", "43 00 15 01 00 04 00 00"}, {"00 17 01", "43 00 17 01 30 00 11 60"},
      {"00 18 01", "80 00 18 01 00 00 02 06"}, {"00 14 01", "80 00 14 01 00 00 02 06"}};
  for (const Expected& expected : objects) {
    bench.cable.send("616#40 " + std::string(expected.object) + " 00 00 00 00");
    EXPECT_EQ(bench.cable.last(0x596), "596#" + std::string(expected.value));
  }
}

TEST(LandingPanelDevice, TheHighestLandingHasNoButtonUpAndTheLowestNoneDown) {
  LiftPanelBench<LandingPanelDevice<>> top(LandingPanel{.floor = 10, .highest_floor = 10});
  EXPECT_EQ(top.press(0), "02 02 01 0A 10 01");
  EXPECT_EQ(top.press(1), "");
  EXPECT_EQ(top.device.inputs().find(BasicFunction::standard_hall_call, hall_up, 10), io_nowhere);
  LiftPanelBench<LandingPanelDevice<>> bottom(LandingPanel{.floor = 1, .highest_floor = 10});
  EXPECT_EQ(bottom.press(0), "02 01 01 01 10 01");
  EXPECT_EQ(bottom.press(1), "");
}

TEST(LandingPanelDevice, ADestinationPanelHasAButtonForEachOtherFloor) {
  LiftPanelBench<LandingPanelDevice<LandingPanelOptions{.destinations = 6}>> bench(
      LandingPanel{.floor = 3, .lowest_floor = 1, .highest_floor = 6, .destinations = true});
  EXPECT_EQ(bench.press(0), "08 01 01 03 10 01");
  EXPECT_EQ(bench.press(2), "08 04 01 03 10 01") << "3 is where it hangs";
  EXPECT_EQ(bench.press(4), "08 06 01 03 10 01");
  EXPECT_EQ(bench.press(5), "");
  bench.cable.send("400#08 06 01 03 10 01");
  EXPECT_TRUE(bench.device.outputs().view(4).on);
}

TEST(LandingPanelDevice, OneDeviceMayHaveTheButtonsOfSeveralLandings) {
  constexpr LandingPanel landings[] = {{.floor = 1, .highest_floor = 9},
                                       {.floor = 2, .highest_floor = 9}};
  LiftPanelBench<LandingPanelDevice<LandingPanelOptions{.panels = 2}>> bench(
      std::span<const LandingPanel>{landings});
  EXPECT_EQ(bench.press(0), "02 01 01 01 10 01");
  EXPECT_EQ(bench.press(2), "02 02 01 02 10 01");
  const std::uint32_t lamp =
      bench.device.outputs().find(BasicFunction::standard_hall_call, hall_down, 2);
  bench.cable.send("400#02 03 01 02 10 01");
  EXPECT_TRUE(bench.device.outputs().view(lamp).on);
  EXPECT_FALSE(bench.device.outputs().view(0).on) << "another landing";
}

TEST(CarPanelDevice, HasAButtonForEachFloorButtonsForTheDoorsAndKeys) {
  LiftPanelBench<CarPanelDevice<>> bench(CarPanel{.lift = 2, .doors = 0b0001, .highest_floor = 20});
  EXPECT_EQ(bench.press(0), "05 01 02 00 01 01");
  EXPECT_EQ(bench.press(19), "05 14 02 00 01 01");
  EXPECT_EQ(bench.press(20), "0E 09 02 00 00 01") << "door open";
  EXPECT_EQ(bench.press(21), "0E 0A 02 00 00 01") << "door close";
  EXPECT_EQ(bench.press(22), "0E 0C 02 00 00 81") << "fire service, a key";
  EXPECT_EQ(bench.press(23), "0E 0E 02 00 00 81") << "attendant service";
  EXPECT_EQ(bench.press(24), "0E 0F 02 00 00 81") << "VIP service";
  EXPECT_EQ(bench.press(25), "");
  bench.cable.send("400#05 14 02 00 F1 01");
  EXPECT_TRUE(bench.device.outputs().view(19).on);
  bench.cable.send("400#43 03 02 00 00 01");
  const std::uint32_t display =
      bench.device.outputs().find(BasicFunction::special_indication, 0, floor_of_car);
  EXPECT_EQ(bench.device.outputs().view(display).sub_function, 0x03) << "overload";
  bench.cable.send("400#40 07 02 FF F0 01");
  const std::uint32_t position =
      bench.device.outputs().find(BasicFunction::position_indicator, 0, floor_of_car);
  EXPECT_FALSE(bench.device.outputs().view(position).on) << "that is for the landings";
}

TEST(CarPanelDevice, ServesUpTo254Floors) {
  LiftPanelBench<CarPanelDevice<CarPanelOptions{.floors = 254}>> bench(CarPanel{});
  EXPECT_EQ(bench.press(253), "05 FE 01 00 01 01") << "6100h:FEh";
  EXPECT_EQ(bench.press(254), "0E 09 01 00 00 01") << "6101h:01h";
  bench.cable.send("400#05 FF 01 00 F1 01");
  for (unsigned floor = 1; floor <= 254; ++floor) {
    ASSERT_TRUE(bench.device.outputs().view(floor - 1).on) << "255 is all target stops";
  }
}

TEST(LiftPanels, WhatFindsNoRoomIsLeftOut) {
  std::array<VirtualInput, 3> inputs;
  EXPECT_EQ(car_inputs({.highest_floor = 9}, inputs).size(), 3u);
  EXPECT_EQ(landing_inputs({.floor = 2}, std::span(inputs).first(1)).size(), 1u);
  EXPECT_EQ(landing_inputs({.floor = 2}, {}).size(), 0u);
}

TEST(LandingPanelDevice, IsSmall) {
  EXPECT_LT(sizeof(LandingPanelDevice<>), 6400u) << sizeof(LandingPanelDevice<>);
}

}  // namespace
}  // namespace canvoy::cia417::lift_panel_device_test
