// Error behaviour: which NMT state a serious error puts the node into, by 1029h (CiA
// 301, 7.5.2.33).
//
//     ErrorBehaviour error_behaviour(node);
//     error_behaviour.device_failure();  // the pilot signal is gone
#pragma once

#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/canopen/node.hpp"

namespace canvoy {

/// Bus-off and the loss of a heartbeat (8130h) are communication errors, and follow sub-index 1.
/// 0: operational becomes pre-operational; 1: nothing changes; 2: stopped. An entry that is not
/// there counts as 0. Construct it behind the emergency producer, so that the error is told before
/// the state changes.
class ErrorBehaviour : private NodeService {
 public:
  static constexpr std::uint8_t communication_error = 1;

  /// Without 1029h there is nothing to write, and nothing that checks it is linked.
  constexpr explicit ErrorBehaviour(Node& node, bool has_object = true)
      : NodeService(has_object ? Listener{told_of_object, object, object} : Listener{told},
                    Cares::for_nothing_frequent),
        node_(node) {
    node_.attach(*this);
  }
  ErrorBehaviour(const ErrorBehaviour&) = delete;
  ErrorBehaviour& operator=(const ErrorBehaviour&) = delete;

  /// An internal failure that counts as severe (CiA 419, 5.2): does what sub-index `sub` says; 2
  /// and up belong to the profile or the manufacturer.
  void device_failure(std::uint8_t sub = communication_error);

 private:
  static constexpr std::uint16_t object = object_index::error_behaviour;

  static void told(NodeService& service, ServiceEvent& event);
  static void told_of_object(NodeService& service, ServiceEvent& event);
  static bool is_communication_error(const ServiceEvent& event);
  void leave_operational();

  Node& node_;
};

}  // namespace canvoy
