#include "canvoy/tools/device/bus/bus_motion.hpp"

#include "canvoy/devices/cia407/kit/motion_recognition.hpp"

namespace canvoy::tools {

double BusMotion::speed_kmh() const {
  return car_.speed() * cia407::kmh_of_metres_per_second;
}

std::optional<cia407::CivilTime> BusMotion::utc() const {
  const cia447::GpsReading reading = car_.receiver();
  if (!reading.date || !reading.time) return std::nullopt;
  return cia407::CivilTime{.year = reading.date->year,
                           .month = reading.date->month,
                           .day = reading.date->day,
                           .hour = reading.time->hour,
                           .minute = reading.time->minute,
                           .second = static_cast<unsigned>(reading.time->second)};
}

}  // namespace canvoy::tools
