// How the vehicle around a device of CiA 407 moves that `canvoy device` runs: as DeviceCar drives
// it, with the metres of all of its life, and the time that its receiver has.
//
//     const BusMotion motion(car, kept.metres);
//     motion.speed_kmh();
#pragma once

#include <optional>

#include "canvoy/devices/cia407/bus_time.hpp"
#include "canvoy/tools/device/device_car.hpp"

namespace canvoy::tools {

class BusMotion {
 public:
  /// `metres_before` are those until this start; `car` must outlive this.
  BusMotion(const DeviceCar& car, double metres_before)
      : car_(car), metres_before_(metres_before) {}
  BusMotion(const BusMotion&) = delete;
  BusMotion& operator=(const BusMotion&) = delete;

  double speed_kmh() const;
  double metres() const { return metres_before_ + car_.metres(); }
  /// With all satellites.
  cia447::GpsReading receiver() const { return car_.receiver(); }
  /// Nothing: the recorded drive has none here.
  std::optional<cia407::CivilTime> utc() const;

 private:
  const DeviceCar& car_;
  double metres_before_;
};

}  // namespace canvoy::tools
