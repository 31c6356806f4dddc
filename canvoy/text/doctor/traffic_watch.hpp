// Traffic on a bus: amount, senders, times of silence, and load.
//
//     TrafficWatch traffic(125'000);
//     traffic.hear(time, frame, node);
//     traffic.awake();  // how long somebody spoke
#pragma once

#include <bitset>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "canvoy/can/frame.hpp"
#include "canvoy/can/time.hpp"
#include "canvoy/canopen/protocol/cob_id.hpp"
#include "canvoy/text/doctor/tally.hpp"

namespace canvoy::text {

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

}  // namespace canvoy::text
