// Whether a lift bears a fault as it must: it stands safely, the right emergency is on the bus, and
// it serves again when the fault has gone, each within its time.
//
//     FaultReferee referee(faults);
//     referee.began(now, 0, {.lift = 1, .emergency = 0x5000});
//     referee.emergency_seen(now, 1, 0x5000);
//     referee.stands(now, 1); referee.starts(now, 1);
//     referee.ended(now, 0);
//     referee.serves(now, 1);
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "canvoy/can/time.hpp"
#include "canvoy/sim/lift/building.hpp"
#include "canvoy/sim/lift/invariant.hpp"

namespace canvoy::lift {

/// What a fault of a kind must bring about; what is absent need not come.
struct FaultExpectation {
  LiftNumber lift = 1;   ///< 0: of the group
  bool is_fire = false;  ///< the lift is in order, and not for passengers
  std::optional<Duration> stands_within{};
  /// When it must have been noticed: from then on no car starts before the fault has gone.
  std::optional<Duration> noticed_within{};
  /// One of `emergencies` has to be heard.
  std::vector<std::uint16_t> emergencies{};
  Duration told_within = 5s;
  /// A car that serves: opens a door at a floor for somebody, or stands ready with nothing to do.
  std::optional<Duration> serves_within{};
  /// Where service goes on in another way, it may be hindered for so long from the fault's begin,
  /// and again from its end. Otherwise until the lift serves again.
  std::optional<Duration> hinders_for{};
};

class FaultReferee {
 public:
  void began(Time now, std::size_t fault, const FaultExpectation& expectation);
  void ended(Time now, std::size_t fault);
  void stands(Time now, LiftNumber lift);
  /// A car that stood moves.
  void starts(Time now, LiftNumber lift);
  void emergency_seen(Time now, LiftNumber lift, std::uint16_t code);
  void serves(Time now, LiftNumber lift);
  /// A fault of this lift is present, or has gone and it does not serve again yet.
  bool is_hindered(Time now, LiftNumber lift) const;
  /// The same, of faults of the lift itself.
  bool is_faulty(LiftNumber lift) const;

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
    Time started_at = never;  ///< although it must not
  };
  static Invariant safe_stand(const Watched& watched, Time until);
  static bool hinders(const Watched& watched, Time now);

  std::vector<Watched> faults_;
};

}  // namespace canvoy::lift
