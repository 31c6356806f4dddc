// Completions of a command line: verbs, options, buses, nodes, objects, states.
//
//     completions(app, {"read", "can0", "10", "temp"});  // temperature
#pragma once

#include <string>
#include <vector>

#include "canvoy/tools/cli/verb.hpp"

namespace canvoy::tools {

/// `words` are those after `canvoy`; the last one is being typed, and may be empty. Returns none
/// where the shell completes better: file names.
std::vector<std::string> completions(const Verb& app, const std::vector<std::string>& words);

}  // namespace canvoy::tools
