// What an IVN gateway asks of its car: numbers, sensed each 100 ms. What is in states (doors,
// engine, occupants ...) is reported to it instead, and what it is told to do goes to
// `switched.drive`.
//
//     CarHardware hardware{.speed = Callback<std::optional<double>()>::to<&Taxi::speed>(taxi),
//     ...};
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "canvoy/devices/cia447/switching.hpp"
#include "canvoy/profiles/cia447/states.hpp"

namespace canvoy::cia447 {

/// What a sensor says; nothing: it fails. A callback that is not there: the car has no such sensor,
/// and the signal is not available.
using Sensor = Callback<std::optional<double>()>;

struct CarHardware {
  Sensor speed = {};     ///< m/s; its sign says nothing
  Sensor distance = {};  ///< m that the car was driven, forwards and backwards; only ever rises

  Sensor engine_speed = {};  ///< revolutions a minute
  /// What engine and transmission do; where it is not there, who knows it reports it.
  Callback<Engine()> engine = {};
  Callback<Gear()> gear = {};

  Sensor fuel = {};              ///< in the tank, litres
  Sensor fuel_consumption = {};  ///< CarSettings::fuel_unit a second

  Sensor steering_wheel_angle = {};  ///< degrees; positive: to the left
  Sensor outside_temperature = {};   ///< degrees Celsius
  Sensor inside_temperature = {};    ///< degrees Celsius
  Sensor light_intensity = {};       ///< outside, 0 to 100 percent
  Sensor mirror_dimming = {};        ///< 0 to 100 percent

  /// 17 characters that live as long as the hardware; empty: not known.
  Callback<std::string_view()> vin = {};

  SwitchedHardware switched = {};
};

struct CarSettings {
  unsigned pulses_per_rotation = 48;   ///< 21 to 253 (4.2.4.6, 4.2.4.8)
  double wheel_circumference_m = 2.0;  ///< above 0
  /// The highest count of the wheel pulse counter: 0 comes after it (6056h).
  std::uint16_t pulse_counter_max = 0xFFFF;
  WheelSource wheel_source = WheelSource::average_rear;

  double local_distance_m = 1000;  ///< the unit of speed and mileage: 1609.344 for miles
  double mileage_at_start_m = 0;   ///< beside what CarHardware::distance says
  double tank_minimum_l = 7;       ///< from here downward the driver is warned
  FuelUnit fuel_unit = FuelUnit::litre;
  double charging_rpm = 500;  ///< from here upward the alternator charges: terminal 61 is active

  SwitchedSettings switched = {};
};

/// A car that stands in a garage, its engine off.
inline CarHardware parked_car() {
  const auto says = [](auto sensed) { return Sensor(sensed, nullptr); };
  CarHardware car;
  car.speed = car.distance = car.engine_speed = car.fuel_consumption = car.steering_wheel_angle =
      car.mirror_dimming = says([](void*) -> std::optional<double> { return 0; });
  car.fuel = says([](void*) -> std::optional<double> { return 40; });
  car.outside_temperature = car.inside_temperature =
      says([](void*) -> std::optional<double> { return 15; });
  car.light_intensity = says([](void*) -> std::optional<double> { return 50; });
  car.vin = Callback<std::string_view()>(
      [](void*) { return std::string_view("CANVOY00000000447"); }, nullptr);
  return car;
}

}  // namespace canvoy::cia447
