// A bay of a charging yard: a charger, the battery at its cable, their plant, their faults, and the
// referees of both. A network of one charger and one battery has one bay.
//
//     ChargingBay bay(world, options, world.add_bus({.bit_rate = options.bit_rate}));
//     bay.start();
//     bay.hear(now, frame);                  // each frame on its bus
//     bay.note(now, bus_event);              // what a BusWatch says of its nodes
//     const ChargerSnapshot look = bay.snapshot();
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "canvoy/sim/bus_trouble.hpp"
#include "canvoy/sim/bus_watch.hpp"
#include "canvoy/sim/fault_engine.hpp"
#include "canvoy/sim/snapshot.hpp"
#include "canvoy/sim/world.hpp"
#include "canvoy/worlds/charger/charger_devices.hpp"
#include "canvoy/worlds/charger/charger_event.hpp"
#include "canvoy/worlds/charger/charger_options.hpp"
#include "canvoy/worlds/charger/charger_referees.hpp"
#include "canvoy/worlds/charger/connection_watch.hpp"

namespace canvoy::charger {

struct Imposter;

/// The faults of a plan between a battery and its charger: it makes and mends them, and reports
/// them as events and to the referees.
///
///     ChargerFaults faults(world, options, devices, referees, events);   // plans them all
class ChargerFaults {
 public:
  /// All must outlive the last run of `world`. The constructor puts nodes that faults need on the
  /// cable, without power.
  ChargerFaults(World& world, const ChargerOptions& options, ChargerDevices& devices,
                ChargerReferees& referees, std::vector<ChargerEvent>& events);
  ~ChargerFaults();
  ChargerFaults(const ChargerFaults&) = delete;
  ChargerFaults& operator=(const ChargerFaults&) = delete;

 private:
  using Engine = FaultEngine<FaultKind>;
  friend Engine;
  void prepare(FaultKind kind);
  void began(std::size_t fault);
  void ended(std::size_t fault);
  void set(std::size_t fault, bool present);
  void set_in_plant(FaultKind kind, bool present);
  void show_temperature(FaultKind last);

  World* world_;
  const ChargerOptions* options_;
  ChargerDevices* devices_;
  ChargerReferees* referees_;
  std::vector<ChargerEvent>* events_;
  std::unique_ptr<Imposter> imposter_;
  BusTrouble trouble_;
  Engine faults_;
};

/// State of a bay, for a table or a line of a log.
struct ChargerSnapshot {
  Time at{};             ///< since the start of the run
  BusSnapshot bus;       ///< load and frames; of a shared bus, those of all bays
  NodeSnapshot charger;  ///< node of the CiA 419 device
  NodeSnapshot battery;  ///< node of the CiA 418 module

  // state of the charger
  cia419::ChargerPhase phase = cia419::ChargerPhase::unplugged;  ///< progress of the charge
  /// Why no current flows; none while it does.
  cia419::StopReason reason = cia419::StopReason::no_pilot_signal;
  bool charger_is_ready = false;    ///< as its status object reports to the battery
  double set_point_ampere = 0;      ///< commanded to the power stage
  double measured_ampere = 0;       ///< with the error of its meter
  double counted_ampere_hours = 0;  ///< over all charges, from the measured current
  double counted_watt_hours = 0;    ///< likewise, with the voltage of the battery

  // readings of the battery
  cia418::BatteryReadings readings;  ///< values that cannot be measured are empty

  // true values
  double ampere = 0;           ///< through the cable
  double volt = 0;             ///< at the terminals of the battery
  double celsius = 0;          ///< of the cells
  double state_of_charge = 0;  ///< 0 to 1
  double ampere_hours = 0;     ///< through the cable since the start of the run
  double watt_hours = 0;       ///< likewise, into the terminals
};

class ChargingBay {
 public:
  /// The world must outlive this object.
  ChargingBay(World& world, const ChargerOptions& options, BusIndex bus);
  ChargingBay(const ChargingBay&) = delete;
  ChargingBay& operator=(const ChargingBay&) = delete;

  /// Switches on the devices that are simulated here.
  void start() { devices_.start(); }
  /// Takes each frame of its bus: the referees judge it, and the first TIME is noted as an event.
  void hear(Time now, const Frame& frame);
  /// Notes what was seen of its nodes on the bus; ignores other nodes.
  void heard(Time now, const BusEvent& event);
  /// Appends an event; `What` is an alternative of ChargerEvent::what.
  template <class What>
  void note(Time now, const What& what) {
    events_.push_back({now, what});
  }

  /// State at present: what devices report, and the true values.
  ChargerSnapshot snapshot();
  /// All events since the start, oldest first.
  std::span<const ChargerEvent> events() const { return events_; }

  /// Options in force: the error of the charger's meter is drawn.
  const ChargerOptions& options() const { return options_; }
  /// Nodes of the bay and the plant behind them.
  ChargerDevices& devices() { return devices_; }
  /// Nodes of the bay and the plant behind them.
  const ChargerDevices& devices() const { return devices_; }
  /// Verdicts on the charge of the bay.
  ChargerReferees& referees() { return referees_; }
  /// Verdicts on the charge of the bay.
  const ChargerReferees& referees() const { return referees_; }

 private:
  void step(Time now);
  void hear_time(Time now, const Frame& frame);
  void charger_said(cia419::Charger::Event event);
  void connections_changed(Time now);

  World& world_;
  ChargerOptions options_;
  std::vector<ChargerEvent> events_;
  ChargerDevices devices_;
  ChargerReferees referees_;
  ConnectionWatch connections_;
  bool time_seen_ = false;
  PlantIndex stepping_;
  ChargerFaults faults_;
};

}  // namespace canvoy::charger
