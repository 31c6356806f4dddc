// Judges an excavator by its plant and by its operator's hands, ears and eyes: never by what a
// controller reports of itself. What a declared fault excuses is not judged while the fault lasts
// and for a time after it. It is never excused that the machine does not stop.
//
//     referee.moves(now, machine, hands);       // each step
//     referee.pressed(now, Button::light);      // a finger
//     referee.has_effect(now, Button::light);   // the lamps of the machine
#pragma once

#include <array>
#include <vector>

#include "canvoy/can/time.hpp"
#include "canvoy/canopen/protocol/cob_id.hpp"
#include "canvoy/worlds/excavator/excavator_invariant.hpp"
#include "canvoy/worlds/excavator/seat_panel.hpp"

namespace canvoy::excavator {

class ExcavatorReferee {
 public:
  /// Time within which what is lost, or has changed, must be right again.
  static constexpr Duration return_bound = 5s;
  static constexpr Duration service_returns = 1min;  ///< like return_bound, for work of the machine
  /// Earth counts as at least this much, in m3, so that the first buckets do not decide: ten.
  static constexpr double earth_least = 12;

  /// A fault begins; one that does not last ends at once.
  void fault_begins(const InvariantSet& kinds);
  /// The fault that began with these kinds is over; return_bound begins.
  void fault_ends(const InvariantSet& kinds, Time now);
  /// True while a fault, or the time after it, excuses the invariant.
  bool is_excused(InvariantKind kind, Time now) const;
  /// Something is lacking to judge these: their verdict says so.
  void cannot_judge(const InvariantSet& kinds) { undecided_ |= kinds; }

  /// Call it when the seat, or the host, was heard on the bus.
  void heard_seat(Time now) { seat_heard_ = now; }
  /// See heard_seat().
  void heard_host(Time now) { host_heard_ = now; }
  /// Call it when the armrest was heard on the bus behind the seat.
  void heard_armrest(Time now) { armrest_heard_ = now; }
  /// The seat has no armrest: its silence is no fault.
  void has_no_armrest() { has_armrest_ = false; }
  /// Time for which the armrest was silent.
  Duration armrest_silence(Time now) const { return now - armrest_heard_; }
  /// Time for which the host has been silent.
  Duration host_silence(Time now) const { return now - host_heard_; }

  /// Judges whether a hand commands each present movement: `hands` are the places of those that
  /// may, -1 to 1.
  void moves(Time now, const Excavator& machine, const std::array<double, movements>& hands);
  /// Call it when a button goes down.
  void pressed(Time now, Button button);
  /// Call it when the effect of the button has happened once.
  void has_effect(Time now, Button button);
  /// Judges the presses that had no effect in time.
  void look_at_presses(Time now);
  /// Judges how much of the earth that was dug has come to lie beside the heap, both in m3 since
  /// the start; call it in each step.
  void has_earth(Time now, double dug, double spilled, bool pours);
  /// Judges the difference between the host's value of an axis and its position one event ago.
  void compare(Time now, double digits_apart);
  /// Judges an invariant; call it in each step. An excuse stops the clock of what is wrong, and
  /// does not reset it: an occasional fault excuses nothing in between.
  void judge(InvariantKind kind, Time now, bool is_right);
  /// Does not judge: the invariant cannot be broken at present.
  void pass(InvariantKind kind, Time now) {
    kept_[index(kind)].looked_at = kept_[index(kind)].right_at = now;
  }
  /// Like judge(), but whatever the faults.
  void judge_always(InvariantKind kind, Time now, bool is_right);
  /// Judges whether a device is at work; each has its own time.
  void judge_device(NodeId id, Time now, bool is_there);

  /// One for each kind, in their order; without an armrest, none of it.
  std::vector<Invariant> verdicts() const;
  /// True if an invariant is broken that was not at the last call.
  bool has_news();

 private:
  static constexpr std::size_t index(InvariantKind kind) { return static_cast<std::size_t>(kind); }

  struct Kept {
    Time right_at{};  ///< extended by the time of later excuses
    Time wrong_at{};
    Time looked_at{};
    double worst = 0;
    std::uint64_t judged = 0;  ///< number of judgements
    unsigned faults = 0;       ///< present faults that excuse it
    Time excused_until{};
  };
  void measure(InvariantKind kind, double value);
  bool is_broken(std::size_t kind) const;

  std::array<Kept, invariant_kinds> kept_{};
  std::array<Time, node_id_max + 1> there_at_{};
  InvariantSet undecided_;
  InvariantSet broken_;  ///< at the last call of has_news()

  Time seat_heard_{};
  Time host_heard_{};
  Time armrest_heard_{};
  bool has_armrest_ = true;
  double spilled_before_ = 0;   ///< m3, at the last step
  double spilled_excused_ = 0;  ///< m3
  Time heard_all_since_{};
  struct Directions {
    std::array<Time, 2> wanted{};  ///< last command, down and up
  };
  std::array<Directions, movements> hand_{};
  struct Pressed {
    unsigned open = 0;
    Time since{};
  };
  std::array<Pressed, button_count> pressed_{};
};

}  // namespace canvoy::excavator
