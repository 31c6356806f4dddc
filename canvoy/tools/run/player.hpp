// Plays a simulated network: as fast as it goes or paced by the clock, with a picture on a
// terminal, as JSON, as a log of its frames, and with real buses as parts of it.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "canvoy/sim/world.hpp"
#include "canvoy/tools/run/told_event.hpp"

namespace canvoy::tools {

/// A network as it is played.
class PlayedNetwork {
 public:
  PlayedNetwork() = default;
  virtual ~PlayedNetwork() = default;
  PlayedNetwork(const PlayedNetwork&) = delete;
  PlayedNetwork& operator=(const PlayedNetwork&) = delete;

  virtual World& world() = 0;
  virtual void run_until(Time until) = 0;
  /// One for each bus of the world, in their order.
  virtual std::vector<std::string> bus_names() const = 0;
  /// So many things have happened.
  virtual std::size_t event_count() const = 0;
  /// One of them, from 0.
  virtual ToldEvent event(std::size_t number) const = 0;
  /// What a terminal shows.
  virtual std::string picture(double speed) = 0;
  virtual nlohmann::ordered_json snapshot() = 0;
  virtual std::string summary_text() = 0;
  virtual nlohmann::ordered_json summary_json() = 0;
  virtual bool all_hold() const = 0;
};

/// A bus of the network that a real one is a part of.
struct RealBus {
  BusIndex bus = 0;
  std::string address;
};

struct PlayOptions {
  Duration duration = 8h;
  std::string log = {};  ///< the path; empty: none
  double speed = -1;     ///< times faster than the clock; 0: as fast as it goes; below 0:
                         ///< terminal_speed on a terminal, else 0
  double terminal_speed = 60;
  Duration snapshot_period = 1min;  ///< of JSON
  bool json = false;
  bool require_decided = false;    ///< see verdict_status()
  std::vector<RealBus> real = {};  ///< with any, the speed is 1
};

/// exit_failed where an invariant is broken; exit_undecided where all held, some were not judged,
/// and that is required: behind a line on the standard error output that names them.
int verdict_status(const nlohmann::ordered_json& summary, bool require_decided);

/// Plays until the end, or SIGINT, SIGTERM or SIGHUP, and prints the summary. The exit status:
/// see verdict_status(). Throws Failure.
int play(PlayedNetwork& network, const PlayOptions& options);

}  // namespace canvoy::tools
