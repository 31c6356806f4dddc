// The fare of a trip, in whole numbers: without floating point, and without loss between two
// additions.
//
// Distance is in wheel pulses (k in a local distance unit), time in microseconds. Their cost is
// kept as whole thousandths of the currency unit and two exact fractions, one with the denominator
// k and one with that of an hour. The fare grows by whole switching units (the increment of the
// level), when all of one has been used. So it is never more than the used amount, and less than a
// switching unit below it. When the level changes, the unused rest counts for the next. Mode S
// charges distance or time of each slice, mode D both; a fixed price charges neither.
//
//     FareCalculation fare;
//     fare.begin({.mode = FareMode::single_calculation, .k = 8000}, level);
//     fare.advance(42, 1s);  // pulses, and how long they took
//     fare.close_slice();    // fast enough or not: it is decided now
//     fare.fare();           // 3900: initial fare and switching units
#pragma once

#include <algorithm>
#include <cstdint>

#include "canvoy/can/time.hpp"
#include "canvoy/devices/cia447/taximeter/tariff.hpp"
#include "canvoy/profiles/cia447/add_on_states.hpp"

namespace canvoy::cia447 {

/// The highest amount of 60D0h: fares stay there.
inline constexpr std::uint32_t amount_max = 0xFFFF'FFFD;
/// The amount, or the greatest that 32 bits have.
constexpr std::uint32_t capped(std::uint64_t amount) {
  return static_cast<std::uint32_t>(std::min<std::uint64_t>(amount, amount_max));
}
/// Thousandths of a currency unit, and of a distance unit.
inline constexpr std::uint64_t thousandths = 1000;

class FareCalculation {
 public:
  /// What does not change during a trip.
  struct Conditions {
    FareMode mode = FareMode::single_calculation;  ///< of distance and time
    std::uint32_t k = 1;                           ///< pulses for a local distance unit, at least 1
    std::uint32_t fixed_price = 0;                 ///< for mode fixed_price
  };

  /// Starts a trip: its initial and minimum fare are those of this level.
  void begin(const Conditions& conditions, const TariffLevel& level);
  /// Changes the rates. The open slice is closed at the old ones.
  void change_level(const TariffLevel& level);
  /// Agrees a price, which replaces all charges from here on.
  void agree(std::uint32_t price);

  /// Adds to the open slice. If it exceeds an hour (no count came) or 2^24 pulses, the rest is
  /// another slice.
  void advance(std::uint32_t turned, Duration time);
  /// In mode S, decides by the speed of the slice whether its distance or its time is charged.
  /// Until then, the fare has the lower of the two possible amounts, and never decreases.
  void close_slice();

  /// Initial fare and switching units, but at least the minimum fare; or the fixed price.
  std::uint32_t fare() const;
  /// Time charged at the time rate, including the open slice.
  Duration charged_time() const;
  /// Tariff level at present.
  const TariffLevel& level() const { return state_.level; }
  /// Mode of the calculation.
  FareMode mode() const { return state_.conditions.mode; }
  /// Fare at the start of the trip, in 0,001 of the currency unit.
  std::uint32_t initial_fare() const { return state_.initial_fare; }
  /// Least fare of the trip, in 0,001 of the currency unit.
  std::uint32_t minimum_fare() const { return state_.minimum_fare; }

  /// The whole state, to be kept over a loss of power.
  struct State {
    Conditions conditions;            ///< of the trip
    TariffLevel level;                ///< at present
    std::uint32_t initial_fare = 0;   ///< in 0,001 of the currency unit
    std::uint32_t minimum_fare = 0;   ///< in 0,001 of the currency unit
    std::uint64_t switched = 0;       ///< in whole switching units
    std::int64_t used = 0;            ///< since the last one, in whole thousandths
    std::uint64_t distance_rest = 0;  ///< of a thousandth, below k
    std::uint64_t time_rest = 0;      ///< of a thousandth, below the microseconds of an hour
    std::uint64_t pulses = 0;         ///< of the open slice
    std::int64_t microseconds = 0;    ///< of the open slice
    std::int64_t charged = 0;         ///< microseconds of closed slices

    /// Passes each number to an archive, in the order of records.
    template <class Archive>
    constexpr void visit(Archive& archive) {
      archive(conditions.mode, conditions.k, conditions.fixed_price, level.name[0], level.name[1],
              level.initial_fare, level.minimum_fare, level.distance_rate, level.time_rate,
              level.crossover_speed, level.increment, initial_fare, minimum_fare, switched, used,
              distance_rest, time_rest, pulses, microseconds, charged);
    }
  };
  /// State, to be kept.
  const State& state() const { return state_; }
  /// Returns to a state that was kept.
  void restore(const State& state) { state_ = state; }

 private:
  enum class Costs : std::uint8_t { nothing, by_distance, by_time, by_both };
  struct Used {
    std::int64_t whole;
    std::uint64_t distance_rest;
    std::uint64_t time_rest;
    std::int64_t floor(std::uint64_t k) const;
  };

  Costs of_slice() const;
  bool is_fast() const;
  Used used_with(Costs costs) const;
  std::int64_t floor_with(Costs costs) const { return used_with(costs).floor(state_.conditions.k); }
  std::int64_t increment() const { return std::max<std::uint32_t>(state_.level.increment, 1); }

  State state_;
};

}  // namespace canvoy::cia447
