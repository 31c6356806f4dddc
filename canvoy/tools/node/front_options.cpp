#include "canvoy/tools/node/front_options.hpp"

#include <algorithm>
#include <cstddef>

#include "canvoy/tools/node/other_names.hpp"
#include "canvoy/tools/node/typed_options.hpp"

namespace canvoy::tools {

namespace {

using Words = std::vector<std::string>;

constexpr std::string_view end_of_options = "--";

Words front_of(const Words& words, std::size_t at) {
  return {words.begin(), words.begin() + static_cast<std::ptrdiff_t>(at)};
}

/// The words in front of this place behind the others, before what ends the options.
Words moved_behind(const Words& words, std::size_t at) {
  Words moved(words.begin() + static_cast<std::ptrdiff_t>(at), words.end());
  const Words front = front_of(words, at);
  moved.insert(std::ranges::find(moved, end_of_options), front.begin(), front.end());
  return moved;
}

/// True if the verb at this place has all options in front of it. `is_lost`: without them no verb
/// is found.
bool has_all(const Words& words, std::size_t at, const LineOf& line_of, bool is_lost) {
  const Words behind = line_from(words, at);
  // `--out decode a.log` misses a value; it does not write into `decode`.
  const bool has_verb = std::ranges::any_of(front_of(words, at), is_verb_name);
  if (behind.empty() || (has_verb && !is_verb_name(words[at]))) return false;
  const FrontFit fit = fit_of_front(front_of(words, at), behind, *line_of(behind.front()));
  return fit == FrontFit::known || (fit == FrontFit::other && is_lost);
}

/// Each option with at most one value.
bool may_be_options(const Words& front) {
  bool is_behind_option = false;
  return std::ranges::all_of(front, [&](const std::string& word) {
    const bool is_option = word.starts_with('-');
    const bool fits = is_option || is_behind_option;
    is_behind_option = is_option;
    return fits;
  });
}

bool is_answered_at_once(std::string_view word) {
  return word == "--help" || word == "-h" || word == "--version";
}

}  // namespace

std::vector<std::string> with_options_behind_verb(std::vector<std::string> words,
                                                  const LineOf& line_of) {
  const bool has_front = !words.empty() && words.front().starts_with('-') &&
                         words.front() != end_of_options && !is_answered_at_once(words.front());
  if (!has_front) return words;
  const bool is_lost = !finds_verb(words);
  for (std::size_t at = 1; at < words.size() && words[at] != end_of_options; ++at) {
    if (has_all(words, at, line_of, is_lost)) return moved_behind(words, at);
  }
  if (!is_lost) return words;
  const auto verb = std::ranges::find_if(words, is_verb_name);
  const auto count = static_cast<std::size_t>(verb - words.begin());
  const bool is_plain = verb != words.end() && may_be_options(front_of(words, count));
  return is_plain ? moved_behind(words, count) : words;
}

}  // namespace canvoy::tools
