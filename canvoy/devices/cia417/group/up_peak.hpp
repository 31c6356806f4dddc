// Several cars of a group at once for those who wait at the main floor. A hall call brings one car;
// where a call comes again as soon as that has left, and so after the next one, more people stand
// there than cars take one after the other, and those who are left would wait until the next one
// has opened, filled and gone. So further cars that stand there with nothing to do open as well,
// which the classical calculation of up-peak traffic takes for granted (Barney and Al-Sharif,
// Elevator Traffic Handbook).
//
//     UpPeak up_peak(lifts, {.main_floor = 1});
//     up_peak.called(now, call);       // by people at a landing
//     up_peak.opened(2, {1, Direction::up});
//     if (const LiftMask wanted = up_peak.call_more(); wanted != 0) ...  // these open there
#pragma once

#include <array>
#include <span>

#include "canvoy/devices/cia417/group/hall_dispatcher.hpp"

namespace canvoy::cia417 {

struct UpPeakSettings {
  std::uint8_t main_floor = 1;
  /// That fill there at the same time; 0 or 1: each waits for the call after the last one has left.
  unsigned cars_max = 2;
  /// A call so soon after a car has left is by those for whom it had no room.
  Duration left_behind = 2s;
  /// Cars that leave people behind, one after the other, before others open as well. By chance one
  /// does where the group is hardly busy, and people who share two cars cost more stops.
  unsigned in_a_row = 2;
};

/// It knows what the lifts tell, and no chance: the same gives the same. Each step looks at each
/// lift once.
class UpPeak {
 public:
  /// `lifts` are lift 1 and up, and must outlive this.
  UpPeak(std::span<const GroupLift> lifts, const UpPeakSettings& settings)
      : lifts_(lifts), settings_(settings) {}

  void reset();
  /// People call: those at the main floor who want up count.
  void called(Time now, const HallCall& call);
  /// A lift opens there, and goes on that way.
  void opened(unsigned lift, const Landing& landing);
  /// It has told where it is and goes.
  void told(Time now, unsigned lift, bool moving);

  /// People were left behind, and cars fill.
  bool is_crowded() const { return left_people_ >= settings_.in_a_row; }
  /// The lifts that are to open at the main floor and have not yet, where there is one more of them
  /// than before; else none. `busy`: these have something else to do.
  LiftMask call_more(LiftMask busy);
  /// What they are to answer: of low priority, so that all others come first, and that it is none
  /// that panels show.
  HallCall call() const;

 private:
  bool is_ready(unsigned lift) const;
  LiftMask serving() const;

  std::span<const GroupLift> lifts_;
  UpPeakSettings settings_;
  HallCall call_{};
  Time left_at_{};
  bool has_left_ = false;
  unsigned left_people_ = 0;  ///< cars in a row
  LiftMask filling_ = 0;      ///< have opened, and not left
  LiftMask called_ = 0;       ///< are to open
  LiftMask asked_ = 0;        ///< were, since they came
};

}  // namespace canvoy::cia417
