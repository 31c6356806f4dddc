// Inputs and outputs of landing and car panels, as records for their units (CiA 417-4, 4.3.1 and
// 4.4.1): call buttons with their lamps, keys, position, lanterns, special indications, a gong.
//
//     std::array<VirtualInput, 3> inputs;
//     const auto used = landing_inputs({.floor = 3, .highest_floor = 10}, inputs);
//
// The lamp that acknowledges a button has the position of the button among the outputs.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "canvoy/devices/cia417/virtual_io/virtual_io.hpp"

namespace canvoy::cia417 {

/// A panel of a landing.
struct LandingPanel {
  std::uint8_t lifts = lift_bit(1);  ///< its lifts: in a group, all that serve the floor
  std::uint8_t floor = 1;            ///< of the landing, from 1
  std::uint8_t doors = 0b0001;       ///< doors beside which it is mounted: bit 0 is door 1
  /// Floors of the building: there is no button up at the highest, none down at the lowest.
  std::uint8_t lowest_floor = 1;
  std::uint8_t highest_floor = 254;  ///< of the building: no call goes up from it
  /// Buttons for destination floors instead of up and down: destination control.
  bool destinations = false;
  bool fire_key = false;  ///< a key switch for fire service

  friend constexpr bool operator==(const LandingPanel&, const LandingPanel&) = default;
};

/// A panel of a car.
struct CarPanel {
  unsigned lift = 1;                 ///< 1 to 8
  std::uint8_t doors = 0b0001;       ///< doors of the exits: bit 0 is door 1
  std::uint8_t lowest_floor = 1;     ///< with a button
  std::uint8_t highest_floor = 254;  ///< with a button
  bool keys = true;                  ///< key switches for fire, attendant and VIP service

  friend constexpr bool operator==(const CarPanel&, const CarPanel&) = default;
};

/// Maximum number on a landing: a button for each floor, or up and down; a key.
inline constexpr std::size_t landing_outputs_more = 5;
/// Inputs of a landing's panel at most. `floors` of the building count only with a button for each
/// destination.
constexpr std::size_t landing_inputs_max(std::size_t floors, bool destinations) {
  return (destinations ? floors : 2) + 1;
}
/// Outputs of a landing's panel at most; arguments as above.
constexpr std::size_t landing_outputs_max(std::size_t floors, bool destinations) {
  return landing_inputs_max(floors, destinations) + landing_outputs_more;
}
/// Maximum number in a car: a button for each floor, door open and door close, three keys.
inline constexpr std::size_t car_outputs_more = 4;
/// Inputs of a car panel at most, with buttons for so many floors.
constexpr std::size_t car_inputs_max(std::size_t floors) {
  return floors + 5;
}
/// Outputs of a car panel at most, with buttons for so many floors.
constexpr std::size_t car_outputs_max(std::size_t floors) {
  return car_inputs_max(floors) + car_outputs_more;
}

/// Writes the inputs of a panel, as far as there is room, and returns them. First come calls, from
/// the lowest floor on or up before down; then doors, and keys.
std::span<const VirtualInput> landing_inputs(const LandingPanel& panel,
                                             std::span<VirtualInput> inputs);
/// Records of the inputs of a car panel, in `inputs`; as many as fit.
std::span<const VirtualInput> car_inputs(const CarPanel& panel, std::span<VirtualInput> inputs);

/// Writes the outputs of a panel like landing_inputs(). After the lamps of the inputs, a landing
/// has position indicator, hall lantern, direction, special indications and gong; a car has
/// position indicator, direction, special indications and gong.
std::span<const VirtualOutput> landing_outputs(const LandingPanel& panel,
                                               std::span<VirtualOutput> outputs);
/// Records of the outputs of a car panel, in `outputs`; as many as fit.
std::span<const VirtualOutput> car_outputs(const CarPanel& panel, std::span<VirtualOutput> outputs);

}  // namespace canvoy::cia417
