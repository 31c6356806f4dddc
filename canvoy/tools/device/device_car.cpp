#include "canvoy/tools/device/device_car.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <chrono>

#include "canvoy/tools/duration_argument.hpp"
#include "canvoy/tools/failure.hpp"
#include "canvoy/tools/run/drive_file.hpp"

namespace canvoy::tools {

namespace {

constexpr double kmh = 1 / 3.6;  ///< m/s
constexpr double kmh_max = 250;
/// Farther than anybody drives.
constexpr double endless = 1e9;

Duration since_1970() {
  return std::chrono::duration_cast<Duration>(std::chrono::system_clock::now().time_since_epoch());
}

}  // namespace

void add_device_car_options(Verb& command, DeviceCarOptions& options) {
  command.add({
      {"--speed", options.speeds,
       "km/h of the car or bus of an ivn-gateway, gps, vehicle-gateway, tachograph or "
       "geographical-positioning, and from when on: 50@10s",
       one_each},
      {"--nmea", options.nmea,
       "a recorded drive of that car, as NMEA 0183; stops of 2 min are left out"},
      {"--places", options.places, "the gazetteer of a navigation system"},
  });
}

cia447::LocalTime host_local_time() {
  return {.seconds = std::chrono::floor<std::chrono::seconds>(since_1970()).count()};
}

DeviceCar::DeviceCar(const DeviceCarOptions& options)
    : record_(options.nmea.empty() ? nullptr : read_drive_file(options.nmea)),
      drive_(record_.get()) {
  if (!options.nmea.empty() && !options.speeds.empty()) {
    throw UsageError("--speed: a recorded drive has its own; give --nmea alone");
  }
  if (!options.places.empty()) places_.emplace(options.places);
  for (const std::string& text : options.speeds) plan(text);
  std::ranges::stable_sort(plan_, {}, &SpeedChange::at);
}

void DeviceCar::plan(const std::string& text) {
  const std::size_t at = text.find('@');
  double speed = 0;
  const char* const end = text.data() + std::min(at, text.size());
  const auto [stop, error] = std::from_chars(text.data(), end, speed);
  const bool is_speed = error == std::errc{} && stop == end && speed >= 0 && speed <= kmh_max;
  if (at == std::string::npos || !is_speed) {
    throw UsageError(fmt::format(
        "--speed: '{}' is no speed with a time: write 50@10s, in km/h up to {}", text, kmh_max));
  }
  plan_.push_back({parse_duration_argument(text.substr(at + 1)), speed * kmh});
}

void DeviceCar::join(Site& site) {
  site.offer(Callback<cia447::CarHardware()>::to<&DeviceCar::car>(*this));
  site.offer(Callback<cia447::GpsHardware()>::to<&DeviceCar::gps>(*this));
  site.offer(Callback<cia447::NavigationHardware()>::to<&DeviceCar::navigation>(*this));
  site.offer(Callback<cia447::RealTimeClockHardware()>::to<&DeviceCar::clock>(*this));
  site.offer(Callback<cia447::DriverIdentificationHardware()>::to<&DeviceCar::reader>(*this));
}

/// It brakes as it would before a red light.
void DeviceCar::change_speed(double speed) {
  const double to_stand = drive_.speed() * drive_.speed() / (2 * car::Drive::deceleration);
  drive_.go(speed > 0 ? endless : to_stand, speed > 0 ? speed : drive_.speed());
}

void DeviceCar::step(Time now) {
  if (!begin_) begin_ = driven_until_ = now;
  for (; done_ < plan_.size() && now - *begin_ >= plan_[done_].at; ++done_) {
    change_speed(plan_[done_].speed);
  }
  if (drive_.is_standing()) drive_.go_on();
  drive_.step(now - driven_until_);
  driven_until_ = now;
}

cia447::CarHardware DeviceCar::car() {
  const auto sensor = [this](auto sense) { return cia447::Sensor(sense, this); };
  cia447::CarHardware made = cia447::parked_car();
  made.speed = sensor([](void* self) -> std::optional<double> {
    return static_cast<DeviceCar*>(self)->drive_.speed();
  });
  made.distance = sensor([](void* self) -> std::optional<double> {
    return static_cast<DeviceCar*>(self)->drive_.metres();
  });
  return made;
}

cia447::GpsHardware DeviceCar::gps() {
  return {.read = Callback<cia447::GpsReading()>::to<&DeviceCar::receiver>(*this)};
}

cia447::GpsReading DeviceCar::receiver() const {
  cia447::GpsReading reading = drive_.receiver();
  if (record_) return reading;
  const CivilTime now =
      std::chrono::floor<std::chrono::milliseconds>(std::chrono::system_clock::now());
  const auto day = std::chrono::floor<std::chrono::days>(now);
  const std::chrono::year_month_day date(day);
  const std::chrono::hh_mm_ss time(now - day);
  reading.date = {.year = static_cast<unsigned>(static_cast<int>(date.year())),
                  .month = static_cast<unsigned>(date.month()),
                  .day = static_cast<unsigned>(date.day())};
  reading.time = {.hour = static_cast<unsigned>(time.hours().count()),
                  .minute = static_cast<unsigned>(time.minutes().count()),
                  .second = static_cast<double>(time.seconds().count())};
  return reading;
}

cia447::NavigationHardware DeviceCar::navigation() {
  cia447::NavigationHardware hardware;
  if (places_) hardware.gazetteer = cia447::Gazetteer(places_->places());
  return hardware;
}

cia447::RealTimeClockHardware DeviceCar::clock() {
  return {.read = {[](void*) -> std::optional<cia447::ChipTime> {
                     return cia447::ChipTime{.since_1970 = since_1970()};
                   },
                   nullptr},
          .write = {}};
}

cia447::DriverIdentificationHardware DeviceCar::reader() {
  return {.clock = {[](void*) -> std::optional<cia447::LocalTime> { return host_local_time(); },
                    nullptr},
          .knows = {}};
}

}  // namespace canvoy::tools
