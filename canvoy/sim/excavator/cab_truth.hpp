// What lamps and display of a seat must show of the machine as it is.
//
//     CabTruth cab(machine, panel, valves);
//     cab.step(now);                                  // each step of the machine
//     cab.lamps_are_right(has_valves, has_armrest);
//     cab.display_is_right(now, has_valves);
#pragma once

#include "canvoy/can/time.hpp"
#include "canvoy/sim/excavator/seat_panel.hpp"
#include "canvoy/sim/excavator/valves_hardware.hpp"
#include "canvoy/sim/plants/excavator.hpp"

namespace canvoy::excavator {

class CabTruth {
 public:
  /// All must outlive this.
  CabTruth(const Excavator& machine, const SeatPanel& panel, const ValvesHardware& valves)
      : machine_(&machine), panel_(&panel), valves_(&valves) {}

  /// Whether the machine moves now.
  void step(Time now);

  /// With a host they say what is so. `has_valves`: the module works; `has_armrest`: it does, or
  /// there is none to be.
  bool lamps_are_right(bool has_valves, bool has_armrest) const;
  /// Without the module for the valves, it has nothing to show.
  bool display_is_right(Time now, bool has_valves) const;
  /// Without one they show what 6207h and 6444h say.
  bool is_as_without_host() const;

 private:
  bool is_blank() const;

  const Excavator* machine_;
  const SeatPanel* panel_;
  const ValvesHardware* valves_;
  Time moved_at_{};  ///< last
};

}  // namespace canvoy::excavator
