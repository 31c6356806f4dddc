#include "canvoy/canopen/heartbeat_producer.hpp"

namespace canvoy {

namespace {

constexpr std::uint16_t producer_time = 0x1017;

}  // namespace

constexpr ServiceCalls HeartbeatProducer::service_calls = {.reset =
                                                               method<&HeartbeatProducer::reset>};
constexpr HookCalls HeartbeatProducer::hook_calls = {
    .first = producer_time,
    .last = producer_time,
    .after_write = method<&HeartbeatProducer::period_written>};

HeartbeatProducer::HeartbeatProducer(Node& node)
    : node_(node), timer_(Callback<void(Time)>::to<&HeartbeatProducer::send>(*this)) {
  node_.attach(service_);
  node_.dictionary().attach(hook_);
}

void HeartbeatProducer::reset(ResetScope) {
  schedule(node_.now());
}

void HeartbeatProducer::period_written(const Entry&, Source) {
  if (period() == Duration::zero()) return node_.timers().disarm(timer_);
  // The boot-up message, which is the first heartbeat, is still to come.
  if (node_.state() == NmtState::initialisation) return schedule(node_.now());
  due_ = node_.now();
  send(node_.now());
}

void HeartbeatProducer::send(Time now) {
  if (node_.state() == NmtState::initialisation) return;
  node_.transmitter().send(Frame::data_frame(std::uint32_t{can_id::error_control} + node_.id(),
                                             {static_cast<std::uint8_t>(node_.state())}));
  // A call that comes late does not shift those that follow, unless it is late by a whole period.
  schedule(due_ + period() > now ? due_ : now);
}

void HeartbeatProducer::schedule(Time previous) {
  const Duration time = period();
  due_ = previous + time;
  node_.timers().arm(timer_, time == Duration::zero() ? never : due_);
}

Duration HeartbeatProducer::period() const {
  return from_milliseconds(static_cast<std::uint16_t>(node_.dictionary().number(producer_time, 0)));
}

}  // namespace canvoy
