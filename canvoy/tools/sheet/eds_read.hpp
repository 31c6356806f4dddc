// canvoy eds read BUS NODE: the DCF of a running node.
#pragma once

#include "canvoy/tools/commands.hpp"

namespace canvoy::tools {

/// As a subcommand of `eds`.
void add_eds_read(Verb& eds);

}  // namespace canvoy::tools
