// The verb `canvoy load`.
//
//     add_load(app);
#pragma once

#include "canvoy/tools/cli/verb.hpp"

namespace canvoy::tools {

void add_load(Verb& app);

}  // namespace canvoy::tools
