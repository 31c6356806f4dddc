// The faults of a plan in an excavator: it makes and mends them, and reports them as events and to
// the referees.
//
//     ExcavatorFaults faults(world, bus, options, devices, panel, referees, events);   // plans all
#pragma once

#include <vector>

#include "canvoy/sim/bus_trouble.hpp"
#include "canvoy/sim/fault_engine.hpp"
#include "canvoy/sim/power_cuts.hpp"
#include "canvoy/worlds/excavator/excavator_devices.hpp"
#include "canvoy/worlds/excavator/excavator_event.hpp"
#include "canvoy/worlds/excavator/excavator_referees.hpp"

namespace canvoy::excavator {

class ExcavatorFaults {
 public:
  /// All must outlive the last run of `world`. `bus` is that of the machine.
  ExcavatorFaults(World& world, BusIndex bus, const ExcavatorOptions& options,
                  ExcavatorDevices& devices, SeatPanel& panel, ExcavatorReferees& referees,
                  std::vector<ExcavatorEvent>& events);
  ExcavatorFaults(const ExcavatorFaults&) = delete;
  ExcavatorFaults& operator=(const ExcavatorFaults&) = delete;

 private:
  using Engine = FaultEngine<FaultKind>;
  friend Engine;
  void began(std::size_t fault);
  void ended(std::size_t fault);
  void set(std::size_t fault, bool present);
  void power(NodeId id, bool is_on) { devices_->power(devices_->node(id), is_on); }
  void cut_cables();

  World* world_;
  BusIndex bus_;
  const ExcavatorOptions* options_;
  ExcavatorDevices* devices_;
  SeatPanel* panel_;
  ExcavatorReferees* referees_;
  std::vector<ExcavatorEvent>* events_;
  BusTrouble trouble_;  ///< of the machine's bus
  Engine faults_;
  PowerCuts cuts_;  ///< a node-ID is on one of the two buses only
};

}  // namespace canvoy::excavator
