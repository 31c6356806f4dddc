// A referee of service: a battery that asks for current gets it, but for what a fault excuses. It
// looks at the battery and at the current, not at what the charger says.
//
//     ServiceWatch service;
//     service.fault_began(now, FaultKind::too_hot);
//     service.on_step(now, battery_asks, ampere);   // for each step of the plant
//     if (service.waiting_max() > ServiceWatch::bound) ...
#pragma once

#include <algorithm>
#include <cstdint>

#include "canvoy/can/time.hpp"
#include "canvoy/sim/charging/fault.hpp"

namespace canvoy::charging {

class ServiceWatch {
 public:
  /// A scan of all nodes takes below 4 s, a heartbeat up to 1 s to come, the questions to the
  /// battery and its SDO manager below 2 s, an NMT command 1 s to be given again; and as much again
  /// since a fault may end in the midst of that.
  static constexpr Duration bound = 15s;

  /// A fault excuses for as long as it lasts, and then once more for `bound`. One that a charge
  /// goes on in spite of excuses from its start for `bound` alone.
  void fault_began(Time now, FaultKind kind) {
    waiting_since_ = now;
    if (!lets_charge_go_on(kind)) ++present_;
  }
  void fault_ended(Time now, FaultKind kind) {
    waiting_since_ = now;
    if (!lets_charge_go_on(kind)) --present_;
  }
  /// `asks`: the battery is plugged in, ready, and wants current.
  void on_step(Time now, bool asks, double ampere) {
    const bool is_judged = asks && present_ == 0;
    if (!is_judged || ampere > no_current_ampere) waiting_since_ = now;
    if (is_judged) ++judged_;
    waiting_max_ = std::max(waiting_max_, now - waiting_since_);
  }

  /// The longest time at a stretch.
  Duration waiting_max() const { return waiting_max_; }
  /// Steps in which the battery asked, and no fault was there.
  std::uint64_t judged() const { return judged_; }

 private:
  static constexpr double no_current_ampere = 0.01;

  static constexpr bool lets_charge_go_on(FaultKind kind) {
    return kind == FaultKind::battery_restart || kind == FaultKind::clock_drift ||
           kind == FaultKind::corrupted_frames;
  }

  Time waiting_since_{};
  Duration waiting_max_{0};
  unsigned present_ = 0;
  std::uint64_t judged_ = 0;
};

}  // namespace canvoy::charging
