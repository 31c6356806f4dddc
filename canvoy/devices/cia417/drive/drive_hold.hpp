// The nodes that hold a drive: they report overspeed (FF05h) or unintended car movement (FF06h; CiA
// 417-4, 4.11). Each holds it until it has no error any more, or boots.
//
//     DriveHold hold(node, emergency_consumer, held);
//     if (hold.is_held()) ...
#pragma once

#include <bitset>
#include <span>

#include "canvoy/canopen/emergency/emergency_consumer.hpp"
#include "canvoy/canopen/node/node.hpp"

namespace canvoy::cia417 {

class DriveHold {
 public:
  /// `emergencies` may be null: then none are received. Beside the nodes of 1028h, those of `more`
  /// are received. `held` is called each time that a node reports one of the two.
  DriveHold(Node& node, EmergencyConsumer* emergencies, std::span<const NodeId> more,
            Callback<void()> held);
  DriveHold(const DriveHold&) = delete;
  DriveHold& operator=(const DriveHold&) = delete;

  /// True while a node holds the drive.
  bool is_held() const { return holders_.any(); }
  /// Releases all nodes: those that have reported an error may have restarted without reporting its
  /// end.
  void release_all();

 private:
  void emergency_heard(NodeId node_id, const Emergency& emergency);
  void error_control_heard(const Frame& frame, Time now);
  void hold_for(NodeId node_id);
  void release(NodeId node_id);

  Node& node_;
  Callback<void()> held_;
  std::bitset<node_id_max + 1> holders_;
};

}  // namespace canvoy::cia417
