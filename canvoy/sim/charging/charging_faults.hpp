// The faults of a plan between a battery and its charger: made, mended, told, and given to the
// referees.
//
//     ChargingFaults faults(world, options, devices, referees, events);   // plans them all
#pragma once

#include <memory>
#include <vector>

#include "canvoy/sim/bus_trouble.hpp"
#include "canvoy/sim/charging/charging_devices.hpp"
#include "canvoy/sim/charging/charging_event.hpp"
#include "canvoy/sim/charging/charging_referees.hpp"
#include "canvoy/sim/fault_engine.hpp"

namespace canvoy::charging {

struct Imposter;

class ChargingFaults {
 public:
  /// All must outlive the last run of `world`. Nodes that faults need are on the cable from here
  /// on, without power.
  ChargingFaults(World& world, const ChargingOptions& options, ChargingDevices& devices,
                 ChargingReferees& referees, std::vector<ChargingEvent>& events);
  ~ChargingFaults();
  ChargingFaults(const ChargingFaults&) = delete;
  ChargingFaults& operator=(const ChargingFaults&) = delete;

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
  const ChargingOptions* options_;
  ChargingDevices* devices_;
  ChargingReferees* referees_;
  std::vector<ChargingEvent>* events_;
  std::unique_ptr<Imposter> imposter_;
  BusTrouble trouble_;
  Engine faults_;
};

}  // namespace canvoy::charging
