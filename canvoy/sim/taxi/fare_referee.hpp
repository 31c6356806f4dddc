// Judges what passengers pay: the fare that the tariff asks for the true drive, against what the
// meter showed (CiA 447-3, 4.2.12; the limits are those of Directive 2014/32/EU, annex MI-007, as
// far as public text has them).
//
//     FareReferee referee(tariff, local_begin);
//     referee.hired(now, drive.metres());
//     referee.step(now, drive.metres());             // while hired
//     const TripVerdict verdict = referee.paid(now, shown);
//
// It calculates by itself, with real numbers and without slices of time; the meter decides for
// slices of a second whether distance or time costs. So the true fare is known between two bounds:
// decided at each moment, and decided for long slices.
#pragma once

#include <cstdint>
#include <optional>

#include "canvoy/can/time.hpp"
#include "canvoy/devices/cia447/taximeter/tariff.hpp"
#include "canvoy/devices/cia447/taximeter/taximeter_unit.hpp"

namespace canvoy::taxi {

/// Money is in 0,001 of the currency unit, as 60D0h has it.
inline constexpr double money_unit = 1000;

/// What of a trip a fault may have cost just now, or has.
struct TripExcuse {
  bool fare = false;      ///< less than the tariff asks for
  bool distance = false;  ///< metres that nobody counted
  bool duration = false;  ///< a time in which the meter was off

  /// Something of it.
  bool any() const { return fare || distance || duration; }
  TripExcuse& operator|=(const TripExcuse& other) {
    fare |= other.fare;
    distance |= other.distance;
    duration |= other.duration;
    return *this;
  }
};

/// A trip, as it was and as the meter had it. What a fault may have cost of it may lack, and no
/// more than that: nothing is metered that was not driven.
struct Trip {
  Time begin{};
  Time end{};
  double metres = 0;           ///< that were driven
  double seconds = 0;          ///< from the key to the key
  double sure_metres = 0;      ///< without those that a fault may have cost
  double sure_seconds = 0;     ///< the same
  double fare_low = 0;         ///< what the tariff asks, with all limits in favour of the passenger
  double fare_high = 0;        ///< and of the driver
  double metered_metres = 0;   ///< as the meter shows them
  double metered_seconds = 0;  ///< the same
  double metered_fare = 0;     ///< in 0,001 of the currency unit
  double extras = 0;           ///< as the meter shows them
  double total = 0;            ///< the same
  double paid = 0;             ///< fare and extras, with what the driver asks beside them
  double pocketed = 0;         ///< of it
  double pressed_extras = 0;   ///< by the driver
  bool knows_extras = true;    ///< who presses them is seen here
  double key_seconds = 0;      ///< in which the meter works off the driver's key
  double key_metres = 0;       ///< that the car goes meanwhile, here and when it is stopped
  bool is_read = true;         ///< what the meter has: else nothing of it can be judged
  bool has_clock = true;       ///< that is known here, and says which level of the tariff it is
  bool has_lost_power = false;     ///< the meter, meanwhile
  bool may_lack_receipt = false;   ///< by a fault when it was over
  TripExcuse excused{};            ///< of all of it
  bool has_tariff_change = false;  ///< of the town's, meanwhile

  /// A fault may have cost it something.
  bool is_disturbed() const { return !is_read || excused.any(); }
  /// What may be wrong: of the distance in m, of the time in s.
  double distance_limit() const;
  double time_limit() const;  ///< in s
  /// In m beyond the limit; 0 or less: within it.
  double distance_excess() const;
  double time_excess() const;  ///< in s
  double fare_excess() const;  ///< in 0,001 of the currency unit
  /// TOTAL and extras against what they have to be, in 0,001 of the currency unit.
  double total_error() const;
};

class FareReferee {
 public:
  /// `local_begin`: seconds since 1970-01-01 that clocks show at time 0. The tariff must outlive
  /// this.
  FareReferee(const cia447::Tariff& tariff, std::int64_t local_begin)
      : tariff_(tariff), local_begin_(local_begin) {}

  /// The meter works off its keys within `key_time`, here and when it is stopped.
  void hired(Time now, double metres, Duration key_time = 1s);
  /// Each step while passengers are driven. `excuse`: what a fault may have cost since the last
  /// one.
  void step(Time now, double metres, const TripExcuse& excuse = {});
  /// The trip that is under way.
  Trip& trip() { return trip_; }
  /// The same.
  const Trip& trip() const { return trip_; }
  /// What the meter shows when the passenger pays; nothing: it cannot be read. Ends the trip.
  Trip paid(Time now, const std::optional<cia447::TripData>& shown);
  /// From hired() to paid().
  bool has_trip() const { return has_trip_; }

 private:
  const cia447::TariffLevel& level_at(Time now) const;
  void close_slice();
  void slice(Time now, double by_distance, double by_time, bool is_excused);

  const cia447::Tariff& tariff_;
  std::int64_t local_begin_;
  Trip trip_;
  bool has_trip_ = false;
  const cia447::TariffLevel* level_ = nullptr;
  double initial_ = 0;
  double minimum_ = 0;
  double at_once_ = 0;    ///< decided at each moment
  double in_slices_ = 0;  ///< decided for closed long slices
  double slice_by_distance_ = 0;
  double slice_by_time_ = 0;
  bool was_excused_ = false;
  Time slice_begin_{};
  Time last_{};
  double last_metres_ = 0;
  double first_metres_ = 0;
  std::optional<double> first_speed_;  ///< m/s
  double last_speed_ = 0;
};

}  // namespace canvoy::taxi
