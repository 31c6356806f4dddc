// True time in a simulated bus: UTC, and the local time of its line.
//
//     TrueClock clock(options, world, vehicle);
//     clock.local()
#pragma once

#include <chrono>

#include "canvoy/devices/cia407/kit/bus_time.hpp"
#include "canvoy/sim/world.hpp"
#include "canvoy/worlds/bus_line/bus_network_options.hpp"

namespace canvoy::bus_line {

class TrueClock {
 public:
  /// All must outlive this object.
  TrueClock(const BusNetworkOptions& options, const World& world, const BusVehicle& vehicle);
  TrueClock(const TrueClock&) = delete;
  TrueClock& operator=(const TrueClock&) = delete;

  /// Seconds since 1970-01-01.
  EpochSeconds utc() const;
  /// Where the line runs.
  cia407::CivilTime local() const;
  /// Offset of local time against UTC.
  std::chrono::minutes offset() const;

 private:
  const LocalClock& clock_;
  const World& world_;
  const BusVehicle& vehicle_;
  EpochSeconds service_begin_;
};

}  // namespace canvoy::bus_line
