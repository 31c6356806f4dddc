// Runs a world as the command line requests: on the terminal, as a page in the browser (`--web`),
// or as a report (`canvoy report`); or only prints it as a file (`--print`).
//
//     return play_world({.kind = "taxi", .make = maker_of(run, make_taxi), ...}, play, options);
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <utility>

#include "canvoy/tools/page/live_world.hpp"
#include "canvoy/tools/player/run_options.hpp"

namespace canvoy::tools {

/// The run with the seed of the plan, and its faults in addition to those of the run. Needs
/// add_fault(Run&, text).
template <class Run>
Run planned(Run run, const WorldPlan& plan) {
  run.network.faults.seed = plan.seed;
  for (const std::string& fault : plan.faults) add_fault(run, fault);
  return run;
}

/// Makes a world of the run for each plan. `make` makes the network of a Run.
template <class Run, class Make>
std::function<MadeWorld(const WorldPlan&)> maker_of(Run run, Make make) {
  return [run = std::move(run), make = std::move(make)](const WorldPlan& plan) {
    return MadeWorld{.network = make(planned(run, plan))};
  };
}

/// Writes the run for each plan as a network file. `text` writes a Run.
template <class Run>
std::function<std::string(const WorldPlan&)> file_of(Run run, std::string (*text)(const Run&)) {
  return [run = std::move(run), text](const WorldPlan& plan) { return text(planned(run, plan)); };
}

/// Returns the exit status: whether all invariants held. Throws Failure.
int play_world(LiveWorldOptions world, const PlayOptions& play_as, const RunOptions& options);

}  // namespace canvoy::tools
