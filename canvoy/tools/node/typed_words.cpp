#include "canvoy/tools/node/typed_words.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <optional>

#include "canvoy/profiles/registry.hpp"
#include "canvoy/tools/argument/node_argument.hpp"
#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/node/ask_verbs.hpp"

namespace canvoy::tools {

namespace {

using Words = std::vector<std::string>;

/// Where a bus stands, in a verb beside those of ask_verbs.hpp.
struct BusPlace {
  std::string_view verb;
  std::size_t at = 1;            ///< in the words: 1 is behind the verb
  std::size_t others_min = 0;    ///< so many other words make the line whole
  std::size_t others_max = 99;   ///< with more, one of them is what stands in place of a bus
  std::string_view second = {};  ///< the word behind the verb, where only that one has a bus
};

constexpr auto bus_places = std::to_array<BusPlace>({
    {.verb = "script", .others_min = 1},
    {.verb = "monitor"},
    {.verb = "scan"},
    {.verb = "clone"},
    {.verb = "browse"},
    {.verb = "gateway"},
    {.verb = "record"},
    {.verb = "doctor", .others_max = 0},
    {.verb = "load", .others_max = 0},
    {.verb = "stats", .others_max = 0},
    {.verb = "view", .others_max = 0},
    {.verb = "boot", .others_max = 0},
    {.verb = "check", .others_min = 1},
    {.verb = "program", .others_min = 2},
    {.verb = "lss", .others_min = 1},
    {.verb = "replay", .at = 2, .others_min = 1},
    {.verb = "eds", .at = 2, .others_min = 2, .second = "read"},
    {.verb = "export", .at = 2, .others_min = 1, .others_max = 1},
});
constexpr auto nmt_states =
    std::to_array<std::string_view>({"operational", "stopped", "pre-operational", "reset-node",
                                     "reset-communication", "start", "stop", "preop"});

/// Of the line's verb; none where it has no bus.
std::optional<BusPlace> bus_place(const Words& words) {
  if (is_ask_verb(words.front())) return BusPlace{.verb = words.front()};
  const auto* const place = std::ranges::find(bus_places, words.front(), &BusPlace::verb);
  if (place == bus_places.end()) return std::nullopt;
  const bool is_other = !place->second.empty() && (words.size() < 2 || words[1] != place->second);
  return is_other ? std::nullopt : std::optional(*place);
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

/// Number of words after the verb and before the first option.
std::size_t count_places(const Words& words) {
  const auto option = std::find_if(words.begin() + 1, words.end(), [](const std::string& word) {
    return word.size() > 1 && word.starts_with('-');
  });
  return static_cast<std::size_t>(option - words.begin()) - 1;
}

/// `0x1017` and `1017h` as `1017`; empty if it is no index.
std::string index_digits(std::string_view word) {
  if (word.starts_with("0x") || word.starts_with("0X")) word.remove_prefix(2);
  if (word.ends_with('h') || word.ends_with('H')) word.remove_suffix(1);
  constexpr std::size_t digits = 4;
  const bool is_index = word.size() == digits &&
                        word.find_first_not_of("0123456789abcdefABCDEF") == std::string_view::npos;
  return is_index ? std::string(word) : std::string();
}

/// Like index_digits(), but for a sub-index: `0`, `01h`, `0x1F`.
std::string sub_digits(std::string_view word) {
  if (word.starts_with("0x") || word.starts_with("0X")) word.remove_prefix(2);
  if (word.ends_with('h') || word.ends_with('H')) word.remove_suffix(1);
  const bool is_sub = !word.empty() && word.size() <= 2 &&
                      word.find_first_not_of("0123456789abcdefABCDEF") == std::string_view::npos;
  return is_sub ? std::string(word) : std::string();
}

/// Joins index and sub-index at `at` and after it into one word.
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

[[noreturn]] void refuse_without_bus(Words words, std::size_t at) {
  words.insert(words.begin() + static_cast<std::ptrdiff_t>(at), "can0");
  order_words(words);
  throw UsageError(
      fmt::format("which bus? {}; or export CANVOY_BUS=can0, and leave it out", line_of(words)));
}

bool is_nmt_state(std::string_view word) {
  return std::ranges::any_of(nmt_states,
                             [word](std::string_view state) { return same_name(state, word); });
}

/// The bus of the environment where none was said, and the line that was meant where that is not
/// known either.
void add_bus(Words& words, const BusPlace& place) {
  const char* const usual = std::getenv("CANVOY_BUS");
  const std::size_t places = count_places(words);
  const bool is_said = places >= place.at && names_bus(words[place.at]);
  if (is_said || places + 1 < place.at) return;
  const std::string& verb = words.front();
  const std::string& first = places >= place.at ? words[place.at] : verb;
  const bool is_file =
      first == "-" || first.find('/') != std::string::npos || first.find('.') != std::string::npos;
  // A log where a bus may stand as well.
  if (verb == "monitor" && places > 0 && is_file) return;
  const bool is_whole = places >= place.others_min && places <= place.others_max;
  if (!is_whole) return;
  if (usual != nullptr && *usual != '\0') {
    words.insert(words.begin() + static_cast<std::ptrdiff_t>(place.at), usual);
    return;
  }
  const bool begins_with_node =
      is_ask_verb(verb) && places > 0 && (find_node_id(words[1]) || is_nmt_state(words[1]));
  const bool is_bare = places == 0 && words.size() == 1;
  const bool is_exact = places == place.others_min && places > 0 && !is_ask_verb(verb);
  if (begins_with_node || is_exact || (is_bare && !is_ask_verb(verb))) {
    refuse_without_bus(std::move(words), place.at);
  }
}

/// `device pump.eds` uses the bus of the environment.
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
    if (is_nmt_state(words[node_at]) && !is_nmt_state(words[object_at])) {
      std::swap(words[node_at], words[object_at]);
    }
  }
  const bool is_turned = verb == "lss" && places > 1 && !names_bus(words[1]);
  if (is_turned && names_bus(words[2])) std::swap(words[1], words[2]);
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
  const std::optional<BusPlace> place = bus_place(words);
  if (asks_for_help || !place) return words;
  add_bus(words, *place);
  order_words(words);
  return words;
}

}  // namespace canvoy::tools
