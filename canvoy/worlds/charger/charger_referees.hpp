// All judgements between a charger and its battery: what was counted, the handshake, service, the
// limits of the cells, and faults that must be detected.
//
//     ChargerReferees referees(options, devices, events);
//     referees.hear(now, frame);        // each frame on the bus
//     referees.set_point(ampere);       // what the power stage is told
//     referees.step(now);               // after each step of the plant
//     for (const Invariant& invariant : referees.invariants()) ok = ok && invariant.held;
#pragma once

#include <array>
#include <vector>

#include "canvoy/sim/wrong_time.hpp"
#include "canvoy/worlds/charger/charger_devices.hpp"
#include "canvoy/worlds/charger/charger_event.hpp"
#include "canvoy/worlds/charger/fault_watch.hpp"
#include "canvoy/worlds/charger/handshake_monitor.hpp"
#include "canvoy/worlds/charger/service_watch.hpp"

namespace canvoy::charger {

class ChargerReferees {
 public:
  /// All must outlive this object; what is broken is noted in `events`.
  ChargerReferees(const ChargerOptions& options, const ChargerDevices& devices,
                  std::vector<ChargerEvent>& events);
  ChargerReferees(const ChargerReferees&) = delete;
  ChargerReferees& operator=(const ChargerReferees&) = delete;

  /// Judges the last step of the plant; call it after each.
  void step(Time now);
  /// Takes each frame of the bus.
  void hear(Time now, const Frame& frame) { handshake_.on_frame(now, frame); }
  /// The power stage has received a set-point, in ampere.
  void set_point(double ampere) { handshake_.on_set_point(ampere); }
  /// Call it when the reason why the charger does not deliver changes.
  void reason_changed(Time now) { faults_.note(now, reason()); }
  /// Call it after a fault was made, or mended.
  void fault_began(Time now, std::size_t fault);
  /// See fault_began().
  void fault_ended(Time now, std::size_t fault);
  /// A fault elsewhere on the bus begins or ends, which may keep the battery waiting.
  void excuse(Time now, FaultKind kind, bool begins) {
    begins ? service_.fault_began(now, kind) : service_.fault_ended(now, kind);
  }

  /// Verdicts at present: the lasting ones, and one for each fault that has begun and must be
  /// detected.
  std::vector<Invariant> invariants() const;

 private:
  /// Number of kinds that need no fault: all but the last one.
  static constexpr std::size_t lasting = invariant_kinds - 1;
  /// Current that comes and goes each second harms like one that stays.
  static constexpr Duration stretch_ends_after = 10s;

  cia419::StopReason reason() const { return devices_->charger().charger().reason(); }
  FaultKind kind_of(std::size_t fault) const { return options_->faults.faults[fault].kind; }
  bool plays_both() const { return options_->plays_battery && options_->plays_charger; }
  double served_ampere() const;
  double wanted_ampere() const;
  void judge_care(Time now);
  DetectionBounds promises() const;
  Duration stop_time_max() const;
  Duration find_unwanted_time_max() const;
  Invariant handshake() const;
  Invariant service() const;
  Invariant missing_charge() const;
  std::array<Invariant, lasting> lasting_invariants() const;
  void report_broken(Time now);

  const ChargerOptions* options_;
  const ChargerDevices* devices_;
  std::vector<ChargerEvent>* events_;
  HandshakeMonitor handshake_;
  FaultWatch faults_;
  ServiceWatch service_;
  Duration unwanted_time_max_;  ///< by the configuration at the start
  WrongTime more_than_asked_{stretch_ends_after};
  WrongTime hot_or_cold_{stretch_ends_after};
  WrongTime over_voltage_{stretch_ends_after};
  unsigned second_batteries_ = 0;
  std::array<bool, lasting> told_{};  ///< true: noted as broken
};

}  // namespace canvoy::charger
