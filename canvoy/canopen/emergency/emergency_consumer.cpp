#include "canvoy/canopen/emergency/emergency_consumer.hpp"

#include <algorithm>

#include "canvoy/canopen/dictionary/object_index.hpp"

namespace canvoy {

constexpr AccessHandlers EmergencyConsumer::hook_calls = {
    .first = object_index::emergency_consumers,
    .last = object_index::emergency_consumers,
    .before_write = method<&EmergencyConsumer::check>,
    .after_write = method<&EmergencyConsumer::written>};
constexpr ServiceHandlers EmergencyConsumer::service_calls = {
    .reset = method<&EmergencyConsumer::reset>, .hooks = {&hook_calls, 1}};

EmergencyConsumer::EmergencyConsumer(Node& node, std::span<Slot> slots)
    : node_(node), slots_(slots) {
  for (Slot& slot : slots_) slot.consumer_ = this;
  node_.attach(service_);
}

bool EmergencyConsumer::listen(NodeId node_id, std::uint16_t can_id) {
  if (!is_node_id(node_id) || can_id > Frame::id_max) return false;
  ignore(node_id);
  return hear(node_id, can_id, true);
}

void EmergencyConsumer::ignore(NodeId node_id) {
  release(node_id, true);
}

void EmergencyConsumer::reset(ResetScope) {
  for (NodeId node_id = node_id_min; node_id <= node_id_max; ++node_id) configure(node_id);
}

AbortCode EmergencyConsumer::check(const Entry& entry, std::span<const std::uint8_t> value) {
  const CobId present{static_cast<std::uint32_t>(load_unsigned(entry.bytes()))};
  const CobId wanted{static_cast<std::uint32_t>(load_unsigned(value))};
  const AbortCode answer = check_emergency_cob_id(present, wanted);
  if (answer != AbortCode::none || !wanted.valid() || present.valid()) return answer;
  const bool has_room = std::ranges::any_of(slots_, [](const Slot& s) { return s.node_id_ == 0; });
  return has_room ? AbortCode::none : AbortCode::out_of_memory;
}

void EmergencyConsumer::written(const Entry& entry, Source) {
  if (is_node_id(entry.sub)) configure(entry.sub);
}

void EmergencyConsumer::configure(NodeId node_id) {
  release(node_id, false);
  const Result<Entry> entry = node_.dictionary().find(object_index::emergency_consumers, node_id);
  if (!entry) return;
  const CobId cob_id{static_cast<std::uint32_t>(load_unsigned(entry->bytes()))};
  if (cob_id.valid() && cob_id.is_base_frame() && !is_restricted(cob_id.can_id())) {
    hear(node_id, static_cast<std::uint16_t>(cob_id.can_id()), false);
  }
}

bool EmergencyConsumer::hear(NodeId node_id, std::uint16_t can_id, bool by_application) {
  const auto free = std::ranges::find(slots_, NodeId{0}, &Slot::node_id_);
  if (free == slots_.end() || !node_.router().add(can_id, free->receiver())) return false;
  free->node_id_ = node_id;
  free->can_id_ = can_id;
  free->by_application_ = by_application;
  return true;
}

void EmergencyConsumer::release(NodeId node_id, bool by_application) {
  for (Slot& slot : slots_) {
    if (slot.node_id_ != node_id || slot.by_application_ != by_application) continue;
    node_.router().remove(slot.can_id_, slot.receiver());
    slot.node_id_ = 0;
  }
}

void EmergencyConsumer::received(const Slot& slot, const Frame& frame) {
  if (node_.state() != NmtState::pre_operational && node_.state() != NmtState::operational) return;
  if (frame.length != Emergency::length) return node_.count_malformed();
  heard_(slot.node_id_, decode_emergency(frame));
}

}  // namespace canvoy
