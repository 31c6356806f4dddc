// All that is judged in a shift of an excavator: the referee is told what hands, machine, lamps,
// display and nodes do, and what excuses it.
//
//     ExcavatorReferees referees(world, options, {machine, panel, valves, driver}, devices, watch);
//     referees.look_at_axes(now);    // each step, before hands move
//     referees.look(now);            // and when the machine has moved
//     for (const Invariant& invariant : referees.verdicts()) ok = ok && invariant.held;
#pragma once

#include <array>
#include <vector>

#include "canvoy/sim/bus_watch.hpp"
#include "canvoy/sim/excavator/cab_truth.hpp"
#include "canvoy/sim/excavator/excavator_devices.hpp"
#include "canvoy/sim/excavator/excavator_event.hpp"
#include "canvoy/sim/excavator/excavator_operator.hpp"
#include "canvoy/sim/excavator/excavator_referee.hpp"

namespace canvoy::excavator {

/// What they look at.
struct ExcavatorTruth {
  const Excavator& machine;
  const SeatPanel& panel;
  const ValvesHardware& valves;
  const ExcavatorOperator& driver;
};

class ExcavatorReferees {
 public:
  /// All must outlive this. `watch` hears the bus of the machine.
  ExcavatorReferees(const World& world, const ExcavatorOptions& options,
                    const ExcavatorTruth& truth, ExcavatorDevices& devices, const BusWatch& watch);
  ExcavatorReferees(const ExcavatorReferees&) = delete;
  ExcavatorReferees& operator=(const ExcavatorReferees&) = delete;

  /// Frames on the bus of the machine, and on that behind the seat.
  void hear(Time now, const Frame& frame);
  void hear_behind(Time now, const Frame& frame);
  /// A button goes down.
  void pressed(Time now, Button button) { referee_.pressed(now, button); }
  /// What it is for was switched.
  void switched(Time now, Button button, bool is_on);
  void fault_begins(Time now, FaultKind kind);
  void fault_ends(Time now, FaultKind kind);

  /// What a stick was at in one of the last steps has been told by now.
  void look_at_axes(Time now);
  void look(Time now);

  std::vector<Invariant> verdicts() const { return referee_.verdicts(); }
  /// Those that are broken since this was asked last, each once.
  std::vector<Invariant> take_broken();

 private:
  void look_at_lamps(Time now);
  bool is_served(Time now);
  bool is_locked_in_sight(Time now);
  bool is_armrest_at_work(Time now);

  const World* world_;
  const ExcavatorOptions* options_;
  const Excavator* machine_;
  const SeatPanel* panel_;
  const ExcavatorOperator* driver_;
  ExcavatorDevices* devices_;
  const BusWatch* watch_;
  ExcavatorReferee referee_;
  CabTruth cab_;
  double heaped_ = 0;             ///< at the last step
  unsigned seat_starts_ = 0;      ///< as they were seen
  bool seat_was_set_up_ = false;  ///< since it has power
  bool had_fault_ = false;        ///< of the plan, since the start
  bool is_out_of_step_ = false;   ///< a recorded shift, since a fault has locked the hydraulics
  /// Where each stick was in the last steps: what is told now is one of these.
  std::array<std::array<double, 3>, stick_count> axes_{};
  std::array<bool, invariant_kinds> told_{};
};

}  // namespace canvoy::excavator
