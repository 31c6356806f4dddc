// Makes and mends the faults of the plan in a taxi, and reports what they excuse.
//
//     TaxiFaults faults(car, options.faults, trips, watch, excuses, tampering, events);
//     faults.plan();
#pragma once

#include "canvoy/sim/bus_trouble.hpp"
#include "canvoy/sim/fault_engine.hpp"
#include "canvoy/sim/power_cuts.hpp"
#include "canvoy/worlds/taxi/meter_watch.hpp"
#include "canvoy/worlds/taxi/tampering.hpp"
#include "canvoy/worlds/taxi/taxi_car.hpp"
#include "canvoy/worlds/taxi/taxi_excuses.hpp"
#include "canvoy/worlds/taxi/trip_book.hpp"

namespace canvoy::taxi {

class TaxiFaults {
 public:
  /// All must outlive this object.
  TaxiFaults(TaxiCar& car, const FaultPlan& plan, TripBook& trips, MeterWatch& watch,
             TaxiExcuses& excuses, TamperWatch& tampering, EventLog<TaxiEvent>& events);
  TaxiFaults(const TaxiFaults&) = delete;
  TaxiFaults& operator=(const TaxiFaults&) = delete;

  /// Plans the faults; this object must outlive the world's last run.
  void plan();

 private:
  using Engine = FaultEngine<FaultKind>;
  friend Engine;
  Time now() const { return car_.bus().world().now(); }
  void began(std::size_t fault);
  void ended(std::size_t fault);
  void set(std::size_t fault, bool is_present);
  void power(NodeId id, bool is_on);
  void meter_power(bool is_on);

  TaxiCar& car_;
  TripBook& trips_;
  MeterWatch& watch_;
  TaxiExcuses& excuses_;
  TamperWatch& tamper_watch_;
  EventLog<TaxiEvent>& events_;
  Engine faults_;
  BusTrouble trouble_;
  PowerCuts cuts_;
  Tampering tampering_;
  Time meter_lost_at_{};
};

}  // namespace canvoy::taxi
