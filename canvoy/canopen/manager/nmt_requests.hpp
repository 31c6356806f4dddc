// How other devices request services of the NMT master by SDO: request NMT (1F82h) and request
// guarding (1F83h) (CiA 302-2).
//
//     NmtRequests requests(node, master, commands, manager, guarding_hooks);
#pragma once

#include "canvoy/canopen/manager/boot_manager.hpp"

namespace canvoy {

/// Serves 1F82h and 1F83h. 1F82h, sub-index = node-ID: a write of 04h stops, 05h starts, 06h resets
/// the node, 07h its communication, 7Fh makes it pre-operational; a read returns the last known NMT
/// state, 00h if there is none, 01h if the node is lost. 1F83h: 01h begins node guarding with the
/// times of 1F81h, 00h ends it; a read returns 01h for a guarded node. Sub-index 80h means all
/// nodes, in 1F83h all slaves.
///
/// Other values are refused with 0609 0030h, all requests with 0800 0022h if this device is not the
/// active NMT master, with 0504 0005h if too many commands wait. A command is sent after the answer
/// to the request, as it may address the master itself.
class NmtRequests {
 public:
  /// Values of 1F82h.
  enum class Value : std::uint8_t {
    unknown = 0,
    missing = 1,
    stopped = 4,
    operational = 5,
    reset_node = 6,
    reset_communication = 7,
    pre_operational = 0x7F,
  };
  static constexpr std::uint8_t all_nodes = 128;  ///< sub-index 80h

  /// Attaches to the node. Without `guarding`, 1F83h refuses writes. All must outlive it.
  NmtRequests(Node& node, const NmtMaster& master, NmtQueue& commands, const BootManager& manager,
              const GuardingHooks& guarding = {});
  NmtRequests(const NmtRequests&) = delete;
  NmtRequests& operator=(const NmtRequests&) = delete;

 private:
  AbortCode refresh(const Entry& entry);
  AbortCode request(const Entry& entry, std::span<const std::uint8_t> value);
  AbortCode request_nmt(std::uint8_t sub, std::uint8_t value);
  AbortCode request_guarding(std::uint8_t sub, std::uint8_t value);
  AbortCode guard(NodeId slave, bool begins);
  Value state_of(NodeId node_id) const;

  Node& node_;
  const NmtMaster& master_;
  NmtQueue& commands_;
  const BootManager& manager_;
  GuardingHooks guarding_;
  static const AccessHandlers hook_calls[1];
  static const ServiceHandlers service_calls;
  HandlerBinding service_{&service_calls, this};
};

}  // namespace canvoy
