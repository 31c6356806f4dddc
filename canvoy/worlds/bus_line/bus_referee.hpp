// Judges a bus by what passengers read and hear, by their tickets, and by the number of people
// aboard; and the pre-defined messages by the tables of CiA 407 (8.1.4.3): never by what a device
// reports of itself. What a declared fault excuses is not judged while the fault lasts and for a
// time after it.
//
//     referee.excuse(kinds, now, fault_lasts);
//     referee.judge(InvariantKind::next_stop, now, is_read);
#pragma once

#include <array>
#include <bitset>
#include <vector>

#include "canvoy/can/time.hpp"
#include "canvoy/canopen/protocol/cob_id.hpp"
#include "canvoy/worlds/bus_line/bus_invariant.hpp"

namespace canvoy::bus_line {

/// A bit for each InvariantKind.
using InvariantSet = std::bitset<invariant_kinds>;

class BusReferee {
 public:
  /// Time within which what is lost, or has changed, must be right again.
  static constexpr Duration return_bound = 10s;
  /// Time for `service`, in place of return_bound: a passenger who could not press the button is
  /// carried past the stop later.
  static constexpr Duration service_bound = 5min;

  /// A fault begins; one that does not last ends at once.
  void fault_begins(const InvariantSet& kinds, Time now);
  /// The fault that began with these kinds is over; return_bound begins.
  void fault_ends(const InvariantSet& kinds, Time now);
  /// Suspends judgement until then.
  void excuse(InvariantKind kind, Time until);
  /// True while a fault, or the time after it, excuses the invariant.
  bool is_excused(InvariantKind kind, Time now) const;
  /// True while a fault is present, or its time has not passed.
  bool has_fault(Time now) const { return faults_ != 0 || now < troubled_until_; }

  /// Judges an invariant with a time: whether it is as it must be; call it in each step. `applies`:
  /// something could be wrong.
  void judge(InvariantKind kind, Time now, bool is_right, bool applies = true);
  /// Judges `lie`, like judge(), but without an excuse; while something is wrong, a little more
  /// time is allowed.
  void judge_honesty(Time now, bool is_honest);
  /// Judges whether a device is at work; each has its own time.
  void judge_device(NodeId id, Time now, bool is_there);
  /// Judges an invariant that counts: something has happened, rightly or not.
  void judge_one(InvariantKind kind, Time now, bool is_right);
  /// Something is lacking to judge these: their verdict says so.
  void cannot_judge(const InvariantSet& kinds) { undecided_ |= kinds; }

  /// One for each kind, in their order.
  std::vector<Invariant> verdicts() const;
  /// True if an invariant is broken that was not at the last call.
  bool has_news();

 private:
  static constexpr std::size_t index(InvariantKind kind) { return static_cast<std::size_t>(kind); }

  struct Kept {
    Time right_at{};
    Duration worst{};
    unsigned wrong = 0;        ///< for invariants that count
    std::uint64_t judged = 0;  ///< number of judgements
    unsigned faults = 0;       ///< present faults that excuse it
    Time excused_until{};
  };
  bool is_broken(std::size_t kind) const;

  std::array<Kept, invariant_kinds> kept_{};
  std::array<Time, node_id_max + 1> there_at_{};
  InvariantSet undecided_;
  std::size_t broken_ = 0;  ///< at the last call of has_news()
  unsigned faults_ = 0;
  Time troubled_until_{return_bound};  ///< all devices boot
};

}  // namespace canvoy::bus_line
