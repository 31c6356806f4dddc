// Runs a world as the command line requests: on the terminal, as a page in the browser (`--web`),
// or as a report (`canvoy report`); or only prints it as a file (`--print`).
//
//     return play_world({.kind = "taxi", .make = make_taxi, ...}, play, options);
#pragma once

#include "canvoy/tools/page/live_world.hpp"
#include "canvoy/tools/player/run_options.hpp"

namespace canvoy::tools {

/// Returns the exit status: whether all invariants held. Throws Failure.
int play_world(LiveWorldOptions world, const PlayOptions& play_as, const RunOptions& options);

}  // namespace canvoy::tools
