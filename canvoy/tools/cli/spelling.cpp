#include "canvoy/tools/cli/spelling.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

namespace canvoy::tools {

namespace {

/// No real name is longer, and the cost grows with the square of the length.
constexpr std::size_t word_length_max = 80;

bool is_same_letter(char a, char b) {
  return in_lower_case(a) == in_lower_case(b);
}

}  // namespace

bool is_listed(std::string_view word, std::string_view list) {
  while (!list.empty()) {
    const std::size_t end = std::min(list.find(' '), list.size());
    if (list.substr(0, end) == word) return true;
    list.remove_prefix(std::min(end + 1, list.size()));
  }
  return false;
}

std::size_t distance(std::string_view a, std::string_view b) {
  // The last three rows of the table with [i][j] for the first letters of both.
  std::vector<std::size_t> before(b.size() + 1);
  std::vector<std::size_t> last(b.size() + 1);
  std::vector<std::size_t> line(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) line[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    before.swap(last);
    last.swap(line);
    line[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const bool is_same = is_same_letter(a[i - 1], b[j - 1]);
      line[j] = std::min({last[j] + 1, line[j - 1] + 1, last[j - 1] + (is_same ? 0 : 1)});
      const bool is_swapped = i > 1 && j > 1 && is_same_letter(a[i - 1], b[j - 2]) &&
                              is_same_letter(a[i - 2], b[j - 1]);
      if (is_swapped) line[j] = std::min(line[j], before[j - 2] + 1);
    }
  }
  return line[b.size()];
}

std::string did_you_mean(std::string_view word, const std::vector<std::string>& known) {
  if (word.empty() || word.size() > word_length_max) return {};
  std::size_t least = std::max<std::size_t>(1, word.size() / 3) + 1;
  const std::string* closest = nullptr;
  for (const std::string& candidate : known) {
    if (candidate == word) return {};
    const std::size_t longer = std::max(candidate.size(), word.size());
    if (longer - std::min(candidate.size(), word.size()) >= least) continue;
    const std::size_t away = distance(word, candidate);
    if (away >= least || away >= longer) continue;
    least = away;
    closest = &candidate;
  }
  // `--node` of `--node-id` is nearer than `--move`: who types it knows how it begins.
  constexpr std::size_t beginning_min = 4;
  for (const std::string& candidate : known) {
    const bool begins = word.size() >= beginning_min && candidate.size() > word.size() &&
                        std::ranges::equal(word, candidate.substr(0, word.size()), is_same_letter);
    if (begins && least > 1) {
      closest = &candidate;
      break;
    }
  }
  return closest == nullptr ? "" : fmt::format("; did you mean '{}'?", *closest);
}

}  // namespace canvoy::tools
