#include "canvoy/sim/taxi/fare_referee.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace canvoy::taxi {

namespace {

constexpr double seconds_an_hour = 3600;
constexpr double metres_a_unit = 1000;
/// MI-007: of distance 0,2 %, at least 4 m; of time 0,1 %, at least 0,2 s; of the fare 0,1 %.
constexpr double distance_share = 0.002;
constexpr double distance_least = 4;
constexpr double time_share = 0.001;
constexpr double time_least = 0.2;
constexpr double fare_share = 0.001;
/// The meter's slices last a second, and begin at any moment: within two of them all is decided.
constexpr Duration long_slice = 2s;

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
double Trip::fare_excess() const {
  return std::max(fare_low - metered_fare, metered_fare - fare_high);
}

double Trip::total_error() const {
  const double of_extras = knows_extras ? std::abs(extras - pressed_extras) : 0;
  return of_extras + std::abs(total - metered_fare - extras);
}

const cia447::TariffLevel& FareReferee::level_at(Time now) const {
  const std::int64_t local = local_begin_ + (now - Time{}) / 1s;
  return tariff_.levels[cia447::level_at(tariff_, local)];
}

void FareReferee::hired(Time now, double metres, Duration key_time) {
  trip_ = {.begin = now, .key_seconds = seconds(key_time)};
  has_trip_ = true;
  level_ = &level_at(now);
  initial_ = level_->initial_fare;
  minimum_ = level_->minimum_fare;
  at_once_ = in_slices_ = slice_by_distance_ = slice_by_time_ = 0;
  slice_begin_ = last_ = now;
  first_metres_ = last_metres_ = metres;
  first_speed_.reset();
  last_speed_ = 0;
  was_excused_ = false;
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

/// What a fault may have cost is not asked for.
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

void FareReferee::close_slice() {
  in_slices_ += std::max(slice_by_distance_, slice_by_time_);
  slice_by_distance_ = slice_by_time_ = 0;
  slice_begin_ = last_;
}

Trip FareReferee::paid(Time now, const std::optional<cia447::TripData>& shown) {
  trip_.end = std::min(now, trip_.end);
  close_slice();
  trip_.key_metres = trip_.key_seconds * (first_speed_.value_or(0) + last_speed_);
  // What the limits of distance and time are worth, the fare's own, and the switching unit of which
  // no part is charged.
  const double cost_of_limits = level_->distance_rate * trip_.distance_limit() / metres_a_unit +
                                level_->time_rate * trip_.time_limit() / seconds_an_hour;
  const double unit = std::max<std::uint32_t>(level_->increment, 1);
  const double low = in_slices_ * (1 - fare_share) - cost_of_limits - unit;
  const double high = at_once_ * (1 + fare_share) + cost_of_limits;
  trip_.fare_low = std::max(minimum_, initial_ + std::max(0.0, low));
  trip_.fare_high = std::max(minimum_, initial_ + high);
  trip_.is_read = shown.has_value();
  if (shown) {
    trip_.metered_metres = shown->distance;
    trip_.metered_seconds = shown->duration;
    trip_.metered_fare = shown->fare;
    trip_.extras = shown->supplements;
    trip_.total = shown->total;
    trip_.paid = trip_.metered_fare + trip_.extras;
  }
  has_trip_ = false;
  return trip_;
}

}  // namespace canvoy::taxi
