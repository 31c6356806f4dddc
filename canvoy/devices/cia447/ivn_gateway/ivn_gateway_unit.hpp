// The IVN gateway: connects the car's own networks to CANopen (CiA 447-3, 4.2.2 to 4.2.4), in three
// function groups: car body electronics, light and signaling, power train.
//
//     IvnGatewayUnit gateway(network, hardware, {.pulses_per_rotation = 60});
//     gateway.report(door_status_driver, Opening::open);
//     gateway.sense(car_light_status_brake, Sensing::failure);
//
// Commands take effect according to the tables (car_body_table.hpp, light_table.hpp,
// power_train_table.hpp); car_seats.hpp has the seats. Measured values are sensed every 100 ms from
// the time when the node becomes operational, and are not available before (4.2.4.6).
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "canvoy/devices/cia447/ivn_gateway/car_body_table.hpp"
#include "canvoy/devices/cia447/ivn_gateway/car_seats.hpp"
#include "canvoy/devices/cia447/ivn_gateway/wheel_pulse_counter.hpp"
#include "canvoy/devices/cia447/kit/car_kind.hpp"
#include "canvoy/devices/cia447/kit/switching.hpp"
#include "canvoy/profiles/cia447/car_handles.hpp"
#include "canvoy/profiles/cia447/devices.hpp"
#include "canvoy/profiles/cia447/states.hpp"

namespace canvoy::cia447 {

/// The value of a sensor; nothing: it has failed. An empty callback: the car has no such sensor,
/// and the signal is not available.
using Sensor = Callback<std::optional<double>()>;

/// Measured values of the car of an IVN gateway, sensed every 100 ms. States (doors, engine,
/// occupants ...) are reported to it instead, and commands go to `switched.drive`.
///
///     CarHardware hardware{.speed = Callback<std::optional<double>()>::to<&Taxi::speed>(taxi),
///     ...};
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
/// Sets it to the member functions of a plain class that have these names: see PlainHardware.
template <class Plain>
constexpr void set_by_names(CarHardware& hardware, Plain& plain) {
  static_assert(
      requires { &Plain::speed; } || requires { &Plain::distance; } ||
          requires { &Plain::engine_speed; } || requires { &Plain::engine; } ||
          requires { &Plain::gear; } || requires { &Plain::fuel; } ||
          requires { &Plain::fuel_consumption; } || requires { &Plain::steering_wheel_angle; } ||
          requires { &Plain::outside_temperature; } || requires { &Plain::inside_temperature; } ||
          requires { &Plain::light_intensity; } || requires { &Plain::mirror_dimming; } ||
          requires { &Plain::vin; } || requires { &Plain::drive; } || requires { &Plain::became; },
      "the class has no member function of CarHardware: speed, distance, engine_speed, engine, "
      "gear, fuel, fuel_consumption, steering_wheel_angle, outside_temperature, "
      "inside_temperature, light_intensity, mirror_dimming, vin, drive or became");
  if constexpr (requires { &Plain::speed; }) hardware.speed = callback<&Plain::speed>(plain);
  if constexpr (requires { &Plain::distance; })
    hardware.distance = callback<&Plain::distance>(plain);
  if constexpr (requires { &Plain::engine_speed; })
    hardware.engine_speed = callback<&Plain::engine_speed>(plain);
  if constexpr (requires { &Plain::engine; }) hardware.engine = callback<&Plain::engine>(plain);
  if constexpr (requires { &Plain::gear; }) hardware.gear = callback<&Plain::gear>(plain);
  if constexpr (requires { &Plain::fuel; }) hardware.fuel = callback<&Plain::fuel>(plain);
  if constexpr (requires { &Plain::fuel_consumption; })
    hardware.fuel_consumption = callback<&Plain::fuel_consumption>(plain);
  if constexpr (requires { &Plain::steering_wheel_angle; })
    hardware.steering_wheel_angle = callback<&Plain::steering_wheel_angle>(plain);
  if constexpr (requires { &Plain::outside_temperature; })
    hardware.outside_temperature = callback<&Plain::outside_temperature>(plain);
  if constexpr (requires { &Plain::inside_temperature; })
    hardware.inside_temperature = callback<&Plain::inside_temperature>(plain);
  if constexpr (requires { &Plain::light_intensity; })
    hardware.light_intensity = callback<&Plain::light_intensity>(plain);
  if constexpr (requires { &Plain::mirror_dimming; })
    hardware.mirror_dimming = callback<&Plain::mirror_dimming>(plain);
  if constexpr (requires { &Plain::vin; }) hardware.vin = callback<&Plain::vin>(plain);
  if constexpr (requires { &Plain::drive; })
    hardware.switched.drive = callback<&Plain::drive>(plain);
  if constexpr (requires { &Plain::became; })
    hardware.switched.became = callback<&Plain::became>(plain);
}

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

// Reactions of lights and signals of the car to commands (CiA 447-3, 4.2.3).

inline constexpr const ObjectInfo* car_light_commands[] = {
    &car_light_command_object, &car_interior_light_command_object,
    &anti_theft_warning_system_command_object, &horn_command_object,
    &flashing_light_command_object};

inline constexpr Mirror car_light_mirrors[] = {
    {&car_light_command_object, &car_light_status_object, 50ms},
    {&car_interior_light_command_object, &car_interior_light_status_object, 50ms},
    {&flashing_light_command_object, &flashing_light_status_object, 50ms}};

inline constexpr Effect car_light_effects[] = {
    // A tip of the lever causes three flashes.
    pulse(car_light_command_tip_turn_indication_right, Order::on,
          car_light_status_tip_turn_indication_right, Signal::on, Signal::off, 2s),
    effect(car_light_command_tip_turn_indication_right, Order::off,
           car_light_status_tip_turn_indication_right, Signal::off, 0ms),
    pulse(car_light_command_tip_turn_indication_left, Order::on,
          car_light_status_tip_turn_indication_left, Signal::on, Signal::off, 2s),
    effect(car_light_command_tip_turn_indication_left, Order::off,
           car_light_status_tip_turn_indication_left, Signal::off, 0ms),

    // Code 1 is "pre-active" in the status and "do not trigger" in the command (errata C4).
    effect(anti_theft_warning_system_command, AntiTheftCommand::disable,
           anti_theft_warning_system_status, AntiTheft::disabled, 200ms),
    effect(anti_theft_warning_system_command, AntiTheftCommand::activate,
           anti_theft_warning_system_status, AntiTheft::pre_active, AntiTheft::active, 10s),
    effect(anti_theft_warning_system_command, AntiTheftCommand::trigger,
           anti_theft_warning_system_status, AntiTheft::triggered, 0ms),
    effect_from(anti_theft_warning_system_command, AntiTheftCommand::do_not_trigger,
                anti_theft_warning_system_status, AntiTheft::triggered, AntiTheft::active),

    effect(horn_command, Order::off, horn_status, Signal::off, 50ms),
    effect(horn_command, Order::on, horn_status, Signal::on, 50ms)};

inline constexpr SwitchedTable car_light_table = {
    .commands = car_light_commands, .mirrors = car_light_mirrors, .effects = car_light_effects};

// Reactions of cruise control and four-wheel drive to commands, and the states of engine and gear,
// which are reported (CiA 447-3, 4.2.4). At power-on the car is parked.

inline constexpr const ObjectInfo* power_train_commands[] = {&cruise_control_command_object,
                                                             &four_wheel_drive_command_object};

inline constexpr Mirror power_train_mirrors[] = {
    {&cruise_control_command_object, &cruise_control_status_object, 0ms},
    {&four_wheel_drive_command_object, &four_wheel_drive_status_object, 500ms}};

/// There is no code for a car that neither accelerates nor decelerates (errata C1).
inline constexpr Effect power_train_effects[] = {
    pulse(cruise_control_command_accelerate_decelerate, Acceleration::accelerate,
          cruise_control_status_accelerate_decelerate, Acceleration::accelerate,
          Acceleration::not_available, 1s),
    pulse(cruise_control_command_accelerate_decelerate, Acceleration::decelerate,
          cruise_control_status_accelerate_decelerate, Acceleration::decelerate,
          Acceleration::not_available, 1s)};

inline constexpr Rest power_train_rests[] = {
    rest(actual_engine_revolutions_terminal_61, Signal::no),
    rest(engine_status, Engine::off),
    rest(transmission_selector_lever_position, SelectorLever::parking),
    rest(automatic_gear_mode, GearMode::comfort),
    rest(parking_brake, Signal::yes),
    rest(coupling_switch, Signal::no),
    rest(engaged_gear, Gear::none),
    rest(cruise_control_status_accelerate_decelerate, Acceleration::not_available),
    rest(cruise_control_status_store, StoredSpeed::released)};

inline constexpr SwitchedTable power_train_table = {.commands = power_train_commands,
                                                    .mirrors = power_train_mirrors,
                                                    .effects = power_train_effects,
                                                    .rests = power_train_rests};

class IvnGatewayUnit {
 public:
  static constexpr Duration cycle = 100ms;  ///< 4.2.4.1, 4.2.4.4, 4.2.4.6

  /// Everything to which `hardware` and `settings` refer must outlive this.
  IvnGatewayUnit(CarNetwork& network, const CarHardware& hardware, const CarSettings& settings);

  /// Reports a state of the car: any status that has named states. For the front passenger's seat,
  /// by its place.
  template <class Handle, class State>
    requires requires { typename Handle::Place; }
  void report(const Handle& handle, State state) {
    report(place_of(handle), static_cast<std::uint32_t>(state));
  }
  /// Reports the state of a function, as its sensor has it.
  void report(const FieldPlace& status, std::uint32_t code);
  /// Reports the state of a function by its handle.
  template <class Handle>
    requires requires { typename Handle::Place; }
  void sense(const Handle& handle, Sensing sensing) {
    sense(place_of(handle), sensing);
  }
  /// Reports whether the sensor of a function works.
  void sense(const FieldPlace& status, Sensing sensing);

  /// Functions of the car body (4.2.2).
  Switching& body() { return body_.switching(); }
  /// Functions of light and signaling (4.2.3).
  Switching& light() { return light_.switching(); }
  /// Functions of the power train (4.2.4).
  Switching& power_train() { return power_train_.switching(); }
  /// The front seats.
  CarSeats& seats() { return seats_; }

 private:
  void reset(ResetScope scope);
  void state_entered(NmtState state);
  void look(Time now);
  void look_at_wheels();
  void look_at_engine();
  void look_at_fuel();
  void look_at_surroundings();
  void report_constants();
  void report_pulses(Signal valid);
  template <class Handle>
  void tell(const Handle& handle, const Sensor& sensor, const std::optional<double>& sensed);
  template <class Handle>
  void report_unknown(const Handle& handle, const Sensor& sensor);

  CarNetwork& network_;
  CarHardware hardware_;
  CarSettings settings_;
  SwitchedUnit<car_body_table> body_;
  SwitchedUnit<car_light_table> light_;
  SwitchedUnit<power_train_table> power_train_;
  CarSeats seats_;
  WheelPulseCounter pulses_;
  static const ServiceHandlers service_calls;
  HandlerBinding service_{&service_calls, this};
  Timer timer_;
};

/// Catalogue row of the IVN gateway (4.2.2 to 4.2.4); car_unit makes it a part of a device.
struct IvnGatewayKind : CarKind<IvnGatewayUnit, CarHardware, CarSettings> {
  static constexpr DeviceInfo info = {.name = "ivn-gateway",
                                      .title = "IVN gateway",
                                      .product = "Canvoy CiA 447 IVN gateway",
                                      .product_code = 44701,
                                      .node_id = 1,
                                      .hardware = "the car: speed, distance, engine, fuel, doors"};
  static constexpr const VirtualDeviceInfo& provides = ivn_gateway_device;
  static CarHardware simulated() { return parked_car(); }
};

}  // namespace canvoy::cia447
