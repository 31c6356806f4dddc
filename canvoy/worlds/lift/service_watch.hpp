// Judges whether each lift of a building does its work: whether it stands while a person waits for
// longer than it needs to come, whichever other lift could, and whether it keeps people behind shut
// doors. It uses the positions of cars, doors and people, and not the reports of a controller.
//
//     ServiceWatch watch(building);
//     watch.look(now, 1, shaft.facts(now), is_hindered, crowd);   // from time to time
//     watch.idle(1);      // how long it has stood while it was wanted
//     watch.trapped(1);   // how long somebody in it could not get out
#pragma once

#include <vector>

#include "canvoy/can/time.hpp"
#include "canvoy/worlds/lift/crowd.hpp"
#include "canvoy/worlds/lift/referee.hpp"

namespace canvoy::lift {

class ServiceWatch {
 public:
  /// The building must outlive this object.
  explicit ServiceWatch(const Building& building);

  /// Looks at one lift. A fault that hinders it excuses it.
  void look(Time now, LiftNumber lift, const LiftFacts& facts, bool is_hindered,
            const Crowd& crowd);

  /// Time, since it left a floor or was last hindered, in which it stood while a person waited for
  /// longer than it needs to come.
  Duration idle(LiftNumber lift) const { return watched(lift).idle; }
  /// True if the last look had something to judge: it has left a floor, or a person waited that
  /// long.
  bool was_wanted(LiftNumber lift) const { return watched(lift).was_wanted; }
  /// True if people are in it, whatever excuses it.
  bool has_people(LiftNumber lift) const { return watched(lift).has_people; }
  /// Like trapped(), but whatever excuses it.
  Duration shut_in(LiftNumber lift) const { return watched(lift).shut_in; }
  /// True if people are in it, and no fault excuses it.
  bool has_riders(LiftNumber lift) const { return watched(lift).has_riders; }
  /// Time for which it stands with people in it, and no door open at a floor.
  Duration trapped(LiftNumber lift) const { return watched(lift).trapped; }

 private:
  struct Watched {
    double position_m = 0;  ///< approximate position while it stands
    Time stands_since{};
    Time hindered_at{-1us};  ///< last time; before 0: never
    Time looked_at{};
    Duration idle{0};
    Duration trapped{0};
    bool was_wanted = false;
    Duration shut_in{0};
    bool has_people = false;
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
