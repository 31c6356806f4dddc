// The sensor unit of a lift, at one landing or in the car: glass, smoke, damage, pressure and
// temperature (CiA 417-4, 4.13).
//
//     ShaftSensors sensors(world, slot, 14, floor_of_car);
//     sensors.set_level(SensorFunction::smoke, true);
//
// It sends them by its PDO of 6012h, at 380h plus its node-ID, as a configuration tool sets it. The
// clause names no device that acts on them: a controller only supervises the unit.
#pragma once

#include <array>

#include "canvoy/devices/cia417/sensor/sensor_place.hpp"
#include "canvoy/devices/cia417/sensor/sensor_unit_device.hpp"
#include "canvoy/sim/node_configuration.hpp"
#include "canvoy/sim/world.hpp"
#include "canvoy/worlds/lift/building.hpp"

namespace canvoy::lift {

class ShaftSensors {
 public:
  /// Sensor unit of lift 1 of its bus. `world` must outlive this object, which takes the slot.
  ShaftSensors(World& world, SlotIndex slot, NodeId id, FloorNumber floor);
  ShaftSensors(const ShaftSensors&) = delete;
  ShaftSensors& operator=(const ShaftSensors&) = delete;

  /// Node of the unit.
  Node& node() { return device_.node(); }
  /// Floor of the unit; floor_of_car: in the car.
  FloorNumber floor() const { return floor_; }

  /// Sets an input, at once; a unit without power reports it when it boots.
  void set_level(cia417::SensorFunction sensor, bool high);
  /// Sets the value of a measuring sensor, in units of its parameter 3: degrees Celsius, pascal.
  void set_value(cia417::SensorFunction sensor, std::int16_t value);
  /// Sets it to defective, not installed, or working again (not_set).
  void report(cia417::SensorFunction sensor, cia417::SensorSignal condition);

 private:
  /// Number of sensors, like that of `canvoy device lift-sensors`.
  static constexpr std::uint8_t room = 8;
  static constexpr std::int16_t room_temperature = 20;

  template <class Change>
  void change(const Change& change_at);

  World* world_;
  SlotIndex slot_;
  FloorNumber floor_;
  cia417::PlacedSensors sensors_;
  cia417::SensorUnitDevice<room> device_;
  std::array<NodeValue, 1> values_;
  NodeConfiguration configuration_;
};

}  // namespace canvoy::lift
