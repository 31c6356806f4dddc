// All devices that the project builds, each with hardware that does nothing: for tests of what must
// hold of every one.
//
//     for (const EveryDevice& kind : every_device()) {
//       Cable cable;
//       const auto device = kind.make(cable.port(0));
//       cable.connect(0, device->node());
//     }
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "canvoy/devices/cia417/call_controller_device.hpp"
#include "canvoy/devices/cia417/car_door_controller_device.hpp"
#include "canvoy/devices/cia417/car_door_device.hpp"
#include "canvoy/devices/cia417/car_drive_controller_device.hpp"
#include "canvoy/devices/cia417/car_drive_device.hpp"
#include "canvoy/devices/cia417/car_position_device.hpp"
#include "canvoy/devices/cia417/group_device.hpp"
#include "canvoy/devices/cia417/lift_controller_device.hpp"
#include "canvoy/devices/cia417/lift_panel_device.hpp"
#include "canvoy/devices/cia417/light_barrier_device.hpp"
#include "canvoy/devices/cia417/load_measuring_device.hpp"
#include "canvoy/devices/cia417/sensor_unit_device.hpp"
#include "canvoy/devices/cia418/battery_device.hpp"
#include "canvoy/devices/cia419/charger_device.hpp"

namespace canvoy {

class AnyDevice {
 public:
  virtual ~AnyDevice() = default;
  virtual Node& node() = 0;
};

struct EveryDevice {
  std::string name;
  std::unique_ptr<AnyDevice> (*make)(const Port& port);
};

/// `what` are the arguments of the device behind its port.
template <class Device>
class HeldDevice : public AnyDevice {
 public:
  template <class... What>
  explicit HeldDevice(const Port& port, const What&... what) : device_(port, what...) {}
  Node& node() override { return device_.node(); }

 private:
  Device device_;
};

inline constexpr std::int32_t four_floors_micrometre[] = {0, 4'000'000, 7'000'000, 10'000'000};

inline cia417::LiftControllerDeviceSettings small_lift() {
  return {.calls = {.served = {cia417::FloorSet::between(1, 4)}},
          .lift = {.floors = four_floors_micrometre}};
}

/// A member is half of a lift controller.
class HeldGroupMember : public AnyDevice {
 public:
  explicit HeldGroupMember(const Port& port)
      : lift_(Port{nullptr, [](void*, const Frame&) { return true; }, nullptr}, 1, small_lift()),
        member_(port, 1, lift_.node(), lift_.calls(), lift_.lift()) {}
  Node& node() override { return member_.node(); }

 private:
  cia417::LiftControllerDevice<> lift_;
  cia417::GroupMemberDevice<> member_;
};

template <class Device, class... What>
std::unique_ptr<AnyDevice> hold(const Port& port, const What&... what) {
  return std::make_unique<HeldDevice<Device>>(port, what...);
}

inline const std::vector<EveryDevice>& every_device() {
  using namespace cia417;
  static const std::vector<EveryDevice> all = {
      {"battery",
       [](const Port& port) {
         return hold<cia418::BatteryDevice<>>(port, NodeId{5}, cia418::BatteryHardware{});
       }},
      {"charger",
       [](const Port& port) {
         return hold<cia419::ChargerDevice<>>(port, NodeId{10}, cia419::ChargerHardware{});
       }},
      {"call controller",
       [](const Port& port) {
         return hold<CallControllerDevice<>>(
             port, NodeId{1}, CallControllerSettings{.served = {FloorSet::between(1, 4)}});
       }},
      {"car door controller",
       [](const Port& port) { return hold<CarDoorControllerDevice<>>(port, NodeId{1}); }},
      {"car door",
       [](const Port& port) {
         return hold<CarDoorDevice<>>(port, NodeId{6}, std::array<DoorHardware, 1>{});
       }},
      {"car drive controller",
       [](const Port& port) { return hold<CarDriveControllerDevice<>>(port, NodeId{1}); }},
      {"car drive",
       [](const Port& port) {
         return hold<CarDriveDevice<>>(port, NodeId{2}, CarDriveHardware{});
       }},
      {"car position",
       [](const Port& port) {
         return hold<CarPositionDevice<>>(port, NodeId{4}, CarPositionHardware{});
       }},
      {"light barrier",
       [](const Port& port) {
         return hold<LightBarrierDevice<>>(port, NodeId{9}, LightBarrierHardware{});
       }},
      {"load measuring",
       [](const Port& port) {
         return hold<LoadMeasuringDevice<>>(port, NodeId{13}, LoadHardware{});
       }},
      {"sensor unit",
       [](const Port& port) {
         return hold<SensorUnitDevice<8>>(port, NodeId{14}, SensorSettings{});
       }},
      {"car panel",
       [](const Port& port) {
         return hold<CarPanelDevice<>>(port, NodeId{16}, OutputHardware{},
                                       CarPanel{.highest_floor = 4});
       }},
      {"landing panel",
       [](const Port& port) {
         return hold<LandingPanelDevice<>>(port, NodeId{21}, OutputHardware{},
                                           LandingPanel{.highest_floor = 4});
       }},
      {"lift controller",
       [](const Port& port) {
         return hold<LiftControllerDevice<>>(port, NodeId{1}, small_lift());
       }},
      {"group member",
       [](const Port& port) {
         return std::unique_ptr<AnyDevice>(std::make_unique<HeldGroupMember>(port));
       }},
      {"group controller",
       [](const Port& port) {
         return hold<GroupControllerDevice<>>(port, GroupControllerSettings{});
       }},
  };
  return all;
}

}  // namespace canvoy
