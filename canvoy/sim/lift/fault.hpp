// What goes wrong in a building with lifts, when and where: a plain struct of options.
//
//     LiftFaultPlan plan{.faults = {{.kind = FaultKind::dead_encoder, .start = Time(5min),
//                                    .duration = 30s, .lift = 2}}};
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "canvoy/can/time.hpp"
#include "canvoy/sim/fault.hpp"
#include "canvoy/sim/lift/building.hpp"

namespace canvoy::lift {

enum class FaultKind : std::uint8_t {
  lost_node,         ///< a node of the lift has no power
  cable_cut,         ///< the cable of the lift is cut behind a node
  stuck_button,      ///< a button of a landing or of the car is held down
  light_barrier,     ///< it is broken, and says so
  dead_encoder,      ///< the position unit measures nothing any more
  babbling_node,     ///< a panel sends as fast as the bus lets it
  fire_alarm,        ///< no fault of the lift, but nobody may stay in it: a key switch is turned
  fire_brigade,      ///< the fire brigade calls a lift to the fire floor, and takes it over there
  finger_protector,  ///< of a door; it is broken, and says so
  motion_detector,   ///< of a door; it is broken, and says so
  door_lock,         ///< it springs open, and the safety chain with it
  safety_contact,    ///< of a door; it does not close, nor does the safety chain
  brake,             ///< it holds nothing: a car that is not balanced moves when it should stand
  rope_slip,         ///< the ropes slip on the sheave by a tenth of the way
  rope_sensor,       ///< the load unit does not know what a rope carries
  runaway,           ///< the motor gets faster whatever the drive wants
  smoke,             ///< in the light barriers, which see somebody always
};

/// All kinds, in the order of FaultKind, and the places `lift=`, `group`, `node=` and `floor=`.
FaultGrammar fault_grammar();
std::string_view fault_name(FaultKind kind);
/// One of a door of the car.
bool is_of_door(FaultKind kind);

struct ScheduledFault {
  FaultKind kind = FaultKind::lost_node;
  Time start{};
  Duration duration = for_the_rest;
  LiftNumber lift = 1;  ///< 0: the group; of a fire alarm all
  /// Node-ID on the bus of the lift, or of the group; of a fault of a door that of its unit; 0: the
  /// first one that suits the kind.
  std::uint8_t node = 0;
  /// stuck_button: of that landing; 0: in the car, for the main floor.
  FloorNumber floor = no_floor;

  Time end() const { return end_of_fault(start, duration); }
  friend bool operator==(const ScheduledFault&, const ScheduledFault&) = default;
};

ScheduledFault scheduled(const WrittenFault& fault);
WrittenFault written(const ScheduledFault& fault);

/// Faults of one lift after the other, and of the group where there are several lifts, drawn by a
/// seed: one at a time, and time to recover.
std::vector<ScheduledFault> random_faults(const Building& building, Time from, Time until,
                                          std::uint64_t seed);
/// The same, each of them with a second one that begins with it, while it lasts, or as it ends. Of
/// every fourth seed the first two begin at time 0, when nobody has been heard.
std::vector<ScheduledFault> random_fault_pairs(const Building& building, Time from, Time until,
                                               std::uint64_t seed);

}  // namespace canvoy::lift
