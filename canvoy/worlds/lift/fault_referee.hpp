// Judges whether a lift handles a fault as it must: it stands safely, the right emergency is on the
// bus, and it carries people again after the fault, each within its time. While another fault of
// the same lift is present, the times that need a lift in order do not run.
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
#include "canvoy/worlds/lift/building.hpp"
#include "canvoy/worlds/lift/invariant.hpp"

namespace canvoy::lift {

/// Required consequences of a fault; an absent member requires nothing.
struct FaultExpectation {
  LiftNumber lift = 1;   ///< 0: of the group
  bool is_fire = false;  ///< or smoke: the lift itself is in order
  /// From the begin of the fault until the car stands at the latest.
  std::optional<Duration> stands_within{};
  /// Time of detection: after it no car starts before the end of the fault.
  std::optional<Duration> noticed_within{};
  bool noticed_when_told = false;  ///< not before its emergency, whenever that comes
  /// One of these must be heard.
  std::vector<std::uint16_t> emergencies{};
  /// From the begin of the fault until its emergency at the latest.
  Duration told_within = 5s;
  /// Time since the end of the fault in which people may wait without any being carried.
  std::optional<Duration> serves_within{};
  /// Time after its end in which its effects are still an excuse.
  Duration recovers_within = 3min;
  /// Where service goes on in another way: time from the fault's beginning, and again from its end,
  /// in which it may hinder. Empty: until the lift serves again.
  std::optional<Duration> hinders_for{};
};

class FaultReferee {
 public:
  /// A fault begins; `fault` is its number in the plan.
  void began(Time now, std::size_t fault, const FaultExpectation& expectation);
  /// It is over; the times for the return of service begin.
  void ended(Time now, std::size_t fault);
  /// A technician leaves the lift: the effects of faults that are over show from then on, as it did
  /// not serve before.
  void handed_back(Time now, LiftNumber lift);
  /// The car stands, or has come to rest.
  void stands(Time now, LiftNumber lift);
  /// A car that stood is moved by its drive, and not because a brake does not hold.
  void starts(Time now, LiftNumber lift);
  /// An emergency of this lift was heard on the bus.
  void emergency_seen(Time now, LiftNumber lift, std::uint16_t code);
  /// A person has reached the destination. People who get out of a car that has not moved since the
  /// end of the fault were not carried.
  void serves(Time now, LiftNumber lift);
  /// Takes the time that has passed: `is_wanted` returns for each lift (0: the group) whether
  /// people wait for it, or in it.
  void passed(Time now, Duration time, const std::function<bool(LiftNumber)>& is_wanted);
  /// True while a fault of this lift is present, or has ended and the lift does not serve again
  /// yet.
  bool is_hindered(Time now, LiftNumber lift) const;
  /// Like is_hindered(), but for faults of the lift itself.
  bool is_faulty(Time now, LiftNumber lift) const;
  /// True if a person who waits since `since` has waited through a fault, or through the time after
  /// it in which service may not have returned: the crowd that it left stands in front.
  bool excuses_waiting(Time since) const;

  /// Margins so far, of the faults that are over, and of those that are present.
  std::vector<Invariant> invariants(Time now) const;

 private:
  struct Watched {
    std::size_t fault = 0;
    FaultExpectation expected{};
    Time began_at{};
    Time ended_at = never;
    Time handed_back_at{};      ///< by a technician, since its end
    bool stood_before = false;  ///< its car, when it began
    Time stood_at = never;
    Time reported_at = never;
    Time served_at = never;
    Time started_at = never;    ///< although it must not start
    Duration beside_others{0};  ///< until it was reported, or ended
    Duration wanted{0};         ///< since its end, until the lift served
    bool has_moved = false;     ///< since its end
  };
  bool moves(LiftNumber lift) const { return lift != 0 && (moving_ >> (lift - 1) & 1) != 0; }
  static Invariant safe_stand(const Watched& watched, Time until);
  static bool hinders(const Watched& watched, Time now);
  static bool recovers(const Watched& watched, Time now);
  static Invariant service(const Watched& watched);
  bool is_alone(const Watched& watched, Time now) const;

  std::vector<Watched> faults_;
  unsigned moving_ = 0;  ///< moving cars: bit 0 is lift 1
};

}  // namespace canvoy::lift
