// Verify configuration: 1020h holds date and time of the configuration that a tool or the
// configuration manager gave to this node, until the configuration changes (CiA 301, 7.5.2.23).
//
//     VerifyConfiguration verify(node);  // that is all
#pragma once

#include "canvoy/canopen/node/node.hpp"

namespace canvoy {

/// Resets 1020h. Any value that an SDO client writes and that counts as configuration sets date and
/// time to zero, so that a manager finds the difference. The manager must therefore write 1020h
/// last.
class VerifyConfiguration {
 public:
  /// Attaches to the node, for all accesses by clients. Without 1020h it does nothing.
  explicit VerifyConfiguration(Node& node);
  VerifyConfiguration(const VerifyConfiguration&) = delete;
  VerifyConfiguration& operator=(const VerifyConfiguration&) = delete;

  /// True if an entry is configuration: everything that a client may write, except process data
  /// (what an RPDO may carry as well), actions and states (is_action_or_state()), 1020h itself,
  /// which is a stored parameter, and SDO channels that are assigned dynamically (bit 30 of their
  /// COB-IDs).
  static bool is_configuration(const Entry& entry);

 private:
  void after_write(const Entry& entry, Source source);

  static const AccessHandlers hook_calls;
  static const ServiceHandlers service_calls;

  Node& node_;
  HandlerBinding service_{&service_calls, this};
};

}  // namespace canvoy
