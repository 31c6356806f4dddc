// Node guarding by the guarded node: answers the master's remote frames, and monitors the master by
// them, which is life guarding (CiA 301, 7.2.8.3.2.1 and objects 100Ch, 100Dh).
//
//     NodeGuardingSlave guarding(node);
#pragma once

#include "canvoy/canopen/node/node.hpp"

namespace canvoy {

/// Answers remote frames of any length with the NMT state and a toggle bit, which is 0 in the first
/// answer after an NMT reset.
///
/// If guard time (100Ch) and life time factor (100Dh) are both set, silence of the master for
/// longer than their product, from its first remote frame on, is the life guarding event: it raises
/// 8130h (instance 0, as the master's node-ID is unknown) until the next remote frame.
///
/// Heartbeat takes precedence: while 1017h is not zero, remote frames are not answered and the
/// master is not monitored.
class NodeGuardingSlave {
 public:
  /// Attaches to the node. Without 100Ch and 100Dh it answers, but does not monitor the master.
  explicit NodeGuardingSlave(Node& node);
  NodeGuardingSlave(const NodeGuardingSlave&) = delete;
  NodeGuardingSlave& operator=(const NodeGuardingSlave&) = delete;

  /// True if the life guarding event has occurred and is not resolved yet.
  bool is_master_lost() const { return lost_; }

 private:
  void reset(ResetScope scope);
  void parameter_written(const Entry& entry, Source source);
  void requested(const Frame& frame, Time now);
  void expired(Time now);
  void resolve();
  void watch();
  bool has_heartbeat() const;
  Duration life_time() const;

  Node& node_;
  static const ServiceHandlers service_calls;
  static const AccessHandlers hook_calls[2];
  HandlerBinding service_{&service_calls, this};
  Timer timer_;
  std::uint16_t can_id_ = 0;  ///< of the remote frames; 0: none
  bool toggle_ = false;       ///< of the next answer
  bool watching_ = false;     ///< the master was heard
  bool lost_ = false;
};

}  // namespace canvoy
