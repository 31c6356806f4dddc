// Whether a lift bears a fault as it must: it stands safely, the right emergency is on the bus, and
// it carries people again when the fault has gone, each within its time. While another fault of the
// same lift is there too, the time for what needs the lift in order does not run.
//
//     FaultReferee referee(faults);
//     referee.began(now, 0, {.lift = 1, .emergency = 0x5000});
//     referee.emergency_seen(now, 1, 0x5000);
//     referee.stands(now, 1); referee.starts(now, 1);
//     referee.ended(now, 0);
//     referee.passed(now, 1s, wanted);              // from time to time
//     referee.serves(now, 1);                       // somebody was carried
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "canvoy/can/time.hpp"
#include "canvoy/sim/lift/building.hpp"
#include "canvoy/sim/lift/invariant.hpp"

namespace canvoy::lift {

/// What a fault of a kind must bring about; what is absent need not come.
struct FaultExpectation {
  LiftNumber lift = 1;   ///< 0: of the group
  bool is_fire = false;  ///< or smoke: the lift is in order
  std::optional<Duration> stands_within{};
  /// When it must have been noticed: from then on no car starts before the fault has gone.
  std::optional<Duration> noticed_within{};
  bool noticed_when_told = false;  ///< not before its emergency, whenever that comes
  /// One of `emergencies` has to be heard.
  std::vector<std::uint16_t> emergencies{};
  Duration told_within = 5s;
  /// The time in which people may want it since the fault's end, and nobody is carried.
  std::optional<Duration> serves_within{};
  /// So long after its end what is left of it is no excuse any more.
  Duration recovers_within = 3min;
  /// Where service goes on in another way, it may be hindered for so long from the fault's begin,
  /// and again from its end. Otherwise until the lift serves again.
  std::optional<Duration> hinders_for{};
};

class FaultReferee {
 public:
  void began(Time now, std::size_t fault, const FaultExpectation& expectation);
  void ended(Time now, std::size_t fault);
  void stands(Time now, LiftNumber lift);
  /// A car that stood is moved by its drive, and not by what a brake does not hold.
  void starts(Time now, LiftNumber lift);
  void emergency_seen(Time now, LiftNumber lift, std::uint16_t code);
  /// It has brought somebody to where he wanted. Who leaves a car that has not moved since the
  /// fault ended was not carried.
  void serves(Time now, LiftNumber lift);
  /// Of time that has passed: `is_wanted` says of each lift (0: the group) whether anybody waits
  /// for it, or in it.
  void passed(Time now, Duration time, const std::function<bool(LiftNumber)>& is_wanted);
  /// A fault of this lift is present, or has gone and it does not serve again yet.
  bool is_hindered(Time now, LiftNumber lift) const;
  /// The same, of faults of the lift itself.
  bool is_faulty(Time now, LiftNumber lift) const;
  /// Who waits from `since` on has waited through a fault that hindered people, or began so soon
  /// after its end that service need not be there again: the crowd that it left is before him.
  bool excuses_waiting(Time since) const;

  std::vector<Invariant> invariants(Time now) const;

 private:
  struct Watched {
    std::size_t fault = 0;
    FaultExpectation expected{};
    Time began_at{};
    Time ended_at = never;
    Time stood_at = never;
    Time told_at = never;
    Time served_at = never;
    Time started_at = never;    ///< although it must not
    Duration beside_others{0};  ///< until it was told, or ended
    Duration wanted{0};         ///< since it ended, until it served
    bool has_moved = false;     ///< since it ended
  };
  bool moves(LiftNumber lift) const { return lift != 0 && (moving_ >> (lift - 1) & 1) != 0; }
  static Invariant safe_stand(const Watched& watched, Time until);
  static bool hinders(const Watched& watched, Time now);
  static bool recovers(const Watched& watched, Time now);
  static Invariant service(const Watched& watched);
  bool is_alone(const Watched& watched, Time now) const;

  std::vector<Watched> faults_;
  unsigned moving_ = 0;  ///< cars: bit 0 is lift 1
};

}  // namespace canvoy::lift
