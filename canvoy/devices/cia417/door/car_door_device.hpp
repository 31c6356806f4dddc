// A whole car door unit of CiA 417-4, for one door or several.
//
//     constexpr LiftDeviceOptions door_2 = {.doors = 0b0010};
//     CarDoorDevice<door_2> door(port, 7, hardware);
//     door.node().start(now);
#pragma once

#include <array>
#include <bit>
#include <type_traits>
#include <utility>

#include "canvoy/devices/cia417/door/car_door_unit.hpp"
#include "canvoy/devices/cia417/kit/lift_kind.hpp"
#include "canvoy/profiles/cia417/watched_nodes.hpp"

namespace canvoy::cia417 {

/// The configuration of a door of the device. Doors that the device does not have give that of its
/// first one.
constexpr std::uint16_t configuration_of(unsigned doors, unsigned door) {
  const bool is_there = (doors >> (door - 1) & 1) != 0;
  const unsigned number = is_there ? door : static_cast<unsigned>(std::countr_zero(doors)) + 1;
  return static_cast<std::uint16_t>(door_configuration_object.index + number - 1);
}

/// The units of several doors in one device.
template <unsigned mask>
class CarDoors {
 public:
  /// Number of doors of the mask, up to 4.
  static constexpr std::size_t doors_max = std::popcount(mask & 0xFU);
  /// One for each door, from the lowest number on.
  using AllHardware = std::array<DoorHardware, doors_max>;

  /// `hardware` has one entry for each door, in their order.
  CarDoors(Node& node, const AllHardware& hardware, const CarDoorSettings& settings)
      : doors_(make(node, hardware, settings, std::make_index_sequence<doors_max>())) {}

  /// The n-th door of this device, from 0.
  CarDoorUnit& door(std::size_t position) { return doors_[position]; }

 private:
  static constexpr CarDoorSettings of_door(CarDoorSettings settings, std::size_t position) {
    unsigned doors = mask;
    for (; position > 0; --position) doors &= doors - 1;
    settings.door = static_cast<unsigned>(std::countr_zero(doors)) + 1;
    return settings;
  }
  template <std::size_t... position>
  static std::array<CarDoorUnit, doors_max> make(Node& node, const AllHardware& hardware,
                                                 const CarDoorSettings& settings,
                                                 std::index_sequence<position...>) {
    return {CarDoorUnit(node, hardware[position], of_door(settings, position))...};
  }

  std::array<CarDoorUnit, doors_max> doors_;
};

namespace detail {

template <unsigned mask>
inline constexpr bool is_one_door = std::has_single_bit(mask & 0xFU);
template <unsigned mask>
using DoorUnits = std::conditional_t<is_one_door<mask>, CarDoorUnit, CarDoors<mask>>;
template <unsigned mask>
using DoorHardwares =
    std::conditional_t<is_one_door<mask>, DoorHardware, typename CarDoors<mask>::AllHardware>;

}  // namespace detail

/// Every object of the virtual device, a heartbeat every 500 ms, and a monitored controller. A
/// maker has a separate description with its own identity.
template <LiftDeviceOptions options = first_door>
struct CarDoorKind : LiftKind<detail::DoorUnits<options.doors>,
                              detail::DoorHardwares<options.doors>, CarDoorSettings> {
  static constexpr DeviceInfo info = {.name = "lift-door",
                                      .title = "car door unit",
                                      .product = "Canvoy CiA 417 car door unit",
                                      .product_code = 41705,
                                      .node_id = 6,
                                      .hardware = "the door: its drive, its lock, what it senses"};
  static constexpr auto description =
      describe(lift_device<VirtualDevice::car_door_unit, options>(
                   {0x6300, 0x6301, 0x6302, configuration_of(options.doors, 1),
                    configuration_of(options.doors, 2), configuration_of(options.doors, 3),
                    configuration_of(options.doors, 4), 0x6310}),
               lift_basics(info, 500), watched_nodes<1000, 1>,
               cia301::error_behavior().initial(1, keeps_state));

  /// Lift and door are those of `options`.
  static constexpr CarDoorSettings fit(CarDoorSettings settings) {
    settings.lift = options.lift;
    settings.door = static_cast<unsigned>(std::countr_zero(options.doors)) + 1;
    return settings;
  }
};

/// `layout` has a description with the objects of a car door unit for `options`.
template <LiftDeviceOptions options = first_door,
          const auto& layout = layout_of<CarDoorKind<options>>, std::size_t own_routes = 0>
using CarDoorDevice = Device<CarDoorKind<options>, layout, own_routes>;

}  // namespace canvoy::cia417
