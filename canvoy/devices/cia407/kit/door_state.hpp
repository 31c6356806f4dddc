// Single doors in 6488h, by their number (CiA 407, 9.2.15.7): four in a byte, the first in the
// highest bits.
//
//     if (door_state(dictionary, 3).is_open) ...
#pragma once

#include "canvoy/canopen/dictionary/dictionary.hpp"
#include "canvoy/profiles/cia407/handles.hpp"

namespace canvoy::cia407 {

struct DoorState {
  bool is_valid = false;  ///< the door exists, and its state is known
  bool is_open = false;   ///< wholly or partly

  friend constexpr bool operator==(const DoorState&, const DoorState&) = default;
};

/// `number` is 1 to doors_max.
inline DoorState door_state(const Dictionary& dictionary, unsigned number) {
  const unsigned bits =
      dictionary.word(state_of_doors_object.index, static_cast<std::uint8_t>(door_sub(number)));
  const unsigned shift = 6 - 2 * ((number - 1) % 4);
  return {.is_valid = (bits >> shift & 1) != 0, .is_open = (bits >> shift & 2) != 0};
}
/// The two bits of a door at their position in its byte.
constexpr std::uint8_t door_bits(unsigned number, DoorState state) {
  const unsigned bits = (state.is_open ? 2U : 0U) | (state.is_valid ? 1U : 0U);
  return static_cast<std::uint8_t>(bits << (6 - 2 * ((number - 1) % 4)));
}

}  // namespace canvoy::cia407
