// The faults of a plan in an excavator: made, mended, told, and given to the referees.
//
//     ExcavatorFaults faults(world, bus, options, devices, panel, referees, events);   // plans all
#pragma once

#include <array>
#include <vector>

#include "canvoy/sim/bus_trouble.hpp"
#include "canvoy/sim/excavator/excavator_devices.hpp"
#include "canvoy/sim/excavator/excavator_event.hpp"
#include "canvoy/sim/excavator/excavator_referees.hpp"
#include "canvoy/sim/power_cuts.hpp"

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
  void begin(std::size_t fault);
  void end(std::size_t fault);
  void set(const ScheduledFault& fault, bool present);
  void power(NodeId id, bool is_on) { devices_->power(devices_->node(id), is_on); }
  void cut_cables();
  unsigned& count_of(const ScheduledFault& fault);

  World* world_;
  BusIndex bus_;
  const ExcavatorOptions* options_;
  ExcavatorDevices* devices_;
  SeatPanel* panel_;
  ExcavatorReferees* referees_;
  std::vector<ExcavatorEvent>* events_;
  BusTrouble trouble_;  ///< of the machine's bus

  // How many of each are present, and where.
  std::array<std::array<unsigned, node_id_max + 1>, fault_kinds> at_node_{};
  std::array<std::array<unsigned, stick_count>, fault_kinds> at_axis_{};
  PowerCuts cuts_;  ///< a node-ID is on one of both buses
};

}  // namespace canvoy::excavator
