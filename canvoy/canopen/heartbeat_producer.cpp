#include "canvoy/canopen/heartbeat_producer.hpp"

namespace canvoy {

namespace {

constexpr std::uint16_t producer_time = 0x1017;

}  // namespace

constexpr ServiceCalls HeartbeatProducer::service_calls = {
    .reset = method<&HeartbeatProducer::reset>, .hooks = {&hook_calls, 1}};
constexpr HookCalls HeartbeatProducer::hook_calls = {
    .first = producer_time,
    .last = producer_time,
    .after_write = method<&HeartbeatProducer::period_written>};

HeartbeatProducer::HeartbeatProducer(Node& node)
    : node_(node), timer_(Callback<void(Time)>::to<&HeartbeatProducer::send>(*this)) {
  node_.attach(service_);
}

inline void HeartbeatProducer::reset(ResetScope) {
  schedule(node_.now());
}

inline void HeartbeatProducer::period_written(const Entry&, Source) {
  schedule(node_.now());
  // In initialisation the boot-up message, which is the first heartbeat, is still to come.
  if (timer_.armed() && node_.state() != NmtState::initialisation) node_.send_state();
}

inline void HeartbeatProducer::send(Time now) {
  if (node_.state() == NmtState::initialisation) return;
  node_.send_state();
  // A call that comes late does not shift those that follow, unless it is late by a whole period.
  schedule(due_);
  if (!is_before(now, due_)) schedule(now);
}

void HeartbeatProducer::schedule(Time previous) {
  const auto period = static_cast<std::uint16_t>(node_.dictionary().word(producer_time, 0));
  due_ = previous + from_milliseconds(period);
  node_.timers().arm(timer_, period == 0 ? never : Time(due_));
}

}  // namespace canvoy
