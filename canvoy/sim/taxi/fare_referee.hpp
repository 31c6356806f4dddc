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

/// A trip, as it was and as the meter had it.
struct Trip {
  Time begin{};
  Time end{};
  double metres = 0;
  double seconds = 0;
  double fare_low = 0;   ///< what the tariff asks, with all limits in favour of the passenger
  double fare_high = 0;  ///< and of the driver
  double metered_metres = 0;
  double metered_seconds = 0;
  double metered_fare = 0;
  double paid = 0;            ///< with supplements
  double key_seconds = 0;     ///< in which the meter works off the driver's key
  double key_metres = 0;      ///< that the car goes meanwhile, here and when it is stopped
  bool is_disturbed = false;  ///< a fault has touched it: it is not judged
  bool has_tariff_change = false;

  /// What may be wrong: of the distance in m, of the time in s.
  double distance_limit() const;
  double time_limit() const;
  /// In m beyond the limit; 0 or less: within it.
  double distance_excess() const;
  double time_excess() const;  ///< in s
  double fare_excess() const;  ///< in 0,001 of the currency unit
};

class FareReferee {
 public:
  /// `local_begin`: seconds since 1970-01-01 that clocks show at time 0. The tariff must outlive
  /// this.
  FareReferee(const cia447::Tariff& tariff, std::int64_t local_begin)
      : tariff_(tariff), local_begin_(local_begin) {}

  /// The meter works off its keys within `key_time`, here and when it is stopped.
  void hired(Time now, double metres, Duration key_time = 1s);
  /// Each step while the meter is hired.
  void step(Time now, double metres);
  void stopped(Time now, double metres) { step(now, metres); }
  void disturb() { trip_.is_disturbed = true; }
  /// What the meter shows when the passenger pays; ends the trip.
  Trip paid(Time now, const cia447::TripData& shown);
  bool has_trip() const { return has_trip_; }
  /// A fault has touched the trip that is under way.
  bool is_disturbed() const { return has_trip_ && trip_.is_disturbed; }

 private:
  const cia447::TariffLevel& level_at(Time now) const;
  void close_slice();

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
  Time slice_begin_{};
  Time last_{};
  double last_metres_ = 0;
  double first_metres_ = 0;
  std::optional<double> first_speed_;  ///< m/s
  double last_speed_ = 0;
};

}  // namespace canvoy::taxi
