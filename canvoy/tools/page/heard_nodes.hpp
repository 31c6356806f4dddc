// Nodes of buses that are only listened to: their boot-ups, heartbeats and emergencies as events
// and as a table, in the words of simulated networks.
//
//     HeardNodes nodes(feed, [&](std::string line) { events.add(std::move(line)); });
//     nodes.hear(time, "can0", frame);
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "canvoy/sim/bus_watch.hpp"
#include "canvoy/tools/page/frame_feed.hpp"
#include "canvoy/tools/player/world_text.hpp"
#include "canvoy/tools/session/heartbeat_watch.hpp"

namespace canvoy::tools {

class HeardNodes {
 public:
  using Tell = std::function<void(ReportedEvent event)>;

  HeardNodes(FrameFeed& feed, Tell tell);
  ~HeardNodes();
  HeardNodes(const HeardNodes&) = delete;
  HeardNodes& operator=(const HeardNodes&) = delete;

  void hear(Duration time, std::string_view bus, const Frame& frame);
  /// Reports nodes that have become silent, or are heard again, until this time. hear() does it
  /// once a second of the times of frames; where no frame comes, the caller has to.
  void look(Duration now);
  /// The table as `nodes` of a snapshot. Nodes are `silent` as HeartbeatWatch
  /// says it.
  Json nodes_json(Duration now);

 private:
  class Names;
  struct Bus;
  struct Said {
    std::string state;
    std::uint8_t error_register = 0;
    HeartbeatWatch heartbeat{};
    bool told_silent = false;
  };

  /// Null: too many buses.
  Bus* bus_of(std::string_view name);
  void note(Time now, const BusEvent& event);
  void hear_heartbeat(Duration time, BusIndex bus, const Frame& frame);

  FrameFeed& feed_;
  Tell tell_;
  std::unique_ptr<Names> names_;
  std::vector<std::unique_ptr<Bus>> buses_;
  std::map<std::pair<BusIndex, NodeId>, Said> nodes_;
  Duration next_look_{};
};

}  // namespace canvoy::tools
