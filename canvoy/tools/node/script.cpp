// canvoy script BUS FILE: runs lines of other verbs in sequence on one bus, with expectations; the
// exit status tells whether all were met.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <deque>
#include <functional>
#include <iostream>
#include <memory>

#include "canvoy/can/host/atomic_file.hpp"
#include "canvoy/sim/duration_text.hpp"
#include "canvoy/text/json_line.hpp"
#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/cli/spelling.hpp"
#include "canvoy/tools/cli/value_file.hpp"
#include "canvoy/tools/node/ask_options.hpp"
#include "canvoy/tools/node/ask_verbs.hpp"
#include "canvoy/tools/node/junit.hpp"
#include "canvoy/tools/node/script_devices.hpp"
#include "canvoy/tools/node/script_line.hpp"
#include "canvoy/tools/node/typed_options.hpp"
#include "canvoy/tools/node/word_order.hpp"

namespace canvoy::tools {

namespace {

struct ScriptOptions : AskOptions {
  std::string file = {};
  std::string junit = {};
  std::vector<std::string> sheets = {};  ///< FILE, or NODE=FILE
  bool keeps_going = false;
};

std::vector<std::string> buses_of(const ScriptOptions& options) {
  std::vector<std::string> buses;
  for (std::string_view rest = options.bus;;) {
    const std::size_t comma = rest.find(',');
    buses.emplace_back(rest.substr(0, comma));
    if (comma == std::string_view::npos) return buses;
    rest.remove_prefix(comma + 1);
  }
}

bool is_the_node(const std::string& word, NodeId node) {
  try {
    return parse_node_id(word) == node;
  } catch (const UsageError&) {
    return false;  // the verb of the line refuses it
  }
}

/// The data sheet for a node as a line has it: of this node, else of all. Empty if there is none.
std::string sheet_of(const std::vector<std::string>& sheets, const std::string& node) {
  std::string of_all;
  for (const std::string& sheet : sheets) {
    const std::size_t equals = sheet.find('=');
    if (equals == std::string::npos) {
      of_all = sheet;
    } else if (is_the_node(node, parse_node_id(sheet.substr(0, equals)))) {
      return sheet.substr(equals + 1);
    }
  }
  return of_all;
}

/// Adds the data sheet to a line whose verb takes one and that names none. `words` are verb, bus,
/// node and so on.
void add_sheet(std::vector<std::string>& words, const std::vector<std::string>& sheets) {
  constexpr std::array<std::string_view, 4> verbs = {"read", "write", "expect", "pdo"};
  constexpr std::array<std::string_view, 2> own = {"--eds", "--profile"};
  const bool takes_it = words.size() > 2 && std::ranges::find(verbs, words.front()) != verbs.end();
  if (!takes_it || std::ranges::find_first_of(words, own) != words.end()) return;
  const std::string sheet = sheet_of(sheets, words[2]);
  if (!sheet.empty()) words.insert(words.end(), {"--eds", sheet});
}

/// A line, and its parsed verb, before it is run.
class ScriptLine {
 public:
  ScriptLine(unsigned number, std::string text) : number_(number), text_(std::move(text)) {}

  unsigned number() const { return number_; }
  const std::string& text() const { return text_; }

  /// Throws UsageError if the line is not a valid call of a verb.
  void parse(std::vector<std::string> words, const ScriptOptions& options, Sessions& sessions,
             ScriptDevices& devices) {
    const std::vector<std::string> buses = buses_of(options);
    if (ScriptDevices::has_verb(words.front())) {
      const bool names_bus = words.size() > 1 && std::ranges::find(buses, words[1]) != buses.end();
      const std::string bus = names_bus ? words[1] : buses.front();
      if (names_bus) words.erase(words.begin() + 1);
      by_hand_ = devices.parse(words, bus, [&sessions, &options, bus]() -> Session& {
        return sessions.open(bus, options.answer_time());
      });
      return;
    }
    add_ask_verbs(line_, sessions);
    check_verb(words.front());
    const bool is_named = words.size() > 1 && std::ranges::find(buses, words[1]) != buses.end();
    if (!is_named && buses.size() > 1 && words.front() != "wait") {
      throw UsageError(fmt::format("on which bus? {} {} ...", words.front(), buses.front()));
    }
    if (!is_named) words.insert(words.begin() + 1, options.bus);
    order_words(words);
    words = with_known_options(std::move(words), line_);
    add_sheet(words, options.sheets);
    if (options.json) words.emplace_back("--json");
    using Kind = CommandLine::Outcome::Kind;
    const CommandLine::Outcome outcome = line_.parse(std::move(words));
    if (outcome.kind == Kind::answered) throw UsageError("a line has no --help");
    if (outcome.kind == Kind::refused) throw UsageError(outcome.text);
  }
  int run() const {
    if (!by_hand_) return line_.run();
    by_hand_();
    return exit_done;
  }

 private:
  /// Other verbs, such as monitor, are not allowed in a line.
  void check_verb(const std::string& verb) const {
    if (is_ask_verb(verb)) return;
    std::vector<std::string> names;
    for (const std::unique_ptr<Verb>& each : line_.verbs()) names.push_back(each->name());
    names.insert(names.end(), {"device", "set", "press"});
    throw UsageError(fmt::format("'{}' is no verb of a script: {}{}", verb, fmt::join(names, ", "),
                                 did_you_mean(verb, names)));
  }

  unsigned number_;
  std::string text_;
  CommandLine line_{"", "canvoy"};
  std::function<void()> by_hand_;  ///< empty: another verb
};

class Script {
 public:
  Script(const ScriptOptions& options, Sessions& sessions, const std::string& content)
      : options_(options) {
    unsigned number = 0;
    for (std::string_view rest = content; !rest.empty();) {
      const std::size_t end = std::min(rest.find('\n'), rest.size());
      add(++number, rest.substr(0, end), sessions);
      rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    if (lines_.empty()) throw UsageError(fmt::format("{}: there is no line in it", name()));
  }

  /// Runs the lines in sequence; after a failure the rest is skipped, unless it keeps going.
  JunitSuite run() {
    JunitSuite suite{.name = name()};
    for (const ScriptLine& line : lines_) {
      JunitCase& done = suite.cases.emplace_back(
          JunitCase{.name = fmt::format("line {}: {}", line.number(), line.text())});
      if (suite.has_failed() && !options_.keeps_going) {
        done.is_skipped = true;
        continue;
      }
      run(line, done);
    }
    return suite;
  }

  std::string name() const { return options_.file == "-" ? "stdin" : options_.file; }

 private:
  void add(unsigned number, std::string_view text, Sessions& sessions) {
    const auto words = script_words(text);
    const std::string where = fmt::format("{} line {}", name(), number);
    if (!words) throw UsageError(fmt::format("{}: a quote does not end", where));
    if (words->empty()) return;
    std::string trimmed(text.substr(text.find_first_not_of(" \t")));
    while (trimmed.ends_with('\r') || trimmed.ends_with(' ')) trimmed.pop_back();
    try {
      lines_.emplace_back(number, trimmed).parse(*words, options_, sessions, devices_);
    } catch (const UsageError& error) {
      throw UsageError(fmt::format("{}: {}", where, error.what()));
    }
  }

  void run(const ScriptLine& line, JunitCase& done) const {
    if (!options_.json) fmt::print("{:>3}  {}\n", line.number(), line.text());
    std::fflush(stdout);
    const auto begun = std::chrono::steady_clock::now();
    try {
      if (line.run() != exit_done) done.failure = "exit status 1";
    } catch (const Failure& failure) {
      done.failure = failure.what();
    }
    done.time = std::chrono::duration_cast<Duration>(std::chrono::steady_clock::now() - begun);
    if (options_.json) return print_json(line, done);
    if (!done.failure.empty()) {
      fmt::print("     {}{}\n", done.failure.starts_with("FAIL ") ? "" : "FAIL: ", done.failure);
    }
    std::fflush(stdout);
  }
  static void print_json(const ScriptLine& line, const JunitCase& done) {
    std::string text;
    text::JsonLine json(text);
    json.begin_object();
    json.key("event").text("line");
    json.key("line").number(line.number());
    json.key("duration_s").number(in_seconds(done.time));
    json.key("passed");
    json.written(done.failure.empty() ? "true" : "false");
    json.key("text").text(line.text());
    if (!done.failure.empty()) json.key("failure").text(done.failure);
    json.end_object();
    fmt::print("{}\n", text);
    std::fflush(stdout);
  }

  const ScriptOptions& options_;
  ScriptDevices devices_;
  std::deque<ScriptLine> lines_;
};

std::string read_script(const std::string& path) {
  if (path == "-") return {std::istreambuf_iterator<char>(std::cin), {}};
  const std::vector<std::uint8_t> bytes = read_value_file(path);
  return {bytes.begin(), bytes.end()};
}

void summarise(const ScriptOptions& options, const JunitSuite& suite) {
  const std::size_t failed = suite.failed();
  const std::size_t passed = suite.cases.size() - failed - suite.skipped();
  if (!options.json) {
    fmt::print("{} of {} lines passed", passed, suite.cases.size());
    fmt::print("{}{}\n", failed == 0 ? "" : fmt::format(", {} failed", failed),
               suite.skipped() == 0 ? "" : fmt::format(", {} not run", suite.skipped()));
    return;
  }
  std::string line;
  text::JsonLine json(line);
  json.begin_object();
  json.key("event").text("summary");
  json.key("lines").number(suite.cases.size());
  json.key("passed").number(passed);
  json.key("failed").number(failed);
  json.key("skipped").number(suite.skipped());
  json.end_object();
  fmt::print("{}\n", line);
}

/// All lines are parsed before the first is run.
int run_script(const ScriptOptions& options, Sessions& sessions) {
  Script script(options, sessions, read_script(options.file));
  for (const std::string& bus : buses_of(options)) sessions.open(bus, options.answer_time());
  const JunitSuite suite = script.run();
  summarise(options, suite);
  if (!options.junit.empty()) {
    const std::string text = junit_text(suite);
    write_value_file(options.junit,
                     {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
  }
  return suite.has_failed() ? exit_failed : exit_done;
}

}  // namespace

void add_script(Verb& app, Sessions& sessions) {
  const auto options = std::make_shared<ScriptOptions>();
  Verb& command = app.add_verb(
      "script", "Run lines of read, write, nmt, expect, wait and others on buses, and judge them");
  options->add_bus(command);
  command.add({
      {"file", options->file,
       "a line for each verb, without canvoy and the bus: 'nmt 10 operational'; of "
       "several buses with it: 'nmt can1 10 operational', 'wait heartbeat' for all; "
       "'device battery --node-id 10' plays a device until the end, 'set temperature=60' and "
       "'press hire' are hands on it (canvoy device --hands); # begins a comment; - for stdin",
       required},
      {"--junit", options->junit, "write a report, as JUnit has it, into this file"},
      {"--keep-going", options->keeps_going, "also behind a line that has failed"},
      {"--eds", options->sheets,
       "the data sheet of a node (10=pump.eds), or of all (pump.eds), for the lines of read, "
       "write, "
       "expect and pdo that name none",
       one_each},
  });
  options->add_json(command);
  command.add_examples(
      "  canvoy script can0 acceptance.canvoy --junit report.xml\n"
      "  printf 'sync can0\\nread can1 10 temperature\\nwait heartbeat within 5s\\n' | "
      "canvoy script can0,can1 -\n"
      "  printf 'nmt 10 start\\nexpect 10 temperature > -20degC within 2s\\n' | "
      "canvoy script can0 -");
  command.runs([options, &sessions] { return run_script(*options, sessions); });
}

}  // namespace canvoy::tools
