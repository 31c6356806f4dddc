// Makes and mends the faults of the plan in a police car, and reports what they excuse.
//
//     PoliceFaults faults(car, options.faults, excuses, events);
//     faults.plan();
//     faults.step();       // each 100 ms
#pragma once

#include "canvoy/sim/bus_trouble.hpp"
#include "canvoy/sim/fault_engine.hpp"
#include "canvoy/sim/power_cuts.hpp"
#include "canvoy/worlds/police/police_car.hpp"
#include "canvoy/worlds/police/police_excuses.hpp"

namespace canvoy::police {

class PoliceFaults {
 public:
  /// All must outlive this object.
  PoliceFaults(PoliceCar& car, const FaultPlan& plan, PoliceExcuses& excuses,
               EventLog<PoliceEvent>& events);
  PoliceFaults(const PoliceFaults&) = delete;
  PoliceFaults& operator=(const PoliceFaults&) = delete;

  /// Plans the faults; this object must outlive the world's last run.
  void plan();
  /// Call it in each step: a client that must lose its power loses it while it has the terminal.
  void step();

 private:
  using Engine = FaultEngine<FaultKind>;
  friend Engine;
  Time now() const { return car_.bus().world().now(); }
  void began(std::size_t fault);
  void ended(std::size_t fault);
  void set(std::size_t fault, bool is_present);
  void let_client_die(bool shall_die);
  void power(NodeId id, bool is_on) { car_.power(car_.bus().node(id), is_on); }

  PoliceCar& car_;
  PoliceExcuses& excuses_;
  EventLog<PoliceEvent>& events_;
  Engine faults_;
  BusTrouble trouble_;
  PowerCuts cuts_;
  bool client_shall_die_ = false;
  NodeId dead_client_ = 0;
};

}  // namespace canvoy::police
