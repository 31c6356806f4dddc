// The heartbeats of all nodes (CiA 301, 7.2.8.3.2.2): how regular they are, gaps in them, and
// whether two devices send those of one node-ID.
//
//     HeartbeatWatch heartbeats;
//     heartbeats.hear(time, 5, NmtState::operational, known, awake);
//     heartbeats.of(5).period();  // 1 s
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "canvoy/can/time.hpp"
#include "canvoy/canopen/cob_id.hpp"
#include "canvoy/canopen/nmt/nmt.hpp"
#include "canvoy/words/doctor/tally.hpp"

namespace canvoy::words {

/// Two senders that take turns: each in a rhythm of its own, and both in the same.
struct TwoRhythms {
  Duration period{};  ///< of each of the two
  Duration apart{};   ///< from one sender to the next, the shorter way
  Time since{};       ///< when it became plain
  Time last{};        ///< when it was so last
};

/// Looks for two rhythms in what should be one.
class RhythmWatch {
 public:
  /// `expected`: the period, where it is known.
  void hear(Time at, std::optional<Duration> expected);
  /// What comes next is compared with nothing before.
  void restart() {
    const std::optional<TwoRhythms> found = found_;
    *this = {};
    found_ = found;
  }
  /// The two rhythms; nothing: there is but one, or too little was heard.
  const std::optional<TwoRhythms>& found() const { return found_; }

 private:
  std::optional<TwoRhythms> found_ = {};
  unsigned heard_ = 0;
  Time latest_{};
  Duration interval_{};
  Duration pair_{};
  unsigned alternating_ = 0;
  unsigned expected_pairs_ = 0;
};

/// From one heartbeat to the next.
struct HeartbeatGap {
  Time end{};         ///< when the next one came, or the listening ended
  Duration length{};  ///< from the heartbeat before to `end`
  Duration awake{};   ///< of it, while somebody else spoke
};

/// The heartbeats of one node.
class NodeHeartbeats {
 public:
  /// `awake`: as TrafficWatch counts it.
  void hear(Time at, NmtState state, std::optional<Duration> expected, Duration awake);
  /// The boot-up message of the node. One that is not expected ends a gap.
  void boot_up(Time at, Duration awake, bool is_expected);
  /// An NMT command was sent to it.
  void commanded(bool is_reset);
  /// The listening ends: the time since the latest heartbeat is a gap as well.
  void end(Time at, Duration awake);
  /// 1017h was written.
  void chosen_anew() { forget(); }

  /// Whether a heartbeat was heard, but for boot-ups.
  bool is_heard() const { return is_heard_; }
  /// Whether a boot-up was heard.
  bool has_booted() const { return has_booted_; }
  /// The middle one of the latest; zero: there are too few.
  Duration period() const;
  /// The longest, the longest first.
  const std::vector<HeartbeatGap>& gaps() const { return gaps_; }
  /// Of the latest intervals, how many are a fifth and more off `period`, and of how many.
  std::pair<unsigned, unsigned> uneven(Duration period) const;
  /// The standard deviation of the latest.
  Duration jitter() const;
  /// As of two devices with this node-ID; nothing: it has one rhythm.
  const std::optional<TwoRhythms>& two_rhythms() const { return rhythm_.found(); }
  /// How often two states came in turns, with no command between them.
  unsigned state_turns() const { return most_turns_; }
  /// Those two.
  const std::pair<NmtState, NmtState>& states_in_turns() const { return in_turns_; }
  /// When two states came in turns last.
  Time turned_at() const { return turned_at_; }
  /// When the latest heartbeat came; only where is_heard().
  Time latest() const { return latest_; }

 private:
  void add_gap(const HeartbeatGap& gap);
  void forget();
  void take_state(Time at, NmtState state);

  static constexpr std::size_t intervals_max = 128;
  static constexpr std::size_t gaps_max = 8;

  bool is_heard_ = false;
  bool has_booted_ = false;
  bool is_running_ = false;  ///< the next one follows the latest
  Time latest_{};
  Duration awake_{};
  std::vector<Duration> intervals_;
  std::size_t next_ = 0;
  std::vector<HeartbeatGap> gaps_;
  RhythmWatch rhythm_;
  NmtState state_{};
  NmtState before_{};
  unsigned states_ = 0;
  unsigned turns_ = 0;
  unsigned most_turns_ = 0;
  std::pair<NmtState, NmtState> in_turns_{};
  Time turned_at_{};
};

class HeartbeatWatch {
 public:
  /// Those of `node`, 0 to 127.
  NodeHeartbeats& of(NodeId node) { return nodes_.at(node); }
  /// Those of `node`, 0 to 127.
  const NodeHeartbeats& of(NodeId node) const { return nodes_.at(node); }

 private:
  std::array<NodeHeartbeats, node_id_max + 1> nodes_{};
};

}  // namespace canvoy::words
