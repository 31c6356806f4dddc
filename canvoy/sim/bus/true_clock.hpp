// The true time in a simulated bus: UTC, and what clocks of its line should show.
//
//     TrueClock clock(options, world, vehicle);
//     clock.local()
#pragma once

#include <chrono>

#include "canvoy/devices/cia407/bus_time.hpp"
#include "canvoy/sim/bus/bus_network_options.hpp"
#include "canvoy/sim/world.hpp"

namespace canvoy::bus {

class TrueClock {
 public:
  /// All must outlive this.
  TrueClock(const BusNetworkOptions& options, const World& world, const BusVehicle& vehicle);
  TrueClock(const TrueClock&) = delete;
  TrueClock& operator=(const TrueClock&) = delete;

  EpochSeconds utc() const;
  cia407::CivilTime local() const;
  /// Of local time against UTC.
  std::chrono::minutes offset() const;

 private:
  const LocalClock& clock_;
  const World& world_;
  const BusVehicle& vehicle_;
  EpochSeconds service_begin_;
};

}  // namespace canvoy::bus
