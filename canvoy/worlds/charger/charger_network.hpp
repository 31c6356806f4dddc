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
#include "canvoy/sim/world.hpp"
#include "canvoy/worlds/charger/charging_bay.hpp"

namespace canvoy::charger {

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
  /// State of bus, nodes and plant at present.
  ChargerSnapshot snapshot() { return bay_.snapshot(); }
  /// All events since the start, oldest first.
  std::span<const ChargerEvent> events() const { return bay_.events(); }

  /// Verdicts at present: ampere-hours, energy, current outside of the handshake and before it, a
  /// battery that is left waiting, and one for each fault that has begun and must be detected.
  std::vector<Invariant> invariants() const { return bay_.referees().invariants(); }
  /// True if no invariant is broken.
  bool all_hold() const;

  // Access for tests, and for tools that take part.
  /// The world of the bus; time passes only in run_until().
  World& world() { return world_; }
  /// Notes an action at a device as an event.
  void note_hand(Time now, const HandActed& acted) { bay_.note(now, acted); }
  /// Battery cells, cable and power stage.
  ChargingPlant& plant() { return bay_.devices().plant(); }
  /// CiA 419 device, with its control.
  cia419::ChargerDevice<>& charger() { return bay_.devices().charger(); }
  /// CiA 418 module at the cells.
  cia418::BatteryDevice<>& battery() { return bay_.devices().battery(); }
  /// Options in force: the error of the charger's meter is drawn.
  const ChargerOptions& options() const { return bay_.options(); }
  /// Number of the charger on the bus.
  ControllerId charger_controller() const { return bay_.devices().charger_controller(); }
  /// Number of the battery module on the bus.
  ControllerId battery_controller() const { return bay_.devices().battery_controller(); }

 private:
  void observe_bus();

  World world_;
  ChargingBay bay_;
  BusWatch bus_watch_;
};

}  // namespace canvoy::charger
