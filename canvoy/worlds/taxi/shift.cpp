#include "canvoy/worlds/taxi/shift.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace canvoy::taxi {

namespace {

constexpr Duration between_presses = 1s;
constexpr double town_speed = 8;      ///< m/s: the slowest leg
constexpr double street_speed = 15;   ///< the fastest in town
constexpr double highway_speed = 25;  ///< on some trips

}  // namespace

Shift::Shift(const ShiftOptions& options, std::uint64_t seed, car::Drive& drive, MeterKeys keys)
    : options_(options),
      random_(seed),
      chances_(~seed),
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

/// Presses once each second, until the meter obeys, or the driver gives up.
bool Shift::press(Time now, const std::function<bool()>& key) {
  if (now < pressed_ + between_presses) return false;
  pressed_ = now;
  has_obeyed_ = key();
  if (!has_obeyed_ && ++presses_ < options_.presses_max) return false;
  presses_ = 0;
  return true;
}

/// In a recorded drive, a trip goes from each arrival to the next.
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

/// Before the trip, for passengers who ask for it.
void Shift::agree() {
  const AgreedPrices& prices = options_.agreed;
  const bool asks =
      prices.share > 0 && !drive_.has_record() && random_.happens(Probability(prices.share));
  if (!asks) return;
  constexpr double metres_a_km = 1000;
  constexpr double unit = 1000;
  const double price = std::max<double>(prices.least, prices.per_km * to_go_ / metres_a_km);
  keys_.agree_price(static_cast<std::uint32_t>(std::ceil(price / unit) * unit));
}

/// The services and the payment of these passengers follow from chances of their own.
void Shift::charge() {
  Random chance(random_.next());
  const bool is_wrong_first = chances_.happens(Probability(options_.mistake_share));
  if (is_wrong_first && keys_.charge(0)) keys_.clear_supplements();
  for (unsigned kind = 0; kind < options_.service_shares.size(); ++kind) {
    if (chance.happens(Probability(options_.service_shares[kind]))) keys_.charge(kind);
  }
  pays_by_card_ = chance.happens(Probability(options_.card_share));
}

void Shift::after_paying(Time now) {
  ++carried_;
  if (is_last(now)) return enter(now, Activity::signing_off);
  wait(now);
}

/// On a road of known length, before the first shift with these wheels. A meter without power is
/// tried again.
void Shift::begin(Time now) {
  constexpr unsigned calibrations_max = 8;
  constexpr Duration try_again = 20s;
  rested_ = now;
  const bool calibrates = options_.calibration_metres > 0 && !drive_.has_record() &&
                          keys_.begin_calibration && calibrations_ < calibrations_max;
  if (!calibrates) return enter(now, Activity::signing_on);
  ++calibrations_;
  if (!keys_.begin_calibration()) return enter(now, Activity::off_duty, try_again);
  drive_.go(options_.calibration_metres, town_speed);
  enter(now, Activity::calibrating, 24h);
}

/// Two drives within half a per cent are believed: one alone may have missed pulses.
void Shift::calibrate(Time now) {
  constexpr Duration last_pulses = 2s;  // come over the bus
  constexpr std::uint32_t share_apart = 200;
  if (!drive_.is_standing()) return;
  if (until_ > now + last_pulses) {
    until_ = now + last_pulses;
  } else if (now >= until_) {
    const std::optional<std::uint32_t> before = std::exchange(
        k_, keys_.end_calibration(static_cast<std::uint32_t>(options_.calibration_metres)));
    const bool agrees =
        k_ && before && std::max(*k_, *before) - std::min(*k_, *before) <= *k_ / share_apart;
    agrees ? enter(now, Activity::signing_on) : begin(now);
  }
}

bool Shift::may_rest(Time now) const {
  return now >= rested_ + options_.break_after && !drive_.has_record() && !is_last(now);
}

/// The driver has the break even if the meter does not obey.
void Shift::step_break(Time now) {
  if (activity_ == Activity::going_to_rest && press(now, keys_.standby)) {
    enter(now, Activity::resting, options_.break_lasts);
  } else if (activity_ == Activity::resting && now >= until_) {
    enter(now, Activity::rising);
  } else if (activity_ == Activity::rising && press(now, keys_.wake)) {
    rested_ = now;
    wait(now);
  }
}

void Shift::wait(Time now) {
  if (may_rest(now)) return enter(now, Activity::going_to_rest);
  enter(now, Activity::waiting, up_to(30s, options_.waiting_max));
}

bool Shift::is_last(Time now) const {
  return now >= options_.end || drive_.is_through();
}

/// Where the drive is recorded, passengers come to the car.
void Shift::fetch(Time now) {
  if (!drive_.has_record()) {
    // The next call comes from a distance similar to that of the last trip: half of the distance is
    // driven empty.
    const double way = last_trip_ == 0 ? between(300, 3000) : last_trip_ * between(0.8, 1.2);
    drive_.go(way, street_speed);
  }
  enter(now, Activity::fetching);
}

/// The people who have called are there, or not.
void Shift::meet(Time now) {
  const bool is_there =
      drive_.has_record() || !chances_.happens(Probability(options_.no_show_share));
  if (!is_there) return enter(now, Activity::unmet, options_.boarding_max);
  enter(now, Activity::boarding, up_to(10s, options_.boarding_max));
}

void Shift::step(Time now) {
  switch (activity_) {
    case Activity::off_duty:
      if (!is_over_ && now >= until_) begin(now);
      break;
    case Activity::calibrating:
      calibrate(now);
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
      if (drive_.is_standing()) meet(now);
      break;
    case Activity::unmet:
      if (now >= until_) wait(now);
      break;
    case Activity::boarding:
      if (now < until_) break;
      last_trip_ = to_go_ = between(options_.trip_min_metres, options_.trip_max_metres);
      enter(now, Activity::hiring);
      break;
    case Activity::hiring:
      if (!press(now, keys_.hire)) break;
      if (!has_obeyed_) return enter(now, Activity::waiting, options_.waiting_max);
      enter(now, Activity::at_lights, time_between(1s, 10s));
      agree();
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
      charge();
      break;
    case Activity::paying:
      if (now >= until_) enter(now, Activity::releasing);
      break;
    case Activity::releasing:
      if (press(now, keys_.for_hire)) after_paying(now);
      break;
    case Activity::going_to_rest:
    case Activity::resting:
    case Activity::rising:
      step_break(now);
      break;
    case Activity::signing_off:
      is_over_ = true;
      if (press(now, keys_.sign_off)) enter(now, Activity::off_duty);
      break;
  }
}

}  // namespace canvoy::taxi
