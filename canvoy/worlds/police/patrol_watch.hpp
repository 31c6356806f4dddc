// Watches a crew on patrol: compares what is seen, heard and read of the car with what the crew
// wants and says. Its referee keeps the verdicts. What a fault excuses, or a real device does, is
// not judged.
//
//     PatrolWatch watch(car, options, crew, excuses, referee);
//     watch.step(now);            // each 100 ms
//     watch.frame_sent(now);
//     crew.step(now, watch.room_hears_crew(), watch.crew_hears_room());
#pragma once

#include <vector>

#include "canvoy/worlds/car/silence_referee.hpp"
#include "canvoy/worlds/police/crew.hpp"
#include "canvoy/worlds/police/invariant.hpp"
#include "canvoy/worlds/police/police_car.hpp"
#include "canvoy/worlds/police/police_excuses.hpp"
#include "canvoy/worlds/police/police_referee.hpp"

namespace canvoy::police {

class PatrolWatch {
 public:
  /// All must outlive this object.
  PatrolWatch(PoliceCar& car, const PoliceOptions& options, Crew& crew,
              const PoliceExcuses& excuses, PoliceReferee& referee);
  PatrolWatch(const PatrolWatch&) = delete;
  PatrolWatch& operator=(const PatrolWatch&) = delete;

  /// Judges what can be seen at `now`; call it in each step.
  void step(Time now);
  /// A frame is on the bus: no device may send one while all sleep.
  void frame_sent(Time now);
  /// Call it when the network wakes up: all devices boot, and are not judged until then.
  void all_boot(Time until) { settled_at_ = until; }

  /// True if speech passes from the car to the control room.
  bool room_hears_crew() const;
  /// True if speech passes from the control room to the car.
  bool crew_hears_room() const;
  /// True if the LED beside the key of the hands-free system shows it, where that is simulated
  /// here.
  bool is_conversation_shown() const;
  /// True state; where it depends on a real device, the wanted state.
  Wish look() const;
  /// True if a key that is pressed at present may arrive late.
  bool may_come_late(Time now) const { return is_excused(InvariantKind::keypad, now); }
  /// True while the bus is silent, and all devices may sleep.
  bool is_asleep() const { return silence_.is_asleep(); }
  /// Longest wait of a person at the terminal, excused or not.
  Duration longest_wait() const { return longest_wait_; }

 private:
  bool is_played(NodeId id) const { return car_.bus().is_played(id); }
  bool talks_are_played() const;
  std::vector<InvariantKind> undecided_kinds() const;
  /// True if a fault may be the cause, or a real device that is still to come.
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
  Time free_at_{};  ///< last time without a wait that was judged
  bool waits_for_real_;
  Duration longest_wait_{};
};

}  // namespace canvoy::police
