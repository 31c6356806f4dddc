// The devices of a bus that sense the vehicle: its gateway and tachograph, the satellite receiver,
// the sensors at the doors that count people in and out, and the driver's display.
//
//     VehicleSensors sensors(nodes, options.sabotage, vehicle, clock);
//     sensors.passed(door, is_in);          // somebody is through
//     sensors.lose_satellites(true);
#pragma once

#include <chrono>
#include <deque>
#include <optional>

#include "canvoy/devices/cia407/counting/counting_manager_unit.hpp"
#include "canvoy/devices/cia407/counting/passenger_counter_unit.hpp"
#include "canvoy/devices/cia407/gateway/vehicle_gateway_unit.hpp"
#include "canvoy/devices/cia407/positioning/positioning_unit.hpp"
#include "canvoy/devices/cia407/positioning/time_fixing_unit.hpp"
#include "canvoy/devices/cia407/tachograph/tachograph_unit.hpp"
#include "canvoy/worlds/bus_line/bus_nodes.hpp"
#include "canvoy/worlds/bus_line/true_clock.hpp"

namespace canvoy::bus_line {

class VehicleSensors {
 public:
  /// All must outlive this object.
  VehicleSensors(BusNodes& nodes, const Sabotage& sabotage, const BusVehicle& vehicle,
                 const TrueClock& clock)
      : nodes_(nodes), sabotage_(sabotage), vehicle_(vehicle), clock_(clock) {}
  VehicleSensors(const VehicleSensors&) = delete;
  VehicleSensors& operator=(const VehicleSensors&) = delete;

  /// Puts them on the bus.
  void add_nodes();

  /// Call it when a contact at a door has changed: the gateway reads it at once.
  void door_changed() {
    nodes_.node(vehicle_gateway_id).with([] {});
  }
  /// A person has got in or out by this door; the first is 0.
  void passed(std::size_t door, bool is_in);
  /// The driver sets the counts to 0.
  void clear_counts();
  /// True while all devices that count are at work, except the on-board computer.
  bool count_passengers();
  /// Takes away the signal of satellites, or returns it.
  void lose_satellites(bool are_lost) { satellites_are_lost_ = are_lost; }
  /// True while the receiver has a signal.
  bool has_satellites() const { return !satellites_are_lost_; }

 private:
  /// Counter of a door, from 1 on; the first door is at the front.
  struct DoorCounter {
    cia407::PassengerCounterSettings settings() { return {.door = door}; }

    DeviceKey key = 0;
    unsigned door = 0;
    cia407::PassengerCounterUnit* unit = nullptr;
  };

  void add_vehicle_devices();
  void add_counters();
  cia407::VehicleGatewayHardware gateway_hardware();
  cia407::VehicleReading read_vehicle();
  cia407::TachographHardware tachograph_hardware();
  cia407::TachographReading read_tachograph();
  cia407::PositioningHardware positioning_hardware();
  cia447::GpsReading read_position();
  cia407::TimeFixingHardware time_hardware();
  std::chrono::minutes local_offset() { return clock_.offset(); }
  std::optional<cia407::CivilTime> satellite_time();
  cia407::CountingManagerSettings manager() { return {.capacity = *nodes_.design().capacity}; }

  BusNodes& nodes_;
  const Sabotage& sabotage_;
  const BusVehicle& vehicle_;
  const TrueClock& clock_;
  std::deque<DoorCounter> counters_;
  cia407::CountingManagerUnit* counting_ = nullptr;
  bool satellites_are_lost_ = false;
};

}  // namespace canvoy::bus_line
