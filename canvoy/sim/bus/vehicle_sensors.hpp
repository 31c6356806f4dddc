// The devices of a bus that sense the vehicle: its gateway and tachograph, the satellite receiver,
// the sensors at the doors that count who gets in and out, and the driver's display.
//
//     VehicleSensors sensors(nodes, options.sabotage, vehicle, clock);
//     sensors.passed(door, is_in);          // somebody is through
//     sensors.lose_satellites(true);
#pragma once

#include <array>
#include <chrono>
#include <optional>

#include "canvoy/devices/cia407/counting/counting_manager_unit.hpp"
#include "canvoy/devices/cia407/counting/passenger_counter_unit.hpp"
#include "canvoy/devices/cia407/gateway/vehicle_gateway_unit.hpp"
#include "canvoy/devices/cia407/positioning/positioning_unit.hpp"
#include "canvoy/devices/cia407/positioning/time_fixing_unit.hpp"
#include "canvoy/devices/cia407/tachograph/tachograph_unit.hpp"
#include "canvoy/sim/bus/bus_nodes.hpp"
#include "canvoy/sim/bus/true_clock.hpp"

namespace canvoy::bus {

class VehicleSensors {
 public:
  /// All must outlive this.
  VehicleSensors(BusNodes& nodes, const Sabotage& sabotage, const BusVehicle& vehicle,
                 const TrueClock& clock)
      : nodes_(nodes), sabotage_(sabotage), vehicle_(vehicle), clock_(clock) {}
  VehicleSensors(const VehicleSensors&) = delete;
  VehicleSensors& operator=(const VehicleSensors&) = delete;

  /// Puts them on the bus.
  void add_nodes();

  /// A contact at a door has changed: the gateway looks at once.
  void door_changed() {
    nodes_.node(vehicle_gateway_id).with([] {});
  }
  /// Somebody is in or out by this door, the first is 0.
  void passed(std::size_t door, bool is_in);
  /// The driver sets the counts to 0.
  void clear_counts();
  /// Who takes part in counting does its work, but for the on-board computer.
  bool count_passengers();
  void lose_satellites(bool are_lost) { satellites_are_lost_ = are_lost; }
  bool has_satellites() const { return !satellites_are_lost_; }

 private:
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
  cia407::PassengerCounterSettings first_counter() { return {.door = 1}; }
  cia407::PassengerCounterSettings second_counter() { return {.door = 2}; }
  void is_first_counter(cia407::PassengerCounterUnit& unit, Node& /*node*/) {
    counters_[0] = &unit;
  }
  void is_second_counter(cia407::PassengerCounterUnit& unit, Node& /*node*/) {
    counters_[1] = &unit;
  }
  void is_counting_manager(cia407::CountingManagerUnit& unit, Node& /*node*/) { counting_ = &unit; }

  BusNodes& nodes_;
  const Sabotage& sabotage_;
  const BusVehicle& vehicle_;
  const TrueClock& clock_;
  std::array<cia407::PassengerCounterUnit*, 2> counters_{};
  cia407::CountingManagerUnit* counting_ = nullptr;
  bool satellites_are_lost_ = false;
};

}  // namespace canvoy::bus
