// A whole car door unit of CiA 417-4, for one door or several: its dictionary, its node with all
// services, and its behaviour.
//
//     constexpr LiftDeviceOptions door_2 = {.doors = 0b0010};
//     CarDoorDevice<door_2> door(port, 7, {hardware});
//     door.node().start(now);
#pragma once

#include <array>
#include <bit>
#include <span>
#include <utility>

#include "canvoy/canopen/device_node.hpp"
#include "canvoy/devices/cia417/bus_warning.hpp"
#include "canvoy/devices/cia417/car_door_unit.hpp"
#include "canvoy/devices/cia417/lift_number.hpp"
#include "canvoy/profiles/cia417/lift_device.hpp"
#include "canvoy/profiles/cia417/watched_nodes.hpp"
#include "canvoy/profiles/layout.hpp"

namespace canvoy::cia417 {

inline constexpr LiftDeviceOptions first_door = {.doors = 0b0001};

/// The configuration of a door of the device, or again that of its first one.
constexpr std::uint16_t configuration_of(unsigned doors, unsigned door) {
  const bool is_there = (doors >> (door - 1) & 1) != 0;
  const unsigned number = is_there ? door : static_cast<unsigned>(std::countr_zero(doors)) + 1;
  return static_cast<std::uint16_t>(door_configuration_object.index + number - 1);
}

/// Every object of the virtual device, a heartbeat each 500 ms, and the controller watched. A maker
/// has a description of his own with his identity.
template <LiftDeviceOptions options = first_door>
inline constexpr auto full_car_door =
    describe(lift_device<VirtualDevice::car_door_unit, options>(
                 {0x6300, 0x6301, 0x6302, configuration_of(options.doors, 1),
                  configuration_of(options.doors, 2), configuration_of(options.doors, 3),
                  configuration_of(options.doors, 4), 0x6310}),
             cia301::identity({.product_code = 41705}),
             cia301::names({.device = "Canvoy CiA 417 car door unit",
                            .hardware_version = "simulated",
                            .software_version = "0.1.0"}),
             cia301::sync_consumer(), cia301::heartbeat_producer(500), watched_nodes<1000, 1>,
             cia301::emergency(), cia301::error_history(8),
             cia301::error_behavior().initial(1, keeps_state));
template <LiftDeviceOptions options = first_door>
inline constexpr auto full_car_door_layout = in_any_lift(lay_out_device<full_car_door<options>>());

/// `layout` is that of a description with the objects of a car door unit for `options`.
template <LiftDeviceOptions options = first_door,
          const auto& layout = full_car_door_layout<options>, std::size_t own_routes = 0>
class CarDoorDevice {
 public:
  static constexpr std::size_t doors_max = std::popcount(options.doors & 0xFU);

  /// `hardware` has one for each door, in their order; what it refers to must outlive the device.
  /// Lift and door in `settings` are those of `options`.
  CarDoorDevice(const Port& port, NodeId node_id,
                const std::array<DoorHardware, doors_max>& hardware,
                const CarDoorSettings& settings = {})
      : device_(port, node_id),
        doors_(make(hardware, settings, std::make_index_sequence<doors_max>())) {}

  Node& node() { return device_.node(); }
  const Node& node() const { return device_.node(); }
  /// The n-th door of this device, from 0 on.
  CarDoorUnit& door(std::size_t position = 0) { return doors_[position]; }
  const CarDoorUnit& door(std::size_t position = 0) const { return doors_[position]; }
  EmergencyProducer& emergency_producer() { return device_.emergency_producer(); }

 private:
  static constexpr CarDoorSettings settings_of(CarDoorSettings settings, std::size_t position) {
    settings.lift = options.lift;
    unsigned doors = options.doors;
    for (; position > 0; --position) doors &= doors - 1;
    settings.door = static_cast<unsigned>(std::countr_zero(doors)) + 1;
    return settings;
  }
  template <std::size_t... position>
  std::array<CarDoorUnit, doors_max> make(const std::array<DoorHardware, doors_max>& hardware,
                                          const CarDoorSettings& settings,
                                          std::index_sequence<position...>) {
    return {CarDoorUnit(device_.node(), hardware[position], settings_of(settings, position))...};
  }

  DeviceNode<layout, own_routes> device_;
  BusWarning bus_warning_{device_.node()};
  LiftNumber lift_number_{device_.node(), {}};
  std::array<CarDoorUnit, doors_max> doors_;
};

}  // namespace canvoy::cia417
