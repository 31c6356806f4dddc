// A driver and the passengers of a shift: their actions at car and meter, by the hour and by
// chance.
//
//     Shift shift(options, seed, drive, keys);
//     shift.step(now);    // each 100 ms, beside the drive
//
// The driver presses a key until the meter obeys, or gives up: a meter without power costs time,
// and one that has lost its trip cannot be stopped. Passengers pay what the meter shows when they
// get out; those for whom it does not start walk away. With a recorded drive, each of its legs is a
// trip, and the shift ends after the last one.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>

#include "canvoy/can/random.hpp"
#include "canvoy/can/time.hpp"
#include "canvoy/devices/cia447/taximeter/tariff.hpp"
#include "canvoy/worlds/car/drive.hpp"

namespace canvoy::taxi {

/// What the driver does.
enum class Activity : std::uint8_t {
  off_duty,
  calibrating,  ///< drives a known distance
  signing_on,
  waiting,   ///< at a stand
  fetching,  ///< drives to people who have called
  unmet,     ///< waits for people who do not come
  boarding,
  hiring,     ///< presses the key
  carrying,   ///< drives with passengers
  at_lights,  ///< stands with passengers
  stopping,
  paying,
  releasing,  ///< presses "for hire"
  going_to_rest,
  resting,  ///< with the meter in standby
  rising,
  signing_off,
};

/// Keys of the meter: true where the meter has obeyed.
struct MeterKeys {
  std::function<bool()> sign_on;            ///< a shift begins
  std::function<bool()> hire;               ///< a trip begins
  std::function<bool()> stop;               ///< ends the trip, which is then to be paid
  std::function<bool()> standby;            ///< for a break
  std::function<bool()> wake;               ///< end of a break
  std::function<bool()> clear_supplements;  ///< withdraws all of them
  /// Opens the seal and begins to count; empty: it cannot be done here.
  std::function<bool()> begin_calibration;
  /// Takes the distance in m, and closes the seal: the new k; empty: it failed.
  std::function<std::optional<std::uint32_t>(std::uint32_t)> end_calibration;
  std::function<bool(unsigned)> charge;            ///< a service, by its index in the tariff
  std::function<bool(std::uint32_t)> agree_price;  ///< in 0.001 of the currency unit
  std::function<bool()> for_hire;                  ///< clears the meter
  std::function<bool()> sign_off;                  ///< ends the shift
};

/// Prices that passengers and driver agree on before the trip, where a town allows them.
struct AgreedPrices {
  double share = 0;          ///< share of the trips that have one; 0 to 1
  std::uint32_t per_km = 0;  ///< in 0.001 of the currency unit for each km, rounded up to a whole
                             ///< unit
  std::uint32_t least = 0;   ///< least price of a trip
};

/// The shift of a driver, with passengers by chance.
struct ShiftOptions {
  Time begin = Time(2min);          ///< the driver signs on
  Time end = Time(11h);             ///< no passenger is fetched after it
  Duration waiting_max = 12min;     ///< longest time at a stand
  Duration boarding_max = 60s;      ///< longest time in which people get in
  Duration paying_max = 90s;        ///< longest time from the halt to the payment
  double trip_min_metres = 800;     ///< shortest trip
  double trip_max_metres = 14'000;  ///< longest trip
  unsigned presses_max = 20;        ///< presses of a key without effect until the driver gives up
  /// Share of the trips with each service of the tariff; 0 to 1. A service that does not exist:
  /// none.
  std::array<double, cia447::supplement_kinds_max> service_shares = {0.2, 0.3, 0.1};
  double card_share = 0.4;      ///< share of the trips that are paid by card; 0 to 1
  AgreedPrices agreed{};        ///< for a share of the trips; none by default
  double no_show_share = 0.05;  ///< share of the callers who do not come; 0 to 1
  double mistake_share = 0.05;  ///< share of the trips in which a wrong service is pressed first; 0
                                ///< to 1
  Duration break_after = 4h + 30min;  ///< of work
  Duration break_lasts = 30min;       ///< with the meter in standby
  /// Metres of the drive before the shift; 0: none. It is repeated until two of them agree.
  double calibration_metres = 0;
};

class Shift {
 public:
  static constexpr Duration step_time = 100ms;  ///< between two steps

  /// `drive` must outlive this object; the same seed gives the same shift.
  Shift(const ShiftOptions& options, std::uint64_t seed, car::Drive& drive, MeterKeys keys);

  /// Acts at the car and at the meter; call it in each step_time.
  void step(Time now);
  /// Sets the function that is called for each change, with the old and the new activity.
  void on_change(std::function<void(Time, Activity, Activity)> changed) {
    changed_ = std::move(changed);
  }

  /// What the driver does at present.
  Activity activity() const { return activity_; }
  /// Number of trips that were paid.
  unsigned carried() const { return carried_; }
  /// True if the present, or last, passengers pay by card; false: in cash.
  bool pays_by_card() const { return pays_by_card_; }
  /// Distance left of the trip, in m; unknown for a recorded drive.
  double to_go() const { return to_go_; }
  /// True if the shift is over.
  bool is_over() const { return is_over_; }

 private:
  void enter(Time now, Activity activity, Duration lasts = {});
  /// True when the driver is done with the key.
  bool press(Time now, const std::function<bool()>& key);
  void next_leg(double metres_per_second_max);
  void carry(Time now);
  void begin(Time now);
  void calibrate(Time now);
  bool may_rest(Time now) const;
  void step_break(Time now);
  void agree();
  void charge();
  void after_paying(Time now);
  void wait(Time now);
  void fetch(Time now);
  void meet(Time now);
  /// True if no further passenger is carried.
  bool is_last(Time now) const;
  double between(double low, double high);
  Duration time_between(Duration low, Duration high);
  /// Not less than the usual least, unless that exceeds `most`.
  Duration up_to(Duration usual_least, Duration most);

  ShiftOptions options_;
  Random random_;
  Random chances_;  ///< of events between trips
  car::Drive& drive_;
  MeterKeys keys_;
  std::function<void(Time, Activity, Activity)> changed_;
  Activity activity_ = Activity::off_duty;
  Time until_{};          ///< of an activity with a fixed duration
  unsigned presses_ = 0;  ///< presses of the key without effect
  bool has_obeyed_ = false;
  Time pressed_{};        ///< last press of the key
  double to_go_ = 0;      ///< distance left of the trip, in m
  double last_trip_ = 0;  ///< length of the last trip, in m
  Time rested_{};         ///< beginning of work, or end of the last break
  unsigned carried_ = 0;
  unsigned calibrations_ = 0;         ///< that were begun, or tried
  std::optional<std::uint32_t> k_{};  ///< by the last one
  bool pays_by_card_ = false;
  bool is_over_ = false;
};

}  // namespace canvoy::taxi
