#include "canvoy/worlds/bus_line/announcements.hpp"

#include <algorithm>

namespace canvoy::bus_line {

namespace {

constexpr Duration announcement_bound = 2s;

}  // namespace

void Announcements::add_car(unsigned car) {
  using cia407::AcousticAnnouncerHardware;
  Environment& environment = nodes_.add_site();
  Speakers& speakers = speakers_.emplace_back(*this, car);
  environment.provide(Callback<AcousticAnnouncerHardware()>::to<&Speakers::hardware>(speakers));
  nodes_.add(announcer_of(car), environment);
}

cia407::AcousticAnnouncerHardware Announcements::Speakers::hardware() {
  return {.announce = Callback<bool(std::uint32_t, std::string_view)>::to<&Speakers::say>(*this)};
}

bool Announcements::say(unsigned car, std::uint32_t stop_point) {
  const Sabotage& sabotage = options_.sabotage;
  const bool is_mute = car == 1 ? sabotage.mute_announcer : car == sabotage.mute_car;
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
  for (unsigned car = 1; car <= nodes_.cars(); ++car) {
    std::optional<std::uint32_t>& expected = expected_.at(car - 1);
    if (!expected || now - expected_since_ <= announcement_bound) continue;
    expected.reset();
    referee_.judge_one(announcements_in(car), now, false);
  }
}

}  // namespace canvoy::bus_line
