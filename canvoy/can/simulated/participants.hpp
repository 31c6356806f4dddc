// Roles of each controller of a bus at a frame: receives it, acknowledges it, can destroy it, and
// reduces its error counter after a good one.
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
  /// Updates the roles after a change of a controller's power, state, mode or receive error
  /// counter.
  void update(const SimulatedController& controller) {
    const ControllerId id = controller.id();
    const bool hears = controller.is_powered() && controller.state() != BusState::bus_off;
    const bool acknowledges = hears && !controller.is_listen_only();
    hearing_.assign(id, hears);
    acknowledging_.assign(id, acknowledges);
    flagging_.assign(id, acknowledges && is_error_active(controller.state()));
    with_receive_errors_.assign(id, acknowledges && controller.counters().receive() > 0);
  }

  /// Controllers with power, not in bus-off.
  const ControllerSet& hearing() const { return hearing_; }
  /// Hearing controllers that do not only listen.
  const ControllerSet& acknowledging() const { return acknowledging_; }
  /// Acknowledging controllers that are error-active: their error flags are dominant, and visible
  /// to all.
  const ControllerSet& flagging() const { return flagging_; }
  /// Acknowledging controllers with a receive error counter above zero: it counts down.
  const ControllerSet& with_receive_errors() const { return with_receive_errors_; }

 private:
  ControllerSet hearing_{};
  ControllerSet acknowledging_{};
  ControllerSet flagging_{};
  ControllerSet with_receive_errors_{};
};

}  // namespace canvoy
