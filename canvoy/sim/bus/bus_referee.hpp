// Judges a bus by what passengers read and hear, what is on their tickets, and who is aboard; and
// the pre-defined messages by the tables of CiA 407, 8.1.4.3: never by what a device says of
// itself. What a declared fault excuses is not judged while it lasts and for a time after it.
//
//     referee.excuse(kinds, now, fault_lasts);
//     referee.judge(InvariantKind::next_stop, now, is_read);
#pragma once

#include <array>
#include <bitset>
#include <vector>

#include "canvoy/can/time.hpp"
#include "canvoy/canopen/cob_id.hpp"
#include "canvoy/sim/bus/bus_invariant.hpp"

namespace canvoy::bus {

using InvariantSet = std::bitset<invariant_kinds>;

class BusReferee {
 public:
  /// What is lost, or has changed, is right again in this time.
  static constexpr Duration return_bound = 10s;
  /// Who could not press the button is carried past his stop later.
  static constexpr Duration service_bound = 5min;

  /// A fault begins; one that does not last ends at once.
  void fault_begins(const InvariantSet& kinds, Time now);
  void fault_ends(const InvariantSet& kinds, Time now);
  /// Not judged until then.
  void excuse(InvariantKind kind, Time until);
  bool is_excused(InvariantKind kind, Time now) const;
  bool has_fault(Time now) const { return faults_ != 0 || now < troubled_until_; }

  /// Of those with a time: whether it is as it shall be; called in each step. `applies`: something
  /// could be wrong.
  void judge(InvariantKind kind, Time now, bool is_right, bool applies = true);
  /// Of `lie`: the same, without an excuse; while something is wrong a little more time is given.
  void judge_honesty(Time now, bool is_honest);
  void judge_device(NodeId id, Time now, bool is_there);
  /// Of those that count: something has happened, rightly or not.
  void judge_one(InvariantKind kind, Time now, bool is_right);
  void cannot_judge(const InvariantSet& kinds) { undecided_ |= kinds; }

  std::vector<Invariant> verdicts() const;
  /// Whether any is broken that was not when this was asked last.
  bool has_news();

 private:
  static constexpr std::size_t index(InvariantKind kind) { return static_cast<std::size_t>(kind); }

  struct Kept {
    Time right_at{};
    Duration worst{};
    unsigned wrong = 0;        ///< of those that count
    std::uint64_t judged = 0;  ///< how often
    unsigned faults = 0;       ///< that are present and excuse it
    Time excused_until{};
  };
  bool is_broken(std::size_t kind) const;

  std::array<Kept, invariant_kinds> kept_{};
  std::array<Time, node_id_max + 1> there_at_{};
  InvariantSet undecided_;
  std::size_t broken_ = 0;  ///< when it was asked last
  unsigned faults_ = 0;
  Time troubled_until_{return_bound};  ///< all boot
};

}  // namespace canvoy::bus
