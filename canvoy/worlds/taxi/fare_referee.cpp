#include "canvoy/worlds/taxi/fare_referee.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace canvoy::taxi {

namespace {

constexpr double seconds_an_hour = 3600;
constexpr double metres_a_unit = 1000;
/// MI-007: 0.2 % of the distance, at least 4 m; 0.1 % of the time, at least 0.2 s; 0.1 % of the
/// fare.
constexpr double distance_share = 0.002;
constexpr double distance_least = 4;
constexpr double time_share = 0.001;
constexpr double time_least = 0.2;
constexpr double fare_share = 0.001;
/// The meter's slices last a second, and begin at any moment: within two of them all is decided.
constexpr Duration long_slice = 2s;
/// Clocks differ by this at most.
constexpr Duration clock_limit = 3s;
/// The display has what was driven this time ago: a slice, and a moment of the bus.
constexpr Duration shown_after = 2s;

double seconds(Duration time) {
  return std::chrono::duration<double>(time).count();
}
double limit_of_distance(double metres) {
  return std::max(distance_least, distance_share * metres);
}
double limit_of_time(double time) {
  return std::max(time_least, time_share * time);
}

}  // namespace

double Trip::distance_limit() const {
  return limit_of_distance(metres) + key_metres;
}
double Trip::time_limit() const {
  return limit_of_time(seconds) + key_seconds;
}
double Trip::distance_excess() const {
  return std::max(metered_metres - metres, sure_metres - metered_metres) - distance_limit();
}
double Trip::time_excess() const {
  return std::max(metered_seconds - seconds, sure_seconds - metered_seconds) - time_limit();
}
double Trip::waiting_excess() const {
  if (!metered_waiting) return 0;
  return std::max(waiting_low - *metered_waiting, *metered_waiting - waiting_high);
}
double Trip::fare_excess() const {
  return std::max({fare_low - metered_fare, metered_fare - fare_high, step_error, shown_error});
}

double Trip::total_error() const {
  const double of_extras = knows_extras ? std::abs(extras - pressed_extras) : 0;
  return of_extras + std::abs(total - metered_fare - extras);
}

const cia447::TariffLevel& FareReferee::level_at(Time now) const {
  return tariff_.levels[cia447::level_at(tariff_, clock_.local(now))];
}

void FareReferee::hired(Time now, double metres, Duration key_time) {
  trip_ = {.begin = now, .key_seconds = seconds(key_time)};
  has_trip_ = true;
  level_ = &level_at(now);
  initial_ = level_->initial_fare;
  minimum_ = level_->minimum_fare;
  at_once_ = in_slices_ = slice_by_distance_ = slice_by_time_ = 0;
  settled_.clear();
  slice_begin_ = last_ = now;
  first_metres_ = last_metres_ = metres;
  first_speed_.reset();
  last_speed_ = 0;
  was_excused_ = was_waiting_ = false;
  turns_ = 0;
}

void FareReferee::press_extra(unsigned kind) {
  if (!has_trip_ || kind >= tariff_.supplements.size() || kind >= trip_.pressed.size()) return;
  ++trip_.pressed[kind];
  trip_.pressed_extras += tariff_.supplements[kind].price;
}

void FareReferee::clear_extras() {
  trip_.pressed = {};
  trip_.pressed_extras = 0;
}

void FareReferee::step(Time now, double metres, const TripExcuse& excuse) {
  if (!has_trip_) return;
  const double time = seconds(now - last_);
  const double by_distance = level_->distance_rate * (metres - last_metres_) / metres_a_unit;
  const double by_time = level_->time_rate * time / seconds_an_hour;
  if (time > 0) last_speed_ = (metres - last_metres_) / time;
  if (!first_speed_) first_speed_ = last_speed_;
  at_once_ += std::max(by_distance, by_time);
  slice(now, by_distance, by_time, excuse.fare);
  wait(time, by_distance, by_time, excuse.fare);
  settle(now);
  trip_.metres = metres - first_metres_;
  trip_.seconds += time;
  if (!excuse.distance) trip_.sure_metres += metres - last_metres_;
  if (!excuse.duration) trip_.sure_seconds += time;
  trip_.excused |= excuse;
  trip_.end = now;
  last_ = now;
  last_metres_ = metres;
  const cia447::TariffLevel* level = &level_at(now);
  if (level != level_) trip_.has_tariff_change = true;
  if (level != level_ || now - slice_begin_ >= long_slice) close_slice();
  level_ = level;
}

/// What a fault may have affected is not required.
void FareReferee::slice(Time now, double by_distance, double by_time, bool is_excused) {
  if (is_excused != was_excused_) close_slice();
  was_excused_ = is_excused;
  if (is_excused) {
    slice_begin_ = now;
  } else {
    slice_by_distance_ += by_distance;
    slice_by_time_ += by_time;
  }
}

/// A car near the speed at which both cost the same may wait or drive; without pulses a meter
/// counts all as waiting.
void FareReferee::wait(double time, double by_distance, double by_time, bool is_excused) {
  constexpr double about = 0.05;
  const bool is_waiting = by_time >= by_distance;
  const bool is_close = std::abs(by_time - by_distance) <= about * std::max(by_time, by_distance);
  if (is_waiting != was_waiting_) ++turns_;
  was_waiting_ = is_waiting;
  if (is_waiting && !is_close && !is_excused) trip_.waiting_low += time;
  if (is_waiting || is_close || is_excused) trip_.waiting_high += time;
}

void FareReferee::close_slice() {
  in_slices_ += std::max(slice_by_distance_, slice_by_time_);
  slice_by_distance_ = slice_by_time_ = 0;
  slice_begin_ = last_;
}

/// Keeps what is at least decided by now.
void FareReferee::settle(Time now) {
  constexpr std::size_t looks_max = 100;
  settled_.push_back({now, in_slices_ + std::max(slice_by_distance_, slice_by_time_)});
  if (settled_.size() > looks_max) settled_.pop_front();
}

double FareReferee::fare_above(double cost) const {
  return std::max(minimum_, initial_ + std::max(0.0, cost));
}

/// Value of the limits of distance and time up to now.
double FareReferee::limits_of_begin() const {
  const double metres =
      limit_of_distance(trip_.metres) + trip_.key_seconds * first_speed_.value_or(0);
  const double time = limit_of_time(trip_.seconds) + trip_.key_seconds;
  return level_->distance_rate * metres / metres_a_unit +
         level_->time_rate * time / seconds_an_hour;
}

/// An agreed price does not grow; around a change of the tariff, both may apply.
void FareReferee::look(Time now, double shown) {
  if (!has_trip_ || trip_.agreed || trip_.has_tariff_change || !trip_.has_clock) return;
  while (settled_.size() > 1 && settled_[1].at <= now - shown_after) settled_.pop_front();
  const bool is_settled = !settled_.empty() && settled_.front().at <= now - shown_after;
  const double settled = is_settled ? settled_.front().in_slices : 0;
  const double unit = std::max<std::uint32_t>(level_->increment, 1);
  const double low = fare_above(settled * (1 - fare_share) - limits_of_begin() - unit);
  const double high = fare_above(at_once_ * (1 + fare_share) + limits_of_begin());
  trip_.shown_error = std::max({trip_.shown_error, low - shown, shown - high});
}

std::array<std::array<char, 2>, 2> FareReferee::levels_about(Time now) const {
  const Time before = std::max(trip_.begin, now - clock_limit);
  return {level_at(before).name, level_at(now + clock_limit).name};
}

/// Levels of one step have no step between them.
double FareReferee::step_error(double fare) const {
  const bool is_one = std::ranges::all_of(
      tariff_.levels, [this](const auto& level) { return level.increment == level_->increment; });
  const bool has_steps = !trip_.agreed && trip_.has_clock && is_one && fare > minimum_;
  if (!has_steps) return 0;
  const double step = std::max<std::uint32_t>(level_->increment, 1);
  return std::abs(std::remainder(fare - initial_, step));
}

Trip FareReferee::paid(Time now, const std::optional<cia447::TripData>& shown) {
  trip_.end = std::min(now, trip_.end);
  close_slice();
  trip_.levels = levels_about(trip_.end);
  trip_.key_metres = trip_.key_seconds * (first_speed_.value_or(0) + last_speed_);
  ask_fare();
  trip_.is_read = shown.has_value();
  if (shown) {
    trip_.metered_metres = shown->distance;
    trip_.metered_seconds = shown->duration;
    if (shown->waiting != cia447::TripData::unknown) trip_.metered_waiting = shown->waiting;
    trip_.metered_fare = shown->fare;
    trip_.step_error = step_error(shown->fare);
    trip_.extras = shown->supplements;
    trip_.total = shown->total;
    trip_.paid = trip_.metered_fare + trip_.extras;
  }
  has_trip_ = false;
  return trip_;
}

void FareReferee::ask_fare() {
  // A slice of the meter that extends from one speed to the other may count as either.
  constexpr double slice_of_meter = 1.5;
  const double waiting_limit = trip_.time_limit() + turns_ * slice_of_meter;
  trip_.waiting_low = trip_.agreed ? 0 : std::max(0.0, trip_.waiting_low - waiting_limit);
  trip_.waiting_high = (trip_.agreed ? 0 : trip_.waiting_high) + waiting_limit;
  if (trip_.agreed) {
    trip_.fare_low = trip_.excused.fare ? 0 : *trip_.agreed;
    trip_.fare_high = *trip_.agreed;
    return;
  }
  // Value of the limits of distance and time, the fare's own limit, and the switching unit, which
  // is charged as a whole.
  const double cost_of_limits = level_->distance_rate * trip_.distance_limit() / metres_a_unit +
                                level_->time_rate * trip_.time_limit() / seconds_an_hour;
  const double unit = std::max<std::uint32_t>(level_->increment, 1);
  const double low = in_slices_ * (1 - fare_share) - cost_of_limits - unit;
  const double high = at_once_ * (1 + fare_share) + cost_of_limits;
  trip_.fare_low = std::max(minimum_, initial_ + std::max(0.0, low));
  trip_.fare_high = std::max(minimum_, initial_ + high);
}

}  // namespace canvoy::taxi
