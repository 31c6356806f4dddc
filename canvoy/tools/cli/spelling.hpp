// Suggests known words for an unknown one.
//
//     did_you_mean("tempersture", {"temperature", "voltage"});  // "; did you mean 'temperature'?"
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace canvoy::tools {

/// A letter of A to Z as a small one, whatever the locale; anything else as it is.
constexpr char in_lower_case(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

/// True if the word is one of a list, which blanks separate.
bool is_listed(std::string_view word, std::string_view list);

/// Number of letters to insert, delete, replace or swap with a neighbour to turn one word into the
/// other, ignoring case. Cost: product of the lengths.
std::size_t distance(std::string_view a, std::string_view b);

/// End of an error message; empty if no known word is close: at most a third of its letters away,
/// and one letter for a short word.
std::string did_you_mean(std::string_view word, const std::vector<std::string>& known);

}  // namespace canvoy::tools
