// A whole car door controller of CiA 417-4: its dictionary, its node with all services, and its
// behaviour. A lift controller has a CarDoorController of its own beside its other virtual devices.
//
//     CarDoorControllerDevice<> doors(port, 1, {.doors = 0b0011});
//     doors.controller().open(0b01);
#pragma once

#include <utility>

#include "canvoy/canopen/device_node.hpp"
#include "canvoy/devices/cia417/bus_warning.hpp"
#include "canvoy/devices/cia417/car_door_controller.hpp"
#include "canvoy/devices/cia417/lift_number.hpp"
#include "canvoy/profiles/cia417/lift_device.hpp"
#include "canvoy/profiles/cia417/watched_nodes.hpp"
#include "canvoy/profiles/layout.hpp"

namespace canvoy::cia417 {

/// Every object of the virtual device, a heartbeat each 300 ms, and three doors watched, and
/// room to watch as many nodes as there can be.
template <LiftDeviceOptions options = LiftDeviceOptions{}>
inline constexpr auto full_car_door_controller = describe(
    lift_device<VirtualDevice::car_door_controller, options>({0x6300, 0x6301, 0x6302, 0x6310}),
    cia301::identity({.product_code = 41704}),
    cia301::names({.device = "Canvoy CiA 417 door controller",
                   .hardware_version = "simulated",
                   .software_version = "0.1.0"}),
    cia301::sync_consumer(), cia301::heartbeat_producer(300),
    watched_nodes<1500, 6, 7, 8, 0, 0, 0, 0, 0>, cia301::emergency(), cia301::error_history(8),
    cia301::error_behavior().initial(1, keeps_state));
template <LiftDeviceOptions options = LiftDeviceOptions{}>
inline constexpr auto full_car_door_controller_layout =
    in_any_lift(lay_out_device<full_car_door_controller<options>>());

/// `layout` is that of a description with the objects of a car door controller for `options`.
template <LiftDeviceOptions options = LiftDeviceOptions{},
          const auto& layout = full_car_door_controller_layout<options>, std::size_t own_routes = 0>
class CarDoorControllerDevice {
 public:
  /// The lift in `settings` is that of `options`.
  CarDoorControllerDevice(const Port& port, NodeId node_id,
                          const CarDoorControllerSettings& settings = {})
      : device_(port, node_id),
        controller_(device_.node(), settings_of(settings), &device_.rpdos()) {
    device_.heartbeat_consumer().on_change(
        Callback<void(NodeId, RemoteState)>::to<&CarDoorController::heard>(controller_));
  }

  Node& node() { return device_.node(); }
  const Node& node() const { return device_.node(); }
  CarDoorController& controller() { return controller_; }
  const CarDoorController& controller() const { return controller_; }
  EmergencyProducer& emergency_producer() { return device_.emergency_producer(); }

 private:
  void lift_changed(std::uint8_t lift) {
    if (std::exchange(lift_, lift) != lift) controller_.begin_anew();
  }
  static constexpr CarDoorControllerSettings settings_of(CarDoorControllerSettings settings) {
    settings.lift = options.lift;
    return settings;
  }

  std::uint8_t lift_ = lift_bit(options.lift);
  DeviceNode<layout, own_routes> device_;
  BusWarning bus_warning_{device_.node()};
  LiftNumber lift_number_{
      device_.node(),
      {.changed = Callback<void(std::uint8_t)>::template to<&CarDoorControllerDevice::lift_changed>(
           *this)}};
  CarDoorController controller_;
};

}  // namespace canvoy::cia417
