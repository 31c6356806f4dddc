// Invariants of the network of a battery and its charger: what must hold whatever happens, and by
// what margin it held.
#pragma once

#include "canvoy/sim/invariant.hpp"

namespace canvoy::charger {

/// What must hold; invariant_rows has name, unit and source of the bound of each.
enum class InvariantKind : std::uint8_t {
  ampere_hours,
  energy,
  current_outside_handshake,
  current_before_ready,
  battery_left_waiting,
  less_than_asked,
  more_than_asked,
  charged_hot_or_cold,
  over_voltage,
  fault_seen
};

/// All kinds, in the order of InvariantKind.
inline constexpr InvariantRow invariant_rows[] = {
    {"ampere_hours", "ampere-hours of charger and plant differ by", "%", "canvoy"},
    {"energy", "energy of charger and plant differs by", "%", "canvoy"},
    {"current_outside_handshake", "current outside of a handshake for at most", "s", "canvoy"},
    {"current_before_ready", "currents that began before ready", "", "canvoy"},
    {"battery_left_waiting", "battery left without current for at most", "s", "canvoy"},
    {"less_than_asked", "missing of the charge that was asked for", "%", "canvoy"},
    {"more_than_asked", "more current than the battery asked for, for at most", "s", "canvoy"},
    {"charged_hot_or_cold", "current into cells too hot or too cold for at most", "s", "canvoy"},
    {"over_voltage", "current into cells above their voltage limit for at most", "s", "canvoy"},
    {"fault_seen", "seen after", "s", "canvoy"},
};
/// Number of invariants.
inline constexpr std::size_t invariant_kinds = std::size(invariant_rows);
static_assert(invariant_kinds == static_cast<std::size_t>(InvariantKind::fault_seen) + 1);
/// The rows of the table above; found by the type of the argument.
constexpr std::span<const InvariantRow> rows_of(InvariantKind) {
  return invariant_rows;
}

/// Verdict on one invariant: whether it held, and by what margin.
using Invariant = canvoy::Invariant<InvariantKind>;

}  // namespace canvoy::charger
