// Verify configuration: 1020h holds date and time of the configuration that a tool or the
// configuration manager gave to this node, until somebody changes it (CiA 301, 7.5.2.23).
//
//     VerifyConfiguration verify(node);  // that is all
#pragma once

#include "canvoy/canopen/node.hpp"

namespace canvoy {

/// Any value that an SDO client writes and that counts as configuration sets date and time to zero,
/// so that a manager finds the difference. It has to write 1020h as the last.
class VerifyConfiguration {
 public:
  explicit VerifyConfiguration(Node& node);
  VerifyConfiguration(const VerifyConfiguration&) = delete;
  VerifyConfiguration& operator=(const VerifyConfiguration&) = delete;

  /// Everything that a client may write is configuration, but for process data (what an RPDO may
  /// carry as well), actions and states (is_action_or_state()), 1020h itself, which is a parameter
  /// that is stored, and SDO channels that are given out dynamically (bit 30 of their COB-IDs).
  static bool is_configuration(const Entry& entry);

 private:
  void after_write(const Entry& entry, Source source);

  static const HookCalls hook_calls;
  static const ServiceCalls service_calls;

  Node& node_;
  ServiceLink service_{&service_calls, this};
};

}  // namespace canvoy
