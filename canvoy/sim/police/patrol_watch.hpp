// Looks on while a crew is on patrol: what is seen, heard and read of the car, against what the
// crew wishes and says. Its referee keeps the verdicts. What a fault excuses, or is in a real
// device's hands, is not judged.
//
//     PatrolWatch watch(car, options, crew, excuses, referee);
//     watch.step(now);            // each 100 ms
//     watch.frame_sent(now);
//     crew.step(now, watch.room_hears_crew(), watch.crew_hears_room());
#pragma once

#include <vector>

#include "canvoy/sim/car/silence_referee.hpp"
#include "canvoy/sim/police/crew.hpp"
#include "canvoy/sim/police/invariant.hpp"
#include "canvoy/sim/police/police_car.hpp"
#include "canvoy/sim/police/police_excuses.hpp"
#include "canvoy/sim/police/police_referee.hpp"

namespace canvoy::police {

class PatrolWatch {
 public:
  /// All must outlive this.
  PatrolWatch(PoliceCar& car, const PoliceOptions& options, Crew& crew,
              const PoliceExcuses& excuses, PoliceReferee& referee);
  PatrolWatch(const PatrolWatch&) = delete;
  PatrolWatch& operator=(const PatrolWatch&) = delete;

  void step(Time now);
  void frame_sent(Time now);
  /// The network wakes up: all boot, and are not judged until then.
  void all_boot(Time until) { settled_at_ = until; }

  bool room_hears_crew() const;
  bool crew_hears_room() const;
  /// The LED beside the key of the hands-free system says so, where it is played.
  bool is_conversation_shown() const;
  /// How it is; where a real device has it in its hands, as it is wished.
  Wish look() const;
  /// A key that is pressed now: to whom it is for.
  bool may_come_late(Time now) const { return is_excused(InvariantKind::keypad, now); }
  bool is_asleep() const { return silence_.is_asleep(); }
  /// Of somebody at the terminal, excused or not.
  Duration longest_wait() const { return longest_wait_; }

 private:
  bool is_played(NodeId id) const { return car_.bus().is_played(id); }
  bool talks_are_played() const;
  std::vector<InvariantKind> undecided_kinds() const;
  /// A fault may be why, or a real device that is still to come.
  bool is_excused(InvariantKind kind, Time now) const {
    return waits_for_real_ || excuses_.is_excused(kind, now);
  }
  void judge_wishes(Time now, bool is_free);
  void judge_waits(Time now);
  bool display_is_right() const;
  bool power_is_right(Time now) const;

  PoliceCar& car_;
  const PoliceOptions& options_;
  Crew& crew_;
  const PoliceExcuses& excuses_;
  PoliceReferee& referee_;
  std::vector<InvariantKind> undecided_;
  car::SilenceReferee silence_;
  Time settled_at_;
  Time free_at_{};  ///< when no wait was judged last
  bool waits_for_real_;
  Duration longest_wait_{};
};

}  // namespace canvoy::police
