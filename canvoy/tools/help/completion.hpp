// What may stand next on a command line: verbs, options, buses, nodes, objects, states.
//
//     completions(app, {"read", "can0", "10", "temp"});  // temperature
#pragma once

#include <string>
#include <vector>

#include "canvoy/tools/cli/verb.hpp"

namespace canvoy::tools {

/// `words` are those behind `canvoy`; the last is the one that is being typed, and may be empty.
/// None where the shell knows better: names of files.
std::vector<std::string> completions(const Verb& app, const std::vector<std::string>& words);

}  // namespace canvoy::tools
