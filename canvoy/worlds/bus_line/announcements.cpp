#include "canvoy/worlds/bus_line/announcements.hpp"

#include <algorithm>

namespace canvoy::bus_line {

namespace {

constexpr Duration announcement_bound = 2s;

constexpr InvariantKind announcements_in(unsigned car) {
  return car == 1 ? InvariantKind::announcements : InvariantKind::second_announcements;
}

}  // namespace

void Announcements::add_first_car() {
  using cia407::AcousticAnnouncerHardware;
  Environment& environment = nodes_.add_site();
  environment.provide(callback<&Announcements::first_hardware>(*this));
  nodes_.add(announcer_id, environment);
}

void Announcements::add_second_car() {
  using cia407::AcousticAnnouncerHardware;
  Environment& environment = nodes_.add_site();
  environment.provide(callback<&Announcements::second_hardware>(*this));
  nodes_.add(second_announcer_id, environment);
}

cia407::AcousticAnnouncerHardware Announcements::first_hardware() {
  return {.announce = callback<&Announcements::say_in_first_car>(*this)};
}

cia407::AcousticAnnouncerHardware Announcements::second_hardware() {
  return {.announce = callback<&Announcements::say_in_second_car>(*this)};
}

bool Announcements::say_in_first_car(std::uint32_t stop_point, std::string_view /*text*/) {
  return say(1, stop_point, options_.sabotage.mute_announcer);
}

bool Announcements::say_in_second_car(std::uint32_t stop_point, std::string_view /*text*/) {
  return say(2, stop_point, options_.sabotage.mute_second_announcer);
}

bool Announcements::say(unsigned car, std::uint32_t stop_point, bool is_mute) {
  const auto stop = std::ranges::find(options_.line.stops, stop_point, &BusStop::number);
  const bool is_known = stop != options_.line.stops.end();
  if (is_mute) return is_known;
  const Time now = nodes_.world().now();
  events_.note(now, Announced{stop_point, is_known ? stop->name : "", car});
  if (car == 1) ++heard_;
  const bool is_right =
      truth_.is_true(now, [&](const TrueData& data) { return data.stop_point == stop_point; });
  referee_.judge_one(announcements_in(car), now, is_right);
  std::optional<std::uint32_t>& expected = expected_.at(car - 1);
  if (expected == stop_point) expected.reset();
  return is_known;
}

void Announcements::stop_comes(Time now, std::uint32_t stop_point) {
  expected_.fill(stop_point);
  expected_since_ = now;
}

void Announcements::step(Time now) {
  for (unsigned car = 1; car <= expected_.size(); ++car) {
    std::optional<std::uint32_t>& expected = expected_.at(car - 1);
    if (!expected || now - expected_since_ <= announcement_bound) continue;
    expected.reset();
    referee_.judge_one(announcements_in(car), now, false);
  }
}

}  // namespace canvoy::bus_line
