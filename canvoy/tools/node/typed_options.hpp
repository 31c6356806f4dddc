// Options as other tools spell them, and words whose form says what they are: `monitor can0 -n 5`
// is `--count 5`, `record can0 -o a.log` has its file, `sync can0 100ms` is `--every 100ms`. What
// may be two things is left to the verb.
//
//     line.parse(with_known_options(words, line));
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "canvoy/tools/cli/verb.hpp"

namespace canvoy::tools {

/// `words` begin with the verb. A line that the verb understands is returned as it is.
std::vector<std::string> with_known_options(std::vector<std::string> words, const Verb& line);

/// How the words in front of a verb are its options.
enum class FrontFit : std::uint8_t {
  none,   ///< not all of them are
  known,  ///< all are, each with its value
  other,  ///< all are, but some are spelt as other tools do, and may be a place: `-n 10`
};
/// `words` begin with the verb.
FrontFit fit_of_front(const std::vector<std::string>& front, const std::vector<std::string>& words,
                      const Verb& line);

}  // namespace canvoy::tools
