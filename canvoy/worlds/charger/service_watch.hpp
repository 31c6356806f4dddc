// A referee of service: a battery that requests current gets it, in full, except for what a fault
// excuses. It compares the battery with the current, not with what the charger reports.
//
//     ServiceWatch service(charger_max_ampere);
//     service.fault_began(now, FaultKind::too_hot);
//     service.on_step(now, asked_ampere, ampere);   // for each step of the plant
//     if (service.waiting_max() > ServiceWatch::bound) ...
//     if (service.missing_percent() > ServiceWatch::missing_max_percent) ...
#pragma once

#include <algorithm>
#include <cstdint>

#include "canvoy/can/time.hpp"
#include "canvoy/sim/plants/charging.hpp"
#include "canvoy/worlds/charger/fault.hpp"

namespace canvoy::charger {

class ServiceWatch {
 public:
  /// Longest wait. A scan of all nodes takes below 4 s, a heartbeat up to 1 s to come, the requests
  /// to the battery and its SDO manager below 2 s, an NMT command 1 s to be repeated; and as much
  /// again, since a fault may end in the midst of that.
  static constexpr Duration bound = 15s;
  /// Share of the charge: a charger that takes a tenth longer than it must is defective.
  static constexpr double missing_max_percent = 5;

  /// The battery must get its requested charge, up to the maximum of the charger.
  explicit ServiceWatch(double charger_max_ampere) : charger_max_ampere_(charger_max_ampere) {}

  /// A fault excuses while it lasts, and for `bound` after it. One in spite of which a charge
  /// continues excuses from its start for `bound` alone.
  void fault_began(Time now, FaultKind kind) {
    excused_at_ = waiting_since_ = now;
    if (!lets_charge_go_on(kind)) ++present_;
  }
  /// See fault_began().
  void fault_ended(Time now, FaultKind kind) {
    excused_at_ = waiting_since_ = now;
    if (!lets_charge_go_on(kind)) --present_;
  }
  /// `asked_ampere` is the current that a battery requests which is plugged in and ready.
  void on_step(Time now, double asked_ampere, double ampere) {
    const bool is_judged = asked_ampere > 0 && present_ == 0;
    if (!is_judged || ampere > ChargingPlant::no_current_ampere) waiting_since_ = now;
    if (is_judged) ++judged_;
    waiting_max_ = std::max(waiting_max_, now - waiting_since_);
    if (!is_judged) excused_at_ = now;
    if (is_judged && now - excused_at_ > bound)
      measure(std::min(asked_ampere, charger_max_ampere_), ampere);
  }

  /// The longest wait without interruption.
  Duration waiting_max() const { return waiting_max_; }
  /// Number of steps in which the battery requested current, and no fault was present.
  std::uint64_t judged() const { return judged_; }

  /// Share of the requested charge that was not delivered; a surplus at other times does not
  /// compensate for it.
  double missing_percent() const { return asked_ > 0 ? 100 * missing_ / asked_ : 0; }
  /// Number of measured steps: those of judged() except the first `bound` after the start, a fault,
  /// or a pause.
  std::uint64_t measured() const { return measured_; }

 private:
  void measure(double asked_ampere, double ampere) {
    ++measured_;
    asked_ += asked_ampere;
    missing_ += std::max(0.0, asked_ampere - ampere);
  }

  static constexpr bool lets_charge_go_on(FaultKind kind) {
    return kind == FaultKind::battery_restart || kind == FaultKind::clock_drift ||
           kind == FaultKind::corrupted_frames;
  }

  double charger_max_ampere_;
  Time excused_at_{};  ///< time of the last excuse
  Time waiting_since_{};
  Duration waiting_max_{0};
  unsigned present_ = 0;
  std::uint64_t judged_ = 0;
  std::uint64_t measured_ = 0;
  double asked_ = 0;    ///< sum in amperes over all measured steps
  double missing_ = 0;  ///< sum in amperes over all measured steps
};

}  // namespace canvoy::charger
