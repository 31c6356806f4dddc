// Emergency 0010h of each kind of device (CiA 417-1, 8.4): an error counter of its CAN controller
// has reached the warning limit.
#include <gtest/gtest.h>

#include <memory>
#include <optional>

#include "canvoy/devices/cia417/call_controller_device.hpp"
#include "canvoy/devices/cia417/car_door_controller_device.hpp"
#include "canvoy/devices/cia417/car_door_device.hpp"
#include "canvoy/devices/cia417/car_drive_controller_device.hpp"
#include "canvoy/devices/cia417/car_drive_device.hpp"
#include "canvoy/devices/cia417/car_position_device.hpp"
#include "canvoy/devices/cia417/device_on_cable_test.hpp"
#include "canvoy/devices/cia417/group_device.hpp"
#include "canvoy/devices/cia417/lift_bench.hpp"
#include "canvoy/devices/cia417/lift_panel_device.hpp"
#include "canvoy/devices/cia417/light_barrier_device.hpp"
#include "canvoy/devices/cia417/load_measuring_device.hpp"
#include "canvoy/devices/cia417/sensor_unit_device.hpp"

namespace canvoy::cia417 {
namespace {

constexpr CallControllerSettings four_served{.served = {FloorSet::between(1, 4)}};
constexpr VirtualInput button{
    .function = BasicFunction::standard_hall_call, .sub_function = hall_up, .floor = 1};

std::optional<double> no_load(void*, unsigned) {
  return 0;
}
struct LoadUnit : LoadMeasuringDevice<> {
  explicit LoadUnit(const Port& port)
      : LoadMeasuringDevice(port, 13, {.rope_load = {&no_load, nullptr}}) {}
};
struct LightBarrier : LightBarrierDevice<> {
  explicit LightBarrier(const Port& port) : LightBarrierDevice(port, 9, {}) {}
};
struct Door : CarDoorDevice<LiftDeviceOptions{.doors = 0b0001}> {
  explicit Door(const Port& port) : CarDoorDevice(port, 6, {}) {}
};
struct Position : CarPositionDevice<> {
  explicit Position(const Port& port) : CarPositionDevice(port, 4, {}) {}
};
struct Drive : CarDriveDevice<> {
  explicit Drive(const Port& port) : CarDriveDevice(port, 2, {}) {}
};
struct DoorController : CarDoorControllerDevice<LiftDeviceOptions{}> {
  explicit DoorController(const Port& port) : CarDoorControllerDevice(port, 1) {}
};
struct DriveController : CarDriveControllerDevice<> {
  explicit DriveController(const Port& port) : CarDriveControllerDevice(port, 1) {}
};
struct Calls : CallControllerDevice<> {
  explicit Calls(const Port& port) : CallControllerDevice(port, 1, four_served) {}
};
struct Lift : LiftControllerDevice<> {
  explicit Lift(const Port& port) : LiftControllerDevice(port, 1, lift_of_four_floors()) {}
};
struct Group : GroupControllerDevice<> {
  explicit Group(const Port& port) : GroupControllerDevice(port, {}) {}
};
struct Member : GroupMemberDevice<> {
  struct Own {
    Cable cable;
    Calls device{cable.port(0)};
    BenchCar car;
    BenchDoors doors;
    LiftController lift{device.node(),
                        device.calls(),
                        {car.interface(), doors.interface(), {}},
                        {.floors = four_floors}};
  };
  explicit Member(const Port& port) : Member(port, std::make_unique<Own>()) {}
  Member(const Port& port, std::unique_ptr<Own> own)
      : GroupMemberDevice(port, 1, own->device.node(), own->device.calls(), own->lift),
        own_(std::move(own)) {}
  std::unique_ptr<Own> own_;
};
struct Landing : LandingPanelDevice<> {
  explicit Landing(const Port& port) : LiftPanelDevice(port, 21, {}, LandingPanel{.floor = 2}) {}
};
constexpr auto buttons =
    describe(panel<PanelOptions{.inputs = 1}>(), cia301::identity({}), cia301::emergency());
constexpr auto buttons_layout = lay_out_device<buttons>();
struct Buttons : InputPanelDevice<buttons_layout> {
  explicit Buttons(const Port& port)
      : InputPanelDevice(port, 22, {.inputs = std::span(&button, 1)}) {}
};
constexpr auto lamps =
    describe(panel<PanelOptions{.outputs = 1}>(), cia301::identity({}), cia301::emergency());
constexpr auto lamps_layout = lay_out_device<lamps>();
struct Lamps : OutputPanelDevice<lamps_layout> {
  explicit Lamps(const Port& port) : OutputPanelDevice(port, 23, {}, {}) {}
};
struct Sensors : SensorUnitDevice<1> {
  explicit Sensors(const Port& port) : SensorUnitDevice(port, 30, {}) {}
};

/// A device on a cable, and what it says of errors.
template <class Device>
struct BusWarningTest : testing::Test, DeviceOnCable<Device> {
  BusWarningTest() { this->start(); }
  void bus(BusState state) {
    this->device.node().bus_state(state, this->cable.now);
    this->cable.run_for(10ms);
  }
  /// Those of errors of communication, and of their ends, since the last call.
  std::vector<std::string> told() {
    const std::uint32_t id = 0x080U + this->device.node().id();
    std::vector<std::string> all;
    for (const Cable::Heard& heard : this->cable.heard) {
      if (heard.frame.id == id) all.push_back(wire_text(heard.frame).substr(4));
    }
    this->cable.clear();
    return all;
  }
};
using Devices =
    testing::Types<LoadUnit, LightBarrier, Door, Position, Drive, DoorController, DriveController,
                   Calls, Lift, Group, Member, Landing, Buttons, Lamps, Sensors>;
TYPED_TEST_SUITE(BusWarningTest, Devices);

using Told = std::vector<std::string>;
constexpr const char* warning = "10 00 11 00 00 00 00 00";
constexpr const char* passive = "20 81 11 00 00 00 00 00";
constexpr const char* gone = "00 00 00 00 00 00 00 00";
constexpr const char* one_gone = "00 00 11 00 00 00 00 00";

TYPED_TEST(BusWarningTest, TheWarningLimitAndItsEndAreTold) {
  this->bus(BusState::error_warning);
  EXPECT_EQ(this->told(), Told{warning});
  this->bus(BusState::error_active);
  EXPECT_EQ(this->told(), Told{gone});
}

TYPED_TEST(BusWarningTest, ItHoldsWhileTheControllerIsErrorPassive) {
  this->bus(BusState::error_warning);
  this->bus(BusState::error_passive);
  EXPECT_EQ(this->told(), (Told{warning, passive}));
  this->bus(BusState::error_warning);
  EXPECT_EQ(this->told(), Told{one_gone});
  this->bus(BusState::error_active);
  EXPECT_EQ(this->told(), Told{gone});
}

TYPED_TEST(BusWarningTest, ItIsToldWhereTheControllerSkipsIt) {
  this->bus(BusState::error_passive);
  EXPECT_EQ(this->told(), (Told{passive, warning}));
  this->bus(BusState::error_active);
  EXPECT_EQ(this->told(), (Told{one_gone, gone}));
}

TYPED_TEST(BusWarningTest, ItEndsWithTheRecoveryFromBusOff) {
  this->bus(BusState::error_warning);
  this->told();
  this->bus(BusState::bus_off);
  EXPECT_EQ(this->told(), Told{});
  this->bus(BusState::error_active);
  EXPECT_EQ(this->told(), (Told{"40 81 11 00 00 00 00 00", one_gone, gone}));
}

TYPED_TEST(BusWarningTest, ItIsToldAgainAfterAResetWhileItLasts) {
  for (const char* reset : {"000#81 00", "000#82 00"}) {
    this->bus(BusState::error_warning);
    this->told();
    this->cable.send(reset);
    this->cable.run_for(100ms);
    EXPECT_EQ(this->told(), Told{warning}) << reset;
    this->bus(BusState::error_active);
    EXPECT_EQ(this->told(), Told{gone}) << reset;
  }
}

}  // namespace
}  // namespace canvoy::cia417
