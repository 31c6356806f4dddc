// The faults of a taxi.
//
//     ScheduledFault fault{.kind = FaultKind::lost_node, .start = Time(20min), .node = 2};
#pragma once

#include "canvoy/profiles/cia447/network.hpp"
#include "canvoy/sim/fault.hpp"

namespace canvoy::taxi {

inline constexpr NodeId taximeter_id = 2;  ///< node-ID of the taximeter

/// What can break; fault_rows says what each kind does, and where by default.
enum class FaultKind : std::uint8_t {
  lost_node,
  restart,
  cable_cut,
  babbling_node,
  corrupted_frames,
  wheel_signal,
  paper_out,
  no_fix,
  stranger_writes,
  extra_pulses,
  seal_opened,
  wrong_k,
  clock_drift
};

/// Harmless: one device lacks its supply, and must report it, or frames are sent again; all goes
/// on.
inline constexpr FaultRow fault_rows[] = {
    {"lost-node",
     "a device has no power (default: the taximeter)",
     {.is_at_node = true, .node = taximeter_id}},
    {"restart",
     "a device boots again (default: the taximeter)",
     {.is_at_node = true, .node = taximeter_id, .is_over_at_once = true}},
    {"cable-cut",
     "the bus cable is cut behind a device (default: the gateway)",
     {.is_at_node = true, .node = cia447::gateway_node_id}},
    {"babbling-node", "a stranger fills the bus with frames of the highest priority"},
    {"corrupted-frames",
     "one frame in a hundred is disturbed, and sent again",
     {.is_harmless = true}},
    {"wheel-signal", "the wheel pulse counter does not know how far the car has gone"},
    {"paper-out", "the printer has no paper", {.is_harmless = true}},
    {"no-fix", "the GPS receiver sees no satellites", {.is_harmless = true}},
    {"stranger-writes",
     "a stranger on the bus writes pulses and time into the taximeter",
     {.is_tampering = true}},
    {"extra-pulses",
     "pulses of a metre a second are added to those of the wheels",
     {.is_tampering = true}},
    {"seal-opened", "the seal of the taximeter is opened", {.is_tampering = true}},
    {"wrong-k",
     "the car has smaller wheels than those that the taximeter was sealed for",
     {.is_tampering = true}},
    {"clock-drift", "the real time clock on the bus gains a minute in ten", {.is_tampering = true}},
};
static_assert(std::size(fault_rows) == static_cast<std::size_t>(FaultKind::clock_drift) + 1);
/// The faults without fraud.
inline constexpr std::size_t fault_kinds = untampered_kinds(fault_rows);
static_assert(fault_kinds == static_cast<std::size_t>(FaultKind::no_fix) + 1);
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

}  // namespace canvoy::taxi
