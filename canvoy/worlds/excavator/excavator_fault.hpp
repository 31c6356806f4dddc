// The faults of an excavator.
//
//     ScheduledFault fault{.kind = FaultKind::stuck_axis, .start = Time(20min), .spot = 4};
#pragma once

#include "canvoy/sim/fault.hpp"
#include "canvoy/worlds/excavator/armrest_watch.hpp"
#include "canvoy/worlds/excavator/excavator_invariant.hpp"
#include "canvoy/worlds/excavator/host_objects.hpp"
#include "canvoy/worlds/excavator/seat_panel.hpp"

namespace canvoy::excavator {

/// What can break; fault_rows says what each kind does, and where by default.
enum class FaultKind : std::uint8_t {
  lost_node,
  restart,
  bus_off,
  cable_cut,
  babbling_node,
  corrupted_frames,
  lost_frames,
  delayed_frames,
  stuck_axis,
  broken_wire,
  vanished_armrest,
  emergency_stop,  ///< at the armrest
  seat_switch,     ///< it stays open
  drifting_axis    ///< of the two sensors of an axis the first one
};

/// A fault of a device; of the host, unless a plan names another one.
inline constexpr FaultTraits at_a_node{.is_at_node = true, .node = host_id};
/// A fault of an axis, 1 to 4; of the last one, the boom, unless a plan names another one.
inline constexpr FaultTraits at_a_stick{.is_at_spot = true, .spot = stick_count};
/// Name in a file, text, and place of each kind, in the order of FaultKind.
inline constexpr FaultRow fault_rows[] = {
    {"lost-node", "a device has no power (default: the host)", at_a_node},
    {"restart",
     "a device boots again (default: the host)",
     {.is_at_node = true, .node = host_id, .is_over_at_once = true}},
    {"bus-off", "a device has the wrong bit rate, until it gives up (default: the host)",
     at_a_node},
    {"cable-cut", "the bus cable is cut behind a device (default: the host)", at_a_node},
    {"babbling-node", "a stranger fills the bus with frames of the highest priority"},
    {"corrupted-frames", "one frame in a hundred is disturbed, and sent again"},
    {"lost-frames", "one in twenty frames of a device is lost (default: the host)", at_a_node},
    {"delayed-frames", "all frames of a device come 20 ms late (default: the host)", at_a_node},
    {"stuck-axis", "one of the two sensors of a stick stays where it is (default: axis 4, boom)",
     at_a_stick},
    {"broken-wire", "the wire of a stick's sensor is broken (default: axis 4, boom)", at_a_stick},
    {"vanished-armrest",
     "the device on the network behind the seat has no power",
     {.node = armrest_id}},
    {"emergency-stop",
     "the emergency stop is pressed, and pulled at the end",
     {.node = armrest_id}},
    {"seat-switch", "the seat switch says that the seat is empty", {.node = armrest_id}},
    {"drifting-axis",
     "one of the two sensors of a stick is off by a quarter (default: axis 4, boom)", at_a_stick},
};
/// Number of kinds of faults.
inline constexpr std::size_t fault_kinds = std::size(fault_rows);
static_assert(fault_kinds == static_cast<std::size_t>(FaultKind::drifting_axis) + 1);
/// How a plan names places: `node=` and `axis=`.
inline constexpr FaultPlaceName fault_places[] = {{"node", node_id_max},
                                                  {"axis", stick_count, &AnyFault::spot}};
/// How a plan of these faults is written and read; found by the type of its argument.
constexpr FaultGrammar grammar_of(FaultKind) {
  return {fault_rows, fault_places};
}

/// A fault of a plan: kind, place, begin and end.
using ScheduledFault = canvoy::ScheduledFault<FaultKind>;
/// The faults of a run, and the seed of all chance.
using FaultPlan = canvoy::FaultPlan<FaultKind>;

/// Invariants that may be broken as the fault begins, and as it ends, until it is found.
InvariantSet affected_at_first(FaultKind kind);
/// Invariants that cannot hold while the fault is present, and for a time after it.
InvariantSet affected_by(FaultKind kind);

}  // namespace canvoy::excavator
