// All that is judged between a charger and its battery: what was counted, the handshake, service,
// and faults that have to be seen.
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
  /// Those that need no fault: ampere-hours, energy, current outside of the handshake and before
  /// it, a battery that is left waiting.
  static constexpr std::size_t lasting = 5;

  cia419::StopReason reason() const { return devices_->charger().charger().reason(); }
  FaultKind kind_of(std::size_t fault) const { return options_->faults.faults[fault].kind; }
  bool battery_asks() const;
  Promises promises() const;
  Invariant handshake() const;
  Invariant service() const;
  std::array<Invariant, lasting> lasting_invariants() const;
  void tell_broken(Time now);

  const ChargingOptions* options_;
  const ChargingDevices* devices_;
  std::vector<ChargingEvent>* events_;
  HandshakeMonitor handshake_;
  FaultWatch faults_;
  ServiceWatch service_;
  std::array<bool, lasting> told_{};  ///< that they are broken
};

}  // namespace canvoy::charging
