// Faults of a building with lifts, and their places.
//
//     FaultPlan plan{.faults = {{FaultKind::dead_encoder, Time(5min), 30s, 2}}};   // of lift 2
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "canvoy/can/time.hpp"
#include "canvoy/sim/fault.hpp"
#include "canvoy/worlds/lift/building.hpp"

namespace canvoy::lift {

/// What can break in a building with lifts; a fault is one of these at a place, for a time.
enum class FaultKind : std::uint8_t {
  lost_node,         ///< a node of the lift has no power
  cable_cut,         ///< the cable of the lift is cut behind a node
  stuck_button,      ///< a button of a landing or of the car is held down
  light_barrier,     ///< it is broken, and reports it
  dead_encoder,      ///< the position unit has no measurement
  babbling_node,     ///< a panel sends as fast as the bus allows
  fire_alarm,        ///< no fault of the lift, but all people leave it: a key switch is turned
  fire_brigade,      ///< the fire brigade calls a lift to the fire floor, and takes it over there
  finger_protector,  ///< of a door; it is broken, and reports it
  motion_detector,   ///< of a door; it is broken, and reports it
  door_lock,         ///< it springs open, and opens the safety chain
  safety_contact,    ///< of a door; it does not close, so that the safety chain stays open
  brake,             ///< it holds nothing: a car without balance moves when it should stand
  rope_slip,         ///< the ropes slip on the sheave by a tenth of the way
  rope_sensor,       ///< the load unit has no measurement of a rope
  runaway,           ///< the motor accelerates whatever the command of the drive
  smoke,             ///< in the light barriers, which are always interrupted
  weak_brake,        ///< it holds the car, but less than it must
};

/// Name in a file, text, and place of each kind, in the order of FaultKind.
inline constexpr FaultRow fault_rows[] = {
    {"lost-node", "a node has no power"},
    {"cable-cut", "the cable of a lift, or of the group, is cut"},
    {"stuck-button", "a button stays pressed"},
    {"light-barrier", "a light barrier is broken"},
    {"dead-encoder", "the position unit measures nothing"},
    {"babbling-node", "a panel, or a lift in the group, sends without a pause"},
    {"fire-alarm", "the car is called to the fire floor; with :group, all cars"},
    {"fire-brigade", "the fire brigade calls a car, and drives it"},
    {"finger-protector", "that of a door is broken, and says so"},
    {"motion-detector", "that of a door is broken, and says so"},
    {"door-lock", "the lock of a door springs open: the safety chain opens"},
    {"safety-contact", "that of a door does not close: the safety chain is open"},
    {"brake", "the brake holds nothing: a car that should stand moves"},
    {"rope-slip", "the ropes slip by a tenth of the way"},
    {"rope-sensor", "the load of a rope is not known"},
    {"runaway", "the motor gets faster whatever the drive wants"},
    {"smoke", "light barriers are always interrupted"},
    {"weak-brake", "the brake holds the car, but less than it must"},
};
inline constexpr std::size_t fault_kinds = std::size(fault_rows);  ///< number of kinds
static_assert(fault_kinds == static_cast<std::size_t>(FaultKind::weak_brake) + 1);
/// The part is the lift, 0: the group, or all for a fire alarm. A node-ID is one on the bus of the
/// lift, or of the group; for a fault of a door that of its unit; 0: the first one that suits the
/// kind. The spot of a stuck button is its landing; 0: it is in the car, for the main floor.
inline constexpr FaultPlaceName fault_places[] = {{"lift", lifts_max, &AnyFault::part},
                                                  {"group", 0, &AnyFault::part},
                                                  {"node", node_id_max},
                                                  {"floor", floors_max, &AnyFault::spot}};
/// How a plan of these faults is written and read.
constexpr FaultGrammar grammar_of(FaultKind) {
  return {fault_rows, fault_places};
}

/// A fault of a plan: kind, place, begin and end.
using ScheduledFault = canvoy::ScheduledFault<FaultKind>;
/// The faults of a run, and the seed of all chance.
using FaultPlan = canvoy::FaultPlan<FaultKind>;

/// True for a fault of a door of the car.
bool is_of_door(FaultKind kind);

/// Draws faults of one lift after the other, and of the group where there are several lifts: one at
/// a time, with time to recover.
std::vector<ScheduledFault> random_faults(const Building& building, Time from, Time until,
                                          std::uint64_t seed);
/// Like random_faults(), but each fault has a second one that begins with it, while it lasts, or as
/// it ends. For every fourth seed the first two begin at time 0, before any node was heard.
std::vector<ScheduledFault> random_fault_pairs(const Building& building, Time from, Time until,
                                               std::uint64_t seed);

}  // namespace canvoy::lift
