// Judges an excavator by its plant and by its operator's hands, ears and eyes: never by what a
// controller says of itself. What a declared fault excuses is not judged while it lasts and for a
// time after it. That the machine stops is never excused.
//
//     referee.moves(now, machine, panel);       // each step
//     referee.pressed(now, Button::light);      // a finger
//     referee.has_effect(now, Button::light);   // the lamps of the machine
#pragma once

#include <array>
#include <vector>

#include "canvoy/can/time.hpp"
#include "canvoy/canopen/cob_id.hpp"
#include "canvoy/sim/excavator/excavator_invariant.hpp"
#include "canvoy/sim/excavator/seat_panel.hpp"

namespace canvoy::excavator {

class ExcavatorReferee {
 public:
  /// What is lost, or has changed, is right again in this time.
  static constexpr Duration return_bound = 5s;
  static constexpr Duration service_returns = 1min;

  /// A fault begins; one that does not last ends at once.
  void fault_begins(const InvariantSet& kinds);
  void fault_ends(const InvariantSet& kinds, Time now);
  bool is_excused(InvariantKind kind, Time now) const;
  void cannot_judge(const InvariantSet& kinds) { undecided_ |= kinds; }

  /// The seat, or the host, was heard on the bus.
  void heard_seat(Time now) { seat_heard_ = now; }
  void heard_host(Time now) { host_heard_ = now; }
  /// The armrest, on the bus behind the seat; where there is one.
  void heard_armrest(Time now) { armrest_heard_ = now; }
  void has_no_armrest() { has_armrest_ = false; }
  /// How long the armrest was silent.
  Duration armrest_silence(Time now) const { return now - armrest_heard_; }
  /// How long the host has been silent.
  Duration host_silence(Time now) const { return now - host_heard_; }

  /// Whether a hand wants each movement that there is.
  void moves(Time now, const Excavator& machine, const SeatPanel& panel);
  /// A button goes down.
  void pressed(Time now, Button button);
  /// What it is for has happened once.
  void has_effect(Time now, Button button);
  /// Presses that had no effect by now.
  void look_at_presses(Time now);
  /// The host's value of an axis, against where it was one event ago.
  void compare(Time now, double digits_apart);
  /// Whether it is as it shall be; called in each step. An excuse stops the clock of what is wrong,
  /// and does not set it back: a fault now and then excuses nothing in between.
  void judge(InvariantKind kind, Time now, bool is_right);
  /// It cannot be wrong now.
  void pass(InvariantKind kind, Time now) {
    kept_[index(kind)].looked_at = kept_[index(kind)].right_at = now;
  }
  /// The same as judge(), whatever the faults.
  void judge_always(InvariantKind kind, Time now, bool is_right);
  void judge_device(NodeId id, Time now, bool is_there);

  std::vector<Invariant> verdicts() const;
  /// Whether any is broken that was not when this was asked last.
  bool has_news();

 private:
  static constexpr std::size_t index(InvariantKind kind) { return static_cast<std::size_t>(kind); }

  struct Kept {
    Time right_at{};  ///< later by the time of excuses since
    Time wrong_at{};
    Time looked_at{};
    double worst = 0;
    std::uint64_t judged = 0;  ///< how often
    unsigned faults = 0;       ///< that are present and excuse it
    Time excused_until{};
  };
  void measure(InvariantKind kind, double value);
  bool is_broken(std::size_t kind) const;

  std::array<Kept, invariant_kinds> kept_{};
  std::array<Time, node_id_max + 1> there_at_{};
  InvariantSet undecided_;
  InvariantSet broken_;  ///< when it was asked last

  Time seat_heard_{};
  Time host_heard_{};
  Time armrest_heard_{};
  bool has_armrest_ = true;
  Time heard_all_since_{};
  struct Directions {
    std::array<Time, 2> wanted{};  ///< last, down and up
  };
  std::array<Directions, movements> hand_{};
  struct Pressed {
    unsigned open = 0;
    Time since{};
  };
  std::array<Pressed, button_count> pressed_{};
};

}  // namespace canvoy::excavator
