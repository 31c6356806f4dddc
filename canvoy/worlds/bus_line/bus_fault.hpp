// The faults of a bus.
//
//     ScheduledFault fault{.kind = FaultKind::lost_node, .start = Time(20min), .node = 5};
#pragma once

#include "canvoy/sim/fault.hpp"
#include "canvoy/worlds/bus_line/bus_places.hpp"

namespace canvoy::bus_line {

/// What can break; fault_rows says what each kind does, and where by default.
enum class FaultKind : std::uint8_t {
  lost_node,
  restart,
  cable_cut,
  babbling_node,
  corrupted_frames,
  wrong_clock,
  no_satellites,
  broken_door,
  blocked_door,
  no_paper,
  train_bus_cut
};

/// Name in a file, text, and place of each kind, in the order of FaultKind.
inline constexpr FaultRow fault_rows[] = {
    {"lost-node",
     "a device has no power (default: the next stop indicator)",
     {.is_at_node = true, .node = next_stop_id}},
    {"restart",
     "a device boots again (default: the on-board computer)",
     {.is_at_node = true, .node = computer_id, .is_over_at_once = true}},
    {"cable-cut",
     "the bus cable is cut behind a device (default: the on-board computer)",
     {.is_at_node = true, .node = computer_id}},
    {"babbling-node", "a stranger fills the bus with frames of the highest priority"},
    {"corrupted-frames", "one frame in a hundred is disturbed, and sent again"},
    {"wrong-clock", "the clock of the on-board computer is an hour fast"},
    {"no-satellites", "there is no signal of satellites: no position, no time"},
    {"broken-door", "the second door stays as it is"},
    {"blocked-door", "something lies in the second door"},
    {"no-paper", "the ticket printer has no paper"},
    {"train-bus-cut", "the train bus to the second car is cut"},
};
/// Number of kinds of faults.
inline constexpr std::size_t fault_kinds = std::size(fault_rows);
static_assert(fault_kinds == static_cast<std::size_t>(FaultKind::train_bus_cut) + 1);
/// How a plan of these faults is written and read; found by the type of its argument.
constexpr FaultGrammar grammar_of(FaultKind) {
  return {fault_rows, node_place};
}

/// A fault of a plan: kind, place, begin and end.
using ScheduledFault = canvoy::ScheduledFault<FaultKind>;
/// The faults of a run, and the seed of all chance.
using FaultPlan = canvoy::FaultPlan<FaultKind>;

}  // namespace canvoy::bus_line
