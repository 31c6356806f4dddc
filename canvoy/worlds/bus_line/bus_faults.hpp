// Makes and mends the faults of the plan in a bus, and reports to its referee what they excuse.
//
//     BusFaults faults(nodes, options.faults, {.displays = displays, ...}, hands, events);
//     faults.plan();
#pragma once

#include <deque>

#include "canvoy/sim/bus_trouble.hpp"
#include "canvoy/sim/fault_engine.hpp"
#include "canvoy/sim/power_cuts.hpp"
#include "canvoy/worlds/bus_line/bus_displays.hpp"
#include "canvoy/worlds/bus_line/bus_nodes.hpp"
#include "canvoy/worlds/bus_line/bus_referee.hpp"
#include "canvoy/worlds/bus_line/following_cars.hpp"
#include "canvoy/worlds/bus_line/on_board_computer.hpp"
#include "canvoy/worlds/bus_line/ticket_devices.hpp"
#include "canvoy/worlds/bus_line/vehicle_sensors.hpp"

namespace canvoy::bus_line {

class BusFaults {
 public:
  /// Objects that faults affect; all must outlive the faults.
  struct Parts {
    BusDisplays& displays;      ///< may lose their power
    OnBoardComputer& computer;  ///< whose clock may be wrong
    VehicleSensors& sensors;    ///< that lose satellites
    TicketDevices& tickets;     ///< that run out of paper
    FollowingCars& following;   ///< behind the train bus
    BusVehicle& vehicle;        ///< whose doors break
    BusReferee& referee;        ///< told what is excused
  };
  /// Functions that receive the reports of faults.
  struct Hands {
    /// Called when a fault begins that affects these invariants.
    Callback<void(const InvariantSet&)> began;
    /// Called when a fault has changed the vehicle: its deadline may be another one.
    Callback<void()> vehicle_touched;
  };

  /// All must outlive this object.
  BusFaults(BusNodes& nodes, const FaultPlan& plan, const Parts& parts, const Hands& hands,
            EventLog<NetworkEvent>& events);
  BusFaults(const BusFaults&) = delete;
  BusFaults& operator=(const BusFaults&) = delete;

  /// Plans the faults; this object must outlive the world's last run.
  void plan();
  /// True while the cable of the first car is cut, or a device babbles on it.
  bool cable_is_broken() const {
    return faults_.is_present(FaultKind::cable_cut) || faults_.is_present(FaultKind::babbling_node);
  }
  /// True while a fault has cut the power of this device.
  bool is_without_power(DeviceKey key) const { return key <= node_id_max && cuts_.is_cut(key); }

 private:
  using Engine = FaultEngine<FaultKind>;
  friend Engine;
  Time now() const { return nodes_.world().now(); }
  void began(std::size_t fault);
  void ended(std::size_t fault);
  void set(std::size_t fault, bool is_present);
  void set_of_cables(const ScheduledFault& fault, bool is_present);
  DeviceKey device_of(const ScheduledFault& fault) const;
  FaultPlace place_of(const ScheduledFault& fault) const;
  void cut(DeviceKey behind, bool is_present);
  void power(DeviceKey key, bool is_on);

  BusNodes& nodes_;
  Parts parts_;
  Hands hands_;
  EventLog<NetworkEvent>& events_;
  Engine faults_;
  std::deque<BusTrouble> troubles_;  ///< of the cable of each car
  PowerCuts cuts_;
};

}  // namespace canvoy::bus_line
