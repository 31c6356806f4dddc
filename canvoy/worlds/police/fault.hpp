// The faults of a police car.
//
//     ScheduledFault fault{.kind = FaultKind::lost_node, .start = Time(20min), .node = 2};
#pragma once

#include "canvoy/profiles/cia447/network.hpp"
#include "canvoy/sim/fault.hpp"

namespace canvoy::police {

inline constexpr NodeId terminal_id = 2;  ///< node-ID of the terminal

/// What can break; fault_rows says what each kind does, and where by default.
enum class FaultKind : std::uint8_t {
  lost_node,
  restart,
  cable_cut,
  babbling_node,
  corrupted_frames,
  burnt_lamp,
  overload,
  dead_client
};

/// Harmless: everything must work in spite of it.
inline constexpr FaultRow fault_rows[] = {
    {"lost-node",
     "a device has no power (default: the terminal)",
     {.is_at_node = true, .node = terminal_id}},
    {"restart",
     "a device boots again (default: the terminal)",
     {.is_at_node = true, .node = terminal_id, .is_over_at_once = true}},
    {"cable-cut",
     "the bus cable is cut behind a device (default: the gateway)",
     {.is_at_node = true, .node = cia447::gateway_node_id}},
    {"babbling-node", "a stranger fills the bus with frames of the highest priority"},
    {"corrupted-frames",
     "one frame in a hundred is disturbed, and sent again",
     {.is_harmless = true}},
    {"burnt-lamp", "a blue flasher in front gives no light", {.is_harmless = true}},
    {"overload", "the power supply has no power for the radio"},
    {"dead-client", "who holds the number pad next has no power from then on"},
};
/// Number of kinds of faults.
inline constexpr std::size_t fault_kinds = std::size(fault_rows);
static_assert(fault_kinds == static_cast<std::size_t>(FaultKind::dead_client) + 1);
/// How a plan names places: `node=`, 1 to 16.
inline constexpr FaultPlaceName fault_places[] = {{"node", cia447::node_id_max}};
/// How a plan of these faults is written and read; found by the type of its argument.
constexpr FaultGrammar grammar_of(FaultKind) {
  return {fault_rows, fault_places};
}

/// A fault of a plan: kind, place, begin and end.
using ScheduledFault = canvoy::ScheduledFault<FaultKind>;
/// The faults of a run, and the seed of all chance.
using FaultPlan = canvoy::FaultPlan<FaultKind>;

}  // namespace canvoy::police
