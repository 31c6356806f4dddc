// Judges what passengers pay: compares the fare of the tariff for the true drive with the one that
// the meter showed (CiA 447-3, 4.2.12; the limits are those of Directive 2014/32/EU, annex MI-007,
// as far as they are in public text).
//
//     FareReferee referee(tariff, clock);
//     referee.hired(now, drive.metres());
//     referee.step(now, drive.metres());             // while hired
//     const TripVerdict verdict = referee.paid(now, shown);
//
// It calculates independently, with real numbers and without slices of time; the meter decides for
// slices of a second whether distance or time costs. The true fare therefore lies between two
// bounds: decided at each moment, and decided for long slices. The fare on the display is between
// them at each moment of the trip as well, and grows by whole steps of the tariff.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <optional>

#include "canvoy/can/time.hpp"
#include "canvoy/devices/cia447/taximeter/tariff.hpp"
#include "canvoy/devices/cia447/taximeter/taximeter_unit.hpp"
#include "canvoy/worlds/taxi/town_clock.hpp"

namespace canvoy::taxi {

/// Money is in 0.001 of the currency unit, like 60D0h.
inline constexpr double money_unit = 1000;

/// Parts of a trip that a fault may have affected.
struct TripExcuse {
  bool fare = false;      ///< a part of the fare
  bool distance = false;  ///< a part of the distance, not counted
  bool duration = false;  ///< a part of the time, in which the meter was off

  /// True if any part may be affected.
  bool any() const { return fare || distance || duration; }
  TripExcuse& operator|=(const TripExcuse& other) {
    fare |= other.fare;
    distance |= other.distance;
    duration |= other.duration;
    return *this;
  }
};

/// A trip, as it was and as the meter has it. What a fault may have affected may be missing, and
/// nothing else; and the meter must not have more than was driven.
struct Trip {
  Time begin{};
  Time end{};
  double metres = 0;           ///< metres driven
  double seconds = 0;          ///< from the first key to the last
  double sure_metres = 0;      ///< without those that a fault may have affected
  double sure_seconds = 0;     ///< without those that a fault may have affected
  double fare_low = 0;         ///< fare by the tariff, with all limits in favour of the passenger
  double fare_high = 0;        ///< with all limits in favour of the driver
  double metered_metres = 0;   ///< as the meter shows it
  double metered_seconds = 0;  ///< as the meter shows it
  double waiting_low = 0;      ///< s for which the time rate applies, in favour of the passenger
  double waiting_high = 0;     ///< in favour of the driver
  std::optional<double> metered_waiting{};  ///< as the meter shows it, if it does
  double metered_fare = 0;                  ///< in 0.001 of the currency unit
  double extras = 0;                        ///< as the meter shows it
  double total = 0;                         ///< as the meter shows it
  double paid = 0;            ///< fare and extras, and what the driver asks beyond them
  double pocketed = 0;        ///< part of it that the driver keeps
  double pressed_extras = 0;  ///< by the driver, at the prices of the town
  /// Number of presses for each kind of the tariff's supplements.
  std::array<unsigned, cia447::supplement_kinds_max> pressed{};
  std::optional<double> agreed{};  ///< the agreed price, as a fare
  double step_error = 0;           ///< by which the fare is no whole number of the tariff's steps
  double shown_error = 0;       ///< by which the display was outside of the bounds during the trip
  bool is_by_card = false;      ///< false: in cash
  bool knows_extras = true;     ///< the presses are seen here
  double key_seconds = 0;       ///< time in which the meter processes the driver's key
  double key_metres = 0;        ///< distance driven in that time, at the start and at the stop
  bool is_read = true;          ///< values of the meter are known; otherwise nothing of it can
                                ///< be judged
  bool has_clock = true;        ///< its clock, which selects the level of the tariff, is known
                                ///< here
  bool has_lost_power = false;  ///< of the meter, during the trip
  bool may_lack_receipt = false;   ///< by a fault at its end
  TripExcuse excused{};            ///< for the whole trip
  bool has_tariff_change = false;  ///< of the town, during the trip
  /// Names of the tariff's levels, one of which applies at its end: two at the time of a change.
  std::array<std::array<char, 2>, 2> levels{};

  /// True if a fault may have affected it.
  bool is_disturbed() const { return !is_read || excused.any(); }
  /// Limit of the error: of the distance in m, of the time in s.
  double distance_limit() const;
  double time_limit() const;  ///< in s
  /// In m beyond the limit; 0 or less: within it.
  double distance_excess() const;
  double time_excess() const;     ///< in s
  double waiting_excess() const;  ///< in s
  double fare_excess() const;     ///< in 0.001 of the currency unit
  /// Error of TOTAL and extras, in 0.001 of the currency unit.
  double total_error() const;
};

class FareReferee {
 public:
  /// The tariff must outlive this object.
  FareReferee(const cia447::Tariff& tariff, const TownClock& clock)
      : tariff_(tariff), clock_(clock) {}

  /// Begins a trip. The meter processes its keys within `key_time`, at the start and at the stop.
  void hired(Time now, double metres, Duration key_time = 1s);
  /// Call it in each step while passengers are driven. `excuse`: what a fault may have affected
  /// since the last one.
  void step(Time now, double metres, const TripExcuse& excuse = {});
  /// Sets the price that was agreed before the trip, in 0.001 of the currency unit.
  void agree(double price) { trip_.agreed = price; }
  /// The passenger reads the fare on the display while driven, in 0.001 of the currency unit.
  void look(Time now, double shown);
  /// Names of the levels that may apply, since clocks differ by seconds.
  std::array<std::array<char, 2>, 2> levels_about(Time now) const;
  /// The driver presses a service of the tariff.
  void press_extra(unsigned kind);
  /// The driver withdraws all services.
  void clear_extras();
  /// The present trip.
  Trip& trip() { return trip_; }
  /// The present trip.
  const Trip& trip() const { return trip_; }
  /// Ends the trip with what the meter shows when the passenger pays; empty: it cannot be read.
  Trip paid(Time now, const std::optional<cia447::TripData>& shown);
  /// True from hired() to paid().
  bool has_trip() const { return has_trip_; }

 private:
  const cia447::TariffLevel& level_at(Time now) const;
  void close_slice();
  void slice(Time now, double by_distance, double by_time, bool is_excused);
  void wait(double time, double by_distance, double by_time, bool is_excused);
  void ask_fare();
  void settle(Time now);
  double fare_above(double cost) const;
  double limits_of_begin() const;
  double step_error(double fare) const;

  const cia447::Tariff& tariff_;
  TownClock clock_;
  Trip trip_;
  bool has_trip_ = false;
  const cia447::TariffLevel* level_ = nullptr;
  double initial_ = 0;
  double minimum_ = 0;
  double at_once_ = 0;    ///< decided at each moment
  double in_slices_ = 0;  ///< decided for closed long slices
  /// Cost that was decided for long slices at these times.
  struct Settled {
    Time at{};
    double in_slices = 0;
  };
  std::deque<Settled> settled_;
  double slice_by_distance_ = 0;
  double slice_by_time_ = 0;
  bool was_excused_ = false;
  bool was_waiting_ = false;
  unsigned turns_ = 0;  ///< changes between driving and waiting
  Time slice_begin_{};
  Time last_{};
  double last_metres_ = 0;
  double first_metres_ = 0;
  std::optional<double> first_speed_;  ///< m/s
  double last_speed_ = 0;
};

}  // namespace canvoy::taxi
