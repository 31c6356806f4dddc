// Measured values of the car of an IVN gateway, sensed every 100 ms. States (doors, engine,
// occupants ...) are reported to it instead, and commands go to `switched.drive`.
//
//     CarHardware hardware{.speed = Callback<std::optional<double>()>::to<&Taxi::speed>(taxi),
//     ...};
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "canvoy/devices/cia447/kit/switching.hpp"
#include "canvoy/profiles/cia447/states.hpp"

namespace canvoy::cia447 {

/// The value of a sensor; nothing: it has failed. An empty callback: the car has no such sensor,
/// and the signal is not available.
using Sensor = Callback<std::optional<double>()>;

struct CarHardware {
  Sensor speed = {};     ///< m/s; the sign is ignored
  Sensor distance = {};  ///< m driven by the car, forwards and backwards; never decreases

  Sensor engine_speed = {};  ///< revolutions per minute
  /// State of engine and transmission. Without a callback, the application reports it.
  Callback<Engine()> engine = {};
  Callback<Gear()> gear = {};  ///< engaged gear

  Sensor fuel = {};              ///< in the tank, litres
  Sensor fuel_consumption = {};  ///< CarSettings::fuel_unit per second

  Sensor steering_wheel_angle = {};  ///< degrees; positive: to the left
  Sensor outside_temperature = {};   ///< degrees Celsius
  Sensor inside_temperature = {};    ///< degrees Celsius
  Sensor light_intensity = {};       ///< outside, 0 to 100 percent
  Sensor mirror_dimming = {};        ///< 0 to 100 percent

  /// 17 characters that live as long as the hardware; empty if not known.
  Callback<std::string_view()> vin = {};

  SwitchedHardware switched = {};  ///< what commands drive
};

/// Properties of the car.
struct CarSettings {
  unsigned pulses_per_rotation = 48;   ///< 21 to 253 (4.2.4.6, 4.2.4.8)
  double wheel_circumference_m = 2.0;  ///< above 0
  /// The highest count of the wheel pulse counter, followed by 0 (6056h).
  std::uint16_t pulse_counter_max = 0xFFFF;
  WheelSource wheel_source = WheelSource::average_rear;  ///< wheels that the pulses are of

  double local_distance_m = 1000;        ///< the unit of speed and mileage: 1609.344 for miles
  double mileage_at_start_m = 0;         ///< added to CarHardware::distance
  double tank_minimum_l = 7;             ///< the driver is warned from this level downward
  FuelUnit fuel_unit = FuelUnit::litre;  ///< of the tank and the consumption
  double charging_rpm = 500;  ///< from here upward the alternator charges (terminal 61 active)

  SwitchedSettings switched = {};  ///< of the functions that are switched
};

/// A parked car with its engine off.
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
      [](void*) { return std::string_view("CANVY000000000447"); }, nullptr);
  return car;
}

}  // namespace canvoy::cia447
