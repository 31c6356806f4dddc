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

/// What other tools call a verb, or what is typed for one of ours.
struct OtherName {
  std::string_view name;
  std::string_view verb;
};
constexpr auto other_names = std::to_array<OtherName>({
    {"candump", "monitor"},  {"dump", "monitor"},
    {"listen", "monitor"},   {"sniff", "monitor"},
    {"watch", "monitor"},    {"heartbeat", "monitor"},
    {"list", "scan"},        {"ls", "scan"},
    {"nodes", "scan"},       {"ping", "scan"},
    {"diff", "eds diff"},    {"compare", "eds diff"},
    {"info", "eds check"},   {"convert", "convert-log"},
    {"simulate", "run"},     {"sim", "run"},
    {"start", "nmt"},        {"stop", "nmt"},
    {"reset", "nmt"},        {"log", "record"},
    {"canplayer", "replay"}, {"play", "replay"},
    {"cansend", "send"},     {"get", "read"},
    {"upload", "read"},      {"sdo", "read"},
    {"set", "write"},        {"download", "write"},
    {"test", "check"},       {"flash", "program"},
    {"serve", "view"},       {"web", "view"},
    {"statistics", "stats"}, {"dbc", "export dbc"},
    {"lookup", "explain"},
});

void refuse_other_name(const Words& words) {
  const auto* const other = std::ranges::find(other_names, words.front(), &OtherName::name);
  if (other == other_names.end()) return;
  Words meant(words.begin() + 1, words.end());
  if (other->verb == "nmt") meant.push_back(words.front());
  const bool misses_bus = meant.empty() && (other->verb == "scan" || other->verb == "monitor");
  if (misses_bus) meant.emplace_back("can0");
  meant.insert(meant.begin(), std::string(other->verb));
  if (other->verb == "nmt") order_words(meant);
  throw UsageError(fmt::format("'{}' is not known here; {} does that: {}", words.front(),
                               other->verb, line_of(meant)));
}

bool has_ending(std::string_view word, std::initializer_list<std::string_view> endings) {
  return std::ranges::any_of(endings,
                             [word](std::string_view ending) { return word.ends_with(ending); });
}

bool is_small_number(std::string_view word) {
  return !word.empty() && word.size() <= 3 &&
         word.find_first_not_of("0123456789") == std::string_view::npos;
}

/// Lines that miss a word, or have one of another verb: the line that was meant.
void refuse_another_line(const Words& words) {
  const std::size_t places = count_places(words);
  const std::string& verb = words.front();
  const auto refuse = [](std::string_view what, const auto&... parts) {
    throw UsageError(
        fmt::format("{} canvoy {}", what, fmt::join({std::string_view(parts)...}, " ")));
  };
  if (verb == "record" && places == 1 && names_bus(words[1])) {
    refuse("which file is to be written?", verb, words[1], "night.log");
  }
  if (verb == "replay" && places == 1 && names_bus(words[1])) {
    refuse("which log?", verb, "night.log", words[1]);
  }
  if (verb == "check" && places == 1 && has_ending(words[1], {".eds", ".dcf", ".xdd", ".xdc"})) {
    refuse("a data sheet is checked by", "eds check", words[1]);
  }
  if (verb == "export" && places == 2 && has_ending(words[2], {".log", ".asc", ".blf", ".trc"})) {
    refuse("the values in a log are written by", "decode", words[2], "--csv");
  }
  const bool has_node_behind =
      (verb == "monitor" || verb == "decode") && places == 2 && is_small_number(words[2]);
  if (has_node_behind) {
    refuse("what is of one node is chosen by", verb, words[1], "--filter", "node=" + words[2]);
  }
  const auto reset = std::find_if(words.begin() + 1, words.end(),
                                  [](const std::string& word) { return same_name("reset", word); });
  if (verb == "nmt" && places == 3 && reset != words.end()) {
    Words meant = words;
    meant[static_cast<std::size_t>(reset - words.begin())] = "reset-node";
    order_words(meant);
    throw UsageError(fmt::format("reset what? {}, or reset-communication", line_of(meant)));
  }
}

/// `1018sub1`, as data sheets have it, as `1018:1`.
std::string with_colon(std::string_view word) {
  const std::size_t sub = word.find("sub");
  if (sub == std::string_view::npos) return {};
  const std::string index = index_digits(word.substr(0, sub));
  const std::string digits = sub_digits(word.substr(sub + 3));
  return index.empty() || digits.empty() ? std::string() : index + ':' + digits;
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
    if (const std::string object = with_colon(words[at]); !object.empty()) words[at] = object;
    const std::string index = index_digits(words[at]);
    if (!index.empty() && words[at].size() > index.size()) words[at] = index;
    if (verb != "read") break;
  }
}

std::vector<std::string> typed_words(Words words) {
  if (words.empty()) {
    throw UsageError(
        "which verb? canvoy --help lists them all; canvoy scan can0 shows who is on a bus");
  }
  if (words.front() == "version") return {"--version"};
  if (words.front() == "help") {
    words.erase(words.begin());
    words.emplace_back("--help");
    return words;
  }
  refuse_other_name(words);
  if (words.front() == "device" && words.size() > 1) add_device_bus(words);
  const bool asks_for_help = std::ranges::find(words, "--help") != words.end() ||
                             std::ranges::find(words, "-h") != words.end();
  const std::optional<BusPlace> place = bus_place(words);
  if (!asks_for_help) refuse_another_line(words);
  if (asks_for_help || !place) return words;
  add_bus(words, *place);
  order_words(words);
  return words;
}

}  // namespace canvoy::tools
