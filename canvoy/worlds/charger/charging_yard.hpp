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
#include <optional>
#include <span>
#include <vector>

#include "canvoy/sim/bus_watch.hpp"
#include "canvoy/sim/world.hpp"
#include "canvoy/worlds/charger/charging_bay.hpp"
#include "canvoy/worlds/charger/yard_event.hpp"
#include "canvoy/worlds/charger/yard_options.hpp"
#include "canvoy/worlds/charger/yard_vehicles.hpp"

namespace canvoy::charger {

/// The referee of a charging yard: whether each battery has what its owner was promised when it is
/// needed, whether plain batteries are equalised, and what the mains connection bears. It looks at
/// the cells and the mains, not at what chargers and modules say.
///
///     YardReferee referee(yard, bays, vehicles);
///     referee.fault_began(now, bay, kind);
///     referee.step(now);                     // after each step of the plants and the vehicles
///     for (const YardInvariant& invariant : referee.invariants()) ok = ok && invariant.held;
class YardReferee {
 public:
  /// After a fault, a charger finds its battery again within this time (ServiceWatch::bound).
  static constexpr Duration recovery = ServiceWatch::bound;
  /// A pause of a fault or a change of vehicles may cost as much of the time of equalising.
  static constexpr double equalising_missing_max_percent = 5;

  /// All must outlive this object.
  YardReferee(const YardOptions& yard, const YardVehicles::Bays& bays,
              const YardVehicles& vehicles);

  /// `bay` is from 0 on.
  void fault_began(Time now, std::size_t bay) { change_faults(now, bay, 1); }
  /// Ends a fault that began in this bay, from 0 on; `recovery` follows, in which the bay is
  /// excused.
  void fault_ended(Time now, std::size_t bay) { change_faults(now, bay, -1); }
  /// Measures the mains, and judges each vehicle; call it every ChargingPlant::step_time.
  void step(Time now);

  /// Verdicts at present: goals where there is one, the equalising of plain batteries, and the
  /// supply where it has a limit.
  std::vector<YardInvariant> invariants() const;

  /// State of charge of a vehicle at the goal's time, or when it left before; 0 to 1. Empty: it has
  /// not come to that.
  std::optional<double> at_goal(std::size_t vehicle) const { return results_[vehicle].charge; }
  /// From the mains since the start, by all chargers.
  double mains_watt_hours() const;
  /// From the mains since the start, by the charger of this bay, from 0 on.
  double mains_watt_hours(std::size_t bay) const;
  /// Greatest power of all chargers together, as the mean of a step of the plants.
  double mains_watt_max() const { return mains_watt_max_; }

 private:
  struct Bay {
    int faults = 0;  ///< that are present
    Time excused_until{};
    double mains_joule = 0;  ///< until the last step
  };
  struct Result {
    std::optional<double> charge;
    Duration excused{};  ///< while it was at the cable
    bool was_here = false;
    Duration full{};       ///< at the cable with full cells, without a fault
    Duration equalised{};  ///< of that, with current
  };

  void change_faults(Time now, std::size_t bay, int by);
  void watch(Time now, std::size_t vehicle);
  void judge_goal(Time now, std::size_t vehicle);
  void measure_mains();
  double missing_percent(std::size_t vehicle) const;
  double allowed_percent(std::size_t vehicle) const;
  bool is_seen(std::size_t vehicle) const;
  YardInvariant goal_of(std::size_t vehicle) const;
  YardInvariant goal_of_bay(unsigned bay) const;
  YardInvariant equalising_of(std::size_t vehicle) const;
  YardInvariant supply() const;

  const YardOptions* yard_;
  const YardVehicles::Bays* bays_;
  const YardVehicles* vehicles_;
  std::vector<Bay> of_bays_;
  std::vector<Result> results_;
  bool is_past_goal_ = false;  ///< who comes now is not judged
  double mains_watt_max_ = 0;
  std::uint64_t steps_ = 0;
};

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
  explicit ChargingYard(YardOptions options);
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
  void report_broken(Time now);

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
