// The referee of a charging yard: whether each battery has what its owner was promised when it is
// needed, whether plain batteries are equalised, and what the mains connection bears. It looks at
// the cells and the mains, not at what chargers and modules say.
//
//     YardReferee referee(yard, bays, vehicles);
//     referee.fault_began(now, bay, kind);
//     referee.step(now);                     // after each step of the plants and the vehicles
//     for (const YardInvariant& invariant : referee.invariants()) ok = ok && invariant.held;
#pragma once

#include <optional>
#include <vector>

#include "canvoy/worlds/charger/charging_bay.hpp"
#include "canvoy/worlds/charger/yard_event.hpp"
#include "canvoy/worlds/charger/yard_options.hpp"
#include "canvoy/worlds/charger/yard_vehicles.hpp"

namespace canvoy::charger {

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

}  // namespace canvoy::charger
