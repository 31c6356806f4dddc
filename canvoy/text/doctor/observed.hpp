// All that was heard on one bus, for the rows of finding.hpp to judge.
#pragma once

#include <array>
#include <bitset>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "canvoy/can/frame.hpp"
#include "canvoy/can/time.hpp"
#include "canvoy/canopen/protocol/cob_id.hpp"
#include "canvoy/decoder/decoder.hpp"
#include "canvoy/text/doctor/heartbeat_watch.hpp"
#include "canvoy/text/doctor/known_parameters.hpp"
#include "canvoy/text/doctor/object_watches.hpp"
#include "canvoy/text/doctor/tally.hpp"

namespace canvoy::text {

/// Traffic on a bus: amount, senders, times of silence, and load.
///
///     TrafficWatch traffic(125'000);
///     traffic.hear(time, frame, node);
///     traffic.awake();  // time with frames
class TrafficWatch {
 public:
  /// Minimum time without frames that counts as silence: the bus sleeps, or has no power.
  static constexpr Duration silence_least = 3s;
  /// Part of a second taken by frames from which a bus is too busy.
  static constexpr double load_most = 0.8;

  /// `bit_rate` in bit/s; 0: unknown, the load is not judged.
  explicit TrafficWatch(std::uint32_t bit_rate) : bit_rate_(bit_rate) {}

  /// Takes a data or remote frame of `node`; 0: unknown sender.
  void hear(Time at, const Frame& frame, NodeId node);
  /// Ends listening: counts the current silence and the current second.
  void end(Time at);

  /// Number of frames, without error frames.
  std::uint64_t frames() const { return frames_.count; }
  /// Time of the first frame; valid if frames() is not 0.
  Time first() const { return frames_.first; }
  /// Time of the last frame; valid if frames() is not 0.
  Time last() const { return frames_.last; }
  /// Duration without the times of silence.
  Duration awake() const { return awake_; }
  /// Ends of silences; count 0: none.
  const Tally& silences() const { return silences_; }
  /// The longest silence, `silence_least` or more; zero: none.
  Duration longest_silence() const { return longest_silence_; }
  /// Time at which the bus last fell silent or woke up; never: it did not.
  Time awoken() const { return awoken_; }
  /// True if a frame of `node`, 0 to 127, was heard.
  bool is_heard(NodeId node) const { return nodes_[node]; }
  /// Number of nodes heard, 0 to 127.
  std::size_t nodes() const { return nodes_.count(); }

  /// Seconds in which the bus was too busy.
  const Tally& peaks() const { return peaks_; }
  /// The highest load of a second, 0 to 1.
  double highest_load() const { return highest_; }
  /// Part of the load by one CAN-ID.
  struct Share {
    std::uint32_t can_id = 0;  ///< of 11 or 29 bits
    NodeId node = 0;           ///< the sender; 0: unknown
    double of_bus = 0;         ///< 0 to 1
  };
  /// Up to 3 parts of the highest load, in descending order; empty: the bit rate is unknown, or no
  /// frame was heard.
  const std::vector<Share>& peak_shares() const { return peak_shares_; }

 private:
  struct Sender {
    NodeId node = 0;         ///< sender of its last frame; 0: unknown
    std::uint64_t bits = 0;  ///< in this second, including interframe spaces
  };
  void pass(Time at);
  void count(Time at, const Frame& frame, NodeId node);
  void close_second();

  std::uint32_t bit_rate_;
  Tally frames_;
  Duration awake_{};
  Tally silences_;
  Duration longest_silence_{};
  Time awoken_ = never;
  std::bitset<node_id_max + 1> nodes_;
  Time second_{};  ///< start of the current second
  std::uint64_t bits_ = 0;
  std::map<std::uint32_t, Sender> senders_;
  Tally peaks_;
  double highest_ = 0;
  std::vector<Share> peak_shares_;
};

/// Error frames and the senders of the affected frames: a controller repeats a destroyed frame at
/// once, so that it is usually the next successful one (ISO 11898-1).
///
///     ErrorWatch errors;
///     errors.hear_error(time, error_frame);
///     errors.hear(time, frame, 5);  // the frame that was repeated, of node 5
class ErrorWatch {
 public:
  /// Takes an error frame. It counts for the next successful frame, if that comes within 100 ms.
  void hear_error(Time at, const Frame& frame);
  /// Takes a successful frame of `node`; 0: unknown sender.
  void hear(Time at, const Frame& frame, NodeId node);

  /// All errors, except those that only report a state of the controller.
  const Tally& errors() const { return errors_; }
  /// Number of errors() that report a missing acknowledgement.
  std::uint64_t unacknowledged() const { return unacknowledged_; }
  /// True if an error frame reported that the listening controller was error-passive.
  bool was_passive() const { return was_passive_; }
  /// True if an error frame reported that the listening controller was bus-off.
  bool was_bus_off() const { return was_bus_off_; }

  /// Frames and errors of one sender.
  struct Struck {
    NodeId node = 0;           ///< the sender; 0: unknown
    std::uint64_t frames = 0;  ///< number of successful frames
    std::uint64_t errors = 0;  ///< number of errors in its frames
  };
  /// By CAN-ID of 11 or 29 bits, for the first 4096 CAN-IDs.
  const std::map<std::uint32_t, Struck>& by_id() const { return by_id_; }
  /// The sums of by_id() for each node, without CAN-IDs of unknown senders.
  std::map<NodeId, Struck> by_node() const;
  /// Number of errors with a known sender.
  std::uint64_t known() const { return known_; }

 private:
  Tally errors_;
  std::uint64_t unacknowledged_ = 0;
  bool was_passive_ = false;
  bool was_bus_off_ = false;
  std::uint64_t waiting_ = 0;  ///< errors without a successful frame so far
  Time latest_{};
  std::map<std::uint32_t, Struck> by_id_;
  std::uint64_t known_ = 0;
};

// Reserved values, values that report a fault, and frames that violate the protocol, by the marks
// of the decoder.
//
//     ValueWatch values;
//     values.hear(time, decoder.decode(frame));

/// Observation on one entry of a node.
struct HeardValue {
  std::string_view name = {};     ///< of the object
  decoder::Mark mark = {};        ///< kind of deviation
  std::string_view meaning = {};  ///< name of a sentinel value
  Tally tally = {};               ///< occurrences
};

/// Reserved values, values that report a fault, and frames that violate CiA 301.
class ValueWatch {
 public:
  /// Takes the decoded content of one frame; ignores a PDO of a wrong length.
  void hear(Time at, const decoder::Decoded& decoded);
  /// Takes the violations of a frame of NMT, SYNC, TIME, emergencies or error control of `node`;
  /// 0: unknown sender.
  void hear_service(Time at, NodeId node, decoder::Marks marks);

  /// By node, index and sub-index.
  using ByEntry = std::map<std::tuple<NodeId, std::uint16_t, std::uint8_t>, HeardValue>;
  /// Values that are reserved or out of range: of the first 1024 entries.
  const ByEntry& wrong() const { return wrong_; }
  /// Values that report a fault, such as of a sensor.
  const ByEntry& failed() const { return failed_; }
  /// Violations by messages instead of values, by node and mark.
  const std::map<std::pair<NodeId, decoder::Mark>, Tally>& messages() const { return messages_; }

 private:
  void hear_value(Time at, NodeId node, const decoder::DecodedValue& value);
  static HeardValue* place(ByEntry& entries, NodeId node, const decoder::DecodedValue& value);

  ByEntry wrong_;
  ByEntry failed_;
  std::map<std::pair<NodeId, decoder::Mark>, Tally> messages_;
};

// Unrequested boot-ups (CiA 301, 7.2.8.3.3) and emergencies (CiA 301, 7.2.7) of each node.
//
//     NodeWatch nodes;
//     nodes.commanded(time, 5);       // NMT reset
//     nodes.boot_up(time, 5, true);   // expected

/// Boot-ups and emergencies of one node.
struct HeardNode {
  Tally boot_ups = {};           ///< unrequested
  Tally emergencies = {};        ///< all of eight bytes, including code 0000h
  Tally storm = {};              ///< those with `storm_least` others in `storm_time`
  std::uint16_t error_code = 0;  ///< of the last one
  Tally errors = {};             ///< those with a code other than 0000h
  /// The different codes of `errors`, in order of their first occurrence; at most `codes_most`.
  std::vector<std::uint16_t> codes = {};
};

/// Unrequested boot-ups (CiA 301, 7.2.8.3.3) and emergencies of each node.
class NodeWatch {
 public:
  /// More emergencies than this in `storm_time` are a storm.
  static constexpr std::size_t storm_least = 10;
  /// Number of codes kept for a node; further ones are only counted.
  static constexpr std::size_t codes_most = 4;
  /// Time in which the emergencies of a storm come.
  static constexpr Duration storm_time = 10s;
  /// Maximum boot time of a node.
  static constexpr Duration boot_most = 10s;

  /// Takes an NMT reset command to the node; 0: all nodes.
  void reset(Time at, NodeId node);
  /// True if an NMT command has requested it.
  bool is_asked(Time at, NodeId node) const;
  /// Takes an unrequested boot-up of the node.
  void boot_up(Time at, NodeId node) { nodes_.at(node).heard.boot_ups.add(at); }
  /// Takes an emergency of eight bytes. Code 0000h, which reports that an error is gone, is counted
  /// too.
  void emergency(Time at, NodeId node, const Frame& frame);

  /// Boot-ups and emergencies of `node`, 0 to 127.
  const HeardNode& of(NodeId node) const { return nodes_.at(node).heard; }

 private:
  struct Node {
    HeardNode heard;                         ///< returned by of()
    Time reset_at = never;                   ///< never: no reset
    std::array<Time, storm_least> latest{};  ///< emergencies, as a ring buffer
  };
  std::array<Node, node_id_max + 1> nodes_{};
};

/// SYNC: its period, and whether two devices send it (CiA 301, 7.2.5).
///
///     SyncWatch syncs;
///     syncs.hear(time, frame, known.sync_period());
///     syncs.period();  // 100 ms
class SyncWatch {
 public:
  /// Takes a data frame with the CAN-ID of SYNC. `expected`: 1006h of its producer, if known.
  void hear(Time at, const Frame& frame, std::optional<Duration> expected);

  /// Number and times of the SYNCs.
  const Tally& heard() const { return heard_; }
  /// CAN-ID of the last SYNC.
  std::uint16_t can_id() const { return can_id_; }
  /// Median of the last intervals; zero: too few.
  Duration period() const;
  /// Two producers in alternation, each in its own rhythm; nothing: one.
  const std::optional<TwoRhythms>& rhythms() const { return rhythm_.found(); }
  /// Counters (1019h) that do not follow the previous one, without a cause for a reset.
  const Tally& jumps() const { return jumps_; }

 private:
  void hear_counter(Time at, const Frame& frame);

  static constexpr std::size_t intervals_max = 32;

  Tally heard_;
  Tally jumps_;
  RhythmWatch rhythm_;
  std::array<Duration, intervals_max> intervals_{};
  std::size_t intervals_heard_ = 0;
  std::uint16_t can_id_ = 0;
  std::uint8_t counter_ = 0;  ///< of the last SYNC; 0: none
};

/// Node guarding of one node (CiA 301, 7.2.8.3.2.1): requests, and those without an answer.
struct Guarding {
  /// With this many requests in a row without an answer the node counts as lost.
  static constexpr unsigned lost_from = 3;

  /// Takes a request.
  void ask(Time at);
  /// Takes an answer.
  void answer() {
    in_a_row = 0;
    is_waiting = false;
  }

  Tally missed = {};         ///< requests without an answer
  unsigned in_a_row = 0;     ///< the last of them
  unsigned most_in_row = 0;  ///< the most of them
  bool is_waiting = false;   ///< the last request is without an answer so far
};

/// PDOs of a node that says that it is stopped or pre-operational, in which it sends none (CiA 301,
/// 7.3.2.2).
class QuietWatch {
 public:
  /// Takes a heartbeat or a guarding answer of a node.
  void tell(NodeId node, NmtState state);
  /// Takes an NMT command to a node; 0: to all. Its state is unknown until it tells it.
  void command(NodeId node);
  /// Takes a PDO of a node.
  void send(Time at, NodeId node);

  /// PDOs between two messages of the node that tell the same state, in which it sends none.
  const Tally& of(NodeId node) const { return nodes_.at(node).sent; }

 private:
  struct Node {
    NmtState state = NmtState::operational;
    Tally sent = {};
    Tally since = {};  ///< the last message of its state
  };
  std::array<Node, node_id_max + 1> nodes_{};
};

/// Data of each watch, from `begin` to `end`.
struct Observed {
  /// `bit_rate` in bit/s; 0: unknown, the load is not judged.
  explicit Observed(std::uint32_t bit_rate) : traffic(bit_rate) {}

  Time begin{};               ///< start of listening
  Time end{};                 ///< last frame, or end of listening
  KnownParameters known;      ///< parameters from nodes and sheets
  Tally losses{};             ///< of the connection to the bus
  std::string loss{};         ///< reason of the last one
  TrafficWatch traffic;       ///< amount of traffic, by sender
  ErrorWatch errors;          ///< error frames, by sender of the affected frames
  HeartbeatWatch heartbeats;  ///< by node
  PdoWatch pdos;              ///< by CAN-ID
  SyncWatch syncs;            ///< rhythm and counter
  SdoWatch sdos;              ///< by server
  NodeWatch nodes;            ///< boot-ups and emergencies by node
  ValueWatch values;          ///< values and messages with marks of the decoder
  SheetWatch sheets;          ///< differences from data sheets
  std::array<Guarding, node_id_max + 1> guarding;  ///< by node
  QuietWatch quiet;                                ///< PDOs of nodes that send none
  RhythmWatch clocks;                              ///< TIME
};

}  // namespace canvoy::text
