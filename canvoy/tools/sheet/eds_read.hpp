// canvoy eds read BUS NODE: the DCF of a running node.
#pragma once

#include "canvoy/tools/cli/commands.hpp"

namespace canvoy::tools {

/// Adds it as a subcommand of `eds`.
void add_eds_read(Verb& eds);

}  // namespace canvoy::tools
