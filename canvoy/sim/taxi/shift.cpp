#include "canvoy/sim/taxi/shift.hpp"

#include <algorithm>
#include <utility>

namespace canvoy::taxi {

namespace {

constexpr Duration between_presses = 1s;
constexpr double town_speed = 8;      ///< m/s: the slowest leg
constexpr double street_speed = 15;   ///< the fastest in town
constexpr double highway_speed = 25;  ///< now and then
constexpr std::uint32_t luggage = 1000;

}  // namespace

Shift::Shift(const ShiftOptions& options, std::uint64_t seed, car::Drive& drive, MeterKeys keys)
    : options_(options),
      random_(seed),
      drive_(drive),
      keys_(std::move(keys)),
      until_(options.begin) {}

double Shift::between(double low, double high) {
  constexpr std::uint32_t steps = 1'000'000;
  return low + (high - low) * static_cast<double>(random_.below(steps)) / steps;
}

Duration Shift::time_between(Duration low, Duration high) {
  const auto width = static_cast<std::uint32_t>((high - low) / 1s);
  return low + 1s * static_cast<std::int64_t>(random_.below(width + 1));
}

Duration Shift::up_to(Duration usual_least, Duration most) {
  return time_between(std::min(usual_least, most), most);
}

void Shift::enter(Time now, Activity activity, Duration lasts) {
  until_ = now + lasts;
  const Activity before = std::exchange(activity_, activity);
  if (changed_) changed_(now, before, activity);
}

/// Each second once, until the meter obeys, or there is no hope.
bool Shift::press(Time now, const std::function<bool()>& key) {
  if (now < pressed_ + between_presses) return false;
  pressed_ = now;
  has_obeyed_ = key();
  if (!has_obeyed_ && ++presses_ < options_.presses_max) return false;
  presses_ = 0;
  return true;
}

/// A drive that was recorded is one trip from each of its arrivals to the next.
void Shift::next_leg(double fastest) {
  if (drive_.has_record()) {
    to_go_ = 0;
    return drive_.go_on();
  }
  const double leg = std::min(to_go_, between(150, 900));
  to_go_ -= leg;
  drive_.go(leg, between(town_speed, fastest));
}

void Shift::carry(Time now) {
  if (to_go_ <= 0) return enter(now, Activity::stopping);
  // Every other stop is a traffic light.
  const bool has_lights = activity_ == Activity::carrying && random_.below(2) == 0;
  if (has_lights) return enter(now, Activity::at_lights, time_between(5s, 50s));
  next_leg(random_.below(5) == 0 ? highway_speed : street_speed);
  if (activity_ != Activity::carrying) enter(now, Activity::carrying);
}

void Shift::after_paying(Time now) {
  ++carried_;
  if (is_last(now)) return enter(now, Activity::signing_off);
  wait(now);
}

void Shift::wait(Time now) {
  enter(now, Activity::waiting, up_to(30s, options_.waiting_max));
}

bool Shift::is_last(Time now) const {
  return now >= options_.end || drive_.is_through();
}

/// Where the car is recorded, passengers come to it.
void Shift::fetch(Time now) {
  if (!drive_.has_record()) drive_.go(between(300, 3000), street_speed);
  enter(now, Activity::fetching);
}

void Shift::step(Time now) {
  switch (activity_) {
    case Activity::off_duty:
      if (!is_over_ && now >= until_) enter(now, Activity::signing_on);
      break;
    case Activity::signing_on:
      if (press(now, keys_.sign_on) && has_obeyed_) wait(now);
      break;
    case Activity::waiting:
      if (now < until_) break;
      if (is_last(now)) return enter(now, Activity::signing_off);
      fetch(now);
      break;
    case Activity::fetching:
      if (drive_.is_standing()) enter(now, Activity::boarding, up_to(10s, options_.boarding_max));
      break;
    case Activity::boarding:
      if (now < until_) break;
      to_go_ = between(options_.trip_min_metres, options_.trip_max_metres);
      enter(now, Activity::hiring);
      break;
    case Activity::hiring:
      if (!press(now, keys_.hire)) break;
      if (!has_obeyed_) return enter(now, Activity::waiting, options_.waiting_max);
      enter(now, Activity::at_lights, time_between(1s, 10s));
      break;
    case Activity::carrying:
      if (drive_.is_standing()) carry(now);
      break;
    case Activity::at_lights:
      if (now >= until_) carry(now);
      break;
    case Activity::stopping:
      if (!press(now, keys_.stop)) break;
      enter(now, Activity::paying, up_to(20s, options_.paying_max));
      if (random_.below(5) == 0) keys_.add_supplement(luggage);
      break;
    case Activity::paying:
      if (now >= until_) enter(now, Activity::releasing);
      break;
    case Activity::releasing:
      if (press(now, keys_.for_hire)) after_paying(now);
      break;
    case Activity::signing_off:
      is_over_ = true;
      if (press(now, keys_.sign_off)) enter(now, Activity::off_duty);
      break;
  }
}

}  // namespace canvoy::taxi
