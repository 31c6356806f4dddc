#include "canvoy/worlds/car/drive.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace canvoy::car {

namespace {

constexpr double road = 10'000;  ///< length of the road in metres
constexpr Duration roll_max = 500ms;

}  // namespace

void Drive::go(double metres, double metres_per_second) {
  rest_ = metres;
  limit_ = metres_per_second;
}

void Drive::go_on() {
  if (!has_record() || is_through()) return;
  plays_ = true;
  at_ = record_->legs[leg_].begin;
}

void Drive::roll(double metres, Duration time) {
  metres_ += metres;
  rest_ = std::max(0.0, rest_ - metres);
  speed_ = time > Duration{} ? metres / std::chrono::duration<double>(time).count() : 0;
  since_roll_ = {};
}

void Drive::step(Duration time) {
  if (is_led_) {
    // No motion is received: the car stands.
    since_roll_ += time;
    if (since_roll_ > roll_max) speed_ = 0;
    return;
  }
  if (is_standing()) return;
  if (has_record()) return play(time);
  const double seconds = std::chrono::duration<double>(time).count();
  // Greatest speed from which it can stop at the end of the leg.
  const double to_stand = std::sqrt(2 * deceleration * rest_);
  const double wanted = std::min({limit_, speed_ + acceleration * seconds, to_stand});
  const double driven = std::min(rest_, (speed_ + wanted) / 2 * seconds);
  speed_ = wanted;
  metres_ += driven;
  rest_ -= driven;
  constexpr double arrived = 0.05;
  if (rest_ > arrived) return;
  metres_ += rest_;
  rest_ = 0;
  speed_ = 0;
}

void Drive::play(Duration time) {
  const Duration end = record_->legs[leg_].end;
  const Duration until = std::min(at_ + time, end);
  hear(until);
  while (at_ < until) {
    while (record_->samples[sample_ + 1].at <= at_) ++sample_;
    play_until(std::min(until, record_->samples[sample_ + 1].at));
  }
  if (at_ < end) return;
  plays_ = false;
  speed_ = 0;
  ++leg_;
}

/// Not beyond the next sample: the speed changes linearly from one to the other.
void Drive::play_until(Duration at) {
  const DriveRecord::Sample& from = record_->samples[sample_];
  const DriveRecord::Sample& to = record_->samples[sample_ + 1];
  const auto speed_at = [&](Duration when) {
    const double share = static_cast<double>((when - from.at).count()) /
                         static_cast<double>((to.at - from.at).count());
    return from.speed + share * (to.speed - from.speed);
  };
  speed_ = speed_at(at);
  metres_ += (speed_at(at_) + speed_) / 2 * std::chrono::duration<double>(at - at_).count();
  at_ = at;
}

void Drive::hear(Duration until) {
  for (; heard_ < record_->said.size() && record_->said[heard_].at <= until; ++heard_) {
    const DriveRecord::Said& said = record_->said[heard_];
    receiver_.receive(std::string_view(record_->text).substr(said.begin, said.end - said.begin));
    receiver_.receive('\n');  // the last line may have no end
  }
}

cia447::GeoPosition Drive::town_position(double metres) {
  constexpr double metres_a_degree = 111'200;
  const double way = std::fmod(metres, 2 * road);
  const double north = way < road ? way : 2 * road - way;
  return {.latitude = 48.137 + north / metres_a_degree, .longitude = 11.575};
}

cia447::GpsReading Drive::receiver() const {
  if (has_record()) return receiver_.reading();
  const cia447::GeoPosition here = town_position(metres_);
  const bool goes_north = std::fmod(metres_, 2 * road) < road;
  return {.fix = cia447::GpsFix::fix_3d,
          .latitude = here.latitude,
          .longitude = here.longitude,
          .altitude = 519,
          .velocity = speed_,
          .heading = goes_north ? 0 : 180,
          .visible_satellites = 11,
          .tracked_satellites = 9};
}

}  // namespace canvoy::car
