// Makes the faults of the plan in a taxi, and mends them; and says what they excuse.
//
//     TaxiFaults faults(car, options.faults, trips, excuse, events);
//     faults.plan();
#pragma once

#include "canvoy/sim/bus_trouble.hpp"
#include "canvoy/sim/car/excuse.hpp"
#include "canvoy/sim/fault_engine.hpp"
#include "canvoy/sim/power_cuts.hpp"
#include "canvoy/sim/taxi/taxi_car.hpp"
#include "canvoy/sim/taxi/trip_book.hpp"

namespace canvoy::taxi {

class TaxiFaults {
 public:
  /// A device that has lost its power, or its bus, is named, booted and started in this time.
  static constexpr Duration return_bound = 20s;

  /// All must outlive this.
  TaxiFaults(TaxiCar& car, const FaultPlan& plan, TripBook& trips, car::Excuse& excuse,
             EventLog<TaxiEvent>& events);
  TaxiFaults(const TaxiFaults&) = delete;
  TaxiFaults& operator=(const TaxiFaults&) = delete;

  /// This must outlive the world's last run.
  void plan();
  bool has_any(FaultKind kind) const { return faults_.has_any(kind); }

 private:
  using Engine = FaultEngine<FaultKind>;
  friend Engine;
  Time now() const { return car_.bus().world().now(); }
  void began(std::size_t fault);
  void ended(std::size_t fault);
  void excuse(FaultKind kind);
  void set(std::size_t fault, bool is_present);
  void power(NodeId id, bool is_on) { car_.power(car_.bus().node(id), is_on); }

  TaxiCar& car_;
  TripBook& trips_;
  car::Excuse& excuse_;
  EventLog<TaxiEvent>& events_;
  Engine faults_;
  BusTrouble trouble_;
  PowerCuts cuts_;
};

}  // namespace canvoy::taxi
