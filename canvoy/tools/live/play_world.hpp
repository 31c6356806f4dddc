// A world as the command line wants it: on the terminal, as a page in the browser (`--web`), or as
// a report (`canvoy report`).
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

/// Makes a world of the run by each plan: with its seed, and with its faults beside those that the
/// run has. `make` makes the network of a Run, and add_fault(Run&, text) is known of it.
template <class Run, class Make>
std::function<MadeWorld(const WorldPlan&)> maker_of(Run run, Make make) {
  return [run = std::move(run), make = std::move(make)](const WorldPlan& plan) {
    Run wanted = run;
    wanted.network.faults.seed = plan.seed;
    for (const std::string& fault : plan.faults) add_fault(wanted, fault);
    return MadeWorld{.network = make(wanted)};
  };
}

/// The exit status: whether all invariants held. Throws Failure.
int play_world(LiveWorldOptions world, const PlayOptions& play_as, const RunOptions& options);

}  // namespace canvoy::tools
