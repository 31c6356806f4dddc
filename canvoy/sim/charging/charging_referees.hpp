// All that is judged between a charger and its battery: what was counted, the handshake, service,
// what the cells bear, and faults that have to be seen.
//
//     ChargingReferees referees(options, devices, events);
//     referees.hear(now, frame);        // each frame on the bus
//     referees.set_point(ampere);       // what the power stage is told
//     referees.step(now);               // after each step of the plant
//     for (const Invariant& invariant : referees.invariants()) ok = ok && invariant.held;
#pragma once

#include <array>
#include <vector>

#include "canvoy/sim/charging/charging_devices.hpp"
#include "canvoy/sim/charging/charging_event.hpp"
#include "canvoy/sim/charging/fault_watch.hpp"
#include "canvoy/sim/charging/handshake_monitor.hpp"
#include "canvoy/sim/charging/service_watch.hpp"
#include "canvoy/sim/wrong_time.hpp"

namespace canvoy::charging {

class ChargingReferees {
 public:
  /// All must outlive this; what is broken is noted in `events`.
  ChargingReferees(const ChargingOptions& options, const ChargingDevices& devices,
                   std::vector<ChargingEvent>& events);
  ChargingReferees(const ChargingReferees&) = delete;
  ChargingReferees& operator=(const ChargingReferees&) = delete;

  void step(Time now);
  void hear(Time now, const Frame& frame) { handshake_.on_frame(now, frame); }
  void set_point(double ampere) { handshake_.on_set_point(ampere); }
  /// Why the charger does not deliver is another reason than before.
  void reason_changed(Time now) { faults_.note(now, reason()); }
  /// After it was made, or mended.
  void fault_began(Time now, std::size_t fault);
  void fault_ended(Time now, std::size_t fault);

  /// As they stand now: the lasting ones, and one for each fault that has begun and has to be seen.
  std::vector<Invariant> invariants() const;

 private:
  /// Those that need no fault: all kinds but the last one.
  static constexpr std::size_t lasting = invariant_kinds - 1;
  /// Current that comes and goes each second harms as one that stays.
  static constexpr Duration stretch_ends_after = 10s;

  cia419::StopReason reason() const { return devices_->charger().charger().reason(); }
  FaultKind kind_of(std::size_t fault) const { return options_->faults.faults[fault].kind; }
  bool plays_both() const { return options_->plays_battery && options_->plays_charger; }
  double served_ampere() const;
  double wanted_ampere() const;
  void judge_care(Time now);
  Promises promises() const;
  Duration stop_time_max() const;
  Duration find_unwanted_time_max() const;
  Invariant handshake() const;
  Invariant service() const;
  Invariant missing_charge() const;
  std::array<Invariant, lasting> lasting_invariants() const;
  void tell_broken(Time now);

  const ChargingOptions* options_;
  const ChargingDevices* devices_;
  std::vector<ChargingEvent>* events_;
  HandshakeMonitor handshake_;
  FaultWatch faults_;
  ServiceWatch service_;
  Duration unwanted_time_max_;  ///< by the configuration at the start
  WrongTime more_than_asked_{stretch_ends_after};
  WrongTime hot_or_cold_{stretch_ends_after};
  WrongTime over_voltage_{stretch_ends_after};
  unsigned second_batteries_ = 0;
  std::array<bool, lasting> told_{};  ///< that they are broken
};

}  // namespace canvoy::charging
