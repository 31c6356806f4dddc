// How other devices ask the NMT master for its services by SDO: request NMT (1F82h) and request
// guarding (1F83h) (CiA 302-2).
//
//     NmtRequests requests(node, master, commands, manager, guarding_hooks);
#pragma once

#include "canvoy/canopen/manager/boot_manager.hpp"

namespace canvoy {

/// 1F82h, sub-index = node-ID: written, 04h stops, 05h starts, 06h resets the node, 07h its
/// communication, 7Fh makes it pre-operational; read, it is the NMT state that was heard last, 00h
/// where none was, 01h where the node is lost. 1F83h: 01h begins node guarding with the times of
/// 1F81h, 00h ends it; read, it is 01h for a guarded node. Sub-index 80h means all nodes: of 1F83h
/// all slaves.
///
/// Other values are refused with 0609 0030h, all requests with 0800 0022h where this device is not
/// the active NMT master, with 0504 0005h where too many commands wait. A command goes out after
/// the answer to the request, as it may be for the master itself.
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
  static constexpr std::uint8_t all_nodes = 128;

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
  static const HookCalls hook_calls[1];
  static const ServiceCalls service_calls;
  ServiceLink service_{&service_calls, this};
};

}  // namespace canvoy
