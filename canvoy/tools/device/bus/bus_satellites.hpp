// The satellites of a bus (CiA 407) that `canvoy device` runs: input of geographical positioning
// and time fixing, while there is a signal.
//
//     BusSatellites satellites(motion);
//     satellites.join(environment);
//     satellites.act(parse_bus_press(units, "no-signal@2s"));
#pragma once

#include <optional>

#include "canvoy/devices/cia407/positioning/positioning_unit.hpp"
#include "canvoy/devices/cia407/positioning/time_fixing_unit.hpp"
#include "canvoy/devices/kit/environment.hpp"
#include "canvoy/tools/device/bus/bus_motion.hpp"
#include "canvoy/tools/device/bus/bus_press.hpp"

namespace canvoy::tools {

class BusSatellites {
 public:
  /// `motion` must outlive this.
  explicit BusSatellites(const BusMotion& motion) : motion_(motion) {}
  BusSatellites(const BusSatellites&) = delete;
  BusSatellites& operator=(const BusSatellites&) = delete;

  /// This must outlive the devices that are made in the environment.
  void join(Environment& environment);
  /// Performs `signal` and `no-signal`; ignores others.
  void act(const BusPress& press);

 private:
  cia407::PositioningHardware positioning();
  cia447::GpsReading position();
  cia407::TimeFixingHardware time_fixing();
  std::optional<cia407::CivilTime> time();

  const BusMotion& motion_;
  bool has_signal_ = true;
};

}  // namespace canvoy::tools
