#include "canvoy/tools/ask/typed_words.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>

#include "canvoy/profiles/registry.hpp"
#include "canvoy/tools/ask/ask_verbs.hpp"
#include "canvoy/tools/ask/node_argument.hpp"
#include "canvoy/tools/failure.hpp"

namespace canvoy::tools {

namespace {

using Words = std::vector<std::string>;

/// Verbs beside those of ask_verbs.hpp whose first word is a bus.
constexpr auto bus_verbs = std::to_array<std::string_view>(
    {"script", "monitor", "scan", "clone", "browse", "gateway", "record"});
constexpr auto nmt_states =
    std::to_array<std::string_view>({"operational", "stopped", "pre-operational", "reset-node",
                                     "reset-communication", "start", "stop", "preop"});

bool takes_bus(std::string_view verb) {
  return is_ask_verb(verb) || std::ranges::find(bus_verbs, verb) != bus_verbs.end();
}

/// `can0`, `vcan12`, `slcan0`: letters with "can" in them, and a number.
bool looks_like_interface(std::string_view word) {
  const std::size_t letters = word.find_last_not_of("0123456789");
  return letters != std::string_view::npos && letters + 1 < word.size() &&
         word.substr(0, letters + 1).ends_with("can");
}

bool is_interface(std::string_view word) {
  constexpr std::size_t length_max = 15;
  std::error_code none;
  return !word.empty() && word.size() <= length_max && word.find('/') == std::string_view::npos &&
         !word.starts_with('.') &&
         std::filesystem::exists("/sys/class/net/" + std::string(word), none);
}

/// How many words stand behind the verb before the first option.
std::size_t count_places(const Words& words) {
  const auto option = std::find_if(words.begin() + 1, words.end(), [](const std::string& word) {
    return word.size() > 1 && word.starts_with('-');
  });
  return static_cast<std::size_t>(option - words.begin()) - 1;
}

/// `0x1017` and `1017h` as `1017`; empty where it is no index.
std::string index_digits(std::string_view word) {
  if (word.starts_with("0x") || word.starts_with("0X")) word.remove_prefix(2);
  if (word.ends_with('h') || word.ends_with('H')) word.remove_suffix(1);
  constexpr std::size_t digits = 4;
  const bool is_index = word.size() == digits &&
                        word.find_first_not_of("0123456789abcdefABCDEF") == std::string_view::npos;
  return is_index ? std::string(word) : std::string();
}

/// As index_digits() of `0`, `01h`, `0x1F`.
std::string sub_digits(std::string_view word) {
  if (word.starts_with("0x") || word.starts_with("0X")) word.remove_prefix(2);
  if (word.ends_with('h') || word.ends_with('H')) word.remove_suffix(1);
  const bool is_sub = !word.empty() && word.size() <= 2 &&
                      word.find_first_not_of("0123456789abcdefABCDEF") == std::string_view::npos;
  return is_sub ? std::string(word) : std::string();
}

/// Index and sub-index at `at` and behind it become one word.
bool join_index(Words& words, std::size_t at) {
  const std::string index = index_digits(words.at(at));
  const std::string sub = sub_digits(words.at(at + 1));
  if (index.empty() || sub.empty()) return false;
  words[at] = index + ':' + sub;
  words.erase(words.begin() + static_cast<std::ptrdiff_t>(at) + 1);
  return true;
}

std::string line_of(const Words& words) {
  return fmt::format("canvoy {}", fmt::join(words, " "));
}

[[noreturn]] void refuse_without_bus(Words words) {
  words.insert(words.begin() + 1, "can0");
  throw UsageError(
      fmt::format("which bus? {}; or export CANVOY_BUS=can0, and leave it out", line_of(words)));
}

/// The bus of the environment where none was said, and the line that was meant where that is not
/// known either.
void add_bus(Words& words) {
  const char* const usual = std::getenv("CANVOY_BUS");
  const std::size_t places = count_places(words);
  const bool is_said = places > 0 && names_bus(words[1]);
  if (is_said) return;
  const bool has_usual = usual != nullptr && *usual != '\0';
  const std::string& verb = words.front();
  const bool is_file = places > 0 && (words[1] == "-" || words[1].find('/') != std::string::npos ||
                                      words[1].find('.') != std::string::npos);
  // A log where a bus may stand as well.
  if (verb == "monitor" && is_file) return;
  if (has_usual) {
    words.insert(words.begin() + 1, usual);
    return;
  }
  if (verb == "script" && places == 1) return refuse_without_bus(std::move(words));
  const bool begins_with_node = is_ask_verb(verb) && places > 0 && find_node_id(words[1]);
  if (begins_with_node) refuse_without_bus(std::move(words));
}

/// `device pump.eds` goes on the bus of the environment.
void add_device_bus(Words& words) {
  const char* const usual = std::getenv("CANVOY_BUS");
  const std::size_t places = count_places(words);
  if (usual == nullptr || *usual == '\0' || places == 0 || names_bus(words[places])) return;
  words.insert(words.begin() + static_cast<std::ptrdiff_t>(places) + 1, usual);
}

}  // namespace

bool names_bus(std::string_view word) {
  const std::string_view first = word.substr(0, word.find(','));
  const std::string_view interface = first.substr(0, first.find('/'));
  return first == "sim" || first.starts_with("udp:") || first.starts_with("tcp:") ||
         looks_like_interface(interface) || is_interface(interface);
}

void order_words(Words& words) {
  constexpr std::size_t node_at = 2;
  constexpr std::size_t object_at = 3;
  const std::size_t places = count_places(words);
  const std::string& verb = words.front();
  if (verb == "nmt" && places == 3) {
    const auto is_state = [&words](std::size_t at) {
      return std::ranges::any_of(
          nmt_states, [&](std::string_view state) { return same_name(state, words[at]); });
    };
    if (is_state(node_at) && !is_state(object_at)) std::swap(words[node_at], words[object_at]);
  }
  if (verb == "read" && places == 4) join_index(words, object_at);
  if (verb == "write" && places == 5) join_index(words, object_at);
  const bool takes_object = verb == "read" || verb == "write" || verb == "expect";
  for (std::size_t at = object_at; takes_object && at <= count_places(words); ++at) {
    const std::string index = index_digits(words[at]);
    if (!index.empty() && words[at].size() > index.size()) words[at] = index;
    if (verb != "read") break;
  }
}

std::vector<std::string> typed_words(Words words) {
  if (words.empty()) return words;
  if (words.front() == "help") {
    words.erase(words.begin());
    words.emplace_back("--help");
    return words;
  }
  if (words.front() == "device" && words.size() > 1) add_device_bus(words);
  const bool asks_for_help = std::ranges::find(words, "--help") != words.end() ||
                             std::ranges::find(words, "-h") != words.end();
  if (asks_for_help || !takes_bus(words.front())) return words;
  add_bus(words);
  order_words(words);
  return words;
}

}  // namespace canvoy::tools
