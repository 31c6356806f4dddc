// The network of a battery and its charger in a simulated world: a bus of 125 kbit/s, a CiA 418
// battery module and a CiA 419 charger on it, the battery and the power stage behind them, faults
// by plan, and a referee.
//
//     ChargerOptions options;
//     options.faults.faults = {{FaultKind::heartbeat_loss, Time(20min)}};
//     ChargerNetwork network(options);
//     network.run_until(Time(8h));
//     for (const Invariant& invariant : network.invariants()) ok = ok && invariant.held;
//
// Equal options give the same frames at the same times.
#pragma once

#include <span>
#include <vector>

#include "canvoy/sim/bus_watch.hpp"
#include "canvoy/sim/snapshot.hpp"
#include "canvoy/sim/world.hpp"
#include "canvoy/worlds/charger/charger_devices.hpp"
#include "canvoy/worlds/charger/charger_event.hpp"
#include "canvoy/worlds/charger/charger_faults.hpp"
#include "canvoy/worlds/charger/charger_options.hpp"
#include "canvoy/worlds/charger/charger_referees.hpp"
#include "canvoy/worlds/charger/connection_watch.hpp"

namespace canvoy::charger {

/// State of the whole network, for a table or a line of a log.
struct ChargerSnapshot {
  Time at{};             ///< since the start of the run
  BusSnapshot bus;       ///< with its load since the start
  NodeSnapshot charger;  ///< state of the charger's node
  NodeSnapshot battery;  ///< state of the battery's node

  // state of the charger
  cia419::ChargerPhase phase = cia419::ChargerPhase::unplugged;     ///< of its work
  cia419::StopReason reason = cia419::StopReason::no_pilot_signal;  ///< why it does not deliver
  bool charger_is_ready = false;                                    ///< as 6001h reports
  double set_point_ampere = 0;                                      ///< current for the power stage
  double measured_ampere = 0;                                       ///< by its own meter
  double counted_ampere_hours = 0;  ///< by its own meter, since the start
  double counted_watt_hours = 0;    ///< by its own meter, since the start

  // readings of the battery
  cia418::BatteryReadings readings;  ///< as the battery module senses its cells

  // true values
  double ampere = 0;           ///< into the battery is positive
  double volt = 0;             ///< at the poles
  double celsius = 0;          ///< of the cells
  double state_of_charge = 0;  ///< 0 to 1
  double ampere_hours = 0;     ///< into the battery, since the start
  double watt_hours = 0;       ///< into the battery, since the start
};

class ChargerNetwork {
 public:
  /// Has default options.
  ChargerNetwork();
  /// Makes all devices that are simulated here, and gives them power at time 0.
  explicit ChargerNetwork(const ChargerOptions& options);
  ChargerNetwork(const ChargerNetwork&) = delete;
  ChargerNetwork& operator=(const ChargerNetwork&) = delete;

  /// Runs up to and including `until`.
  void run_until(Time until) { world_.run_until(until); }
  /// Time since the start of the run.
  Time now() const { return world_.now(); }

  /// Adds a further observer of the bus, for a log; false where there are too many.
  bool observe(const BusTap& tap) { return world_.bus().observe(tap); }
  /// State at present.
  ChargerSnapshot snapshot();
  /// All events since the start, oldest first.
  std::span<const ChargerEvent> events() const { return events_; }

  /// Verdicts at present: ampere-hours, energy, current outside of the handshake and before it, a
  /// battery that is left waiting, and one for each fault that has begun and must be detected.
  std::vector<Invariant> invariants() const { return referees_.invariants(); }
  /// True if no invariant is broken.
  bool all_hold() const;

  // Access for tests, and for tools that take part.
  /// The world of the bus; time passes only in run_until().
  World& world() { return world_; }
  /// Notes an action at a device as an event.
  void note_hand(Time now, const HandActed& acted) { note(now, acted); }
  /// Battery cells, cable and power stage.
  ChargingPlant& plant() { return devices_.plant(); }
  /// The charger's device.
  cia419::ChargerDevice<>& charger() { return devices_.charger(); }
  /// The battery module.
  cia418::BatteryDevice<>& battery() { return devices_.battery(); }
  /// Options that it was made with.
  const ChargerOptions& options() const { return options_; }
  /// Number of the charger on the bus.
  ControllerId charger_controller() const { return devices_.charger_controller(); }
  /// Number of the battery module on the bus.
  ControllerId battery_controller() const { return devices_.battery_controller(); }

 private:
  void step(Time now);
  void observe_bus();
  void hear(Time now, const Frame& frame);
  void hear_time(Time now, const Frame& frame);
  void heard(Time now, const BusEvent& event);
  void charger_said(cia419::Charger::Event event);
  void connections_changed(Time now);
  template <class What>
  void note(Time now, const What& what) {
    events_.push_back({now, what});
  }

  ChargerOptions options_;
  World world_;
  std::vector<ChargerEvent> events_;
  ChargerDevices devices_;
  ChargerReferees referees_;
  BusWatch bus_watch_;
  ConnectionWatch connections_;
  bool time_seen_ = false;
  PlantIndex stepping_;
  ChargerFaults faults_;
};

}  // namespace canvoy::charger
