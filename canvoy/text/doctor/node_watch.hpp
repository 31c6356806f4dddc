// Unrequested boot-ups (CiA 301, 7.2.8.3.3) and emergencies (CiA 301, 7.2.7) of each node.
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
#include "canvoy/canopen/protocol/cob_id.hpp"
#include "canvoy/text/doctor/tally.hpp"

namespace canvoy::text {

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

}  // namespace canvoy::text
