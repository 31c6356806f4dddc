// Invariants of an excavator: what must hold whatever happens, and by what margin it held.
#pragma once

#include <bitset>

#include "canvoy/sim/invariant.hpp"

namespace canvoy::excavator {

/// What must hold; invariant_rows has name, unit and source of the bound of each.
enum class InvariantKind : std::uint8_t {
  unwanted_motion,
  lost_seat,
  lost_host,
  lost_armrest,
  presses,
  axis_delta,
  indicators,
  display,
  throttle,
  service,
  spilled,
  device_missing
};

/// All kinds, in the order of InvariantKind.
inline constexpr InvariantRow invariant_rows[] = {
    {"unwanted_motion", "the machine moved as no hand wanted it for at most", "s", "canvoy"},
    {"lost_seat", "the machine moved without a sign of the seat for at most", "s", "canvoy"},
    {"lost_host", "the machine moved without a sign of the host for at most", "s", "canvoy"},
    {"lost_armrest", "the machine moved without a sign of the armrest for at most", "s", "canvoy"},
    {"presses", "presses without their one effect, or effects without a press", "", "canvoy"},
    {"axis_delta", "an axis was away from the host's value by at most", "digits", "canvoy"},
    {"indicators", "a lamp said what is not so for at most", "s", "canvoy"},
    {"display", "the display said what is not so for at most", "s", "canvoy"},
    {"throttle", "the engine had another throttle than its wheel for at most", "s", "canvoy"},
    {"service", "no earth came to the heap at work for at most", "s", "canvoy"},
    {"spilled", "of the earth that was dug, beside the heap", "%", "canvoy"},
    {"device_missing", "a device was missing without an excuse for at most", "s", "canvoy"},
};
/// Number of invariants.
inline constexpr std::size_t invariant_kinds = std::size(invariant_rows);
static_assert(invariant_kinds == static_cast<std::size_t>(InvariantKind::device_missing) + 1);
/// The rows of the table above; found by the type of the argument.
constexpr std::span<const InvariantRow> rows_of(InvariantKind) {
  return invariant_rows;
}

/// A bit for each InvariantKind.
using InvariantSet = std::bitset<invariant_kinds>;
/// Verdict on one invariant: whether it held, and by what margin.
using Invariant = canvoy::Invariant<InvariantKind>;

}  // namespace canvoy::excavator
