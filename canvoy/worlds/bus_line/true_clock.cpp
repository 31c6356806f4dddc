#include "canvoy/worlds/bus_line/true_clock.hpp"

namespace canvoy::bus_line {

TrueClock::TrueClock(const BusNetworkOptions& options, const World& world,
                     const BusVehicle& vehicle)
    : clock_(options.clock),
      world_(world),
      vehicle_(vehicle),
      service_begin_(options.clock.service_begin(options.date)) {}

EpochSeconds TrueClock::utc() const {
  const Duration of_day = vehicle_.time_of_day(world_.now());
  return service_begin_ + std::chrono::floor<std::chrono::seconds>(of_day).count();
}

cia407::CivilTime TrueClock::local() const {
  return cia447::civil_time(clock_.local(utc()));
}

std::chrono::minutes TrueClock::offset() const {
  const std::chrono::seconds offset(clock_.offset_at(utc()));
  return std::chrono::duration_cast<std::chrono::minutes>(offset);
}

}  // namespace canvoy::bus_line
