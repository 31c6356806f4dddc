// What a listener must not overlook: a bus that is lost or off, nodes whose heartbeats have
// stopped, frames that were lost before they were read. Each is told when it begins and when it
// ends, and is part of one line while it lasts.
//
//     BusNews news([](const std::string& line) { print_message(line); });
//     for (host::HostBus* bus : session.buses()) news.follow(*bus);
//     news.look(loop.now());  // at least once a second
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <string>

#include "canvoy/can/host/host_bus.hpp"
#include "canvoy/canopen/protocol/cob_id.hpp"
#include "canvoy/tools/session/heartbeat_watch.hpp"

namespace canvoy::tools {

/// The observers of the buses refer to it: it must outlive the runs of their loop.
class BusNews {
 public:
  using Tell = std::function<void(const std::string& line)>;

  explicit BusNews(Tell tell) : tell_(std::move(tell)) {}
  BusNews(const BusNews&) = delete;
  BusNews& operator=(const BusNews&) = delete;

  /// Tells of the bus, and with `with_nodes` of its nodes, for which it listens to all frames.
  void follow(host::HostBus& bus, bool with_nodes = true);
  /// Looks for what no call of a bus tells: lost frames and silent nodes. `now`: of the loop.
  void look(Time now);
  /// What is wrong with the buses themselves, in one line; empty: nothing.
  std::string trouble() const;
  /// What is wrong at present, in one line: `can0 is bus-off; node 10 (0Ah) is silent for 12 s; 3
  /// frames were lost`. Empty: nothing.
  std::string text(Time now) const;
  /// Number of frames that were lost before they were read.
  std::uint64_t frames_lost() const;

 private:
  struct Node {
    HeartbeatWatch heartbeat{};
    bool is_silent = false;
  };
  struct Bus {
    host::HostBus* host;
    std::string trouble{};  ///< empty: none
    bool is_lost = false;   ///< the trouble says why
    std::uint64_t lost = 0;
    std::map<NodeId, Node> nodes{};
  };

  void hear(Bus& bus, const host::BusFrame& heard);
  void tell_state(Bus& bus, BusState state);
  void look_at(Bus& bus, Duration now);
  /// `can0: ` where there are several.
  std::string place(const Bus& bus) const;

  Tell tell_;
  std::deque<Bus> buses_;  // addresses are kept by the observers
};

}  // namespace canvoy::tools
