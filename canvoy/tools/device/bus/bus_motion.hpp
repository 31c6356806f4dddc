// Motion of the vehicle around a device of CiA 407 that `canvoy device` runs: driven by DeviceCar,
// with the total metres of the vehicle and the time of its receiver.
//
//     const BusMotion motion(car, kept.metres);
//     motion.speed_kmh();
#pragma once

#include <optional>

#include "canvoy/devices/cia407/kit/bus_time.hpp"
#include "canvoy/tools/device/car/device_car.hpp"

namespace canvoy::tools {

class BusMotion {
 public:
  /// `metres_before` is the total until this start; `car` must outlive this.
  BusMotion(const DeviceCar& car, double metres_before)
      : car_(car), metres_before_(metres_before) {}
  BusMotion(const BusMotion&) = delete;
  BusMotion& operator=(const BusMotion&) = delete;

  double speed_kmh() const;
  double metres() const { return metres_before_ + car_.metres(); }
  /// The receiver with all satellites.
  cia447::GpsReading receiver() const { return car_.receiver(); }
  /// The time; nothing if the recorded drive has none here.
  std::optional<cia407::CivilTime> utc() const;

 private:
  const DeviceCar& car_;
  double metres_before_;
};

}  // namespace canvoy::tools
