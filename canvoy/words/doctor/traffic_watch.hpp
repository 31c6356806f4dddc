// How much was heard on a bus, of whom, when nobody spoke, and how busy it was.
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
#include "canvoy/canopen/cob_id.hpp"
#include "canvoy/words/doctor/tally.hpp"

namespace canvoy::words {

class TrafficWatch {
 public:
  /// Nobody has spoken for so long: the bus sleeps, or has no power.
  static constexpr Duration silence_least = 3s;
  /// A bus is too busy where frames take so much of a second.
  static constexpr double load_most = 0.8;

  /// `bit_rate` in bit/s; 0: not known, and the load is not judged.
  explicit TrafficWatch(std::uint32_t bit_rate) : bit_rate_(bit_rate) {}

  /// A data or remote frame of `node`; 0: not known of whom.
  void hear(Time at, const Frame& frame, NodeId node);
  /// The listening ends: the silence and the second that are going on are counted.
  void end(Time at);

  /// How many were heard, without error frames.
  std::uint64_t frames() const { return frames_.count; }
  /// When the first frame came; only where frames() is not 0.
  Time first() const { return frames_.first; }
  /// When the latest frame came; only where frames() is not 0.
  Time last() const { return frames_.last; }
  /// Without the times of silence.
  Duration awake() const { return awake_; }
  /// When somebody spoke again; count 0: there was no silence.
  const Tally& silences() const { return silences_; }
  /// `silence_least` or longer; zero: there was no silence.
  Duration longest_silence() const { return longest_silence_; }
  /// When the bus fell silent or awoke last; never: it did not.
  Time awoken() const { return awoken_; }
  /// Whether a frame of `node`, 0 to 127, was heard.
  bool is_heard(NodeId node) const { return nodes_[node]; }
  /// How many nodes were heard, 0 to 127.
  std::size_t nodes() const { return nodes_.count(); }

  /// Seconds in which the bus was too busy.
  const Tally& peaks() const { return peaks_; }
  /// The greatest, 0 to 1.
  double highest_load() const { return highest_; }
  /// Who made it.
  struct Share {
    std::uint32_t can_id = 0;  ///< of 11 or 29 bits
    NodeId node = 0;           ///< its sender; 0: not known
    double of_bus = 0;         ///< 0 to 1
  };
  /// Up to 3, the greatest first; empty: the bit rate is not known, or there was no frame.
  const std::vector<Share>& peak_shares() const { return peak_shares_; }

 private:
  struct Sender {
    NodeId node = 0;         ///< of its latest frame; 0: not known
    std::uint64_t bits = 0;  ///< in this second, with those between frames
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
  Time second_{};  ///< when the one that is counted began
  std::uint64_t bits_ = 0;
  std::map<std::uint32_t, Sender> senders_;
  Tally peaks_;
  double highest_ = 0;
  std::vector<Share> peak_shares_;
};

}  // namespace canvoy::words
