// A charging yard in a simulated world: bays with a CiA 419 charger each, vehicles with CiA 418
// batteries that come and go, the mains, faults by plan, and referees of each charger and battery.
//
//     YardOptions options{.chargers = 3, .batteries = 4, .goal = Goal{}};
//     options.vehicles = drawn_vehicles(options);
//     ChargingYard yard(options);
//     yard.run_until(Time(12h));
//     for (const YardInvariant& invariant : yard.goals()) ok = ok && invariant.held;
//
// Equal options give the same frames at the same times. Each bay has a bus of its own, or all have
// one: then each charger is told the node-ID of the battery in its bay, since the pilot signal says
// that a battery is there, and not which (CiA 419, 6.1 and annex B).
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "canvoy/sim/bus_watch.hpp"
#include "canvoy/sim/world.hpp"
#include "canvoy/worlds/charger/charging_bay.hpp"
#include "canvoy/worlds/charger/yard_event.hpp"
#include "canvoy/worlds/charger/yard_options.hpp"
#include "canvoy/worlds/charger/yard_referee.hpp"
#include "canvoy/worlds/charger/yard_vehicles.hpp"

namespace canvoy::charger {

/// State of the battery of a vehicle.
struct VehicleSnapshot {
  unsigned bay = 0;                         ///< from 1 on
  VehiclePlace place = VehiclePlace::away;  ///< away, in the yard, or at the cable
  double state_of_charge = 0;               ///< 0 to 1, as all that follows true
  double celsius = 0;                       ///< of the cells
  bool is_full = false;                     ///< the current has fallen to the tail current
  /// State of charge at the time of the goal, or at an earlier departure, 0 to 1; empty: not yet
  /// judged.
  std::optional<double> at_goal{};
};

/// State of a yard, for a table or a line of a log.
struct YardSnapshot {
  Time at{};                              ///< since the start of the run
  std::vector<BusSnapshot> buses;         ///< one where all bays share it, else one for each bay
  std::vector<ChargerSnapshot> bays;      ///< from bay 1 on
  std::vector<VehicleSnapshot> vehicles;  ///< in the order of YardOptions::vehicles
  double mains_watt_hours = 0;            ///< of all chargers, since the start
  double mains_watt_max = 0;              ///< greatest mean power of a step of the plants
};

class ChargingYard {
 public:
  /// Makes bays and vehicles, and gives the devices power at time 0; no battery is at a cable yet.
  explicit ChargingYard(const YardOptions& options);
  ChargingYard(const ChargingYard&) = delete;
  ChargingYard& operator=(const ChargingYard&) = delete;

  /// Runs up to and including `until`.
  void run_until(Time until);
  /// Time since the start of the run.
  Time now() const { return world_.now(); }

  /// State of buses, bays, vehicles and mains at present.
  YardSnapshot snapshot();
  /// All events since the start, oldest first.
  std::span<const YardEvent> events() const { return events_; }

  /// Verdicts on each bay, as of a network of one charger; their part is the bay.
  std::vector<Invariant> invariants() const;
  /// Verdicts on what the yard is for.
  std::vector<YardInvariant> goals() const { return referee_.invariants(); }
  /// True if neither invariants() nor goals() has a broken one.
  bool all_hold() const;

  /// World of all buses; time passes only in run_until().
  World& world() { return world_; }
  /// Options that the yard was made with.
  const YardOptions& options() const { return options_; }
  /// Number of bays, each with a charger.
  std::size_t bays() const { return bays_.size(); }
  /// From 0 on.
  ChargingBay& bay(std::size_t number) { return *bays_[number]; }
  /// From 0 on.
  const ChargingBay& bay(std::size_t number) const { return *bays_[number]; }
  /// Places and cells of the vehicles.
  const YardVehicles& vehicles() const { return vehicles_; }
  /// Judge of the goals, which also measures the mains.
  const YardReferee& referee() const { return referee_; }
  /// 1 where all bays share a bus, else as many as bays.
  std::size_t buses() const { return watches_.size(); }
  /// The bay of a node; null: of none.
  const ChargingBay* bay_of(BusIndex bus, NodeId node) const;

 private:
  /// Frames and news of a bus, for its bays.
  struct Watch {
    Watch(ChargingYard& yard, BusIndex bus);
    ChargingYard* yard;
    BusIndex bus;
    BusWatch of_nodes;
  };

  static YardVehicles::Bays make_bays(World& world, const YardOptions& options);
  void observe();
  void hear(BusIndex bus, Time now, const Frame& frame);
  void heard(BusIndex bus, Time now, const BusEvent& event);
  void step(Time now);
  void collect();
  void take(std::size_t bay, ChargerEvent event);
  void excuse(Time now, std::size_t bay, FaultKind kind, bool begins);
  void tell_broken(Time now);

  YardOptions options_;
  World world_;
  YardVehicles::Bays bays_;
  std::vector<YardEvent> events_;
  std::vector<std::size_t> collected_;            ///< of the events of each bay
  std::vector<std::vector<std::size_t>> faults_;  ///< of each bay, in the plan of the yard
  YardVehicles vehicles_;
  YardReferee referee_;
  std::vector<std::unique_ptr<Watch>> watches_;
  std::vector<bool> told_;  ///< of goals(): noted as broken
  PlantIndex stepping_;
};

}  // namespace canvoy::charger
