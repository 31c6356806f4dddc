// The network of a battery and its charger in a simulated world: a bus of 125 kbit/s, a CiA 418
// battery module and a CiA 419 charger on it, the battery and the power stage behind them, faults
// by plan, and a referee.
//
//     ChargingOptions options;
//     options.faults.faults = {{FaultKind::heartbeat_loss, Time(20min)}};
//     ChargingNetwork network(options);
//     network.run_until(Time(8h));
//     for (const Invariant& invariant : network.invariants()) ok = ok && invariant.held;
//
// The same options give the same frames at the same times.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "canvoy/can/callback.hpp"
#include "canvoy/can/random.hpp"
#include "canvoy/devices/cia418/battery_device.hpp"
#include "canvoy/devices/cia419/charger_device.hpp"
#include "canvoy/sim/bus_watch.hpp"
#include "canvoy/sim/charging/charging_event.hpp"
#include "canvoy/sim/charging/fault.hpp"
#include "canvoy/sim/charging/fault_watch.hpp"
#include "canvoy/sim/charging/handshake_monitor.hpp"
#include "canvoy/sim/charging/lossy_port.hpp"
#include "canvoy/sim/charging/service_watch.hpp"
#include "canvoy/sim/charging/vehicle_manager.hpp"
#include "canvoy/sim/plants/charging.hpp"
#include "canvoy/sim/snapshot.hpp"
#include "canvoy/sim/wall_clock.hpp"
#include "canvoy/sim/world.hpp"

namespace canvoy::charging {

struct Imposter;

struct ChargingOptions {
  FaultPlan faults{};  ///< and the seed
  std::uint32_t bit_rate = 125'000;
  NodeId charger_id = 5;
  NodeId battery_id = 10;
  /// Of the vehicle's CANopen manager, which gives the charger its connection to the battery (CiA
  /// 419, 6.1); 0: there is none, and the charger takes the default channel.
  NodeId manager_id = 0;
  /// What the charger's clock shows at the start, so that it tells the time (4.1); nothing: it has
  /// no clock.
  std::optional<CivilTime> begin{};
  BatteryDesign battery = BatteryPlant::lead_acid_48v();
  double state_of_charge = 0.2;  ///< at the start, 0 to 1
  double ambience_celsius = 20;
  PowerStageOptions stage{};
  double meter_tolerance = 0.003;  ///< by as much the seed may make the charger's meter be off
  cia419::ChargerSettings charger{};
  /// False: it has no power here, and a real one may be on a bus that is bridged to this one.
  bool plays_charger = true;
  bool plays_battery = true;
};

/// A look at everything, for a table or a line of a log.
struct ChargingSnapshot {
  Time at{};
  BusSnapshot bus;
  NodeSnapshot charger;
  NodeSnapshot battery;

  // The charger's
  cia419::ChargerPhase phase = cia419::ChargerPhase::unplugged;
  cia419::StopReason reason = cia419::StopReason::no_pilot_signal;
  bool charger_is_ready = false;
  double set_point_ampere = 0;
  double measured_ampere = 0;
  double counted_ampere_hours = 0;
  double counted_watt_hours = 0;

  // What the battery says
  cia418::BatteryReadings readings;

  // The truth
  double ampere = 0;
  double volt = 0;
  double celsius = 0;
  double state_of_charge = 0;  ///< 0 to 1
  double ampere_hours = 0;
  double watt_hours = 0;
};

class ChargingNetwork {
 public:
  /// With default options.
  ChargingNetwork();
  explicit ChargingNetwork(const ChargingOptions& options);
  ~ChargingNetwork();
  ChargingNetwork(const ChargingNetwork&) = delete;
  ChargingNetwork& operator=(const ChargingNetwork&) = delete;

  /// Runs up to and including `until`.
  void run_until(Time until) { world_.run_until(until); }
  Time now() const { return world_.now(); }

  /// A further observer of the bus, for a log; false where there are too many.
  bool observe(const BusTap& tap) { return world_.bus().observe(tap); }
  ChargingSnapshot snapshot();
  /// All since the start, oldest first.
  std::span<const ChargingEvent> events() const { return events_; }

  /// As they stand now: ampere-hours, energy, current outside of the handshake and before it, a
  /// battery that is left waiting, and one for each fault that has begun and has to be seen.
  std::vector<Invariant> invariants() const;
  /// None is broken.
  bool all_hold() const;

  // For tests, and for tools that take part.
  World& world() { return world_; }
  ChargingPlant& plant() { return plant_; }
  cia419::ChargerDevice<>& charger() { return charger_; }
  cia418::BatteryDevice<>& battery() { return battery_; }
  const ChargingOptions& options() const { return options_; }
  ControllerId charger_controller() const { return world_.controller(charger_slot_); }
  ControllerId battery_controller() const { return world_.controller(battery_slot_); }

 private:
  static ChargingOptions with_meter_of_seed(ChargingOptions options);
  Promises promises() const;
  HandshakeRules rules() const;
  cia419::ChargerHardware charger_hardware();
  void deliver(double ampere);
  void add_manager();
  cia418::BatterySettings battery_settings() const;
  Invariant handshake_invariant() const;
  /// Those that need no fault.
  std::array<Invariant, 5> lasting_invariants() const;
  Invariant service_invariant() const;

  // charging_network_faults.cpp
  void plan_faults();
  void prepare(FaultKind kind);
  void begin(std::size_t fault);
  void end(std::size_t fault);
  bool is_present(FaultKind kind) const { return present_.at(static_cast<std::size_t>(kind)) != 0; }
  void set_fault(FaultKind kind, bool present);
  void show_temperature(FaultKind last);
  void set_plant_fault(FaultKind kind, bool present);
  void set_battery_running(bool runs);

  // charging_network_events.cpp
  void step(Time now);
  bool battery_asks() const;
  void check(Time now);
  void hear(Time now, const Frame& frame);
  void hear_time(Time now, const Frame& frame);
  void watch_connections(Time now);
  void heard(Time now, const BusEvent& event);
  void charger_said(cia419::Charger::Event event);
  template <class What>
  void note(Time now, const What& what) {
    events_.push_back({now, what});
  }

  ChargingOptions options_;
  World world_;
  BusIndex bus_;
  SlotIndex charger_slot_;
  SlotIndex battery_slot_;
  LossyPort battery_port_;
  ChargingPlant plant_;
  Callback<void(double)> power_stage_;
  std::optional<WallClock> clock_;
  cia419::ChargerDevice<> charger_;
  cia418::BatteryDevice<> battery_;
  std::unique_ptr<VehicleManager> manager_;   ///< of the vehicle, where there is one
  std::array<SdoConnection, 4> connections_;  ///< as they were told of
  bool time_seen_ = false;
  std::unique_ptr<Imposter> imposter_;
  ControllerId babbler_ = no_controller;

  HandshakeMonitor handshake_;
  std::array<unsigned, fault_kinds> present_{};  ///< how many faults of each kind
  FaultWatch fault_watch_;
  ServiceWatch service_;
  BusWatch bus_watch_;
  std::vector<ChargingEvent> events_;
  std::array<bool, 5> told_{};  ///< that the lasting invariants are broken
};

}  // namespace canvoy::charging
