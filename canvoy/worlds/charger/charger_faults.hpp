// The faults of a plan between a battery and its charger: it makes and mends them, and reports them
// as events and to the referees.
//
//     ChargerFaults faults(world, options, devices, referees, events);   // plans them all
#pragma once

#include <memory>
#include <vector>

#include "canvoy/sim/bus_trouble.hpp"
#include "canvoy/sim/fault_engine.hpp"
#include "canvoy/worlds/charger/charger_devices.hpp"
#include "canvoy/worlds/charger/charger_event.hpp"
#include "canvoy/worlds/charger/charger_referees.hpp"

namespace canvoy::charger {

struct Imposter;

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

}  // namespace canvoy::charger
