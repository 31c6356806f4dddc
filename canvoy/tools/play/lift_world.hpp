// canvoy run lift: plays a building with lifts, from the command line or from a file.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "canvoy/tools/play/hand_file.hpp"
#include "canvoy/tools/play/world.hpp"
#include "canvoy/worlds/lift/lift_network_description.hpp"

namespace canvoy::tools {

struct LiftRun : WorldRun {
  Duration duration = 1h;
  lift::LiftNetworkDescription network{};
  std::string arrival_list{};  ///< file of network.arrivals
  std::vector<HandOfFile> hands{};
};

/// File names are relative to `folder`.
std::vector<FilePart<LiftRun>> lift_parts(const std::string& folder);

std::string_view traffic_pattern_name(lift::TrafficPattern pattern);
/// Throws UsageError.
lift::TrafficPattern parse_traffic_pattern(std::string_view name);

struct LiftWorld {
  using Run = LiftRun;
  using Kind = lift::FaultKind;
  struct Choice {
    unsigned lifts = 1;
    unsigned floors = 10;
    std::string traffic = "interfloor";
    std::string people{};
    std::optional<double> percent{};
    bool destination_control = false;
  };
  static constexpr std::string_view name = "lift";

  static WorldInfo info();
  static WorldFile<Run> file(const std::string& folder);
  static void check(const TomlTable& file, const std::string&, Run& run) {
    const std::string error = lift::check(run.network);
    if (!error.empty()) file.refuse(error);
  }
  static Run run_of_file() { return {}; }
  static Duration& length(Run& run) { return run.duration; }
  /// Sets the seed. Seeds of traffic and people in a file are kept until another seed is set.
  static void set_seed(Run& run, std::uint64_t seed) {
    run.network.faults.seed = run.network.traffic.seed = run.network.people.seed = seed;
  }
  static void check_run(const Run& run) {
    const std::string error = lift::check(run.network);
    if (!error.empty()) throw UsageError(error);
  }
  static void add_options(Verb& verb, Choice& choice);
  static Run chosen(const Choice& choice);
  static MadeWorld make(const Run& run, const Choice&);
};

}  // namespace canvoy::tools
