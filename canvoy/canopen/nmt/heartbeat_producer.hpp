// Heartbeat producer: tells the others each 1017h milliseconds in which NMT state the node is (CiA
// 301, 7.2.8.3.2.2).
//
//     HeartbeatProducer heartbeat_producer(node);
#pragma once

#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/canopen/node.hpp"

namespace canvoy {

/// The boot-up message counts as the first heartbeat, so the next one follows it by the period. A
/// write to 1017h sends one at once, and the period starts anew; 0 ends it, as does the lack of
/// 1017h.
class HeartbeatProducer : private NodeService {
 public:
  constexpr explicit HeartbeatProducer(Node& node)
      : NodeService({told, object, object}, Cares::for_nothing_frequent),
        node_(node),
        timer_(Callback<void(Time)>(&HeartbeatProducer::expire, this)) {
    node_.attach(*this);
  }
  HeartbeatProducer(const HeartbeatProducer&) = delete;
  HeartbeatProducer& operator=(const HeartbeatProducer&) = delete;

 private:
  static constexpr std::uint16_t object = object_index::heartbeat_producer;

  static void told(NodeService& service, ServiceEvent& event);
  void period_written();
  static void expire(void* producer, Time now);
  void send(Time now);
  void schedule(std::uint32_t late);

  Node& node_;
  Timer timer_;
  std::uint32_t due_ = 0;  ///< the next heartbeat: see low_ticks()
};

}  // namespace canvoy
