#include "canvoy/canopen/nmt/heartbeat_consumer.hpp"

#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/canopen/nmt/error_control_id.hpp"

namespace canvoy {

namespace {

/// An entry of 1016h.
struct ConsumerTime {
  NodeId node_id;
  Duration time;

  explicit ConsumerTime(std::uint64_t value)
      : node_id(static_cast<NodeId>(value >> 16)),
        time(std::chrono::milliseconds(static_cast<std::uint16_t>(value))) {}
  bool used() const { return is_node_id(node_id) && time != Duration::zero(); }
};

Error loss_of(NodeId node_id) {
  return {.code = emergency_code::heartbeat,
          .instance = node_id,
          .register_bits = error_register::communication};
}

}  // namespace

constexpr AccessHandlers HeartbeatConsumer::hook_calls = {
    .first = object_index::heartbeat_consumers,
    .last = object_index::heartbeat_consumers,
    .before_write = method<&HeartbeatConsumer::check>,
    .after_write = method<&HeartbeatConsumer::written>};
constexpr ServiceHandlers HeartbeatConsumer::service_calls = {
    .reset = method<&HeartbeatConsumer::reset>, .hooks = {&hook_calls, 1}};

HeartbeatConsumer::HeartbeatConsumer(Node& node, std::span<Slot> slots, Start start)
    : node_(node), slots_(slots), start_(start) {
  for (Slot& slot : slots_) slot.consumer_ = this;
  node_.attach(service_);
}

RemoteState HeartbeatConsumer::state(NodeId node_id) const {
  for (const Slot& slot : slots_) {
    if (slot.node_id_ == node_id) return slot.state_;
  }
  return RemoteState::unknown;
}

void HeartbeatConsumer::reset(ResetScope) {
  for (std::size_t position = 0; position < slots_.size(); ++position) {
    release(slots_[position]);
    configure(position);
  }
}

AbortCode HeartbeatConsumer::check(const Entry& entry, std::span<const std::uint8_t> value) {
  const ConsumerTime wanted(load_unsigned(value));
  if (entry.sub == 0 || !wanted.used()) return AbortCode::none;
  if (entry.sub > slots_.size()) return AbortCode::out_of_memory;
  const Dictionary& dictionary = node_.dictionary();
  const auto count = static_cast<unsigned>(dictionary.number(object_index::heartbeat_consumers, 0));
  for (unsigned sub = 1; sub <= count; ++sub) {
    const ConsumerTime other(
        dictionary.number(object_index::heartbeat_consumers, static_cast<std::uint8_t>(sub)));
    if (sub != entry.sub && other.used() && other.node_id == wanted.node_id) {
      return AbortCode::parameter_incompatible;
    }
  }
  return AbortCode::none;
}

void HeartbeatConsumer::written(const Entry& entry, Source) {
  if (entry.sub >= 1 && entry.sub <= slots_.size()) configure(entry.sub - std::size_t{1});
}

void HeartbeatConsumer::configure(std::size_t position) {
  Slot& slot = slots_[position];
  const ConsumerTime wanted(node_.dictionary().number(object_index::heartbeat_consumers,
                                                      static_cast<std::uint8_t>(position + 1)));
  // A new time does not change the node's state.
  const bool goes_on = wanted.used() && wanted.node_id == slot.node_id_;
  if (goes_on) {
    slot.time_ = wanted.time;
    if (slot.timer_.armed()) node_.timers().arm(slot.timer_, node_.now() + slot.time_);
    return;
  }
  release(slot);
  if (!wanted.used()) return;
  slot.node_id_ = wanted.node_id;
  slot.time_ = wanted.time;
  node_.router().add(error_control_id(slot.node_id_), slot.receiver());
  if (start_ == Start::configuration) node_.timers().arm(slot.timer_, node_.now() + slot.time_);
}

void HeartbeatConsumer::release(Slot& slot) {
  if (slot.node_id_ == 0) return;
  node_.router().remove(error_control_id(slot.node_id_), slot.receiver());
  node_.timers().disarm(slot.timer_);
  const bool was_lost = slot.state_ == RemoteState::lost;
  const NodeId node_id = slot.node_id_;
  slot.node_id_ = 0;
  slot.state_ = RemoteState::unknown;
  if (was_lost) node_.clear(loss_of(node_id));
}

void HeartbeatConsumer::received(Slot& slot, const Frame& frame, Time now) {
  const RemoteState state = frame.length == 1 ? remote_state(frame.data[0]) : RemoteState::unknown;
  if (state == RemoteState::unknown) return node_.count_malformed();
  const bool supervised = slot.timer_.armed() || slot.state_ == RemoteState::lost;
  if (supervised || state != RemoteState::boot_up) {
    node_.timers().arm(slot.timer_, now + slot.time_);
  }
  enter(slot, state);
}

void HeartbeatConsumer::enter(Slot& slot, RemoteState state) {
  const RemoteState previous = slot.state_;
  if (state == previous && state != RemoteState::boot_up) return;
  slot.state_ = state;
  const NodeId node_id = slot.node_id_;
  if (state == RemoteState::lost) node_.raise(loss_of(node_id));
  if (previous == RemoteState::lost) node_.clear(loss_of(node_id));
  changed_(node_id, state);
}

}  // namespace canvoy
