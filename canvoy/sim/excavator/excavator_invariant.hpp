// What must hold in an excavator, whatever happens, and by how much it did.
#pragma once

#include <bitset>
#include <cstdint>
#include <span>

#include "canvoy/sim/invariant.hpp"

namespace canvoy::excavator {

enum class InvariantKind : std::uint8_t {
  unwanted_motion,  ///< the longest time that it moved as no hand wanted it; in s
  lost_seat,        ///< the longest time that it moved after the seat was heard last; in s
  lost_host,        ///< the same of the host; in s
  lost_armrest,     ///< the same of the armrest behind the seat; in s
  presses,          ///< of buttons, that had not one effect each; and effects that nobody pressed
  axis_delta,       ///< how far the host's value of an axis was from the stick; in digits
  indicators,       ///< the longest time that a lamp said what is not so; in s
  display,          ///< the same of the display; in s
  service,          ///< the longest time of work in which no earth came to the heap; in s
  device_missing,   ///< the longest time that a device was not operational without an excuse; in s
};
inline constexpr std::size_t invariant_kinds =
    static_cast<std::size_t>(InvariantKind::device_missing) + 1;
using InvariantSet = std::bitset<invariant_kinds>;

/// All kinds, in the order of InvariantKind.
std::span<const InvariantName> invariant_names();
const InvariantName& invariant_name(InvariantKind kind);

using Invariant = canvoy::Invariant<InvariantKind>;

}  // namespace canvoy::excavator
