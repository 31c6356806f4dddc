// Whether each lift of a building does its work: whether it stands while somebody waits longer than
// it would take to come, whoever else could, and whether it keeps people behind shut doors. By
// where cars, doors and people are, and not by what a controller says.
//
//     ServiceWatch watch(building);
//     watch.look(now, 1, shaft.facts(now), is_hindered, crowd);   // from time to time
//     watch.idle(1);      // how long it has stood while it was wanted
//     watch.trapped(1);   // how long somebody in it could not get out
#pragma once

#include <vector>

#include "canvoy/can/time.hpp"
#include "canvoy/sim/lift/crowd.hpp"
#include "canvoy/sim/lift/referee.hpp"

namespace canvoy::lift {

class ServiceWatch {
 public:
  /// It must outlive this.
  explicit ServiceWatch(const Building& building);

  /// Of one lift. A fault that hinders it excuses it.
  void look(Time now, LiftNumber lift, const LiftFacts& facts, bool is_hindered,
            const Crowd& crowd);

  /// Since it has left a floor, or was hindered the last time: in which it stood there, and
  /// somebody waited for longer than it needs to come.
  Duration idle(LiftNumber lift) const { return watched(lift).idle; }
  /// There was something to judge at the last look: it has left a floor, or somebody waited so
  /// long.
  bool was_wanted(LiftNumber lift) const { return watched(lift).was_wanted; }
  /// Somebody is in it, and no fault excuses it.
  bool has_riders(LiftNumber lift) const { return watched(lift).has_riders; }
  /// It stands with people in it, and no door is open at a floor, for so long.
  Duration trapped(LiftNumber lift) const { return watched(lift).trapped; }

 private:
  struct Watched {
    double position_m = 0;  ///< where it stands, about
    Time stands_since{};
    Time hindered_at{-1us};  ///< the last time; before 0: never
    Time looked_at{};
    Duration idle{0};
    Duration trapped{0};
    bool was_wanted = false;
    bool has_riders = false;
    bool is_new = true;
  };

  bool is_awaited_too_long(Time now, LiftNumber lift, const Crowd& crowd) const;
  bool lets_out(LiftNumber lift, const LiftFacts& facts) const;
  Watched& watched(LiftNumber lift) { return lifts_.at(lift - std::size_t{1}); }
  const Watched& watched(LiftNumber lift) const { return lifts_.at(lift - std::size_t{1}); }

  const Building* building_;
  std::vector<Watched> lifts_;
};

}  // namespace canvoy::lift
