#include "canvoy/devices/kit/gap_watch.hpp"

#include <algorithm>

namespace canvoy {

constexpr ServiceHandlers GapWatch::service_calls = {
    .reset = method<&GapWatch::reset>,
    .bus_state_changed = method<&GapWatch::bus_state_changed>,
    .error_changed = method<&GapWatch::error_changed>};

GapWatch::GapWatch(Node& node, Callback<void(NodeId)> ask, std::span<Rhythm> rhythms)
    : node_(node), ask_(ask), rhythms_(rhythms), timer_(callback<&GapWatch::expired>(*this)) {
  node.attach(service_);
}

void GapWatch::reset(ResetScope) {
  std::ranges::fill(rhythms_, Rhythm{});
  suspects_.reset();
  asked_at_ = never;
  node_.timers().disarm(timer_);
}

/// In error-passive or bus-off, further frames may be lost: the end of that state is the sign.
void GapWatch::bus_state_changed(BusState state) {
  if (is_error_active(state)) suspect(everyone);
}

void GapWatch::error_changed(const Error& error, bool present) {
  if (error.code == emergency_code::can_overrun && present) suspect(everyone);
}

/// A period is known from the one before: a write of 1017h of a node is taken for a gap at most
/// once.
void GapWatch::heard(NodeId id, RemoteState state) {
  if (!is_node_id(id) || id > rhythms_.size()) return;
  Rhythm& rhythm = rhythms_[id - std::size_t{1}];
  const Time now = node_.now();
  const bool begins = state == RemoteState::boot_up || rhythm.at == never;
  const Duration period = begins ? Duration{} : now - rhythm.at;
  const bool is_late = rhythm.period > Duration{} && period > rhythm.period * 3 / 2;
  rhythm = {now, period};
  if (is_late) suspect(id);
}

void GapWatch::heard(NodeId id, const Emergency& emergency) {
  constexpr unsigned communication = 0x81;
  if (is_node_id(id) && emergency.code >> 8 == communication) suspect(id);
}

void GapWatch::suspect(NodeId id) {
  suspects_[id] = true;
  if (timer_.armed()) return;
  const Time now = node_.now();
  const Time rested = asked_at_ == never ? now : asked_at_ + rests;
  node_.timers().arm(timer_, std::max(now + collects, rested));
}

void GapWatch::expired(Time now) {
  const auto suspects = suspects_;
  suspects_.reset();
  if (node_.state() != NmtState::operational) return;
  asked_at_ = now;
  if (suspects[everyone]) return ask_(everyone);
  for (unsigned id = 1; id <= node_id_max; ++id) {
    if (suspects[id]) ask_(static_cast<NodeId>(id));
  }
}

}  // namespace canvoy
