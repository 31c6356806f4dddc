// Error behaviour: the NMT state after a serious error, set by 1029h (CiA 301, 7.5.2.33).
//
//     ErrorBehaviour error_behaviour(node);
//     error_behaviour.device_failure();  // the pilot signal is gone
#pragma once

#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/canopen/node/node.hpp"

namespace canvoy {

/// Changes the NMT state. Bus-off and the loss of a heartbeat (8130h) are communication errors, and
/// follow sub-index 1. 0: operational becomes pre-operational; 1: no change; 2: stopped. A missing
/// entry counts as 0. Construct it after the emergency producer, so that the error is sent before
/// the state changes.
class ErrorBehaviour : private NodeService {
 public:
  static constexpr std::uint8_t communication_error = 1;  ///< sub-index of 1029h

  /// Makes the service. Without 1029h the code that checks writes to it is not linked.
  constexpr explicit ErrorBehaviour(Node& node, bool has_object = true)
      : NodeService(has_object ? Listener{on_object_event, object, object} : Listener{on_event},
                    EventMask::none),
        node_(node) {
    node_.attach(*this);
  }
  ErrorBehaviour(const ErrorBehaviour&) = delete;
  ErrorBehaviour& operator=(const ErrorBehaviour&) = delete;

  /// Handles an internal failure that counts as severe as sub-index `sub` requires; 2 and up belong
  /// to the profile or the manufacturer (CiA 419, 5.2).
  void device_failure(std::uint8_t sub = communication_error);

 private:
  static constexpr std::uint16_t object = object_index::error_behaviour;

  static void on_event(NodeService& service, ServiceEvent& event);
  static void on_object_event(NodeService& service, ServiceEvent& event);
  static bool is_communication_error(const ServiceEvent& event);
  void leave_operational();

  Node& node_;
};

}  // namespace canvoy
