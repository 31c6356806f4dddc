// A driver and those whom he carries: what they do with car and meter, by the hour and by chance.
//
//     Shift shift(options, seed, drive, keys);
//     shift.step(now);    // each 100 ms, beside the drive
//
// The driver presses a key until the meter obeys, or he gives it up: a meter without power costs
// time, and one that has lost its trip cannot be stopped. Passengers pay what the meter shows when
// they get out; those for whom it does not start walk away. With a drive that was recorded, each of
// its legs is a trip, and the shift ends after the last one.
#pragma once

#include <cstdint>
#include <functional>

#include "canvoy/can/random.hpp"
#include "canvoy/can/time.hpp"
#include "canvoy/sim/car/drive.hpp"

namespace canvoy::taxi {

enum class Activity : std::uint8_t {
  off_duty,
  signing_on,
  waiting,   ///< at a stand
  fetching,  ///< drives to who has called
  boarding,
  hiring,     ///< presses the key
  carrying,   ///< drives with passengers
  at_lights,  ///< stands with passengers
  stopping,
  paying,
  releasing,  ///< presses "for hire"
  signing_off,
};

/// The driver's hands: true where the meter has obeyed.
struct MeterKeys {
  std::function<bool()> sign_on;
  std::function<bool()> hire;
  std::function<bool()> stop;
  std::function<bool(std::uint32_t)> add_supplement;  ///< in 0,001 of the currency unit
  std::function<bool()> for_hire;
  std::function<bool()> sign_off;
};

struct ShiftOptions {
  Time begin = Time(2min);  ///< the driver signs on
  Time end = Time(11h);     ///< nobody is fetched after it
  Duration waiting_max = 12min;
  Duration boarding_max = 60s;
  Duration paying_max = 90s;
  double trip_min_metres = 800;
  double trip_max_metres = 14'000;
  unsigned presses_max = 20;  ///< of a key that is not obeyed
};

class Shift {
 public:
  static constexpr Duration step_time = 100ms;

  Shift(const ShiftOptions& options, std::uint64_t seed, car::Drive& drive, MeterKeys keys);

  void step(Time now);
  /// Told of each change: what it was, what it is.
  void on_change(std::function<void(Time, Activity, Activity)> changed) {
    changed_ = std::move(changed);
  }

  Activity activity() const { return activity_; }
  unsigned carried() const { return carried_; }
  /// Of the trip, in m; of a drive that was recorded nobody knows.
  double to_go() const { return to_go_; }
  /// The shift is over.
  bool is_over() const { return is_over_; }

 private:
  void enter(Time now, Activity activity, Duration lasts = {});
  /// True where he is done with it.
  bool press(Time now, const std::function<bool()>& key);
  void next_leg(double metres_per_second_max);
  void carry(Time now);
  void after_paying(Time now);
  void wait(Time now);
  void fetch(Time now);
  /// Nobody is carried any more.
  bool is_last(Time now) const;
  double between(double low, double high);
  Duration time_between(Duration low, Duration high);
  /// Not less than what is usual, unless all of it is.
  Duration up_to(Duration usual_least, Duration most);

  ShiftOptions options_;
  Random random_;
  car::Drive& drive_;
  MeterKeys keys_;
  std::function<void(Time, Activity, Activity)> changed_;
  Activity activity_ = Activity::off_duty;
  Time until_{};          ///< of what just takes its time
  unsigned presses_ = 0;  ///< of the key, in vain
  bool has_obeyed_ = false;
  Time pressed_{};    ///< when the key was pressed last
  double to_go_ = 0;  ///< of the trip, in m
  unsigned carried_ = 0;
  bool is_over_ = false;
};

}  // namespace canvoy::taxi
