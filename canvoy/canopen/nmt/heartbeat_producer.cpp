#include "canvoy/canopen/nmt/heartbeat_producer.hpp"

namespace canvoy {

void HeartbeatProducer::on_event(NodeService& service, ServiceEvent& event) {
  HeartbeatProducer& self = static_cast<HeartbeatProducer&>(service);
  if (event.kind == ServiceEvent::reset) self.schedule(0);
  if (event.kind == ServiceEvent::after_write) self.period_written();
}

inline void HeartbeatProducer::period_written() {
  schedule(0);
  // In initialisation the boot-up message, which is the first heartbeat, is still to come.
  if (timer_.armed() && node_.state() != NmtState::initialisation) node_.send_state();
}

void HeartbeatProducer::expire(void* producer, Time now) {
  static_cast<HeartbeatProducer*>(producer)->send(now);
}

[[gnu::always_inline]] inline void HeartbeatProducer::send(Time now) {
  if (node_.state() == NmtState::initialisation) return;
  // Heartbeats of a bus-off period would all leave at once after it.
  if (node_.bus_state() != BusState::bus_off) node_.send_state();
  schedule(low_ticks(now) - due_);
}

/// Schedules the next heartbeat after one that is `late` by so many microseconds: that does not
/// shift later ones, unless it is late by a whole period.
void HeartbeatProducer::schedule(std::uint32_t late) {
  const auto milliseconds = static_cast<std::uint16_t>(node_.dictionary().word(object));
  const std::uint32_t period = milliseconds * std::uint32_t{1000};
  if (period == 0) return node_.timers().disarm(timer_);
  const std::uint32_t left = late < period ? period - late : period;
  due_ = low_ticks(node_.now()) + left;
  node_.timers().arm_in(timer_, left);
}

}  // namespace canvoy
