#include "canvoy/tools/cli/meant_line.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <filesystem>
#include <system_error>
#include <utility>

namespace canvoy::tools {

namespace {

using Words = std::vector<std::string>;

constexpr std::string_view program_of_examples = "canvoy ";

std::string quoted(const std::string& word) {
  const bool is_plain = !word.empty() && word.front() != '#' &&
                        word.find_first_of(" '\"<>|&;()*?$!\\") == std::string::npos;
  return is_plain ? word : '\'' + word + '\'';
}

/// The words of an example, with their quotes.
Words words_of_example(std::string_view example) {
  Words words;
  char quote = '\0';
  bool is_in_word = false;
  for (const char letter : example) {
    if (quote == '\0' && letter == ' ') {
      is_in_word = false;
      continue;
    }
    if (quote == letter) {
      quote = '\0';
    } else if (quote == '\0' && (letter == '\'' || letter == '"')) {
      quote = letter;
    }
    if (!std::exchange(is_in_word, true)) words.emplace_back();
    words.back() += letter;
  }
  return words;
}

bool is_option(const std::string& word) {
  return word.starts_with('-') && word.size() > 1;
}

}  // namespace

std::string typed_line(const Words& words) {
  std::string line = "canvoy";
  for (const std::string& word : words) line += ' ' + quoted(word);
  return line;
}

std::string example_with(std::string_view examples, std::string_view word) {
  while (!examples.empty()) {
    std::string_view line = examples.substr(0, examples.find('\n'));
    examples.remove_prefix(std::min(line.size() + 1, examples.size()));
    line.remove_prefix(std::min(line.find_first_not_of(' '), line.size()));
    if (!line.starts_with(program_of_examples)) continue;
    const Words words = words_of_example(line);
    if (std::ranges::find(words, word) != words.end()) return std::string(line);
  }
  return {};
}

std::string completed_line(const Words& words, std::string_view verb, std::string_view examples) {
  const Words example = words_of_example(example_with(examples, verb));
  const auto end = std::ranges::find_if(example, is_option);
  const auto options = std::ranges::find_if(words, is_option);
  // The first word of the example is the program.
  const std::ptrdiff_t typed = options - words.begin() + 1;
  if (end - example.begin() <= typed) return {};
  std::string line = typed_line({words.begin(), options});
  for (auto word = example.begin() + typed; word != end; ++word) line += ' ' + *word;
  for (auto word = options; word != words.end(); ++word) line += ' ' + quoted(*word);
  return line;
}

bool only_shows(const Words& words) {
  constexpr auto verbs = std::to_array<std::string_view>(
      {"monitor", "decode", "stats", "doctor", "load", "explain", "search", "profile", "scan",
       "plot", "read", "expect", "wait", "completion", "view"});
  const auto writes = [](const std::string& word) {
    return word.starts_with("-o") || word.starts_with("--o") || word.starts_with("--log") ||
           word.starts_with("--parquet") || word.starts_with("--write");
  };
  const bool is_of_sheets =
      words.size() > 1 && words[0] == "eds" && (words[1] == "check" || words[1] == "diff");
  const bool is_one = !words.empty() && std::ranges::find(verbs, words[0]) != verbs.end();
  return (is_one || is_of_sheets) && std::ranges::none_of(words, writes);
}

bool is_safe_line(std::string_view line, const Words& words) {
  constexpr auto senders = std::to_array<std::string_view>(
      {"write", "send", "emcy", "pdo", "lss", "nmt", "program", "time", "sync"});
  if (only_shows(words)) return true;
  if (!words.empty() && std::ranges::find(senders, words[0]) != senders.end()) return false;
  std::error_code none;
  const Words all = words_of_example(line);
  return std::none_of(all.begin() + 1, all.end(), [&](const std::string& word) {
    const bool is_typed = std::ranges::find(words, word) != words.end();
    return !is_typed && std::filesystem::is_regular_file(word, none);
  });
}

std::string new_file(std::string_view file, std::string_view ending) {
  std::filesystem::path name(file);
  std::error_code none;
  const std::string stem = name.replace_extension().string();
  std::string made = fmt::format("{}.{}", stem, ending);
  for (int number = 2; std::filesystem::exists(made, none); ++number) {
    made = fmt::format("{}-{}.{}", stem, number, ending);
  }
  return made;
}

std::string line_without(Words words, const Words& unknown) {
  for (const std::string& each : unknown) {
    const auto found = std::ranges::find(words, each);
    if (found != words.end()) words.erase(found);
  }
  return typed_line(words);
}

}  // namespace canvoy::tools
