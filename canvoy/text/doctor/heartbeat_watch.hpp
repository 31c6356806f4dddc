// Heartbeats of all nodes: their regularity, gaps, and whether two devices send those of one
// node-ID (CiA 301, 7.2.8.3.2.2).
//
//     HeartbeatWatch heartbeats;
//     heartbeats.of(5).hear(time, NmtState::operational, expected, awake);
//     heartbeats.of(5).period();  // 1 s
#pragma once

#include <array>
#include <bitset>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "canvoy/can/time.hpp"
#include "canvoy/canopen/protocol/cob_id.hpp"
#include "canvoy/canopen/protocol/nmt.hpp"
#include "canvoy/text/doctor/tally.hpp"

namespace canvoy::text {

/// Two senders in alternation: each in its own rhythm, with the same period.
struct TwoRhythms {
  Duration period{};  ///< of each sender
  Duration apart{};   ///< time from one sender to the other, the shorter way
  Time since{};       ///< time of the detection
  Time last{};        ///< time of the last confirmation
};

/// Detects several devices with one node-ID by their heartbeats, whatever their periods are:
/// between two heartbeats that are the period of the node apart come others.
class CrossingWatch {
 public:
  /// Takes a heartbeat; nothing is detected while the period is unknown.
  void hear(Time at, std::optional<Duration> period);
  /// Starts again: the next heartbeat is not compared with earlier ones.
  void restart() {
    count_ = 0;
    crossed_.reset();
  }
  /// Time of the last detection; nothing: none.
  const std::optional<Time>& found() const { return found_; }

 private:
  static constexpr std::size_t times_max = 32;
  bool is_crossed(Time at, Duration period) const;

  std::array<Time, times_max> times_{};  ///< the last heartbeats, as a ring buffer
  std::size_t count_ = 0;
  std::bitset<times_max> crossed_;  ///< of them, those that others came before within a period
  std::optional<Time> found_;
};

/// The periods of two senders, the shorter one first.
struct TwoPeriods {
  Duration shorter{};  ///< period of one sender
  Duration longer{};   ///< period of the other
  Time last{};         ///< time of the last confirmation
};

/// Detects two senders with different periods, both unknown: all heartbeats belong to one of two
/// regular sequences.
class PeriodsWatch {
 public:
  /// Takes a heartbeat; at most 256 comparisons.
  void hear(Time at);
  /// Starts again: the next heartbeat is not compared with earlier ones.
  void restart() { count_ = 0; }
  /// The two periods; nothing: one, or too few heartbeats.
  const std::optional<TwoPeriods>& found() const { return found_; }

 private:
  static constexpr std::size_t times_max = 64;
  Time ago(std::size_t back) const { return times_[(count_ - 1 - back) % times_max]; }
  void try_period(std::size_t start, Duration period);

  std::array<Time, times_max> times_{};  ///< the last heartbeats, as a ring buffer
  std::size_t count_ = 0;
  std::optional<TwoPeriods> found_;
};

/// Detects two rhythms in one sequence.
class RhythmWatch {
 public:
  /// Takes an occurrence. `expected`: the period, if known.
  void hear(Time at, std::optional<Duration> expected);
  /// Starts again: the next occurrence is not compared with earlier ones.
  void restart() {
    const std::optional<TwoRhythms> found = found_;
    *this = {};
    found_ = found;
  }
  /// The two rhythms; nothing: only one, or too few occurrences.
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

/// The time between two heartbeats.
struct HeartbeatGap {
  Time end{};         ///< time of the next one, or the end of listening
  Duration length{};  ///< from the previous heartbeat to `end`
  Duration awake{};   ///< the part of it in which other nodes sent frames
};

/// Heartbeats of one node.
class NodeHeartbeats {
 public:
  /// Takes a heartbeat. `awake`: as counted by TrafficWatch.
  void hear(Time at, NmtState state, std::optional<Duration> expected, Duration awake);
  /// Takes the boot-up message of the node. An unexpected one ends a gap.
  void boot_up(Time at, Duration awake, bool is_expected);
  /// Takes an NMT command to the node.
  void commanded(bool is_reset);
  /// Ends listening: the time since the last heartbeat counts as a gap.
  void end(Time at, Duration awake);
  /// Takes a write of 1017h, which sets a new period.
  void chosen_anew() { forget(); }

  /// True if a heartbeat other than a boot-up was heard.
  bool is_heard() const { return is_heard_; }
  /// True if a boot-up was heard.
  bool has_booted() const { return has_booted_; }
  /// Median of the last intervals; zero: too few.
  Duration period() const;
  /// The longest gaps, in descending order.
  const std::vector<HeartbeatGap>& gaps() const { return gaps_; }
  /// Number of the last intervals that deviate from `period` by a fifth or more, and number of
  /// intervals.
  std::pair<unsigned, unsigned> uneven(Duration period) const;
  /// Standard deviation of the last intervals.
  Duration jitter() const;
  /// Two rhythms, as of two devices with this node-ID; nothing: one rhythm.
  const std::optional<TwoRhythms>& two_rhythms() const { return rhythm_.found(); }
  /// The time when other heartbeats last came between those of its period; nothing: never.
  const std::optional<Time>& crossed() const { return crossings_.found(); }
  /// Two periods, as of two devices with this node-ID; nothing: one period.
  const std::optional<TwoPeriods>& two_periods() const { return periods_.found(); }
  /// Number of alternations between two states without an NMT command.
  unsigned state_turns() const { return most_turns_; }
  /// The two alternating states.
  const std::pair<NmtState, NmtState>& states_in_turns() const { return in_turns_; }
  /// Time of the last alternation.
  Time turned_at() const { return turned_at_; }
  /// Time of the last heartbeat; valid if is_heard().
  Time latest() const { return latest_; }

 private:
  void add_gap(const HeartbeatGap& gap);
  void restart();
  void forget();
  void take_state(Time at, NmtState state);

  static constexpr std::size_t intervals_max = 128;
  static constexpr std::size_t gaps_max = 8;

  bool is_heard_ = false;
  bool has_booted_ = false;
  bool is_running_ = false;  ///< the next interval starts at the last heartbeat
  Time latest_{};
  Duration awake_{};
  std::vector<Duration> intervals_;
  std::size_t next_ = 0;
  std::vector<HeartbeatGap> gaps_;
  RhythmWatch rhythm_;
  CrossingWatch crossings_;
  PeriodsWatch periods_;
  NmtState state_{};
  NmtState before_{};
  unsigned states_ = 0;
  unsigned turns_ = 0;
  unsigned most_turns_ = 0;
  std::pair<NmtState, NmtState> in_turns_{};
  Time turned_at_{};
};

/// Heartbeats of all nodes.
class HeartbeatWatch {
 public:
  /// Heartbeats of `node`, 0 to 127.
  NodeHeartbeats& of(NodeId node) { return nodes_.at(node); }
  /// Heartbeats of `node`, 0 to 127.
  const NodeHeartbeats& of(NodeId node) const { return nodes_.at(node); }

 private:
  std::array<NodeHeartbeats, node_id_max + 1> nodes_{};
};

}  // namespace canvoy::text
