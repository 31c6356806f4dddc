// Makes trouble on a cable: cuts it, attaches a device that babbles, disturbs frames.
//
//     BusTrouble trouble(world.bus());
//     trouble.attach_babbler();       // before the world runs
//     trouble.babble(true);
#pragma once

#include "canvoy/can/frame.hpp"
#include "canvoy/can/simulated/simulated_bus.hpp"
#include "canvoy/canopen/protocol/cob_id.hpp"

namespace canvoy {

class BusTrouble {
 public:
  /// The bus must outlive this object.
  explicit BusTrouble(SimulatedBus& bus) : bus_(bus) {}
  BusTrouble(const BusTrouble&) = delete;
  BusTrouble& operator=(const BusTrouble&) = delete;

  /// Cuts the cable behind the controller, or mends it.
  void cut_cable(ControllerId controller, bool is_cut) {
    is_cut ? bus_.cut_cable(controller) : bus_.mend_cable();
  }
  /// Attaches a device without power, which babble() switches on. Further calls do nothing.
  void attach_babbler() {
    if (babbler_ != no_controller) return;
    babbler_ = bus_.attach({});
    bus_.power(babbler_, false);
  }
  /// Sends an NMT command of the wrong length again and again: no node obeys it, and no frame has a
  /// higher priority.
  void babble(bool does_babble) {
    constexpr Frame babble{.id = can_id::nmt, .length = Frame::length_max};
    bus_.power(babbler_, does_babble);
    does_babble ? bus_.babble(babbler_, babble) : bus_.stop_babbling(babbler_);
  }
  /// Disturbs `share` of all frames, 0 to 1.
  void disturb(double share) { bus_.set_frame_error_probability(share); }

 private:
  SimulatedBus& bus_;
  ControllerId babbler_ = no_controller;
};

}  // namespace canvoy
