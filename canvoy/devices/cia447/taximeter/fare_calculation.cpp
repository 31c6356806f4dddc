#include "canvoy/devices/cia447/taximeter/fare_calculation.hpp"

namespace canvoy::cia447 {

namespace {

constexpr std::uint64_t microseconds_an_hour = 3'600'000'000;
/// Maximum of a slice: the products below then fit into 64 bits for all rates.
constexpr std::uint64_t pulses_max = 1U << 24;

/// A product of 64 and 32 bits.
struct Product {
  std::uint64_t upper;  ///< in units of 2^32
  std::uint32_t lower;

  constexpr Product(std::uint64_t one, std::uint32_t other) {
    const std::uint64_t low = (one & 0xFFFF'FFFF) * other;
    upper = (one >> 32) * other + (low >> 32);
    lower = static_cast<std::uint32_t>(low);
  }
  friend constexpr bool operator>(const Product& a, const Product& b) {
    return a.upper != b.upper ? a.upper > b.upper : a.lower > b.lower;
  }
};

}  // namespace

void FareCalculation::begin(const Conditions& conditions, const TariffLevel& level) {
  state_ = {.conditions = conditions,
            .level = level,
            .initial_fare = level.initial_fare,
            .minimum_fare = level.minimum_fare};
  state_.conditions.k = std::max<std::uint32_t>(conditions.k, 1);
}

void FareCalculation::change_level(const TariffLevel& level) {
  close_slice();
  state_.level = level;
}

void FareCalculation::agree(std::uint32_t price) {
  close_slice();
  state_.conditions.mode = FareMode::fixed_price;
  state_.conditions.fixed_price = price;
}

void FareCalculation::advance(std::uint32_t turned, Duration time) {
  std::uint64_t left = turned;
  auto microseconds = std::max<std::int64_t>(time.count(), 0);
  do {
    const std::uint64_t some = std::min(left, pulses_max - state_.pulses);
    const auto room = static_cast<std::int64_t>(microseconds_an_hour) - state_.microseconds;
    const std::int64_t of_them = std::min(microseconds, room);
    state_.pulses += some;
    state_.microseconds += of_them;
    left -= some;
    microseconds -= of_them;
    const bool is_full = state_.pulses == pulses_max || of_them == room;
    if (is_full) close_slice();
  } while (left > 0 || microseconds > 0);
}

/// Compares pulses per time with a speed, each multiplied by the divisor of the other.
bool FareCalculation::is_fast() const {
  const TariffLevel& level = state_.level;
  const auto time = static_cast<std::uint64_t>(state_.microseconds);
  const auto hour = static_cast<std::uint32_t>(microseconds_an_hour);
  if (level.crossover_speed != 0) {
    return Product(state_.pulses * 1000, hour) >
           Product(level.crossover_speed * time, state_.conditions.k);
  }
  return Product(state_.pulses * level.distance_rate, hour) >
         Product(level.time_rate * time, state_.conditions.k);
}

FareCalculation::Costs FareCalculation::of_slice() const {
  switch (state_.conditions.mode) {
    case FareMode::single_calculation:
      return is_fast() ? Costs::by_distance : Costs::by_time;
    case FareMode::double_calculation:
      return Costs::by_both;
    default:
      return Costs::nothing;
  }
}

/// The used amount when the open slice costs this.
FareCalculation::Used FareCalculation::used_with(Costs costs) const {
  Used used = {state_.used, state_.distance_rest, state_.time_rest};
  const std::uint64_t k = state_.conditions.k;
  if (costs == Costs::by_distance || costs == Costs::by_both) {
    const std::uint64_t parts = state_.pulses * state_.level.distance_rate + used.distance_rest;
    used.whole += static_cast<std::int64_t>(parts / k);
    used.distance_rest = parts % k;
  }
  if (costs == Costs::by_time || costs == Costs::by_both) {
    const auto time = static_cast<std::uint64_t>(state_.microseconds);
    const std::uint64_t parts = time * state_.level.time_rate + used.time_rest;
    used.whole += static_cast<std::int64_t>(parts / microseconds_an_hour);
    used.time_rest = parts % microseconds_an_hour;
  }
  return used;
}

/// The two fractions may be a whole together: a/k + b/h >= 1 is a * h >= k * (h - b).
std::int64_t FareCalculation::Used::floor(std::uint64_t k) const {
  const bool is_whole =
      distance_rest * microseconds_an_hour >= k * (microseconds_an_hour - time_rest);
  return whole + (is_whole ? 1 : 0);
}

void FareCalculation::close_slice() {
  const Costs costs = of_slice();
  const Used used = used_with(costs);
  const std::int64_t units = used.floor(state_.conditions.k) / increment();
  state_.switched += static_cast<std::uint64_t>(units * increment());
  state_.used = used.whole - units * increment();
  state_.distance_rest = used.distance_rest;
  state_.time_rest = used.time_rest;
  const bool is_time = costs == Costs::by_time || costs == Costs::by_both;
  if (is_time) state_.charged += state_.microseconds;
  state_.pulses = 0;
  state_.microseconds = 0;
}

/// The certain part of the open slice counts.
std::uint32_t FareCalculation::fare() const {
  if (state_.conditions.mode == FareMode::fixed_price) return state_.conditions.fixed_price;
  const bool is_single = state_.conditions.mode == FareMode::single_calculation;
  const std::int64_t used =
      is_single ? std::min(floor_with(Costs::by_distance), floor_with(Costs::by_time))
                : floor_with(Costs::by_both);
  const auto units = static_cast<std::uint64_t>(used / increment() * increment());
  const std::uint64_t fare = state_.initial_fare + state_.switched + units;
  return static_cast<std::uint32_t>(
      std::min<std::uint64_t>(std::max<std::uint64_t>(fare, state_.minimum_fare), amount_max));
}

Duration FareCalculation::charged_time() const {
  const Costs costs = of_slice();
  const bool is_time = costs == Costs::by_time || costs == Costs::by_both;
  return Duration(state_.charged + (is_time ? state_.microseconds : 0));
}

}  // namespace canvoy::cia447
