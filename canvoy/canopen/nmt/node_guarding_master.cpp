#include "canvoy/canopen/nmt/node_guarding_master.hpp"

#include <algorithm>

#include "canvoy/canopen/nmt/error_control_id.hpp"

namespace canvoy {

namespace {

constexpr Duration guard_time_max = 65'535ms;  // limit of 100Ch

}  // namespace

constexpr ServiceHandlers NodeGuardingMaster::service_calls = {
    .reset = method<&NodeGuardingMaster::reset>, .tx_ready = method<&NodeGuardingMaster::tx_ready>};

NodeGuardingMaster::NodeGuardingMaster(Node& node, std::span<Slot> slots)
    : node_(node), slots_(slots) {
  for (Slot& slot : slots_) slot.master_ = this;
  node_.attach(service_);
}

bool NodeGuardingMaster::guard(NodeId node_id, Duration guard_time, std::uint8_t life_time_factor) {
  const bool valid = is_node_id(node_id) && node_id != node_.id() &&
                     guard_time > Duration::zero() && guard_time <= guard_time_max;
  if (!valid || node_.state() == NmtState::initialisation) return false;
  release(node_id);
  Slot* slot = find(0);
  if (slot == nullptr || !node_.router().add(error_control_id(node_id), slot->receiver())) {
    return false;
  }
  slot->node_id_ = node_id;
  slot->guard_time_ = guard_time;
  slot->life_time_ = guard_time * life_time_factor;
  slot->heard_ = slot->due_ = node_.now();
  slot->state_ = slot->expected_ = RemoteState::unknown;
  slot->toggle_ = slot->stale_ = slot->timed_out_ = slot->mismatched_ = false;
  poll(*slot);
  return true;
}

void NodeGuardingMaster::release(NodeId node_id) {
  Slot* slot = is_node_id(node_id) ? find(node_id) : nullptr;
  if (slot == nullptr) return;
  node_.router().remove(error_control_id(node_id), slot->receiver());
  node_.timers().disarm(slot->timer_);
  slot->node_id_ = 0;
  slot->waits_ = false;
}

void NodeGuardingMaster::expect(NodeId node_id, NmtState state) {
  Slot* slot = is_node_id(node_id) ? find(node_id) : nullptr;
  if (slot == nullptr) return;
  slot->expected_ = static_cast<RemoteState>(state);
  slot->stale_ = true;
}

RemoteState NodeGuardingMaster::state(NodeId node_id) const {
  const Slot* slot = is_node_id(node_id) ? find(node_id) : nullptr;
  return slot == nullptr ? RemoteState::unknown : slot->state_;
}

NodeGuardingMaster::Slot* NodeGuardingMaster::find(NodeId node_id) const {
  const auto slot = std::ranges::find(slots_, node_id, &Slot::node_id_);
  return slot == slots_.end() ? nullptr : &*slot;
}

void NodeGuardingMaster::reset(ResetScope) {
  for (Slot& slot : slots_) release(slot.node_id_);
}

// Requests

void NodeGuardingMaster::poll(Slot& slot) {
  const Time now = node_.now();
  slot.due_ += slot.guard_time_;
  if (slot.due_ <= now) slot.due_ = now + slot.guard_time_;
  arm(slot);
  // Last, since the answer may come at once and release the slot.
  ask(slot);
}

/// If many nodes are asked at one time, requests without room wait for it.
void NodeGuardingMaster::ask(Slot& slot) {
  slot.waits_ = node_.transmitter().full();
  if (slot.waits_) return;
  slot.stale_ = false;
  node_.transmitter().send(Frame::remote_frame(error_control_id(slot.node_id_), 1));
}

void NodeGuardingMaster::tx_ready() {
  for (Slot& slot : slots_) {
    if (slot.waits_) ask(slot);
  }
}

/// Arms the timer for the next request, or for the end of the life time, whichever is earlier.
void NodeGuardingMaster::arm(Slot& slot) {
  const bool may_be_lost = slot.life_time_ != Duration::zero() && !slot.timed_out_;
  const Time end = may_be_lost ? slot.heard_ + slot.life_time_ : never;
  node_.timers().arm(slot.timer_, std::min(slot.due_, end));
}

void NodeGuardingMaster::expired(Slot& slot, Time now) {
  const NodeId node_id = slot.node_id_;
  if (now >= slot.due_) {
    poll(slot);
  } else {
    arm(slot);
  }
  const bool over = slot.life_time_ != Duration::zero() && now >= slot.heard_ + slot.life_time_;
  if (!over || slot.timed_out_ || slot.node_id_ != node_id) return;
  notify(slot, NodeGuardingEvent::time_out, slot.timed_out_, true);
  if (slot.node_id_ == node_id) enter(slot, RemoteState::lost);
  if (slot.node_id_ == node_id) arm(slot);
}

// Answers

void NodeGuardingMaster::received(Slot& slot, const Frame& frame, Time now) {
  const RemoteState state = frame.length == 1 ? remote_state(frame.data[0]) : RemoteState::unknown;
  const bool toggle = (frame.data[0] & guarding_toggle_bit) != 0;
  const bool boots = state == RemoteState::boot_up;
  if (state == RemoteState::unknown || (boots && toggle)) return node_.count_malformed();
  if (!boots && toggle != slot.toggle_) return;
  slot.toggle_ = !boots && !toggle;
  const NodeId node_id = slot.node_id_;
  slot.heard_ = now;
  notify(slot, NodeGuardingEvent::time_out, slot.timed_out_, false);
  if (slot.node_id_ == node_id) enter(slot, state);
  if (slot.node_id_ == node_id) compare(slot);
  if (slot.node_id_ == node_id) arm(slot);
}

void NodeGuardingMaster::enter(Slot& slot, RemoteState state) {
  if (state == slot.state_ && state != RemoteState::boot_up) return;
  slot.state_ = state;
  changed_(slot.node_id_, state);
}

void NodeGuardingMaster::compare(Slot& slot) {
  if (slot.expected_ == RemoteState::unknown || slot.stale_) return;
  const bool boots = slot.state_ == RemoteState::boot_up;
  const RemoteState entered = boots ? RemoteState::pre_operational : slot.state_;
  notify(slot, NodeGuardingEvent::state, slot.mismatched_, entered != slot.expected_);
}

void NodeGuardingMaster::notify(Slot& slot, NodeGuardingEvent event, bool& occurred, bool occurs) {
  if (occurred == occurs) return;
  occurred = occurs;
  event_(slot.node_id_, event, occurs);
}

}  // namespace canvoy
