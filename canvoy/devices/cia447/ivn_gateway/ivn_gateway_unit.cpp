#include "canvoy/devices/cia447/ivn_gateway/ivn_gateway_unit.hpp"

#include <cmath>

namespace canvoy::cia447 {

namespace {

constexpr Duration lead = 1ms;
constexpr double seconds_per_minute = 60;
constexpr double per_hour = 3600;
constexpr double consumption_max = 0x7F00 / 1000.0;  ///< units per second that 605Dh can hold
constexpr std::string_view no_vin{"\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0", 17};

std::optional<double> known(bool is_known, double number) {
  return is_known ? std::optional(number) : std::nullopt;
}

}  // namespace

constexpr ServiceHandlers IvnGatewayUnit::service_calls = {
    .reset = method<&IvnGatewayUnit::reset>,
    .state_entered = method<&IvnGatewayUnit::state_entered>};

IvnGatewayUnit::IvnGatewayUnit(CarNetwork& network, const CarHardware& hardware,
                               const CarSettings& settings)
    : network_(network),
      hardware_(hardware),
      settings_(settings),
      body_(network, hardware.switched, settings.switched),
      light_(network, hardware.switched, settings.switched),
      power_train_(network, hardware.switched, settings.switched),
      seats_(network, hardware.switched, settings.switched),
      pulses_({.per_rotation = settings.pulses_per_rotation,
               .circumference_m = settings.wheel_circumference_m,
               .count_max = settings.pulse_counter_max}),
      timer_(callback<&IvnGatewayUnit::look>(*this)) {
  network.node().attach(service_);
}

void IvnGatewayUnit::report(const FieldPlace& status, std::uint32_t code) {
  body().report(status, code);
  light().report(status, code);
  power_train().report(status, code);
  seats_.report(status, code);
}

void IvnGatewayUnit::sense(const FieldPlace& status, Sensing sensing) {
  body().sense(status, sensing);
  light().sense(status, sensing);
  power_train().sense(status, sensing);
}

/// No sensor has been read yet: numbers are not available.
void IvnGatewayUnit::reset(ResetScope) {
  const Values car(network_.node().dictionary());
  car[actual_engine_revolutions] = std::nullopt;
  car[wheel_rpm] = std::nullopt;
  car[displayed_vehicle_speed] = std::nullopt;
  car[odometer] = std::nullopt;
  car[tank_level] = std::nullopt;
  car[tank_level_minimum] = Signal::not_available;
  car[current_average_fuel_consumption] = std::nullopt;
  car[current_average_fuel_consumption_overflow] = Signal::not_available;
  car[steering_wheel_angle] = std::nullopt;
  car[steering_wheel_angle_side] = SteeringWheelSide::not_available;
  car[displayed_outside_air_temperature] = std::nullopt;
  car[displayed_inside_air_temperature] = std::nullopt;
  car[environment_light_intensity] = std::nullopt;
  car[mirror_anti_dazzle_position] = std::nullopt;
  car[vin_data] = no_vin;
  car[wheel_pulse_counter_overrun_value] = settings_.pulse_counter_max;
  car[wheel_pulse_counter_overrun_value_valid] = Signal::not_available;
  report_pulses(Signal::not_available);
  report_constants();
  network_.node().timers().arm(timer_, network_.node().now() + cycle);
}

/// Slightly before the end of the cycle of PDO 17: changes are then sent, that starts the next
/// cycle, and no second frame follows.
void IvnGatewayUnit::state_entered(NmtState state) {
  if (state != NmtState::operational) return;
  network_.node().timers().arm(timer_, network_.node().now() + cycle - lead);
}

void IvnGatewayUnit::report_constants() {
  const Values car(network_.node().dictionary());
  car[wheel_signal_source] = settings_.wheel_source;
  car[pulses_per_wheel_rotation] = settings_.pulses_per_rotation;
  car[current_average_fuel_consumption_unit] = settings_.fuel_unit;
}

void IvnGatewayUnit::look(Time now) {
  network_.node().timers().arm(timer_, now + cycle);
  look_at_wheels();
  look_at_engine();
  look_at_fuel();
  look_at_surroundings();
  const std::string_view vin = hardware_.vin();
  const auto told = Values(network_.node().dictionary())[vin_data];
  told = vin.empty() ? no_vin : vin;
}

/// The value of a sensor; without a value, whether the sensor exists.
template <class Handle>
void IvnGatewayUnit::tell(const Handle& handle, const Sensor& sensor,
                          const std::optional<double>& sensed) {
  Dictionary& dictionary = network_.node().dictionary();
  const auto value = Values(dictionary)[handle];
  if (sensed) {
    value = *sensed;
  } else if (sensor) {
    write_field(dictionary, place_of(handle),
                code_meaning(place_of(handle), Meaning::failure).value_or(0));
  } else {
    value = std::nullopt;
  }
}

/// The state beside a number that is not known.
template <class Handle>
void IvnGatewayUnit::report_unknown(const Handle& handle, const Sensor& sensor) {
  const Meaning meaning = sensor ? Meaning::failure : Meaning::invalid;
  write_field(network_.node().dictionary(), place_of(handle),
              code_meaning(place_of(handle), meaning).value_or(0));
}

void IvnGatewayUnit::look_at_wheels() {
  const Values car(network_.node().dictionary());
  const std::optional<double> speed = hardware_.speed();
  const bool is_known = speed.has_value();
  const double metres_per_second = std::abs(speed.value_or(0));
  tell(wheel_rpm, hardware_.speed,
       known(is_known, metres_per_second * seconds_per_minute / settings_.wheel_circumference_m));
  tell(displayed_vehicle_speed, hardware_.speed,
       known(is_known, metres_per_second * per_hour / settings_.local_distance_m));

  const std::optional<double> driven = hardware_.distance();
  if (driven) pulses_.drive(*driven);
  // The last digit changes when its unit is complete.
  const double units =
      (settings_.mileage_at_start_m + driven.value_or(0)) / settings_.local_distance_m;
  tell(odometer, hardware_.distance, known(driven.has_value(), std::floor(units * 10) / 10));
  car[wheel_pulse_counter_overrun_value_valid] = Signal::yes;
  report_pulses(driven               ? Signal::yes
                : hardware_.distance ? Signal::failure
                                     : Signal::not_available);
}

void IvnGatewayUnit::report_pulses(Signal valid) {
  const Values car(network_.node().dictionary());
  car[wheel_pulse_counter] = pulses_.count();
  car[wheel_pulse_counter_valid] = valid;
}

void IvnGatewayUnit::look_at_engine() {
  const std::optional<double> rpm = hardware_.engine_speed();
  tell(actual_engine_revolutions, hardware_.engine_speed, rpm);
  if (rpm) {
    const bool charges = *rpm >= settings_.charging_rpm;
    report(actual_engine_revolutions_terminal_61, charges ? Signal::yes : Signal::no);
  }
  if (hardware_.engine) report(engine_status, hardware_.engine());
  if (hardware_.gear) report(engaged_gear, hardware_.gear());
}

void IvnGatewayUnit::look_at_fuel() {
  const Values car(network_.node().dictionary());
  const std::optional<double> litres = hardware_.fuel();
  tell(tank_level, hardware_.fuel, litres);
  if (litres) {
    car[tank_level_minimum] = *litres <= settings_.tank_minimum_l ? Signal::yes : Signal::no;
  } else {
    report_unknown(tank_level_minimum, hardware_.fuel);
  }
  const std::optional<double> used = hardware_.fuel_consumption();
  tell(current_average_fuel_consumption, hardware_.fuel_consumption, used);
  if (used) {
    car[current_average_fuel_consumption_overflow] =
        *used > consumption_max ? Signal::yes : Signal::no;
  } else {
    report_unknown(current_average_fuel_consumption_overflow, hardware_.fuel_consumption);
  }
}

void IvnGatewayUnit::look_at_surroundings() {
  const Values car(network_.node().dictionary());
  const std::optional<double> angle = hardware_.steering_wheel_angle();
  tell(steering_wheel_angle, hardware_.steering_wheel_angle,
       known(angle.has_value(), std::abs(angle.value_or(0))));
  if (angle) {
    car[steering_wheel_angle_side] =
        *angle < 0 ? SteeringWheelSide::right : SteeringWheelSide::left;
  } else {
    report_unknown(steering_wheel_angle_side, hardware_.steering_wheel_angle);
  }
  const auto report_sensed = [this](const auto& handle, const Sensor& sensor) {
    tell(handle, sensor, sensor());
  };
  report_sensed(displayed_outside_air_temperature, hardware_.outside_temperature);
  report_sensed(displayed_inside_air_temperature, hardware_.inside_temperature);
  report_sensed(environment_light_intensity, hardware_.light_intensity);
  report_sensed(mirror_anti_dazzle_position, hardware_.mirror_dimming);
}

}  // namespace canvoy::cia447
