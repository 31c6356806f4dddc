#include "canvoy/canopen/manager/boot_manager.hpp"

#include <utility>

namespace canvoy {

constexpr AccessHandlers BootManager::hook_calls[] = {
    {.first = master_object::nmt_startup,
     .last = master_object::slave_assignment,
     .before_write = method<&BootManager::check>,
     .after_write = method<&BootManager::written>}};
constexpr ServiceHandlers BootManager::service_calls = {
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
               callback<&BootManager::report>(*this)},
      slaves_(context_, memory,
              {.booted = callback<&BootManager::booted>(*this),
               .changed = callback<&BootManager::check_network>(*this)}) {
  using Told = Callback<void(NodeId, RemoteState)>;
  master.on_message(Told::to<&SlaveBoots::heard>(slaves_));
  master.on_change(Told::to<&SlaveBoots::changed>(slaves_));
  commands.on_sent(callback<&BootManager::command_sent>(*this));
  node_.attach(service_);
}

void BootManager::reset(ResetScope) {
  retire();
  was_reset_ = true;
}

void BootManager::state_entered(NmtState state) {
  if (state == NmtState::initialisation) return;
  if (state == NmtState::stopped) return slaves_.rest();
  if (std::exchange(was_reset_, false)) {
    const NmtStartup wanted = startup();
    if (wanted.is_master() && !wanted.is_flying_master()) become_master();
    if (wanted.is_self_starting()) context_.commands.add({node_.id(), NmtCommand::start});
  }
  if (is_active()) slaves_.wake();
}

/// 1F80h: bits that are not supported cannot be set.
AbortCode BootManager::check(const Entry& entry, std::span<const std::uint8_t> value) {
  if (entry.index != master_object::nmt_startup) return AbortCode::none;
  const bool known = (load_unsigned(value) & ~std::uint64_t{NmtStartup::known_bits}) == 0;
  return known ? AbortCode::none : AbortCode::value_range;
}

/// A slave that is added while the network runs is booted; one that is removed is left alone.
void BootManager::written(const Entry& entry, Source) {
  if (entry.index != master_object::slave_assignment || !is_active()) return;
  if (!is_node_id(entry.sub) || entry.sub == node_.id()) return;
  slaves_.assign(entry.sub, assignment(entry.sub).is_slave());
  check_network();
}

void BootManager::become_master() {
  if (is_active()) return;
  slaves_.begin();
  set_network(NetworkBoot::booting);
  if (!is_active()) return;  // a callback may have retired it
  if (context_.options.resets_slaves) slaves_.reset_all();
  slaves_.wake();
  check_network();
}

void BootManager::command_sent(const NmtQueue::Request& request) {
  const bool is_reset = request.command == NmtCommand::reset_communication ||
                        request.command == NmtCommand::reset_node;
  if (is_active() && is_reset) slaves_.reset_sent(request.node);
}

void BootManager::retire() {
  slaves_.retire();
  network_ = NetworkBoot::idle;
}

/// If one command starts all, it waits until all have had their attempt: it must not reach a slave
/// during its configuration.
bool BootManager::is_waited_for(const Record& record, SlaveAssignment slave) const {
  if (record.state == SlaveState::none || record.state == SlaveState::booted) return false;
  return slave.is_mandatory() || (startup().starts_all_at_once() && !record.was_tried);
}

void BootManager::check_network() {
  if (!is_active() || network_ == NetworkBoot::complete) return;
  NetworkBoot next = NetworkBoot::complete;
  for (NodeId slave = node_id_min; slave <= node_id_max; ++slave) {
    const SlaveAssignment assigned = assignment(slave);
    if (!is_waited_for(slaves_.record(slave), assigned)) continue;
    const bool has_failed =
        slaves_.record(slave).state == SlaveState::failed && assigned.is_mandatory();
    if (has_failed) return set_network(NetworkBoot::failed);
    next = NetworkBoot::booting;
  }
  if (next == NetworkBoot::complete) return complete();
  set_network(next);
}

void BootManager::complete() {
  set_network(NetworkBoot::complete);
  if (!is_active()) return;  // a callback may have retired it
  const NmtStartup wanted = startup();
  if (wanted.enters_operational()) context_.commands.add({node_.id(), NmtCommand::start});
  if (!wanted.starts_slaves() || !wanted.starts_all_at_once()) return;
  slaves_.start_all();
}

/// If all are started at once, later ones are started one by one.
void BootManager::booted(NodeId slave) {
  const NmtStartup wanted = startup();
  const bool waits = wanted.starts_all_at_once() && network_ != NetworkBoot::complete;
  if (wanted.starts_slaves() && assignment(slave).is_booted() && !waits) slaves_.start(slave);
}

void BootManager::set_network(NetworkBoot network) {
  if (network == network_) return;
  network_ = network;
  network_changed_(network);
}

}  // namespace canvoy
