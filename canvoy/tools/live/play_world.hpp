// A world as the command line wants it: on the terminal, as a page in the browser (`--web`), or as
// a report (`canvoy report`); or only as the file that plays it (`--print`).
//
//     return play_world({.kind = "taxi", .make = maker_of(run, make_taxi), ...}, play, options);
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <utility>

#include "canvoy/tools/live/live_world.hpp"
#include "canvoy/tools/run/run.hpp"

namespace canvoy::tools {

/// The run by the plan: with its seed, and with its faults beside those that the run has.
/// add_fault(Run&, text) is known of it.
template <class Run>
Run planned(Run run, const WorldPlan& plan) {
  run.network.faults.seed = plan.seed;
  for (const std::string& fault : plan.faults) add_fault(run, fault);
  return run;
}

/// Makes a world of the run by each plan. `make` makes the network of a Run.
template <class Run, class Make>
std::function<MadeWorld(const WorldPlan&)> maker_of(Run run, Make make) {
  return [run = std::move(run), make = std::move(make)](const WorldPlan& plan) {
    return MadeWorld{.network = make(planned(run, plan))};
  };
}

/// Writes the run by each plan as a network file. `text` does so with a Run.
template <class Run>
std::function<std::string(const WorldPlan&)> file_of(Run run, std::string (*text)(const Run&)) {
  return [run = std::move(run), text](const WorldPlan& plan) { return text(planned(run, plan)); };
}

/// The exit status: whether all invariants held. Throws Failure.
int play_world(LiveWorldOptions world, const PlayOptions& play_as, const RunOptions& options);

}  // namespace canvoy::tools
