// Heartbeat producer: tells the others each 1017h milliseconds in which NMT state the node is (CiA
// 301, 7.2.8.3.2.2).
//
//     HeartbeatProducer heartbeat_producer(node);
#pragma once

#include "canvoy/canopen/node.hpp"

namespace canvoy {

/// The boot-up message counts as the first heartbeat, so the next one follows it by the period. A
/// write to 1017h sends one at once, and the period starts anew; 0 ends it, as does the lack of
/// 1017h.
class HeartbeatProducer {
 public:
  constexpr explicit HeartbeatProducer(Node& node)
      : node_(node), timer_(Callback<void(Time)>(&HeartbeatProducer::expire, this)) {
    node_.attach(service_);
  }
  HeartbeatProducer(const HeartbeatProducer&) = delete;
  HeartbeatProducer& operator=(const HeartbeatProducer&) = delete;

 private:
  void reset(ResetScope scope);
  void period_written(const Entry& entry, Source source);
  static void expire(void* producer, Time now);
  void send(Time now);
  void schedule(std::uint32_t late);

  Node& node_;
  static const ServiceCalls service_calls;
  static const HookCalls hook_calls;
  ServiceLink service_{&service_calls, this};
  Timer timer_;
  std::uint32_t due_ = 0;  ///< the next heartbeat: see low_ticks()
};

}  // namespace canvoy
