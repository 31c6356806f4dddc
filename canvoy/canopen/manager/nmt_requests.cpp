#include "canvoy/canopen/manager/nmt_requests.hpp"

#include <optional>

namespace canvoy {

namespace {

std::optional<NmtCommand> command_of(std::uint8_t value) {
  switch (static_cast<NmtRequests::Value>(value)) {
    case NmtRequests::Value::stopped:
      return NmtCommand::stop;
    case NmtRequests::Value::operational:
      return NmtCommand::start;
    case NmtRequests::Value::reset_node:
      return NmtCommand::reset_node;
    case NmtRequests::Value::reset_communication:
      return NmtCommand::reset_communication;
    case NmtRequests::Value::pre_operational:
      return NmtCommand::enter_pre_operational;
    default:
      return std::nullopt;
  }
}

}  // namespace

constexpr AccessHandlers NmtRequests::hook_calls[] = {
    {.first = master_object::request_nmt,
     .last = master_object::request_guarding,
     .before_read = method<&NmtRequests::refresh>,
     .before_write = method<&NmtRequests::request>}};
constexpr ServiceHandlers NmtRequests::service_calls = {.hooks = hook_calls};

NmtRequests::NmtRequests(Node& node, const NmtMaster& master, NmtQueue& commands,
                         const BootManager& manager, const GuardingHooks& guarding)
    : node_(node), master_(master), commands_(commands), manager_(manager), guarding_(guarding) {
  node_.attach(service_);
}

AbortCode NmtRequests::refresh(const Entry& entry) {
  if (!is_node_id(entry.sub)) return AbortCode::none;
  const bool is_guarding = entry.index == master_object::request_guarding;
  const auto value = is_guarding ? static_cast<std::uint8_t>(guarding_.is_guarded(entry.sub))
                                 : static_cast<std::uint8_t>(state_of(entry.sub));
  node_.dictionary().set(entry, std::span(&value, 1));
  return AbortCode::none;
}

/// A boot-up message is followed by pre-operational.
NmtRequests::Value NmtRequests::state_of(NodeId node_id) const {
  const RemoteState state = node_id == node_.id() ? static_cast<RemoteState>(node_.state())
                                                  : master_.remote(node_id).state();
  switch (state) {
    case RemoteState::unknown:
      return Value::unknown;
    case RemoteState::lost:
      return Value::missing;
    case RemoteState::boot_up:
      return Value::pre_operational;
    default:
      return static_cast<Value>(state);
  }
}

AbortCode NmtRequests::request(const Entry& entry, std::span<const std::uint8_t> value) {
  if (entry.sub == 0) return AbortCode::none;
  if (!manager_.is_active()) return AbortCode::device_state;
  return entry.index == master_object::request_nmt ? request_nmt(entry.sub, value[0])
                                                   : request_guarding(entry.sub, value[0]);
}

AbortCode NmtRequests::request_nmt(std::uint8_t sub, std::uint8_t value) {
  const std::optional<NmtCommand> command = command_of(value);
  if (!command) return AbortCode::value_range;
  const NodeId node_id = sub == all_nodes ? NmtQueue::all_nodes : sub;
  return commands_.add({node_id, *command}) ? AbortCode::none : AbortCode::out_of_memory;
}

AbortCode NmtRequests::request_guarding(std::uint8_t sub, std::uint8_t value) {
  if (value > 1) return AbortCode::value_range;
  if (sub != all_nodes) return guard(sub, value == 1);
  for (NodeId slave = node_id_min; slave <= node_id_max; ++slave) {
    const SlaveAssignment assigned = slave_assignment(node_.dictionary(), slave);
    const bool is_meant = assigned.is_slave() && assigned.guard_time() != Duration::zero();
    const AbortCode answer = is_meant ? guard(slave, value == 1) : AbortCode::none;
    if (answer != AbortCode::none) return answer;
  }
  return AbortCode::none;
}

/// Without a guard time in 1F81h, guarding cannot begin.
AbortCode NmtRequests::guard(NodeId slave, bool begins) {
  if (!begins) {
    guarding_.stop(slave);
    return AbortCode::none;
  }
  const SlaveAssignment assigned = slave_assignment(node_.dictionary(), slave);
  const bool has_begun = guarding_.start(slave, assigned.guard_time(), assigned.retry_factor());
  return has_begun ? AbortCode::none : AbortCode::device_state;
}

}  // namespace canvoy
