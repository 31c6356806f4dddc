// Splits a line of a script into words as a shell does: separated by blanks, grouped by quotes; `#`
// begins a comment.
//
//     script_words("expect 10 'temperature > 20degC'  # warm");  // expect, 10, temperature >
//     20degC
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace canvoy::tools {

/// Nothing if a quote is not closed.
std::optional<std::vector<std::string>> script_words(std::string_view line);

}  // namespace canvoy::tools
