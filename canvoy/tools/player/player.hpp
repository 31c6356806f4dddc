// Plays a simulated network: as fast as possible or paced by the clock, with a picture on a
// terminal, as JSON, as a log of its frames, and with real buses.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "canvoy/sim/world.hpp"
#include "canvoy/tools/player/act.hpp"
#include "canvoy/tools/player/reported_event.hpp"
#include "canvoy/tools/player/world_text.hpp"

namespace canvoy::tools {

/// A network to be played.
class PlayedNetwork {
 public:
  PlayedNetwork() = default;
  virtual ~PlayedNetwork() = default;
  PlayedNetwork(const PlayedNetwork&) = delete;
  PlayedNetwork& operator=(const PlayedNetwork&) = delete;

  virtual World& world() = 0;
  virtual void run_until(Time until) = 0;
  /// One name for each bus of the world, in order.
  virtual std::vector<std::string> bus_names() const = 0;
  /// Number of events so far.
  virtual std::size_t event_count() const = 0;
  /// The event with this number, from 0.
  virtual ReportedEvent event(std::size_t number) const = 0;
  /// Picture for a terminal.
  virtual std::string picture(double speed) = 0;
  virtual nlohmann::ordered_json snapshot() = 0;
  virtual std::string summary_text() = 0;
  virtual nlohmann::ordered_json summary_json() = 0;
  virtual bool all_hold() const = 0;
  /// Its invariants, in the order of summary_json(); empty if the summary has those of several
  /// networks.
  virtual std::vector<Judged> judged() const { return {}; }
  /// True if people come and go.
  virtual bool takes_visitors() const { return false; }
  /// True if a visitor can travel from one floor to the other.
  virtual bool has_way(unsigned /*from*/, unsigned /*to*/) const { return false; }
  /// Adds a visitor. Needs has_way().
  virtual void visit(unsigned /*from*/, unsigned /*to*/) {}
};

/// A real bus that is part of a bus of the network.
struct RealBus {
  BusIndex bus = 0;
  std::string address;
};

struct PlayOptions {
  Duration duration = 8h;
  std::string log = {};  ///< the path; empty: none
  double speed = -1;  ///< factor to the clock; 0: as fast as possible; below 0: terminal_speed on a
                      ///< terminal, else 0
  double terminal_speed = 60;
  Duration snapshot_period = 1min;  ///< of JSON
  bool json = false;
  bool require_decided = false;    ///< see verdict_status()
  std::vector<RealBus> real = {};  ///< with any, the speed is 1
  std::vector<Act> acts = {};      ///< in the order of their times
};

/// exit_failed if an invariant is broken; exit_undecided if all judged ones held, some were not
/// judged, and `require_decided`, after a line on standard error that names them.
int verdict_status(const nlohmann::ordered_json& summary, bool require_decided);

/// Plays until the end, or SIGINT, SIGTERM or SIGHUP, and prints the summary. Returns the exit
/// status of verdict_status(). Throws Failure.
int play(PlayedNetwork& network, const PlayOptions& options);

}  // namespace canvoy::tools
