// What each controller of a bus takes part in, as the bus asks for it at each frame: who hears it,
// who acknowledges it, who can destroy it, and for whom a good one is good for the error counter.
//
//     participants.update(controller);
//     if ((receivers & participants.acknowledging()).empty()) ...  // nobody acknowledges
#pragma once

#include "canvoy/can/port.hpp"
#include "canvoy/can/simulated/controller_set.hpp"
#include "canvoy/can/simulated/simulated_controller.hpp"

namespace canvoy {

class Participants {
 public:
  /// The power, state, mode or receive error counter of a controller is another than before.
  void update(const SimulatedController& controller) {
    const ControllerId id = controller.id();
    const bool hears = controller.is_powered() && controller.state() != BusState::bus_off;
    const bool acknowledges = hears && !controller.is_listen_only();
    hearing_.assign(id, hears);
    acknowledging_.assign(id, acknowledges);
    flagging_.assign(id, acknowledges && is_error_active(controller.state()));
    with_receive_errors_.assign(id, acknowledges && controller.counters().receive() > 0);
  }

  /// With power, not in bus-off.
  const ControllerSet& hearing() const { return hearing_; }
  /// Of these, all that do not only listen.
  const ControllerSet& acknowledging() const { return acknowledging_; }
  /// Of these, the error-active: their error flags are dominant, and seen by all.
  const ControllerSet& flagging() const { return flagging_; }
  /// Of those that acknowledge, whose receive error counter is not zero: it counts down.
  const ControllerSet& with_receive_errors() const { return with_receive_errors_; }

 private:
  ControllerSet hearing_{};
  ControllerSet acknowledging_{};
  ControllerSet flagging_{};
  ControllerSet with_receive_errors_{};
};

}  // namespace canvoy
