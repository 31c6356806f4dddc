// The NMT master: boots a network by 1F80h to 1F89h, monitors it, and boots lost or restarted nodes
// again (CiA 302-2).
//
// All slaves are booted at once, as far as there are slots; the others wait for their turn. Each
// step of each slave is reported. Memory belongs to the owner: MasterNode contains all of it.
//
//     BootManager manager(node, master, commands, {records, slots}, {.hooks = hooks});
//     manager.on_report(Callback<void(const BootReport&)>::to<&App::slave_is_booted>(app));
//     node.start(now);  // the boot-up of the network begins where 1F80h makes the node its master
#pragma once

#include <cstdint>
#include <span>

#include "canvoy/canopen/manager/slave_boots.hpp"

namespace canvoy {

/// The manager uses on_message() and on_change() of the NmtMaster and on_sent() of the NmtQueue
/// itself.
///
/// It begins when the node enters pre-operational after each reset, if 1F80h makes it the NMT
/// master; a flying master (1F80h bit 5) begins with become_master(). While the node is stopped,
/// boots pause.
///
/// A slave that does not answer (B, or a time-out in a later step) is booted again a second later:
/// an optional one without limit, a mandatory one until its boot time (1F89h) is over. All other
/// errors are final. Any slave that failed is booted again when it sends a boot-up message, or when
/// a slave that did not answer is heard again.
///
/// A slave that restarts without a command is booted again at once three times; unless it runs for
/// half a minute, after 1, 2, 4 and 8 s, and then no more (J if it was being configured, otherwise
/// B). Each further boot-up message leads to one attempt, 8 s later.
class BootManager {
 public:
  /// State of one slave: waiting, booting, booted, failed, or none if it is not assigned.
  using SlaveState = SlaveBoots::State;
  /// State of one slave, in memory of the owner.
  using Record = SlaveBoots::Record;
  /// 127 records, and as many slots as slaves are to be booted at once.
  using Memory = SlaveBoots::Memory;
  /// Parts that other services add, and times.
  struct Settings {
    BootHooks hooks = {};         ///< software and configuration of slaves
    GuardingHooks guarding = {};  ///< node guarding of slaves
    BootOptions options = {};     ///< times and resets
  };

  /// Makes the manager. All arguments must outlive it. If the backlog of the node and its
  /// controller have room for fewer frames than there are slots, requests may be lost, and are
  /// repeated later.
  BootManager(Node& node, NmtMaster& master, NmtQueue& commands, const Memory& memory,
              const Settings& settings);
  BootManager(const BootManager&) = delete;
  BootManager& operator=(const BootManager&) = delete;

  /// Replaces the hooks of the settings; to be called before the node is started.
  void use(const BootHooks& hooks) { context_.hooks = hooks; }

  /// Sets the callback for each step of each slave, and for later events.
  void on_report(Callback<void(const BootReport&)> report) { told_ = report; }
  /// Sets the callback for each change of network().
  void on_network(Callback<void(NetworkBoot)> changed) { network_changed_ = changed; }

  /// Begins as NMT master; called for a flying master that has won.
  void become_master();
  /// Ends the work as NMT master without changing any node; called for a flying master that has
  /// lost.
  void retire();
  /// True while this node is the active NMT master.
  bool is_active() const { return network_ != NetworkBoot::idle; }

  /// Notes that a slave is silent by node guarding.
  void guarding_lost(NodeId slave) { slaves_.lost(slave); }

  /// State of the network as a whole; idle while this node is not the master.
  NetworkBoot network() const { return network_; }
  /// State of a slave, 1 to 127.
  SlaveState slave_state(NodeId slave) const { return slaves_.record(slave).state; }
  /// Reason why a slave did not boot, or its last error; L if it was left as it was.
  BootError slave_error(NodeId slave) const { return slaves_.record(slave).error; }

 private:
  void reset(ResetScope scope);
  void state_entered(NmtState state);
  AbortCode check(const Entry& entry, std::span<const std::uint8_t> value);
  void written(const Entry& entry, Source source);

  void check_network();
  bool is_waited_for(const Record& record, SlaveAssignment slave) const;
  void complete();
  void booted(NodeId slave);
  void set_network(NetworkBoot network);
  void command_sent(const NmtQueue::Request& request);
  void report(const BootReport& report) { told_(report); }

  SlaveAssignment assignment(NodeId slave) const {
    return slave_assignment(node_.dictionary(), slave);
  }
  NmtStartup startup() const { return nmt_startup(node_.dictionary()); }

  Node& node_;
  BootContext context_;
  SlaveBoots slaves_;
  Callback<void(const BootReport&)> told_;
  Callback<void(NetworkBoot)> network_changed_;
  static const ServiceHandlers service_calls;
  static const AccessHandlers hook_calls[1];
  HandlerBinding service_{&service_calls, this};
  NetworkBoot network_ = NetworkBoot::idle;
  bool was_reset_ = false;  ///< has not begun since a reset
};

}  // namespace canvoy
