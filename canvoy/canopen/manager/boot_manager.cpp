#include "canvoy/canopen/manager/boot_manager.hpp"

#include <utility>

namespace canvoy {

constexpr HookCalls BootManager::hook_calls[] = {{.first = master_object::nmt_startup,
                                                  .last = master_object::slave_assignment,
                                                  .before_write = method<&BootManager::check>,
                                                  .after_write = method<&BootManager::written>}};
constexpr ServiceCalls BootManager::service_calls = {
    .reset = method<&BootManager::reset>,
    .state_entered = method<&BootManager::state_entered>,
    .hooks = hook_calls};

BootManager::BootManager(Node& node, NmtMaster& master, NmtQueue& commands, const Memory& memory,
                         const Settings& settings)
    : node_(node),
      context_{node,
               master,
               commands,
               settings.hooks,
               settings.guarding,
               settings.options,
               Callback<void(const BootReport&)>::to<&BootManager::report>(*this)},
      memory_(memory),
      timer_(Callback<void(Time)>::to<&BootManager::run_due>(*this)) {
  for (BootSlave& slot : memory_.slots) {
    slot.prepare(context_, BootSlave::Finished::to<&BootManager::finished>(*this));
  }
  master.on_message(Callback<void(NodeId, RemoteState)>::to<&BootManager::heard>(*this));
  master.on_change(Callback<void(NodeId, RemoteState)>::to<&BootManager::changed>(*this));
  commands.on_sent(Callback<void(const NmtQueue::Request&)>::to<&BootManager::command_sent>(*this));
  node_.attach(service_);
}

void BootManager::reset(ResetScope) {
  retire();
  was_reset_ = true;
}

void BootManager::state_entered(NmtState state) {
  if (state == NmtState::initialisation) return;
  if (state == NmtState::stopped) return rest();
  if (std::exchange(was_reset_, false)) {
    const NmtStartup wanted = startup();
    if (wanted.is_master() && !wanted.is_flying_master()) become_master();
    if (wanted.is_self_starting()) context_.commands.add({node_.id(), NmtCommand::start});
  }
  if (is_active()) node_.timers().arm(timer_, node_.now());
}

/// 1F80h: what is not known here cannot be switched on.
AbortCode BootManager::check(const Entry& entry, std::span<const std::uint8_t> value) {
  if (entry.index != master_object::nmt_startup) return AbortCode::none;
  const bool known = (load_unsigned(value) & ~std::uint64_t{NmtStartup::known_bits}) == 0;
  return known ? AbortCode::none : AbortCode::value_range;
}

/// A slave that is named while the network runs is booted, one that is no longer named is left
/// alone.
void BootManager::written(const Entry& entry, Source) {
  if (entry.index != master_object::slave_assignment || !is_active()) return;
  if (!is_node_id(entry.sub) || entry.sub == node_.id()) return;
  const bool is_slave = assignment(entry.sub).is_slave();
  if (!is_slave) forget(entry.sub);
  if (is_slave && record(entry.sub).state == SlaveState::none) queue(entry.sub, node_.now());
  check_network();
}

void BootManager::become_master() {
  if (is_active()) return;
  for (NodeId slave = node_id_min; slave <= node_id_max; ++slave) {
    record(slave) = {};
    if (slave == node_.id() || !assignment(slave).is_slave()) continue;
    record(slave) = {.due = node_.now(), .since = node_.now(), .state = SlaveState::waiting};
  }
  set_network(NetworkBoot::booting);
  if (!is_active()) return;  // whoever was told had it retire
  if (context_.options.resets_slaves) reset_slaves();
  node_.timers().arm(timer_, node_.now());
  check_network();
}

/// All by one command, unless one of them is to be kept alive. What was reset waits for its boot-up
/// message from when the command is sent: see command_sent().
void BootManager::reset_slaves() {
  bool keeps_some = false;
  for (NodeId slave = node_id_min; slave <= node_id_max; ++slave) {
    const bool is_slave = record(slave).state != SlaveState::none;
    keeps_some = keeps_some || (is_slave && assignment(slave).is_kept_alive());
  }
  const bool resets_all =
      !keeps_some &&
      context_.commands.add({NmtQueue::all_nodes, NmtCommand::reset_communication, true});
  for (NodeId slave = node_id_min; slave <= node_id_max; ++slave) {
    if (record(slave).state == SlaveState::none || assignment(slave).is_kept_alive()) continue;
    const bool is_reset =
        resets_all || context_.commands.add({slave, NmtCommand::reset_communication});
    if (is_reset) record(slave).due = never;
  }
}

void BootManager::command_sent(const NmtQueue::Request& request) {
  if (!is_active()) return;
  const bool is_reset = request.command == NmtCommand::reset_communication ||
                        request.command == NmtCommand::reset_node;
  if (!is_reset) return;
  const Time due = node_.now() + context_.options.boot_up_time_out;
  for (NodeId slave = node_id_min; slave <= node_id_max; ++slave) {
    if (request.node != slave && request.node != NmtQueue::all_nodes) continue;
    if (BootSlave* slot = find_slot(slave); slot != nullptr) slot->reset_sent();
    Record& waiting = record(slave);
    if (waiting.state == SlaveState::waiting && waiting.due == never) queue(slave, due);
  }
}

void BootManager::retire() {
  rest();
  node_.timers().disarm(timer_);
  for (NodeId slave = node_id_min; slave <= node_id_max; ++slave) forget(slave);
  network_ = NetworkBoot::idle;
}

/// What is under way begins anew when the node leaves NMT state stopped.
void BootManager::rest() {
  for (BootSlave& slot : memory_.slots) {
    if (!slot.busy()) continue;
    const NodeId slave = slot.slave();
    slot.abandon();
    queue(slave, node_.now());
  }
}

/// By one command for all, all have had their chance before it is given: it must not hit a slave in
/// the middle of its configuration.
bool BootManager::is_waited_for(const Record& record, SlaveAssignment slave) const {
  if (record.state == SlaveState::none || record.state == SlaveState::booted) return false;
  return slave.is_mandatory() || (startup().starts_all_at_once() && !record.was_tried);
}

void BootManager::check_network() {
  if (!is_active() || network_ == NetworkBoot::complete) return;
  NetworkBoot next = NetworkBoot::complete;
  for (NodeId slave = node_id_min; slave <= node_id_max; ++slave) {
    const SlaveAssignment assigned = assignment(slave);
    if (!is_waited_for(record(slave), assigned)) continue;
    const bool has_failed = record(slave).state == SlaveState::failed && assigned.is_mandatory();
    if (has_failed) return set_network(NetworkBoot::failed);
    next = NetworkBoot::booting;
  }
  if (next == NetworkBoot::complete) return complete();
  set_network(next);
}

void BootManager::complete() {
  set_network(NetworkBoot::complete);
  if (!is_active()) return;  // whoever was told had it retire
  const NmtStartup wanted = startup();
  if (wanted.enters_operational()) context_.commands.add({node_.id(), NmtCommand::start});
  if (!wanted.starts_slaves() || !wanted.starts_all_at_once()) return;
  context_.commands.add({NmtQueue::all_nodes, NmtCommand::start, true});
  for (NodeId slave = node_id_min; slave <= node_id_max; ++slave) {
    Record& booted = record(slave);
    if (booted.state != SlaveState::booted || booted.is_started) continue;
    booted.is_started = true;
    report({.slave = slave, .event = BootEvent::started, .step = BootStep::done});
  }
}

void BootManager::set_network(NetworkBoot network) {
  if (network == network_) return;
  network_ = network;
  network_changed_(network);
}

}  // namespace canvoy
