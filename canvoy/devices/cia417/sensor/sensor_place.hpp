// The sensors of a unit at one location of a lift: one of each kind that has data (CiA 417-4,
// 4.13.1).
//
//     const PlacedSensors sensors = sensors_at(1, 3);   // at floor 3 of lift 1
//     SensorUnit unit(node, tpdos, memory, {.sensors = sensors});
#pragma once

#include <array>
#include <cstddef>

#include "canvoy/devices/cia417/virtual_io/virtual_io.hpp"
#include "canvoy/profiles/cia417/sensors.hpp"

namespace canvoy::cia417 {

/// Functions from this one on; a generic sensor has no data.
inline constexpr auto first_placed_sensor = SensorFunction::glass;
/// Sensors of one location.
using PlacedSensors = std::array<VirtualSensor, 5>;

/// Index of a sensor with this function, from `first_placed_sensor` to `temperature`.
constexpr std::size_t sensor_number(SensorFunction function) {
  return static_cast<std::size_t>(function) - static_cast<std::size_t>(first_placed_sensor);
}

/// True if it has a value beside its signal.
constexpr bool is_measured(SensorFunction function) {
  return function == SensorFunction::pressure || function == SensorFunction::temperature;
}

/// `lift` is 1 to 8, `floor` 1 to 254, or floor_of_car.
constexpr PlacedSensors sensors_at(unsigned lift, std::uint8_t floor) {
  PlacedSensors sensors;
  for (std::size_t i = 0; i < sensors.size(); ++i) {
    const std::size_t function = static_cast<std::size_t>(first_placed_sensor) + i;
    sensors[i] = {
        .function = static_cast<SensorFunction>(function), .lifts = lift_bit(lift), .floor = floor};
  }
  return sensors;
}

}  // namespace canvoy::cia417
