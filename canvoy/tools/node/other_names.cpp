#include "canvoy/tools/node/other_names.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <optional>

#include "canvoy/can/frame_text.hpp"
#include "canvoy/formats/trace/trace_format.hpp"
#include "canvoy/profiles/registry.hpp"
#include "canvoy/sim/duration_text.hpp"
#include "canvoy/tools/argument/bus_argument.hpp"
#include "canvoy/tools/argument/node_argument.hpp"
#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/cli/meant_line.hpp"
#include "canvoy/tools/cli/spelling.hpp"
#include "canvoy/tools/node/ask_verbs.hpp"
#include "canvoy/tools/node/other_programs.hpp"
#include "canvoy/tools/node/word_order.hpp"
#include "canvoy/tools/play/world.hpp"

namespace canvoy::tools {

namespace {

using Words = std::vector<std::string>;

/// Words for what a verb works on, in front of the verb: `sdo read`, `node scan`.
constexpr auto nouns =
    std::to_array<std::string_view>({"sdo", "od", "object", "bus", "can", "node", "nodes",
                                     "network", "canopen", "trace", "frame", "frames", "log"});
/// Verbs with verbs below them.
constexpr auto groups = std::to_array<std::string_view>({"eds", "lss", "export", "nmt"});

bool has_ending(std::string_view word, std::initializer_list<std::string_view> endings) {
  return std::ranges::any_of(endings,
                             [word](std::string_view ending) { return word.ends_with(ending); });
}

bool is_one_of(std::string_view word, std::initializer_list<std::string_view> names) {
  return std::ranges::find(names, word) != names.end();
}

/// The verb with this other name; null: none has it.
const VerbWords* verb_called(std::string_view word) {
  const auto* const found = std::ranges::find_if(verb_words, [word](const VerbWords& verb) {
    return is_listed(word, verb.others) || is_listed(word, verb.told);
  });
  return found == verb_words.end() ? nullptr : found;
}

/// True for our name of a verb and for each other name of it.
bool is_any_verb_name(std::string_view word) {
  return is_verb_name(word) || verb_called(word) != nullptr;
}

/// `eds check` as two words.
Words words_of_verb(std::string_view name) {
  const std::size_t blank = std::min(name.find(' '), name.size());
  Words words = {std::string(name.substr(0, blank))};
  if (blank < name.size()) words.emplace_back(name.substr(blank + 1));
  return words;
}

/// The words behind the first one.
Words behind(const Words& words, std::size_t count = 1) {
  return {words.begin() + static_cast<std::ptrdiff_t>(count), words.end()};
}

Words line(std::initializer_list<std::string_view> first, const Words& rest) {
  Words made(first.begin(), first.end());
  made.insert(made.end(), rest.begin(), rest.end());
  return made;
}

// The order

/// `-v` has no effect: what is said does not depend on it.
bool is_loudness(std::string_view word) {
  return word == "-v" || word == "-vv" || word == "--verbose";
}

void put_in(Words& words, std::size_t at, const std::string& word) {
  words.insert(words.begin() + static_cast<std::ptrdiff_t>(std::min(at, words.size())), word);
}

/// What stands in front of the verb: places, and options with their values.
struct Front {
  Words places = {};
  Words options = {};
};

bool is_world(std::string_view word) {
  return word.ends_with(".toml") ||
         std::ranges::find(worlds(), word, &WorldEntry::name) != worlds().end();
}

/// What is done with a thing that stands alone, `night.log`, `pump.eds`, `yard.toml`, `lift`,
/// `18A#AC0001`; empty: it is not plain.
Words verb_of_thing(std::string_view word) {
  if (parse_frame(word)) return {"decode"};
  if (formats::names_trace(word)) return {"decode"};
  if (is_sheet_name(word)) return {"eds", "check"};
  return is_world(word) ? Words{"run"} : Words{};
}

/// The number of words there that belong in front of a verb; 0: the verb stands there.
std::size_t take_front(const Words& words, std::size_t at, Front& front) {
  const std::string& word = words[at];
  const bool has_value = at + 1 < words.size();
  if (word.starts_with('-') && has_value) {
    const std::string& value = words[at + 1];
    const bool is_node = is_one_of(word, {"-n", "--node", "--node-id"}) && find_node_id(value);
    const bool is_log = formats::names_trace(value) && !word.starts_with("--");
    if (is_node || is_log || names_bus(value)) {
      front.places.push_back(value);
      return 2;
    }
    const bool takes_value = is_one_of(word, {"--colour", "--color", "--network"});
    front.options.push_back(word);
    if (takes_value) front.options.push_back(value);
    return takes_value ? 2 : 1;
  }
  const bool is_verb = is_any_verb_name(word);
  // sim lift: run lift
  const bool is_place = !is_verb && (names_bus(word) || find_node_id(word));
  if (is_place) front.places.push_back(word);
  return is_place ? 1 : 0;
}

/// Returns the number of words in front of the verb.
std::size_t take_all_in_front(const Words& words, Front& front) {
  std::size_t at = 0;
  while (at < words.size() && !is_one_of(words[at], {"--help", "-h", "--version"})) {
    const std::size_t count = take_front(words, at, front);
    if (count == 0) break;
    at += count;
  }
  return at;
}

bool is_alone(const Words& words, std::size_t at) {
  return at + 1 == words.size() || words[at + 1].starts_with('-');
}

// Names that depend on what stands behind them

bool has_node(const Words& words) {
  return count_places(words) >= 2 && names_bus(words[1]) && find_node_id(words[2]).has_value();
}

/// `devices`, `list profiles`, `networks`: what there is, beside any bus.
void use_verb_of_list(Words& words) {
  const bool has_list = words.size() > 1 && is_one_of(words[0], {"list", "ls", "show"});
  const std::string& things = words[has_list ? 1 : 0];
  Words meant;
  if (is_one_of(things, {"devices", "kinds"})) meant = {"device", "--list"};
  if (things == "profiles") meant = {"profile"};
  if (is_one_of(things, {"worlds", "networks", "simulations"})) meant = {"run", "--help"};
  if (things == "demo") meant = {"run", "charger"};
  if (meant.empty()) return;
  const Words rest = behind(words, has_list ? 2 : 1);
  meant.insert(meant.end(), rest.begin(), rest.end());
  words = std::move(meant);
}

/// `sdo read`, `node scan`, `profile list`.
void leave_out_nouns(Words& words) {
  const bool has_noun = words.size() > 1 && std::ranges::find(nouns, words[0]) != nouns.end() &&
                        (is_any_verb_name(words[1]) || words[1] == "write");
  if (has_noun) erase_words(words, 0);
  if (words.size() > 2 && words[0] == "error" && is_one_of(words[1], {"history", "log", "list"})) {
    erase_words(words, 1);
  }
  // `validate eds pump.eds`
  const bool is_of_sheet =
      words.size() > 2 && words[1] == "eds" &&
      is_one_of(words[0], {"check", "validate", "lint", "verify", "info", "show", "diff", "compare",
                           "convert", "export", "read", "new", "create", "generate", "make"});
  if (is_of_sheet) std::swap(words[0], words[1]);
  const bool is_list = words.size() > 1 && is_one_of(words[1], {"list", "ls"});
  if (is_list && words[0] == "profile") erase_words(words, 1);
  if (is_list && words[0] == "device") words[1] = "--list";
}

template <std::size_t size>
bool is_in(const std::array<std::string_view, size>& names, std::string_view word) {
  return std::ranges::find(names, word) != names.end();
}

/// `check-eds` and `eds-check` as `eds check`, `read-sdo` as `read`.
void part_joined_name(Words& words) {
  const std::string name = words.front();
  const std::size_t dash = name.find('-');
  const bool is_one =
      dash == std::string::npos || dash == 0 || is_any_verb_name(name) || is_nmt_word(name);
  if (is_one) return;
  const std::string first = name.substr(0, dash);
  const std::string second = name.substr(dash + 1);
  if (is_in(groups, second)) {
    words.front() = first;
    words.insert(words.begin(), second);
  } else if (is_in(groups, first)) {
    words.front() = second;
    words.insert(words.begin(), first);
  } else if (is_in(nouns, second) && is_any_verb_name(first)) {
    words.front() = first;
  } else if (is_in(nouns, first) && is_any_verb_name(second)) {
    words.front() = second;
  }
}

/// `read can0 node 10 object 1018`, `explain abort 06010002`.
void leave_out_names_of_places(Words& words) {
  constexpr auto places =
      std::to_array<std::string_view>({"node", "node-id", "knoten", "object", "objekt", "index",
                                       "sub", "subindex", "sub-index", "value", "id", "to"});
  constexpr auto codes = std::to_array<std::string_view>(
      {"abort", "emcy", "emergency", "error", "sdo", "code", "state", "id", "cob-id", "object",
       "-a", "-e", "register", "is", "does", "the", "this"});
  const bool explains = words.front() == "explain";
  if (!explains && !is_ask_verb(words.front())) return;
  // what does 06010002 mean
  if (explains && words.size() > 2 && is_one_of(words.back(), {"mean", "means"})) words.pop_back();
  for (std::size_t at = words.size() - 1; at > 1 || (explains && at == 1); --at) {
    const bool is_name = explains ? is_in(codes, words[at]) : is_in(places, words[at]);
    // The last word is a value; `nmt can0 10 reset node` has a command.
    const bool is_value = at + 1 == words.size() || words[at - 1] == "reset";
    if (is_name && !is_value) erase_words(words, at);
  }
}

/// A verb of one node, by a name that others have for all of a bus.
bool use_verb_of_node(Words& words) {
  const std::string name = words.front();
  const Words rest = behind(words);
  if (!has_node(words)) return false;
  const std::size_t places = count_places(words);
  if (is_one_of(name, {"dump", "save", "backup", "dcf"})) {
    words = line({"eds", "read"}, rest);
  } else if (name == "watch" && places > 2) {
    words = line({"read"}, rest);
    words.emplace_back("--watch");
  } else if (is_one_of(name, {"errors", "error", "faults", "history"}) && places == 2) {
    words = line({"read"}, rest);
    put_in(words, 3, "1003");
  } else if (is_one_of(name, {"ping", "info", "show", "status", "identify", "identity"}) &&
             places == 2) {
    words = line({"read"}, rest);
    put_in(words, 3, "1000");
    if (name != "ping") put_in(words, 4, "1018");
  } else if (is_one_of(name, {"compare", "diff"}) && places == 3) {
    words = line({"configure"}, rest);
    words.emplace_back("--diff");
  } else if (name == "heartbeat" && places == 3 && parse_duration(rest[2])) {
    words = line({"write"}, rest);
    put_in(words, 3, "1017");
  } else if (name == "heartbeat" && places == 2) {
    words = line({"wait"}, {rest[0], "node=" + rest[1], "and", "heartbeat"});
  } else {
    return false;
  }
  return true;
}

/// A verb of a bus: `emcy can0` listens, where `emcy can0 10 8130` sends.
bool use_verb_of_bus(Words& words) {
  const bool is_of_bus = words.size() > 1 && count_places(words) == 1 && names_bus(words[1]);
  if (!is_of_bus) return false;
  const std::string name = words.front();
  const Words options = behind(words, 2);
  if (is_one_of(name, {"emcy", "emergency", "emergencies", "errors", "faults", "alarms"})) {
    words = line({"monitor", words[1], "--filter", "EMCY"}, options);
  } else if (is_one_of(name, {"heartbeat", "heartbeats"})) {
    words = line({"monitor", words[1], "--filter", "heartbeat"}, options);
  } else if (is_one_of(name, {"info", "show"})) {
    words.front() = "scan";
  } else {
    return false;
  }
  return true;
}

/// `export pump.eds out.dbc`: the end of the file says what is exported; empty: nothing does.
std::string table_to_export(const Words& words) {
  constexpr auto tables = std::to_array<std::string_view>({"dbc", "csv", "html"});
  const bool is_said = is_in(tables, words[1]);
  if (is_said || (!is_sheet_name(words[1]) && !names_bus(words[1]))) return {};
  for (const std::string& word : behind(words, 2)) {
    for (const std::string_view table : tables) {
      if (word.ends_with('.' + std::string(table))) return std::string(table);
    }
  }
  return {};
}

/// `download battery.dcf --node 10`, `write can0 10 battery.dcf`: a file is the last place.
bool is_configuration(const Words& words) {
  const std::size_t places = count_places(words);
  return places > 0 && is_sheet_name(words[places]) && (places == 1 || has_node(words));
}

bool use_verb_of_file(Words& words) {
  if (words.size() < 2) return false;
  const std::string name = words.front();
  const std::string& first = words[1];
  if (is_one_of(name, {"simulate", "sim", "emulate"})) {
    // A bus to be put on, or a network to be played.
    words.front() = is_world(first) && !names_bus(words.back()) ? "run" : "device";
  } else if (name == "log" && count_places(words) == 2 && names_bus(first)) {
    words.front() = "record";
  } else if ((name == "log" && formats::names_trace(first)) ||
             (name == "explain" && first.find('#') != std::string::npos)) {
    words.front() = "decode";
  } else if (is_one_of(name, {"filter", "grep"}) && count_places(words) == 2 &&
             (formats::names_trace(first) || formats::names_trace(words[2]))) {
    const bool is_log_behind = !formats::names_trace(first);  // as grep has it
    words = line({"decode", words[is_log_behind ? 2 : 1], "--filter", words[is_log_behind ? 1 : 2]},
                 behind(words, 3));
  } else if (name == "export" && first == "csv" && words.size() > 2 &&
             formats::names_trace(words[2])) {
    words = line({"decode", words[2], "--csv"}, behind(words, 3));
  } else if (is_one_of(name, {"info", "show"}) && formats::names_trace(first)) {
    words.front() = "stats";
  } else if (is_one_of(name, {"info", "show", "describe", "objects"}) &&
             find_profile(first) != nullptr) {
    words.front() = "profile";
  } else if (is_one_of(name, {"errors", "faults", "alarms", "emcy"}) &&
             formats::names_trace(first)) {
    words = line({"decode", first, "--filter", "EMCY"}, behind(words, 2));
  } else if (name == "export" && !table_to_export(words).empty()) {
    put_in(words, 1, table_to_export(words));
  } else if (is_one_of(name, {"download", "write"}) && is_configuration(words)) {
    words.front() = "configure";
  } else if (name == "search" && words.size() == 2 && first.starts_with("0x")) {
    words.front() = "explain";
  } else if (is_one_of(name, {"check", "test", "validate", "verify"}) && count_places(words) == 1 &&
             formats::names_trace(first)) {
    words.front() = "doctor";
  } else {
    return false;
  }
  return true;
}

bool use_verb_of_sheet(Words& words) {
  if (words.size() < 2 || words.front() != "eds") return false;
  const std::string& first = words[1];
  if (is_sheet_name(first)) {
    words.insert(words.begin() + 1, "check");
  } else if (is_one_of(first, {"info", "show", "validate", "lint", "verify"})) {
    words[1] = "check";
  } else if (first == "compare") {
    words[1] = "diff";
  } else if (is_one_of(first, {"new", "create", "generate", "make"})) {
    words[1] = "export";
  } else {
    return false;
  }
  return true;
}

/// The digits of a CAN-ID as a frame has them: 3, or 8 of 29 bits.
std::string digits_of_id(std::string_view digits) {
  return fmt::format("{:0>{}}", digits, digits.size() <= 3 ? 3 : 8);
}

/// A frame as people write it down: `decode 0x18A 01 02`, `explain 0x18A#0102`.
bool use_frame(Words& words) {
  const bool is_about_frame = words.size() > 1 && is_one_of(words[0], {"decode", "explain"});
  if (!is_about_frame || !words[1].starts_with("0x")) return false;
  const std::string first = words[1].substr(2);
  const std::size_t hash = first.find('#');
  std::string frame;
  if (hash != std::string::npos) {
    frame = digits_of_id(first.substr(0, hash)) + first.substr(hash);
    erase_words(words, 1);
  } else if (words[0] == "decode" && words.size() > 2) {
    frame = digits_of_id(first) + '#';
    erase_words(words, 1);
    while (words.size() > 1 && !words[1].starts_with('-')) {
      const std::size_t prefix = words[1].starts_with("0x") ? 2 : 0;
      frame += fmt::format("{:0>2}", words[1].substr(prefix));
      erase_words(words, 1);
    }
  }
  if (frame.empty()) return false;
  words[0] = "decode";
  words.insert(words.begin() + 1, frame);
  return true;
}

/// `convert a.log to a.asc`.
void leave_out_to(Words& words) {
  const bool has_to = words.size() > 3 && is_one_of(words[0], {"convert", "convert-log"}) &&
                      is_one_of(words[2], {"to", "into", "as"});
  if (has_to) erase_words(words, 2);
}

/// `reset can0 10 communication`: the other word of the command stands behind the node.
void join_nmt(Words& words) {
  if (words.size() > 1 && is_nmt_word(words[0] + '-' + words[1])) {
    words[0] += '-' + words[1];
    erase_words(words, 1);
  }
  if (words.front() != "reset") return;
  for (std::size_t at = 1; at <= count_places(words); ++at) {
    if (!is_nmt_word("reset-" + words[at])) continue;
    words[0] += '-' + words[at];
    erase_words(words, at);
    return;
  }
}

/// A word that is no verb, or one of another kind of thing: what there is for that kind.
void tell_by_kind(const Words& words) {
  if (words[std::min<std::size_t>(1, words.size() - 1)].ends_with(".dbc")) {
    throw UsageError(
        "a DBC is only written here: canvoy export dbc pump.eds; what a log says is read by "
        "profiles and data sheets: canvoy decode night.log --eds 10=pump.eds");
  }
  if (words.size() < 2) return;
  const std::string& name = words.front();
  const std::string& thing = words[1];
  const bool asks = is_ask_verb(name);
  std::vector<std::string> known;
  known.reserve(verb_words.size());
  for (const VerbWords& verb : verb_words) known.emplace_back(verb.name);
  const bool is_verb = is_any_verb_name(name) || is_nmt_word(name);
  const bool is_typo = !is_verb && !did_you_mean(name, known).empty();
  if (is_typo || (is_verb && !asks)) return;
  const std::string what =
      asks ? fmt::format("'{}' is of a bus", name) : fmt::format("'{}' is not known here", name);
  const auto tell = [&](std::string_view kind, std::string_view lines) {
    throw UsageError(
        fmt::format("{}; of {} there are {}", what, kind, fmt::format(fmt::runtime(lines), thing)));
  };
  if (formats::names_trace(thing)) {
    tell("a log", "canvoy decode {0}, canvoy stats {0}, canvoy doctor {0} and canvoy view {0}");
  }
  if (asks) return;
  if (is_sheet_name(thing)) tell("a data sheet", "canvoy eds check {0} and canvoy device {0} can0");
  if (has_node(words)) {
    tell("a node", fmt::format("canvoy read {{0}} {0} 1018, canvoy browse {{0}} {0} and canvoy eds "
                               "read {{0}} {0}",
                               words[2]));
  }
  if (names_bus(thing)) {
    tell("a bus", "canvoy scan {0}, canvoy monitor {0}, canvoy doctor {0} and canvoy view {0}");
  }
}

/// The line with our name of the verb.
void use_own_name(Words& words) {
  join_nmt(words);
  const std::string typed = words.front();
  const VerbWords* const other = is_nmt_word(typed) ? verb_called("start") : verb_called(typed);
  if (other == nullptr) return;
  std::string_view verb = other->name;
  if (verb == "convert-log" && words.size() > 1 && is_sheet_name(words[1])) verb = "eds convert";
  Words meant = behind(words);
  if (verb == "nmt") put_in(meant, count_places(words), words.front());
  const Words name = words_of_verb(verb);
  meant.insert(meant.begin(), name.begin(), name.end());
  // A program has no index.
  const bool is_object = typed == "download" && count_places(words) > 3;
  if (!is_listed(typed, other->told) || is_object) {
    words = std::move(meant);
    return;
  }
  throw UsageError(
      fmt::format("'{}' is not known here; {} does that: {}", typed, verb, typed_line(meant)));
}

}  // namespace

bool is_verb_name(std::string_view word) {
  return std::ranges::find(verb_words, word, &VerbWords::name) != verb_words.end();
}

bool is_sheet_name(std::string_view word) {
  return has_ending(word, {".eds", ".dcf", ".xdd", ".xdc", ".EDS", ".DCF"});
}

bool finds_verb(const Words& words) {
  Front front;
  const std::size_t at = take_all_in_front(words, front);
  if (at == words.size()) return !front.places.empty();
  return words[at].starts_with('-') || !line_from(words, at).empty();
}

std::vector<std::string> line_from(const Words& words, std::size_t at) {
  if (is_verb_name(words[at])) return behind(words, at);
  const VerbWords* const other = verb_called(words[at]);
  if (other == nullptr) {
    Words verb = is_alone(words, at) ? verb_of_thing(words[at]) : Words{};
    if (!verb.empty())
      verb.insert(verb.end(), words.begin() + static_cast<std::ptrdiff_t>(at), words.end());
    return verb;
  }
  Words verb = words_of_verb(other->name);
  const Words rest = behind(words, at + 1);
  verb.insert(verb.end(), rest.begin(), rest.end());
  return verb;
}

void put_verb_in_front(Words& words) {
  std::erase_if(words, is_loudness);
  Front front;
  const std::size_t at = take_all_in_front(words, front);
  if (at == words.size()) {
    if (front.places.empty()) return;
    Words verb = verb_of_thing(front.places.front());
    if (!verb.empty()) {
      verb.insert(verb.end(), front.places.begin(), front.places.end());
      verb.insert(verb.end(), front.options.begin(), front.options.end());
      words = std::move(verb);
      return;
    }
    if (!names_bus(front.places.front())) return;
    throw UsageError(
        fmt::format("which verb? canvoy monitor {0} shows its frames, canvoy scan {0} who is there",
                    front.places.front()));
  }
  const bool is_verb = is_any_verb_name(words[at]);
  if (front.places.empty() && is_alone(words, at) && !is_verb) {
    const Words verb = verb_of_thing(words[at]);
    words.insert(words.begin() + static_cast<std::ptrdiff_t>(at), verb.begin(), verb.end());
  }
  if (at == 0) return;
  Words meant = line({words[at]}, front.places);
  meant.insert(meant.end(), words.begin() + static_cast<std::ptrdiff_t>(at) + 1, words.end());
  meant.insert(meant.end(), front.options.begin(), front.options.end());
  words = std::move(meant);
}

void use_own_names(Words& words) {
  use_python_can_options(words);
  use_program(words);
  part_joined_name(words);
  use_verb_of_list(words);
  leave_out_nouns(words);
  leave_out_to(words);
  const bool is_done = use_frame(words) || use_verb_of_node(words) || use_verb_of_bus(words) ||
                       use_verb_of_sheet(words) || use_verb_of_file(words);
  if (!is_done) {
    tell_by_kind(words);
    use_own_name(words);
  }
  leave_out_names_of_places(words);
}

}  // namespace canvoy::tools
