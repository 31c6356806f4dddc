// Boot-ups that nobody has asked for (CiA 301, 7.2.8.3.3), and emergencies (7.2.7) by node.
//
//     NodeWatch nodes;
//     nodes.commanded(time, 5);       // NMT reset
//     nodes.boot_up(time, 5, true);   // expected
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "canvoy/can/frame.hpp"
#include "canvoy/can/time.hpp"
#include "canvoy/canopen/cob_id.hpp"
#include "canvoy/words/doctor/tally.hpp"

namespace canvoy::words {

/// What was heard of one node.
struct HeardNode {
  Tally boot_ups = {};           ///< that nobody has asked for
  Tally emergencies = {};        ///< all of eight bytes, with code 0000h too
  Tally storm = {};              ///< those that came with `storm_least` others in `storm_time`
  std::uint16_t error_code = 0;  ///< of the latest
  Tally errors = {};             ///< those with another code than 0000h
  /// The different codes of `errors`, in the order in which they came first; at most `codes_most`.
  std::vector<std::uint16_t> codes = {};
};

class NodeWatch {
 public:
  /// More emergencies than this many in `storm_time` are a storm.
  static constexpr std::size_t storm_least = 10;
  /// So many codes of a node are known; more are counted alone.
  static constexpr std::size_t codes_most = 4;
  /// In which the emergencies of a storm come.
  static constexpr Duration storm_time = 10s;
  /// How long a node may take to boot.
  static constexpr Duration boot_most = 10s;

  /// An NMT command resets the node; 0: all.
  void reset(Time at, NodeId node);
  /// Whether it was asked for by an NMT command.
  bool is_asked(Time at, NodeId node) const;
  /// A boot-up of the node that nobody has asked for.
  void boot_up(Time at, NodeId node) { nodes_.at(node).heard.boot_ups.add(at); }
  /// An emergency of eight bytes. Code 0000h, which tells that an error is gone, is counted too.
  void emergency(Time at, NodeId node, const Frame& frame);

  /// What was heard of `node`, 0 to 127.
  const HeardNode& of(NodeId node) const { return nodes_.at(node).heard; }

 private:
  struct Node {
    HeardNode heard;                         ///< what of() gives
    Time reset_at = never;                   ///< never: it was not
    std::array<Time, storm_least> latest{};  ///< emergencies, in a ring
  };
  std::array<Node, node_id_max + 1> nodes_{};
};

}  // namespace canvoy::words
