// Options in front of the verb, as in `canvoy --eds pump.eds decode a.log`: which words are the
// values of options is known from the verb that stands behind them.
//
//     words = with_options_behind_verb(words, line_of);  // decode a.log --eds pump.eds
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "canvoy/tools/cli/verb.hpp"

namespace canvoy::tools {

/// A command line with the verb of this name.
using LineOf = std::function<std::unique_ptr<CommandLine>(std::string_view verb)>;

/// Puts the options behind the verb that has all of them. Where no verb has, a line whose first
/// verb is plain gets them as well, and is refused by that verb. Other lines are left as they are.
std::vector<std::string> with_options_behind_verb(std::vector<std::string> words,
                                                  const LineOf& line_of);

}  // namespace canvoy::tools
