// Judges a shift of a taxi by what passengers pay and read, what is seen on the roof and on the
// terminal, how long people must wait, and which devices are present: never by what a controller
// reports of itself. What a fault can cause (taxi_excuses.hpp) is not judged for as long as it can;
// everything else is.
//
//     TaxiReferee referee(car, options, shift, trips, watch, excuses, tampering);
//     referee.step(now);            // each 100 ms
//     referee.frame_sent(now);
//     for (const Invariant& verdict : referee.verdicts()) ...
#pragma once

#include <vector>

#include "canvoy/sim/missing_devices.hpp"
#include "canvoy/sim/wrong_time.hpp"
#include "canvoy/worlds/car/silence_referee.hpp"
#include "canvoy/worlds/taxi/invariant.hpp"
#include "canvoy/worlds/taxi/meter_watch.hpp"
#include "canvoy/worlds/taxi/tampering.hpp"
#include "canvoy/worlds/taxi/taxi_car.hpp"
#include "canvoy/worlds/taxi/taxi_excuses.hpp"
#include "canvoy/worlds/taxi/trip_book.hpp"

namespace canvoy::taxi {

class TaxiReferee {
 public:
  /// All must outlive this object.
  TaxiReferee(TaxiCar& car, const TaxiOptions& options, const Shift& shift, const TripBook& trips,
              const MeterWatch& watch, const TaxiExcuses& excuses, const TamperWatch& tampering);
  TaxiReferee(const TaxiReferee&) = delete;
  TaxiReferee& operator=(const TaxiReferee&) = delete;

  /// Judges what can be seen at `now`; call it in each step.
  void step(Time now);
  /// A frame is on the bus: no device may send one while all sleep.
  void frame_sent(Time now) { silence_.frame_sent(now, is_excused(InvariantKind::silence, now)); }
  /// True if passengers see that something is wrong with what they pay.
  bool passengers_see() const;
  /// Verdicts at present.
  std::vector<Invariant> verdicts() const;

 private:
  bool is_played(NodeId id) const { return car_.bus().is_played(id); }
  bool can_be_judged(InvariantKind kind) const;
  bool is_excused(InvariantKind kind, Time now) const {
    return waits_for_real_ || excuses_.is_excused(kind, now);
  }
  void judge_silence(Time now);
  void judge_service(Time now);
  void judge_devices(Time now);
  void judge_sign(Time now);
  bool level_is_shown(Time now) const;
  void judge_alarm(Time now);
  void judge_terminal(Time now);
  bool is_awake(NodeId id);
  bool place_is_shown() const;
  Invariant judge_carried() const;
  Invariant of_trips(InvariantKind kind, double unit) const;

  TaxiCar& car_;
  const TaxiOptions& options_;
  const Shift& shift_;
  const TripBook& trips_;
  const MeterWatch& watch_;
  const TaxiExcuses& excuses_;
  const TamperWatch& tampering_;
  bool waits_for_real_;  ///< false once all were present: no device is waited for after that
  car::SilenceReferee silence_;
  WrongTime wait_;  ///< of people who want to ride or to pay
  WrongTime sign_;  ///< the light for a vacant taxi
  WrongTime taxi_light_;
  WrongTime level_sign_;
  WrongTime alarm_;
  Time alarm_seen_{};  ///< last time of an alarm light
  WrongTime fare_screen_;
  WrongTime place_screen_;
  MissingDevices missing_;
  Duration without_excuse_{};  ///< sum
  std::uint64_t quiet_ = 0;    ///< number of looks at a network that sleeps
};

}  // namespace canvoy::taxi
