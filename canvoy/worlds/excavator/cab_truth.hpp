// Compares lamps and display of a seat with the true state of the machine.
//
//     CabTruth cab(machine, panel, valves);
//     cab.step(now);                                  // each step of the machine
//     cab.lamps_are_right(has_valves, has_armrest);
//     cab.display_is_right(now, has_valves);
#pragma once

#include "canvoy/can/time.hpp"
#include "canvoy/sim/plants/excavator.hpp"
#include "canvoy/worlds/excavator/seat_panel.hpp"
#include "canvoy/worlds/excavator/valves_hardware.hpp"

namespace canvoy::excavator {

class CabTruth {
 public:
  /// All must outlive this object.
  CabTruth(const Excavator& machine, const SeatPanel& panel, const ValvesHardware& valves)
      : machine_(&machine), panel_(&panel), valves_(&valves) {}

  /// Looks whether the machine moves.
  void step(Time now);

  /// With a host, the lamps show the true state. `has_valves`: the module works; `has_armrest`: the
  /// armrest works, or the machine has none.
  bool lamps_are_right(bool has_valves, bool has_armrest) const;
  /// Without the module for the valves, the display has nothing to show.
  bool display_is_right(Time now, bool has_valves) const;
  /// Without a host, both show the values of 6207h and 6444h.
  bool is_as_without_host() const;

 private:
  bool is_blank() const;

  const Excavator* machine_;
  const SeatPanel* panel_;
  const ValvesHardware* valves_;
  Time moved_at_{};  ///< time of the last motion
};

}  // namespace canvoy::excavator
