// The vehicle gateway: values of drive, doors and engine from the other networks of the vehicle, in
// the ranges of SAE J1939 (CiA 407, 6.11, 9.2.15). A value beyond its range becomes the end of the
// range, a missing one "not available", and one with a failed sensor "error".
//
//     VehicleGatewayUnit gateway(device, {.read = ...}, {});
#pragma once

#include <array>
#include <cmath>

#include "canvoy/devices/cia407/kit/bus_kind.hpp"
#include "canvoy/devices/cia407/kit/bus_time.hpp"
#include "canvoy/devices/cia407/kit/door_state.hpp"
#include "canvoy/devices/cia407/kit/motion_recognition.hpp"
#include "canvoy/profiles/cia407/devices.hpp"

namespace canvoy::cia407 {

/// A measured value; nothing if it is missing.
struct Measured {
  std::optional<double> value = {};  ///< in the unit of its name
  bool has_failed = false;           ///< the sensor has failed: no value counts

  constexpr Measured() = default;
  /// A value that was measured.
  constexpr Measured(double number) : value(number) {}  // NOLINT(google-explicit-constructor)
  /// The value as converted by `convert`; a failure stays a failure.
  Measured changed(std::optional<double> (*convert)(std::optional<double>)) const {
    Measured made = *this;
    made.value = convert(value);
    return made;
  }
  /// A value of a failed sensor.
  static constexpr Measured failure() {
    Measured made;
    made.has_failed = true;
    return made;
  }
};

/// The values of the other networks of the vehicle.
struct VehicleReading {
  static constexpr std::size_t doors_max = 12;  ///< as in 6488h

  Measured speed_kmh;                              ///< negative: backward
  Measured mileage_metres;                         ///< total
  Measured bearing_degrees;                        ///< clockwise from north
  Measured ambient_celsius;                        ///< of the air outside
  Measured fuel_rate_l_per_h;                      ///< at present
  Measured economy_km_per_l;                       ///< at present
  Measured average_economy_km_per_l;               ///< of the trip
  Measured fuel_used_l;                            ///< total
  Measured trip_fuel_l;                            ///< of the trip
  Measured idle_fuel_l;                            ///< total
  Measured coolant_celsius;                        ///< of the engine
  Measured idle_hours;                             ///< of the engine, total
  Measured vehicle_hours;                          ///< total
  Measured engine_hours;                           ///< total
  Measured takeoff_hours;                          ///< of the power take-off, total
  Direction direction = Direction::not_available;  ///< of travel
  BrakePedal brake = BrakePedal::not_available;    ///< pedal
  std::array<DoorState, doors_max> doors{};        ///< by number, from 1
  bool left_released = false;                      ///< doors on the left side
  bool right_released = false;                     ///< doors on the right side
  std::optional<CivilTime> local_time = {};        ///< of the vehicle
};
/// The other networks of the vehicle.
struct VehicleGatewayHardware {
  Callback<VehicleReading()> read = {};  ///< once a period
};
/// Sets it to the member functions of a plain class that have these names: see PlainHardware.
template <class Plain>
constexpr void set_by_names(VehicleGatewayHardware& hardware, Plain& plain) {
  static_assert(
      requires { &Plain::read; },
      "the class has no member function of VehicleGatewayHardware: read");
  if constexpr (requires { &Plain::read; }) hardware.read = callback<&Plain::read>(plain);
}
/// Motion sensor, and period.
struct VehicleGatewaySettings {
  double pulses_per_metre = 8;  ///< of the motion sensor
  Duration period = 100ms;      ///< of readings
};

class VehicleGatewayUnit {
 public:
  /// Everything to which `hardware` refers must outlive this.
  VehicleGatewayUnit(VirtualDevice& device, const VehicleGatewayHardware& hardware,
                     const VehicleGatewaySettings& settings);

  /// Checks the vehicle at the next call of the node.
  void hardware_changed() { device_.node().timers().arm(timer_, device_.node().now()); }

 private:
  void reset(ResetScope /*scope*/) { look(device_.node().now()); }
  void look(Time now);
  void report_doors(const VehicleReading& reading);
  void report_engine(const VehicleReading& reading);
  template <class Handle>
  void tell(const Handle& handle, const Measured& measured);

  VirtualDevice& device_;
  VehicleGatewayHardware hardware_;
  VehicleGatewaySettings settings_;
  MotionRecognition recognition_;
  Timer timer_;
};

/// Catalogue row of the gateway to the networks of the vehicle (6.11);
/// bus_unit makes it a part of a device.
struct VehicleGatewayKind
    : BusKind<VehicleGatewayUnit, VehicleGatewayHardware, VehicleGatewaySettings> {
  static constexpr DeviceInfo info = {.name = "vehicle-gateway",
                                      .title = "gateway to the networks of the vehicle",
                                      .product = "Canvoy CiA 407 vehicle gateway",
                                      .product_code = 40710,
                                      .node_id = 11,
                                      .hardware = "the vehicle: speed, doors, engine, fuel"};
  static constexpr const VirtualDeviceInfo& provides = vehicle_gateway;
  static constexpr std::array pdos = {own_pdo<motion_tpdo>, own_pdo<mileage_tpdo>};
};

}  // namespace canvoy::cia407
