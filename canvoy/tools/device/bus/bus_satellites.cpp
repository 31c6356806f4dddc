#include "canvoy/tools/device/bus/bus_satellites.hpp"

namespace canvoy::tools {

void BusSatellites::join(Environment& environment) {
  environment.provide(
      Callback<cia407::PositioningHardware()>::to<&BusSatellites::positioning>(*this));
  environment.provide(
      Callback<cia407::TimeFixingHardware()>::to<&BusSatellites::time_fixing>(*this));
}

void BusSatellites::act(const BusPress& press) {
  if (press.what == "signal" || press.what == "no-signal") has_signal_ = press.what == "signal";
}

cia407::PositioningHardware BusSatellites::positioning() {
  return {.read = Callback<cia447::GpsReading()>::to<&BusSatellites::position>(*this)};
}

cia447::GpsReading BusSatellites::position() {
  return has_signal_ ? motion_.receiver() : cia447::GpsReading{.fix = cia447::GpsFix::none};
}

cia407::TimeFixingHardware BusSatellites::time_fixing() {
  return {.utc = Callback<std::optional<cia407::CivilTime>()>::to<&BusSatellites::time>(*this),
          .local_offset = {}};
}

std::optional<cia407::CivilTime> BusSatellites::time() {
  return has_signal_ ? motion_.utc() : std::nullopt;
}

}  // namespace canvoy::tools
