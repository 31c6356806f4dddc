// All judgements in a shift of an excavator: it reports to the referee what hands, machine, lamps,
// display and nodes do, and what excuses it.
//
//     ExcavatorReferees referees(world, options, {machine, panel, trainer, valves, driver},
//     devices, watch); referees.look_at_axes(now);    // each step, before hands move
//     referees.look(now);            // and when the machine has moved
//     for (const Invariant& invariant : referees.verdicts()) ok = ok && invariant.held;
#pragma once

#include <array>
#include <vector>

#include "canvoy/sim/bus_watch.hpp"
#include "canvoy/worlds/excavator/cab_truth.hpp"
#include "canvoy/worlds/excavator/excavator_devices.hpp"
#include "canvoy/worlds/excavator/excavator_event.hpp"
#include "canvoy/worlds/excavator/excavator_operator.hpp"
#include "canvoy/worlds/excavator/excavator_referee.hpp"

namespace canvoy::excavator {

/// The objects that the referees compare with.
struct ExcavatorTruth {
  const Excavator& machine;         ///< the truth
  const SeatPanel& panel;           ///< what hands do, and lamps show
  const SeatPanel& trainer;         ///< panel of the second seat
  const ValvesHardware& valves;     ///< what the module drives
  const ExcavatorOperator& driver;  ///< what the operator wants
};

class ExcavatorReferees {
 public:
  /// All must outlive this object. `watch` listens to the bus of the machine.
  ExcavatorReferees(const World& world, const ExcavatorOptions& options,
                    const ExcavatorTruth& truth, ExcavatorDevices& devices, const BusWatch& watch);
  ExcavatorReferees(const ExcavatorReferees&) = delete;
  ExcavatorReferees& operator=(const ExcavatorReferees&) = delete;

  /// Takes frames of the machine's bus, and of the one behind the seat.
  void hear(Time now, const Frame& frame);
  /// Takes a frame of the bus behind the seat.
  void hear_behind(Time now, const Frame& frame);
  /// Call it when a button goes down.
  void pressed(Time now, Button button) { referee_.pressed(now, button); }
  /// Call it when the device of this button was switched.
  void switched(Time now, Button button, bool is_on);
  /// A fault of the plan begins.
  void fault_begins(Time now, FaultKind kind);
  /// A fault of the plan is over.
  void fault_ends(Time now, FaultKind kind);

  /// Judges whether the host has received a position of each stick of one of the last steps.
  void look_at_axes(Time now);
  /// Judges what can be seen at `now`; call it in each step.
  void look(Time now);

  /// Verdicts at present.
  std::vector<Invariant> verdicts() const { return referee_.verdicts(); }
  /// The invariants broken since the last call, each once.
  std::vector<Invariant> take_broken();

 private:
  void excuse_at_first(Time now, FaultKind kind);
  double wanted(Movement movement) const;
  void look_at_lamps(Time now);
  void look_at_throttle(Time now);
  void look_at_earth(Time now);
  bool is_served(Time now);
  bool is_locked_in_sight(Time now);
  bool is_armrest_at_work(Time now);

  const World* world_;
  const ExcavatorOptions* options_;
  const Excavator* machine_;
  const SeatPanel* panel_;
  const SeatPanel* trainer_;
  const ExcavatorOperator* driver_;
  ExcavatorDevices* devices_;
  const BusWatch* watch_;
  ExcavatorReferee referee_;
  CabTruth cab_;
  double heaped_ = 0;             ///< at the last step
  double poured_ = 0;             ///< out of the bucket, at the last step
  unsigned seat_starts_ = 0;      ///< at the last look
  bool seat_was_set_up_ = false;  ///< since power-on
  bool had_fault_ = false;        ///< of the plan, since the start
  bool is_out_of_step_ = false;   ///< a recorded shift, after a fault has locked the hydraulics
  /// Positions of each stick in the last steps: the host's value must be one of them.
  std::array<std::array<double, 3>, stick_count> axes_{};
  std::array<bool, invariant_kinds> told_{};
};

}  // namespace canvoy::excavator
