// The nodes of buses that are only listened to: what they say of themselves by boot-up, heartbeat
// and emergency, as events and as a table, in the words that simulated networks have for it.
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
#include "canvoy/tools/live/frame_feed.hpp"
#include "canvoy/tools/run/world_text.hpp"

namespace canvoy::tools {

class HeardNodes {
 public:
  using Tell = std::function<void(ToldEvent event)>;

  HeardNodes(FrameFeed& feed, Tell tell);
  ~HeardNodes();
  HeardNodes(const HeardNodes&) = delete;
  HeardNodes& operator=(const HeardNodes&) = delete;

  void hear(Duration time, std::string_view bus, const Frame& frame);
  /// As `nodes` of a snapshot. A node whose heartbeats have stopped is `silent` after three of its
  /// periods, one second at least: nobody tells its end.
  Json nodes_json(Duration now);

 private:
  class Names;
  struct Bus;
  struct Said {
    std::string state;
    std::uint8_t error_register = 0;
    Duration heard_at{};         ///< its latest heartbeat
    Duration period{};           ///< the longest of late between two; 0: there was one at most
    bool has_heartbeat = false;  ///< beside its boot-up message
  };

  /// Null: there are too many.
  Bus* bus_of(std::string_view name);
  void note(Time now, const BusEvent& event);
  void hear_heartbeat(Duration time, BusIndex bus, const Frame& frame);

  FrameFeed& feed_;
  Tell tell_;
  std::unique_ptr<Names> names_;
  std::vector<std::unique_ptr<Bus>> buses_;
  std::map<std::pair<BusIndex, NodeId>, Said> nodes_;
};

}  // namespace canvoy::tools
