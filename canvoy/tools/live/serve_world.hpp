// `--web` of canvoy run: a world as a page in the browser.
#pragma once

#include "canvoy/tools/live/live_world.hpp"
#include "canvoy/tools/run/run.hpp"

namespace canvoy::tools {

/// In place of play(), where the options have `web`. Throws Failure.
int serve_world(LiveWorldOptions world, const PlayOptions& play, const RunOptions& options);

}  // namespace canvoy::tools
