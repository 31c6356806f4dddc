// Heartbeat producer: sends the NMT state every 1017h milliseconds (CiA 301, 7.2.8.3.2.2).
//
//     HeartbeatProducer heartbeat_producer(node);
#pragma once

#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/canopen/node/node.hpp"

namespace canvoy {

/// Sends heartbeats. The boot-up message counts as the first, so the next one follows after the
/// period. A write to 1017h sends one at once, and restarts the period; 0 ends the heartbeat, as
/// does a missing 1017h.
class HeartbeatProducer : private NodeService {
 public:
  /// Attaches to the node; the first heartbeat follows its boot-up message.
  constexpr explicit HeartbeatProducer(Node& node)
      : NodeService({on_event, object, object}, EventMask::none),
        node_(node),
        timer_(Callback<void(Time)>(&HeartbeatProducer::expire, this)) {
    node_.attach(*this);
  }
  HeartbeatProducer(const HeartbeatProducer&) = delete;
  HeartbeatProducer& operator=(const HeartbeatProducer&) = delete;

 private:
  static constexpr std::uint16_t object = object_index::heartbeat_producer;

  static void on_event(NodeService& service, ServiceEvent& event);
  void period_written();
  static void expire(void* producer, Time now);
  void send(Time now);
  void schedule(std::uint32_t late);

  Node& node_;
  Timer timer_;
  std::uint32_t due_ = 0;  ///< time of the next heartbeat: see low_ticks()
};

}  // namespace canvoy
