// The NMT master of CiA 302-2: boots a network by 1F80h to 1F89h, watches over it, and boots again
// what was lost or restarted.
//
// All slaves come up at once, as far as there are slots; the others wait for their turn. Each step
// of each slave is reported. Memory belongs to the owner: MasterNode lays all of it out.
//
//     BootManager manager(node, master, commands, {records, slots}, {.hooks = hooks});
//     manager.on_report(Callback<void(const BootReport&)>::to<&App::slave_is_booted>(app));
//     node.start(now);  // the boot-up of the network begins where 1F80h makes the node its master
#pragma once

#include <cstdint>
#include <span>

#include "canvoy/canopen/manager/slave_boots.hpp"

namespace canvoy {

/// It takes on_message() and on_change() of the NmtMaster and on_sent() of the NmtQueue for itself.
///
/// It begins when the node enters pre-operational after each reset, where 1F80h says that it is the
/// NMT master; a flying master (1F80h bit 5) begins when it is told that it won. While the node is
/// stopped, boots rest.
///
/// A slave that does not answer (B, or a time-out in a later step) is booted again a second later:
/// an optional one for ever, a mandatory one until its boot time (1F89h) is over. All other errors
/// are final. Whatever failed is booted anew when it sends a boot-up message, or is heard again
/// after it did not answer.
///
/// A slave that restarts without being told is booted anew at once three times; where it does not
/// leave off for half a minute, after 1, 2, 4 and 8 s, and then it is given up (J, where it was
/// being configured, or else B). Each further boot-up message is worth one attempt, 8 s later.
class BootManager {
 public:
  using SlaveState = SlaveBoots::State;
  using Record = SlaveBoots::Record;
  using Memory = SlaveBoots::Memory;
  struct Settings {
    BootHooks hooks = {};
    GuardingHooks guarding = {};
    BootOptions options = {};
  };

  /// All of it must outlive the manager. With room for fewer frames in the backlog of the node and
  /// its controller than there are slots, requests may be lost, and are repeated later.
  BootManager(Node& node, NmtMaster& master, NmtQueue& commands, const Memory& memory,
              const Settings& settings);
  BootManager(const BootManager&) = delete;
  BootManager& operator=(const BootManager&) = delete;

  /// In place of those of the settings; before the node is started.
  void use(const BootHooks& hooks) { context_.hooks = hooks; }

  /// Each step of each slave, and what happens to it afterwards.
  void on_report(Callback<void(const BootReport&)> report) { told_ = report; }
  void on_network(Callback<void(NetworkBoot)> changed) { network_changed_ = changed; }

  /// A flying master has won: begins as the only one does by itself.
  void become_master();
  /// It has lost: leaves everything as it is.
  void retire();
  bool is_active() const { return network_ != NetworkBoot::idle; }

  /// Node guarding found a slave silent.
  void guarding_lost(NodeId slave) { slaves_.lost(slave); }

  NetworkBoot network() const { return network_; }
  SlaveState slave_state(NodeId slave) const { return slaves_.record(slave).state; }
  /// Why it is not up, or the last error that it met; L where it was not touched.
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
  static const ServiceCalls service_calls;
  static const HookCalls hook_calls[1];
  ServiceLink service_{&service_calls, this};
  NetworkBoot network_ = NetworkBoot::idle;
  bool was_reset_ = false;  ///< and has not begun yet
};

}  // namespace canvoy
