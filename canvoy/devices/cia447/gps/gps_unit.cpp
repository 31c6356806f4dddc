#include "canvoy/devices/cia447/gps/gps_unit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "canvoy/devices/cia447/kit/commands.hpp"

namespace canvoy::cia447 {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

constexpr unsigned days_of(unsigned month, unsigned year) {
  constexpr unsigned char days[] = {31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
  const bool is_leap = (year % 4 == 0 && year % 100 != 0) || year % 400 == 0;
  return days[month - 1] + (month == 2 && is_leap ? 1U : 0U);
}
constexpr bool can_be(const GpsDate& date) {
  return date.month >= 1 && date.month <= 12 && date.day >= 1 &&
         date.day <= days_of(date.month, date.year);
}
constexpr bool can_be(const GpsTime& time) {
  return time.hour <= 23 && time.minute <= 59 && time.second >= 0 && time.second < 61;
}

std::optional<double> number(std::optional<unsigned> count) {
  return count ? std::optional<double>(*count) : std::nullopt;
}

/// Within the circle, and in steps, so that a value that rounds to a whole turn is north.
std::optional<double> as_heading(std::optional<double> degrees) {
  if (!degrees || !std::isfinite(*degrees)) return degrees;
  const double steps = std::fmod(std::round(*degrees * 10), 3600.0);
  return (steps < 0 ? steps + 3600 : steps) / 10;
}

}  // namespace

constexpr ServiceHandlers GpsUnit::service_calls = {.reset = method<&GpsUnit::reset>};

GpsUnit::GpsUnit(CarNetwork& network, const GpsHardware& hardware, const GpsSettings& settings)
    : network_(network),
      hardware_(hardware),
      settings_(settings),
      values_(network.node().dictionary()),
      timer_(callback<&GpsUnit::look>(*this)) {
  network.node().attach(service_);
}

void GpsUnit::reset(ResetScope) {
  look(network_.node().now());
}

void GpsUnit::look(Time now) {
  if (settings_.period > Duration::zero()) {
    network_.node().timers().arm(timer_, now + settings_.period);
  }
  reading_ = hardware_.read();
  report_position();
  report_quality();
  report_clock();
  report_movement();
}

template <class Handle>
void GpsUnit::fail(const Handle& handle) {
  const auto code = code_meaning(place_of(handle), Meaning::failure);
  if (code) values_[handle].set_raw(static_cast<typename Handle::Reference::Raw>(*code));
}

/// Possible values beyond the codes are sent as the nearest code.
template <class Handle>
void GpsUnit::tell(const Handle& handle, std::optional<double> value, double low, double high) {
  using Raw = typename Handle::Reference::Raw;
  if (reading_.has_failed) return fail(handle);
  if (!value || std::isnan(*value)) {
    values_[handle] = std::nullopt;
  } else if (*value < low || *value > high) {
    fail(handle);
  } else {
    values_[handle].set_raw(static_cast<Raw>(Handle::Place::rules.nearest(*value)));
  }
}

void GpsUnit::report_position() {
  const bool is_lost = reading_.fix == GpsFix::none;
  const auto unless_lost = [&](std::optional<double> value) {
    return is_lost ? std::nullopt : value;
  };
  tell(gps_current_position_latitude, unless_lost(reading_.latitude), -90, 90);
  tell(gps_current_position_longitude, unless_lost(reading_.longitude), -180, 180);
  // Three dimensions, or no information about them.
  const bool has_height = reading_.fix == GpsFix::fix_3d || reading_.fix == GpsFix::not_available;
  tell(gps_altitude, has_height ? reading_.altitude : std::nullopt, -infinity, infinity);
}

void GpsUnit::report_quality() {
  tell(gps_satellites_visible, number(reading_.visible_satellites), 0, infinity);
  tell(gps_satellites_tracked, number(reading_.tracked_satellites), 0, infinity);
  tell(gps_status_vdop, reading_.vdop, 0, infinity);
  tell(gps_status_hdop, reading_.hdop, 0, infinity);
  tell(gps_status_pdop, reading_.pdop, 0, infinity);
  values_[gps_status_fix] = reading_.has_failed ? GpsFix::failure : reading_.fix;
}

void GpsUnit::report_clock() {
  const auto impossible = std::optional(-1.0);
  const auto& date = reading_.date;
  const auto of_date = [&](unsigned GpsDate::*part) {
    if (!date) return std::optional<double>();
    return can_be(*date) ? std::optional<double>(*date.*part) : impossible;
  };
  tell(gps_date_year, of_date(&GpsDate::year), 0, infinity);
  tell(gps_date_month, of_date(&GpsDate::month), 0, infinity);
  tell(gps_date_day, of_date(&GpsDate::day), 0, infinity);
  const auto& time = reading_.time;
  const auto of_time = [&](auto part) {
    if (!time) return std::optional<double>();
    return can_be(*time) ? std::optional<double>(*time.*part) : impossible;
  };
  tell(gps_utc_time_hour, of_time(&GpsTime::hour), 0, infinity);
  tell(gps_utc_time_minute, of_time(&GpsTime::minute), 0, infinity);
  tell(gps_utc_time_second, of_time(&GpsTime::second), 0, infinity);
}

void GpsUnit::report_movement() {
  const bool is_lost = reading_.fix == GpsFix::none;
  tell(gps_velocity, is_lost ? std::nullopt : reading_.velocity, 0, infinity);
  tell(gps_heading, is_lost ? std::nullopt : as_heading(reading_.heading), -infinity, infinity);
}

}  // namespace canvoy::cia447
