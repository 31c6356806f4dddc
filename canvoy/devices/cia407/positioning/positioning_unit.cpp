#include "canvoy/devices/cia407/positioning/positioning_unit.hpp"

#include <cmath>

#include "canvoy/devices/cia407/kit/errors.hpp"
#include "canvoy/devices/cia407/kit/turn.hpp"

namespace canvoy::cia407 {

namespace {

bool has_position(const cia447::GpsReading& reading) {
  const bool is_within = reading.latitude && reading.longitude &&
                         std::abs(*reading.latitude) <= 90 && std::abs(*reading.longitude) <= 180;
  return is_within && !reading.has_failed && reading.fix != cia447::GpsFix::none;
}

}  // namespace

PositioningUnit::PositioningUnit(VirtualDevice& device, const PositioningHardware& hardware,
                                 const PositioningSettings& settings)
    : device_(device),
      hardware_(hardware),
      settings_(settings),
      timer_(callback<&PositioningUnit::look>(*this)) {
  device.on_reset = callback<&PositioningUnit::reset>(*this);
}

void PositioningUnit::look(Time now) {
  device_.node().timers().arm(timer_, now + settings_.period);
  const cia447::GpsReading reading = hardware_.read ? hardware_.read() : cia447::GpsReading{};
  const bool is_known = has_position(reading);
  const auto if_known = [is_known](std::optional<double> value) {
    return is_known && value && std::isfinite(*value) ? value : std::nullopt;
  };
  device_.tell(latitude, if_known(reading.latitude));
  device_.tell(longitude, if_known(reading.longitude));
  const auto hdop = if_known(reading.hdop);
  device_.tell(position_precision,
               hdop ? std::optional(*hdop * settings_.metres_per_hdop) : std::nullopt);
  const std::optional<double> velocity = if_known(reading.velocity);
  // 6662h has no code for "not known": 0 would say that the vehicle stands.
  if (velocity) device_.tell(gps_based_speed, *velocity);
  device_.tell(gps_based_heading, if_known(within_turn(reading.heading)));
  const std::chrono::duration<double> passed = now - looked_.value_or(now);
  looked_ = now;
  mileage_metres_ += std::abs(velocity.value_or(0)) * passed.count();
  device_.tell(gps_mileage, mileage_metres_);
  device_.report(bus_error::no_signal, !is_known);
}

}  // namespace canvoy::cia407
