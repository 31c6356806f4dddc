// The vehicle as seen by the vehicle gateway and the tachograph of a bus (CiA 407) that `canvoy
// device` runs: motion, doors, brake, and the cards of its drivers.
//
//     SensedVehicle vehicle(motion, console, kept.trip_begin);
//     vehicle.join(environment);
//     vehicle.act(parse_bus_press(units, "open:2@3s"));
#pragma once

#include <array>
#include <optional>

#include "canvoy/devices/cia407/gateway/vehicle_gateway_unit.hpp"
#include "canvoy/devices/cia407/tachograph/tachograph_unit.hpp"
#include "canvoy/devices/kit/environment.hpp"
#include "canvoy/tools/device/bus/bus_console.hpp"
#include "canvoy/tools/device/bus/bus_motion.hpp"
#include "canvoy/tools/device/bus/bus_press.hpp"

namespace canvoy::tools {

class SensedVehicle {
 public:
  /// `kept_trip_begin`, in m, is that of the trip before the last power-down. All other arguments
  /// must outlive this.
  SensedVehicle(const BusMotion& motion, const BusConsole& console, double kept_trip_begin)
      : motion_(motion), console_(console), kept_trip_begin_(kept_trip_begin) {}
  SensedVehicle(const SensedVehicle&) = delete;
  SensedVehicle& operator=(const SensedVehicle&) = delete;

  /// This must outlive the devices that are made in the environment.
  void join(Environment& environment);
  /// Performs `open`, `close`, `brake` and `release`, which need the gateway, and `card` and
  /// `no-card`; ignores others.
  void act(const BusPress& press);

  /// In m; nothing without a tachograph.
  std::optional<double> trip_begin() const;

 private:
  cia407::VehicleGatewayHardware gateway_hardware();
  cia407::VehicleReading read();
  cia407::TachographHardware tachograph_hardware();
  cia407::TachographSettings tachograph_settings();
  cia407::TachographReading record();

  const BusMotion& motion_;
  const BusConsole& console_;
  double kept_trip_begin_;
  std::array<cia407::DoorState, cia407::VehicleReading::doors_max> doors_{};
  bool is_braking_ = false;
  std::array<bool, 2> has_card_{};
  cia407::VehicleGatewayUnit* gateway_ = nullptr;
  cia407::TachographUnit* tachograph_ = nullptr;
};

}  // namespace canvoy::tools
