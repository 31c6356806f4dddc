// Completes the words of a command line: `help read`, a bus from $CANVOY_BUS, `nmt can0 start 10`,
// `write can0 10 1017 0 500`. Ambiguous words are left to the verb, or refused with the line to
// type.
//
//     const std::vector<std::string> words = typed_words({"read", "10", "1018"});
#pragma once

#include <string>
#include <vector>

namespace canvoy::tools {

/// `words` are those after the name of the program. Throws UsageError with the intended line.
std::vector<std::string> typed_words(std::vector<std::string> words);

}  // namespace canvoy::tools
