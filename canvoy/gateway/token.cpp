#include "canvoy/gateway/token.hpp"

#include <algorithm>

namespace canvoy::gateway {

namespace {

constexpr std::string_view between_tokens = " \t";

constexpr char lower(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

/// Length of the text at the start of `line`, with both quotes; 0 if it has no end.
std::size_t quoted_length(std::string_view line) {
  for (std::size_t i = 1; i < line.size(); ++i) {
    if (line[i] == '\\') {
      ++i;
    } else if (line[i] == '"') {
      if (i + 1 == line.size() || line[i + 1] != '"') return i + 1;
      ++i;
    }
  }
  return 0;
}

bool same_word(std::string_view a, std::string_view b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (lower(a[i]) != lower(b[i])) return false;
  }
  return true;
}

}  // namespace

std::optional<std::vector<Token>> split(std::string_view line) {
  std::vector<Token> tokens;
  while (true) {
    const std::size_t first = line.find_first_not_of(between_tokens);
    if (first == std::string_view::npos || line[first] == '#') return tokens;
    line.remove_prefix(first);
    std::size_t length = std::min(line.find_first_of(" \t#"), line.size());
    if (line.front() == '"') {
      length = quoted_length(line);
      const std::string_view rest = line.substr(length);
      const bool alone = rest.empty() || rest.find_first_of(" \t#") == 0;
      if (length == 0 || !alone) return std::nullopt;
    }
    tokens.push_back(line.substr(0, length));
    line.remove_prefix(length);
  }
}

bool matches(std::string_view pattern, Token word) {
  const std::size_t bracket = pattern.find('[');
  if (bracket == std::string_view::npos) return same_word(pattern, word);
  const std::string_view required = pattern.substr(0, bracket);
  const std::string_view more = pattern.substr(bracket + 1, pattern.size() - bracket - 2);
  if (same_word(required, word)) return true;
  return word.size() == required.size() + more.size() &&
         same_word(required, word.substr(0, bracket)) && same_word(more, word.substr(bracket));
}

}  // namespace canvoy::gateway
