// Judges a shift of a taxi by what passengers pay and read, what is seen on the roof and on the
// terminal, who has to wait, and which devices are there: never by what a controller says of
// itself. What a fault can cause (taxi_excuses.hpp) is not judged for as long as it can, all else
// is.
//
//     TaxiReferee referee(car, options, shift, trips, watch, excuses, tampering);
//     referee.step(now);            // each 100 ms
//     referee.frame_sent(now);
//     for (const Invariant& verdict : referee.verdicts()) ...
#pragma once

#include <vector>

#include "canvoy/sim/car/silence_referee.hpp"
#include "canvoy/sim/missing_devices.hpp"
#include "canvoy/sim/taxi/invariant.hpp"
#include "canvoy/sim/taxi/meter_watch.hpp"
#include "canvoy/sim/taxi/tampering.hpp"
#include "canvoy/sim/taxi/taxi_car.hpp"
#include "canvoy/sim/taxi/taxi_excuses.hpp"
#include "canvoy/sim/taxi/trip_book.hpp"
#include "canvoy/sim/wrong_time.hpp"

namespace canvoy::taxi {

class TaxiReferee {
 public:
  /// All must outlive this.
  TaxiReferee(TaxiCar& car, const TaxiOptions& options, const Shift& shift, const TripBook& trips,
              const MeterWatch& watch, const TaxiExcuses& excuses, const TamperWatch& tampering);
  TaxiReferee(const TaxiReferee&) = delete;
  TaxiReferee& operator=(const TaxiReferee&) = delete;

  void step(Time now);
  void frame_sent(Time now) { silence_.frame_sent(now, is_excused(InvariantKind::silence, now)); }
  /// Something is wrong with what is paid.
  bool passengers_see() const;
  /// As they stand now.
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
  bool waits_for_real_;  ///< once all were there, nobody is waited for again
  car::SilenceReferee silence_;
  WrongTime wait_;  ///< of who wants to ride or to pay
  WrongTime sign_;
  WrongTime fare_screen_;
  WrongTime place_screen_;
  MissingDevices missing_;
  Duration without_excuse_{};  ///< in all
  std::uint64_t quiet_ = 0;    ///< looks at a network that sleeps
};

}  // namespace canvoy::taxi
