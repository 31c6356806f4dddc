#include "canvoy/canopen/heartbeat_producer.hpp"

namespace canvoy {

namespace {

constexpr std::uint16_t producer_time = 0x1017;

}  // namespace

HeartbeatProducer::HeartbeatProducer(Node& node)
    : node_(node), timer_(Callback<void(Time)>::to<&HeartbeatProducer::send>(*this)) {
  service_.reset = Callback<void(ResetScope)>::to<&HeartbeatProducer::reset>(*this);
  hook_.first = hook_.last = producer_time;
  hook_.after_write =
      Callback<void(const Entry&, Source)>::to<&HeartbeatProducer::period_written>(*this);
  node_.attach(service_);
  node_.dictionary().attach(hook_);
}

void HeartbeatProducer::reset(ResetScope) {
  schedule(node_.now());
}

void HeartbeatProducer::period_written(const Entry&, Source) {
  if (period() == Duration::zero()) return node_.timers().disarm(timer_);
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
  return std::chrono::milliseconds(node_.dictionary().number(producer_time, 0));
}

}  // namespace canvoy
