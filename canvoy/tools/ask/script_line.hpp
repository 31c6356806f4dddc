// A line of a script in words, as a shell has them: blanks part them, quotes keep them together,
// `#` begins a comment.
//
//     script_words("expect 10 'temperature > 20degC'  # warm");  // expect, 10, temperature >
//     20degC
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace canvoy::tools {

/// Nothing where a quote does not end.
std::optional<std::vector<std::string>> script_words(std::string_view line);

}  // namespace canvoy::tools
