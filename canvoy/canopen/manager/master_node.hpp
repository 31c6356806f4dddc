// An NMT master that boots its network, in memory laid out at compile time: a DeviceNode with the
// additions of CiA 302-2.
//
//     constexpr auto layout = lay_out_device<my_master>();  // with cia302::nmt_master()
//     MasterNode<layout, MasterSize{.slots = 8}> master(port, 127);
//     master.boot_manager().on_report(...);
//     master.node().start(now);
#pragma once

#include <array>
#include <cstddef>
#include <utility>

#include "canvoy/canopen/device/device_node.hpp"
#include "canvoy/canopen/manager/boot_manager.hpp"
#include "canvoy/canopen/manager/nmt_requests.hpp"
#include "canvoy/canopen/nmt/node_guarding_master.hpp"

namespace canvoy {

/// Room of a MasterNode, at compile time.
struct MasterSize {
  std::size_t slots = 4;       ///< slaves that are booted at once
  std::size_t guarded = 0;     ///< slaves monitored by node guarding
  std::size_t commands = 128;  ///< waiting NMT commands
  std::size_t own_routes = 0;  ///< CAN-IDs for other services of the application
};

/// The node of an NMT master. A lost heartbeat (1016h) is an error of the master's own node as
/// well, and takes it out of operational unless 1029h forbids that.
template <const auto& layout, MasterSize size = MasterSize{}>
class MasterNode {
 public:
  /// Makes the master. Hooks and guarding of `settings` may be empty; guarding is done here if
  /// there is room for it.
  MasterNode(const Port& port, NodeId node_id, const BootManager::Settings& settings = {})
      : device_(port, node_id),
        nmt_master_(device_.node(), remote_nodes_),
        commands_(device_.node(), command_memory_),
        guarding_(device_.node(), std::span<NodeGuardingMaster::Slot>(guarding_slots_)),
        slots_(make_slots(std::make_index_sequence<size.slots>{})),
        boot_manager_(device_.node(), nmt_master_, commands_, {records_, slots_},
                      with_guarding(settings)),
        requests_(device_.node(), nmt_master_, commands_, boot_manager_,
                  with_guarding(settings).guarding) {
    guarding_.on_event(callback<&MasterNode::guarding_event>(*this));
  }
  MasterNode(const MasterNode&) = delete;
  MasterNode& operator=(const MasterNode&) = delete;

  /// The master's own node: frames and points in time are handed to it.
  Node& node() { return device_.node(); }
  /// Object dictionary of the master.
  Dictionary& dictionary() { return device_.dictionary(); }
  /// The DeviceNode within, for the other services.
  auto& device() { return device_; }
  /// States of all nodes; its commands bypass the inhibit time.
  NmtMaster& nmt_master() { return nmt_master_; }
  /// NMT commands in order, with the inhibit time (102Ah) between two.
  NmtQueue& commands() { return commands_; }
  /// Boots the network; for callbacks and states.
  BootManager& boot_manager() { return boot_manager_; }

 private:
  static constexpr std::size_t routes = node_id_max + size.slots + size.guarded + size.own_routes;
  /// All slots may send at once, and also NMT commands and the services of the device.
  static constexpr std::size_t backlog = size.slots + 16;

  template <std::size_t... numbers>
  std::array<BootSlave, size.slots> make_slots(std::index_sequence<numbers...>) {
    return {((void)numbers, BootSlave(device_.node()))...};
  }
  BootManager::Settings with_guarding(BootManager::Settings settings) {
    if (size.guarded == 0 || settings.guarding.start) return settings;
    settings.guarding = {callback<&NodeGuardingMaster::guard>(guarding_),
                         callback<&NodeGuardingMaster::release>(guarding_),
                         {[](void* guarding, NodeId slave) {
                            return static_cast<NodeGuardingMaster*>(guarding)->guards(slave);
                          },
                          &guarding_}};
    return settings;
  }
  void guarding_event(NodeId slave, NodeGuardingEvent event, bool occurs) {
    if (occurs && event == NodeGuardingEvent::time_out) boot_manager_.guarding_lost(slave);
  }

  std::array<NmtMaster::RemoteNode, node_id_max> remote_nodes_;
  std::array<NmtQueue::Request, size.commands> command_memory_{};
  std::array<NodeGuardingMaster::Slot, size.guarded> guarding_slots_;
  std::array<BootManager::Record, node_id_max> records_{};

  DeviceNode<layout, routes, true, backlog> device_;
  NmtMaster nmt_master_;
  NmtQueue commands_;
  NodeGuardingMaster guarding_;
  std::array<BootSlave, size.slots> slots_;
  BootManager boot_manager_;
  NmtRequests requests_;
};

}  // namespace canvoy
