#include "canvoy/canopen/nmt/node_guarding_slave.hpp"

#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/canopen/nmt/error_control_id.hpp"

namespace canvoy {

namespace {

constexpr Error life_guarding_error{.code = emergency_code::heartbeat,
                                    .register_bits = error_register::communication};

}  // namespace

constexpr AccessHandlers NodeGuardingSlave::hook_calls[] = {
    {.first = object_index::guard_time,
     .last = object_index::life_time_factor,
     .after_write = method<&NodeGuardingSlave::parameter_written>},
    {.first = object_index::heartbeat_producer,
     .last = object_index::heartbeat_producer,
     .after_write = method<&NodeGuardingSlave::parameter_written>}};
constexpr ServiceHandlers NodeGuardingSlave::service_calls = {
    .reset = method<&NodeGuardingSlave::reset>, .hooks = hook_calls};

NodeGuardingSlave::NodeGuardingSlave(Node& node)
    : node_(node), timer_(callback<&NodeGuardingSlave::expired>(*this)) {
  node_.attach(service_);
}

void NodeGuardingSlave::reset(ResetScope) {
  const auto receiver = Router::Receiver::to<&NodeGuardingSlave::requested>(*this);
  if (can_id_ != 0) node_.router().remove(can_id_, receiver, Router::Kind::remote);
  can_id_ = is_node_id(node_.id()) ? error_control_id(node_.id()) : std::uint16_t{0};
  if (can_id_ != 0) node_.router().add(can_id_, receiver, Router::Kind::remote);
  toggle_ = false;
  watching_ = false;
  watch();
  resolve();
}

void NodeGuardingSlave::parameter_written(const Entry&, Source) {
  if (has_heartbeat()) watching_ = toggle_ = false;
  if (!lost_) return watch();
  if (!watching_ || life_time() == Duration::zero()) resolve();
}

void NodeGuardingSlave::requested(const Frame&, Time) {
  if (node_.state() == NmtState::initialisation || has_heartbeat()) return;
  const unsigned state =
      static_cast<unsigned>(node_.state()) | (toggle_ ? guarding_toggle_bit : 0U);
  node_.transmitter().send(Frame::data_frame(can_id_, {static_cast<std::uint8_t>(state)}));
  toggle_ = !toggle_;
  watching_ = true;
  watch();
  resolve();
}

/// Restarts the life time, if there is one.
void NodeGuardingSlave::watch() {
  const Duration time = life_time();
  const bool watched = watching_ && time != Duration::zero();
  node_.timers().arm(timer_, watched ? node_.now() + time : never);
}

void NodeGuardingSlave::expired(Time) {
  lost_ = true;
  node_.raise(life_guarding_error);
}

void NodeGuardingSlave::resolve() {
  if (!lost_) return;
  lost_ = false;
  node_.clear(life_guarding_error);
}

bool NodeGuardingSlave::has_heartbeat() const {
  return node_.dictionary().number(object_index::heartbeat_producer, 0) != 0;
}

Duration NodeGuardingSlave::life_time() const {
  const Dictionary& dictionary = node_.dictionary();
  return std::chrono::milliseconds(dictionary.number(object_index::guard_time, 0) *
                                   dictionary.number(object_index::life_time_factor, 0));
}

}  // namespace canvoy
