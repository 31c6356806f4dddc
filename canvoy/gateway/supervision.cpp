#include "canvoy/gateway/supervision.hpp"

#include <utility>

#include "canvoy/canopen/dictionary/object_index.hpp"

namespace canvoy::gateway {

namespace {

/// After a reset a node waits in pre-operational.
constexpr NmtState state_after(NmtCommand command) {
  switch (command) {
    case NmtCommand::start:
      return NmtState::operational;
    case NmtCommand::stop:
      return NmtState::stopped;
    case NmtCommand::enter_pre_operational:
    case NmtCommand::reset_node:
    case NmtCommand::reset_communication:
      break;
  }
  return NmtState::pre_operational;
}

}  // namespace

Supervision::Supervision(GatewayDevice& device, Report report)
    : device_(device), report_(std::move(report)), guarding_(device.node(), slots_) {
  device_.heartbeat_consumer().on_change(
      Callback<void(NodeId, RemoteState)>::to<&Supervision::heartbeat_changed>(*this));
  guarding_.on_event(
      Callback<void(NodeId, NodeGuardingEvent, bool)>::to<&Supervision::guarding_event>(*this));
}

Answer Supervision::watch_heartbeat(std::uint32_t node, Duration time) {
  if (!is_node_id(node)) return Answer::failed(ErrorCode::unknown_node);
  heard_[node] = false;
  // A node that is already monitored is reported again: its earlier state is discarded first.
  set_time(node, Duration::zero());
  const AbortCode refused = set_time(node, time);
  return refused == AbortCode::none ? Answer::ok() : Answer::failed(refused);
}

AbortCode Supervision::set_time(std::uint32_t node, Duration time) {
  std::array<std::uint8_t, 4> value{};
  store(value.data(), static_cast<std::uint32_t>(node << 16 | time / 1ms));
  return device_.dictionary().write(object_index::heartbeat_consumers,
                                    static_cast<std::uint8_t>(node), value, Source::application);
}

Answer Supervision::guard(std::uint32_t node, Duration guard_time, std::uint8_t life_time_factor) {
  const auto id = static_cast<NodeId>(node);
  if (!is_node_id(node) || id == device_.node().id()) {
    return Answer::failed(ErrorCode::unknown_node);
  }
  if (guard_time == Duration::zero() || life_time_factor == 0) {
    guarding_.release(id);
    return Answer::ok();
  }
  const bool guarded = guarding_.guard(id, guard_time, life_time_factor);
  return guarded ? Answer::ok() : Answer::failed(ErrorCode::internal_state);
}

void Supervision::commanded(NodeId node, NmtCommand command) {
  const NodeId first = node == 0 ? node_id_min : node;
  const NodeId last = node == 0 ? node_id_max : node;
  for (unsigned id = first; id <= last; ++id) {
    guarding_.expect(static_cast<NodeId>(id), state_after(command));
  }
}

void Supervision::heartbeat_changed(NodeId node, RemoteState state) {
  if (state == RemoteState::boot_up) return;
  const bool comes = state != RemoteState::lost;
  if (comes && !heard_[node]) report_(node, ErrorCode::heartbeat_started);
  if (!comes) report_(node, ErrorCode::heartbeat_lost);
  heard_[node] = comes;
}

void Supervision::guarding_event(NodeId node, NodeGuardingEvent event, bool occurs) {
  if (!occurs) return;
  report_(node, event == NodeGuardingEvent::time_out ? ErrorCode::guarding_lost
                                                     : ErrorCode::wrong_nmt_state);
}

}  // namespace canvoy::gateway
