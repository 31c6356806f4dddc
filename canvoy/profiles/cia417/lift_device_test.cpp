// Devices of a lift as built by a maker: expectations typed from the table of pre-defined PDOs of
// CiA 417-3 and from CiA 417-4.
#include "canvoy/profiles/cia417/lift_device.hpp"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "canvoy/canopen/device/device_node.hpp"
#include "canvoy/canopen/testing/wire.hpp"
#include "canvoy/profiles/cia417/handles.hpp"
#include "canvoy/profiles/model/layout.hpp"
#include "canvoy/profiles/testing/device_memory.hpp"

namespace canvoy::lift_device_test {
namespace {

using cia417::lift_device;
using cia417::LiftDeviceOptions;
using cia417::VirtualDevice;

/// COB-ID and mapping of the PDO with its parameter at `index`.
std::vector<std::uint32_t> pdo_at(const Dictionary& dictionary, unsigned index) {
  const auto number = [&](unsigned at, unsigned sub) {
    return static_cast<std::uint32_t>(
        dictionary.number(static_cast<std::uint16_t>(at), static_cast<std::uint8_t>(sub)));
  };
  std::vector<std::uint32_t> pdo = {number(index, 1)};
  for (unsigned sub = 1; sub <= number(index + 0x200, 0); ++sub) {
    pdo.push_back(number(index + 0x200, sub));
  }
  return pdo;
}
using Pdo = std::vector<std::uint32_t>;

constexpr auto door_2 =
    describe(lift_device<VirtualDevice::car_door_unit, LiftDeviceOptions{.doors = 0b0010}>(
                 {0x6300, 0x6301, 0x6302, 0x6305}),
             cia301::identity({.vendor_id = 1}));
constexpr auto door_2_layout = partial(lay_out_device<door_2>());

TEST(Cia417LiftDevice, ADoorUnitSendsTheStateOfItsOwnDoorAndHearsCommandsToAll) {
  const DeviceMemory memory(door_2_layout.tables());
  const Dictionary& door = memory.dictionary;
  EXPECT_EQ(door.number(0x1000, 0), 0x050001A1U);
  EXPECT_EQ(pdo_at(door, 0x190C), (Pdo{0x202, 0x63010210, 0x63020210}));
  EXPECT_EQ(pdo_at(door, 0x1508), (Pdo{0x200, 0x63000110, 0x63000210, 0x63000310, 0x63000410}));
  EXPECT_EQ(door.number(0x190C, 2), 255U);
  EXPECT_EQ(door.find(0x190A, 1).abort(), AbortCode::no_object) << "door 1 is another device's";
  EXPECT_EQ(door.find(0x190D, 1).abort(), AbortCode::no_object) << "light barriers, too";
}

constexpr auto position_5 =
    describe(lift_device<VirtualDevice::car_position_unit, LiftDeviceOptions{.lift = 5}>(
                 {{0x6383, 1}, {0x6384, 3}}),
             cia301::identity({.vendor_id = 1}));
constexpr auto position_5_layout = partial(lay_out_device<position_5>());

TEST(Cia417LiftDevice, TheObjectsAndPdosOfLift5AreFourBlocksAbove) {
  const DeviceMemory memory(position_5_layout.tables());
  const Dictionary& unit = memory.dictionary;
  EXPECT_EQ(unit.number(0x6001, 0), 0x10U) << "the lift number itself is of the device";
  EXPECT_EQ(unit.number(0x8384, 1), 10U);
  EXPECT_EQ(unit.find(0x6383, 1).abort(), AbortCode::no_object);
  EXPECT_EQ(pdo_at(unit, 0x1946), (Pdo{0x1CC, 0x83830120}));
}

constexpr auto drive = describe(
    lift_device<VirtualDevice::car_drive_unit>({0x6400, 0x6401, 0x6403, 0x6404, 0x6430, 0x6433}),
    cia301::identity({.vendor_id = 1}));
constexpr auto drive_layout = partial(lay_out_device<drive>());

TEST(Cia417LiftDevice, ADriveHasThePdosOfTheModeWhoseObjectsItHas) {
  const DeviceMemory memory(drive_layout.tables());
  const Dictionary& unit = memory.dictionary;
  EXPECT_EQ(pdo_at(unit, 0x1503), (Pdo{0x184, 0x64000010, 0x64300020}));
  EXPECT_EQ(pdo_at(unit, 0x1907), (Pdo{0x185, 0x64010010, 0x64330020}));
  EXPECT_EQ(unit.find(0x1504, 1).abort(), AbortCode::no_object) << "it has no target position";
  EXPECT_EQ(unit.find(0x1905, 1).abort(), AbortCode::no_object);
  EXPECT_EQ(access_text(unit.find(0x6400, 0)->row->access), "rw TR");
  EXPECT_EQ(access_text(unit.find(0x6433, 0)->row->access), "ro T");
}

constexpr auto panel =
    describe(lift_device<VirtualDevice::input_panel_unit>({0x6010, {0x6100, 4}, {0x6120, 4}}),
             cia301::identity({.vendor_id = 1}));
constexpr auto panel_layout = partial(lay_out_device<panel>());

constexpr auto panel_8 =
    describe(lift_device<VirtualDevice::input_panel_unit, LiftDeviceOptions{.lift = 8}>(
                 {0x6010, {0x6100, 4}}),
             cia301::identity({.vendor_id = 1}));
constexpr auto panel_8_layout = partial(lay_out_device<panel_8>());

TEST(Cia417LiftDevice, WhatIsNextToBeSentStandsAtOnePlaceForAllLifts) {
  const DeviceMemory memory(panel_8_layout.tables(), 17);
  EXPECT_EQ(pdo_at(memory.dictionary, 0x1881), (Pdo{0x80000491, 0x60100030}));
  EXPECT_EQ(memory.dictionary.number(0x9900, 0), 4U);
  EXPECT_EQ(memory.dictionary.find(0x9810, 0).abort(), AbortCode::no_object);
}

TEST(Cia417LiftDevice, AnInputPanelHasThePdoOfItsNodeButInvalid) {
  const DeviceMemory memory(panel_layout.tables(), 17);
  EXPECT_EQ(pdo_at(memory.dictionary, 0x1881), (Pdo{0x80000491, 0x60100030}));
  EXPECT_EQ(memory.dictionary.find(0x6001, 0).abort(), AbortCode::no_object);
}

constexpr auto display =
    describe(lift_device<VirtualDevice::output_panel_unit>({0x6011, {0x6200, 4}, {0x6220, 4}}),
             cia301::identity({.vendor_id = 1}));
constexpr auto display_layout = partial(lay_out_device<display>());

TEST(Cia417LiftDevice, AnOutputPanelHearsTheOutputsOfTheCallController) {
  const DeviceMemory memory(display_layout.tables());
  EXPECT_EQ(pdo_at(memory.dictionary, 0x1500), (Pdo{0x400, 0x60110030}));
  EXPECT_EQ(access_text(memory.dictionary.find(0x6011, 0)->row->access), "rw TR");
  EXPECT_EQ(access_text(memory.dictionary.find(0x6220, 4)->row->access), "rw");
}

/// A device with the test as its bus.
template <const auto& layout>
struct Bench {
  static bool take(void* context, const Frame& frame) {
    static_cast<Bench*>(context)->sent.push_back(wire_text(frame));
    return true;
  }
  /// Enters NMT state operational, and discards the frames sent up to then.
  Bench() {
    device.node().start(Time{});
    receive("000#01 00");
    sent.clear();
  }
  void receive(std::string_view frame) {
    device.node().receive(wire_frame(frame), Time{});
    settle();
  }
  void settle() {
    for (int i = 0; i < 100 && device.node().deadline() <= Time{}; ++i) {
      device.node().advance(Time{});
    }
  }
  std::vector<std::string> take_sent() {
    settle();
    return std::exchange(sent, {});
  }

  std::vector<std::string> sent;
  DeviceNode<layout> device{{this, &Bench::take, nullptr}, 7};
  Values values{device.node().dictionary()};
};
using Frames = std::vector<std::string>;

TEST(Cia417LiftDevice, ADoorMovesByOneFrameAndTellsByAnother) {
  Bench<door_2_layout> door;
  door.receive("200#FF FF 07 44 FF FF FF FF");
  EXPECT_TRUE(door.values[cia417::door_command(1)].is(cia417::DoorCommand::no_action));
  EXPECT_TRUE(door.values[cia417::door_command(2)].is(cia417::DoorCommand::open_with_limit_force));
  EXPECT_TRUE(door.values[cia417::door_velocity(2)].is(cia417::DoorVelocity::reduced));
  EXPECT_EQ(door.take_sent(), Frames{});
  door.values[cia417::door_state(2)] = cia417::DoorState::opening;
  EXPECT_EQ(door.take_sent(), Frames{"202#FF 5F FF FF"});
  door.values[cia417::door_position(2)] = 650;
  EXPECT_EQ(door.take_sent(), Frames{"202#FF 5F 8A 02"});
}

TEST(Cia417LiftDevice, ADriveHearsItsVelocityOn184h) {
  Bench<drive_layout> unit;
  unit.receive("184#0F 00 24 FA FF FF");
  EXPECT_TRUE(unit.values[cia417::enable_operation].is_set());
  EXPECT_EQ(unit.values[cia417::target_velocity].value(), -1500);
  unit.values[cia417::velocity_actual_value] = -1;
  EXPECT_EQ(unit.take_sent(), Frames{"185#00 00 FF FF FF FF"});
}

TEST(Cia417LiftDevice, ACallLeavesWhenThePanelIsGivenItsCobId) {
  Bench<panel_layout> unit;
  unit.receive("607#23 81 18 01 87 04 00 00");
  EXPECT_EQ(unit.take_sent(), (Frames{"487#00 00 00 00 00 00", "587#60 81 18 01 00 00 00 00"}))
      << "an event-driven PDO is sent when it begins";
  unit.values[cia417::next_input.whole] = 0x01'10'05'01'01'02;
  EXPECT_EQ(unit.take_sent(), Frames{"487#02 01 01 05 10 01"});
}

}  // namespace
}  // namespace canvoy::lift_device_test
