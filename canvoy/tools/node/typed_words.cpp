#include "canvoy/tools/node/typed_words.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <optional>

#include "canvoy/formats/trace/trace_format.hpp"
#include "canvoy/profiles/registry.hpp"
#include "canvoy/tools/argument/bus_argument.hpp"
#include "canvoy/tools/argument/node_argument.hpp"
#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/cli/meant_line.hpp"
#include "canvoy/tools/node/ask_verbs.hpp"
#include "canvoy/tools/node/other_names.hpp"
#include "canvoy/tools/node/word_order.hpp"

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

/// Of the line's verb; none where it has no bus.
std::optional<BusPlace> bus_place(const Words& words) {
  if (is_ask_verb(words.front())) return BusPlace{.verb = words.front()};
  const auto* const place = std::ranges::find(bus_places, words.front(), &BusPlace::verb);
  if (place == bus_places.end()) return std::nullopt;
  const bool is_other = !place->second.empty() && (words.size() < 2 || words[1] != place->second);
  return is_other ? std::nullopt : std::optional(*place);
}

/// `180:780`: an identifier and a mask, as candump has it.
bool is_can_id_mask(std::string_view word) {
  const std::size_t colon = word.find(':');
  return colon != std::string_view::npos && colon != 0 && colon + 1 < word.size() &&
         word.find_first_not_of("0123456789abcdefABCDEF:") == std::string_view::npos &&
         word.find(':', colon + 1) == std::string_view::npos;
}

[[noreturn]] void refuse_without_bus(Words words, std::size_t at) {
  words.insert(words.begin() + static_cast<std::ptrdiff_t>(at), "can0");
  order_words(words);
  throw UsageError(
      fmt::format("which bus? {}; or export CANVOY_BUS=can0, and leave it out", typed_line(words)));
}

/// The bus stands where the verb has it, wherever it was typed: `lss scan can0`, `replay can0
/// a.log`.
void move_bus(Words& words, std::size_t at) {
  const std::size_t places = count_places(words);
  if (places < at || names_bus(words[at])) return;
  for (std::size_t typed = 1; typed <= places; ++typed) {
    if (!names_bus(words[typed])) continue;
    const std::string bus = words[typed];
    erase_words(words, typed);
    words.insert(words.begin() + static_cast<std::ptrdiff_t>(at), bus);
    return;
  }
}

/// The bus of the environment where none was said, and the line that was meant where that is not
/// known either.
void add_bus(Words& words, const BusPlace& place) {
  const char* const usual = std::getenv("CANVOY_BUS");
  move_bus(words, place.at);
  const std::size_t places = count_places(words);
  const bool is_said = places >= place.at && names_bus(words[place.at]);
  if (is_said || places + 1 < place.at) return;
  const std::string first = places >= place.at ? words[place.at] : words.front();
  const bool is_file =
      first == "-" || first.find('/') != std::string::npos || first.find('.') != std::string::npos;
  const std::optional<std::string> said =
      is_file ? std::nullopt
              : take_option(words, {"--bus", "--interface", "--channel", "-i", "-c"}, names_bus);
  if (said) {
    words.insert(words.begin() + static_cast<std::ptrdiff_t>(place.at), *said);
    return;
  }
  const std::string verb = words.front();
  // A log where a bus may stand as well.
  if (verb == "monitor" && places > 0 && is_file) return;
  const bool is_whole = places >= place.others_min && places <= place.others_max;
  if (!is_whole) return;
  if (usual != nullptr && *usual != '\0') {
    words.insert(words.begin() + static_cast<std::ptrdiff_t>(place.at), usual);
    return;
  }
  const bool begins_with_node =
      is_ask_verb(verb) && places > 0 && (find_node_id(words[1]) || is_nmt_word(words[1]));
  const bool is_bare = places == 0 && words.size() == 1;
  const bool is_exact = places == place.others_min && places > 0 && !is_ask_verb(verb);
  if (begins_with_node || is_exact || (is_bare && !is_ask_verb(verb))) {
    refuse_without_bus(std::move(words), place.at);
  }
}

/// `device can0 pump.eds` is `device pump.eds can0`; without a bus, that of the environment is
/// used.
void add_device_bus(Words& words) {
  const char* const usual = std::getenv("CANVOY_BUS");
  std::string bus = usual == nullptr ? "" : usual;
  if (count_places(words) > 1 && names_bus(words[1])) {
    bus = words[1];
    erase_words(words, 1);
  }
  const std::size_t places = count_places(words);
  const auto last = words.begin() + static_cast<std::ptrdiff_t>(places) + 1;
  if (bus.empty() || places == 0 || std::any_of(words.begin() + 1, last, names_bus)) return;
  words.insert(places > 1 && find_node_id(words[places]) ? last - 1 : last, bus);
}

/// `can0,180:780`, as candump has it, is the bus and a filter.
void part_candump_filters(Words& words) {
  if (words.front() != "monitor" || count_places(words) == 0) return;
  std::string buses;
  std::string filters;
  std::string_view rest = words[1];
  while (true) {
    const std::size_t comma = rest.find(',');
    const std::string_view part = rest.substr(0, comma);
    std::string& list = is_can_id_mask(part) ? filters : buses;
    if (!list.empty()) list += ',';
    list += part;
    if (comma == std::string_view::npos) break;
    rest.remove_prefix(comma + 1);
  }
  if (filters.empty() || buses.empty()) return;
  words[1] = buses;
  words.insert(words.end(), {"--filter", "id=" + filters});
}

/// `plot night.log 10:6010`: the node in front of its object.
void part_nodes_of_objects(Words& words) {
  if (words.front() != "plot") return;
  std::string node;
  for (std::size_t at = 2; at <= count_places(words); ++at) {
    const std::size_t colon = words[at].find(':');
    const std::string_view first = std::string_view(words[at]).substr(0, colon);
    if (colon == std::string::npos || !is_small_number(first) || !find_node_id(first)) continue;
    if (!node.empty() && node != first) return;  // the verb tells of both
    node = first;
  }
  if (node.empty()) return;
  for (std::size_t at = 2; at <= count_places(words); ++at) {
    if (words[at].starts_with(node + ':')) words[at].erase(0, node.size() + 1);
  }
  words.insert(words.end(), {"--filter", "node=" + node});
}

/// True if the standard input is a pipe or a file.
bool has_piped_input() {
  struct stat input {};
  return fstat(STDIN_FILENO, &input) == 0 && (S_ISFIFO(input.st_mode) || S_ISREG(input.st_mode));
}

/// `cat night.log | canvoy stats`: the log is on the standard input where no other source is said.
void use_piped_input(Words& words) {
  constexpr auto readers =
      std::to_array<std::string_view>({"monitor", "stats", "doctor", "load", "plot"});
  const bool reads = std::ranges::find(readers, words.front()) != readers.end();
  const std::size_t places = count_places(words);
  const bool misses_log =
      words.front() == "plot" ? places == 1 && !formats::names_trace(words[1]) : places == 0;
  if (!reads || !misses_log || !has_piped_input()) return;
  words.insert(words.begin() + 1, "-");
}

/// `battery can0 11`: the node-ID stands behind the bus.
void use_node_behind_bus(Words& words) {
  const std::size_t places = count_places(words);
  const bool is_behind = words.front() == "device" && places > 2 && names_bus(words[places - 1]) &&
                         find_node_id(words[places]);
  if (is_behind) words.insert(words.begin() + static_cast<std::ptrdiff_t>(places), "--node-id");
}

/// Of a conversion that says only the format of the file to be written: `bus.trc --to csv`.
std::string format_to_convert(const Words& words) {
  if (words.size() == 2) return "asc";
  const bool is_format = words.size() < 5 && formats::names_trace("log." + words.back()) &&
                         words.back().find('.') == std::string::npos;
  return is_format && words.size() > 2 ? words.back() : "";
}

/// Lines that miss a word, or have one of another verb: the line that was meant.
void refuse_another_line(const Words& words) {
  const std::size_t places = count_places(words);
  const std::string& verb = words.front();
  const auto refuse = [](std::string_view what, const auto&... parts) {
    throw UsageError(
        fmt::format("{} canvoy {}", what, fmt::join({std::string_view(parts)...}, " ")));
  };
  const bool names_file = std::ranges::any_of(words, [](const std::string& word) {
    return word.starts_with("-o") || word.starts_with("--o") || formats::names_trace(word);
  });
  if (verb == "record" && places == 1 && names_bus(words[1]) && !names_file) {
    refuse("which file is to be written?", verb, words[1], new_file("night.log", "log"));
  }
  if (verb == "convert-log" && words.size() > 1 && formats::names_trace(words[1])) {
    const std::string format = format_to_convert(words);
    if (!format.empty()) {
      refuse("which file is to be written?", verb, words[1], new_file(words[1], format));
    }
  }
  if (verb == "report" && places == 1 && formats::names_trace(words[1]) && words.size() == 2) {
    refuse("which file is to be written?", verb, words[1], "--out", new_file(words[1], "html"));
  }
  if (verb == "pdo" && places == 2 && names_bus(words[1])) {
    refuse(
        "which PDO? one is sent by", verb, words[1], words[2],
        fmt::format("tpdo1, and its mapping read by canvoy read {} {} 1A00", words[1], words[2]));
  }
  const bool has_several_nodes = (verb == "read" || verb == "write") && places > 2 &&
                                 (words[2] == "all" || words[2].find(',') != std::string::npos);
  if (has_several_nodes) {
    const std::string first = words[2] == "all" ? "10" : words[2].substr(0, words[2].find(','));
    refuse("one node is asked at a time:", verb, words[1], first,
           fmt::format("{}; canvoy scan {} asks all who they are",
                       fmt::join(words.begin() + 3, words.end(), " "), words[1]));
  }
  if (verb == "replay" && places == 1 && names_bus(words[1])) {
    refuse("which log?", verb, "night.log", words[1]);
  }
  if (verb == "check" && places == 1 && is_sheet_name(words[1])) {
    refuse("a data sheet is checked by", "eds check", words[1]);
  }
  if (verb == "export" && places == 2 && formats::names_trace(words[2])) {
    refuse("the values in a log are written by", "decode", words[2], "--csv");
  }
  const bool has_node_behind =
      (verb == "monitor" || verb == "decode") && places == 2 && is_small_number(words[2]);
  if (has_node_behind) {
    refuse("what is of one node is chosen by", verb, words[1], "--filter", "node=" + words[2]);
  }
  if (verb == "nmt" && (places == 2 || places == 3) && names_bus(words[1])) {
    const std::string state = places == 2 ? words[2] : words[2] + '-' + words[3];
    if (is_nmt_word(state)) {
      throw UsageError(fmt::format("which node? canvoy nmt {0} 10 {1}, or canvoy nmt {0} all {1}",
                                   words[1], state));
    }
  }
  const auto reset = std::find_if(words.begin() + 1, words.end(),
                                  [](const std::string& word) { return same_name("reset", word); });
  if (verb == "nmt" && places == 3 && reset != words.end()) {
    Words meant = words;
    meant[static_cast<std::size_t>(reset - words.begin())] = "reset-node";
    order_words(meant);
    throw UsageError(fmt::format("reset what? {}, or reset-communication", typed_line(meant)));
  }
}

/// As other systems have it.
bool is_call_for_help(std::string_view word) {
  constexpr auto calls =
      std::to_array<std::string_view>({"/?", "-?", "/h", "/help", "-help", "--hilfe"});
  return std::ranges::find(calls, word) != calls.end();
}

}  // namespace

std::vector<std::string> typed_words(Words words) {
  const auto refuse_empty = [&words] {
    if (!words.empty()) return;
    throw UsageError(
        "which verb? canvoy --help lists them all; canvoy scan can0 shows who is on a bus");
  };
  refuse_empty();
  if (words.front() == "version") return {"--version"};
  for (std::string& word : words) {
    if (is_call_for_help(word)) word = "--help";
  }
  if (words.front() == "help" || words.front() == "hilfe") {
    words.erase(words.begin());
    words.emplace_back("--help");
  }
  put_verb_in_front(words);
  refuse_empty();  // `-v` alone is left out
  use_own_names(words);
  if (words.front() == "device" && words.size() > 1) add_device_bus(words);
  use_node_behind_bus(words);
  part_candump_filters(words);
  part_nodes_of_objects(words);
  const bool asks_for_help = std::ranges::find(words, "--help") != words.end() ||
                             std::ranges::find(words, "-h") != words.end();
  const std::optional<BusPlace> place = bus_place(words);
  if (!asks_for_help) refuse_another_line(words);
  if (asks_for_help) return words;
  use_piped_input(words);
  if (!place) return words;
  add_bus(words, *place);
  order_words(words);
  return words;
}

}  // namespace canvoy::tools
