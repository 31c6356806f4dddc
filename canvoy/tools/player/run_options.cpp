#include "canvoy/tools/player/run_options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>

#include "canvoy/tools/argument/duration_argument.hpp"
#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/cli/spelling.hpp"
#include "canvoy/tools/session/session.hpp"
#include "canvoy/tools/watch/log_writer.hpp"
#include "canvoy/web/request_target.hpp"

namespace canvoy::tools {

namespace {

/// True if it is written to a file instead of shown.
bool is_of_report(const Verb& command) {
  const Verb* const parent = command.parent();
  return command.name() == "report" || (parent != nullptr && parent->name() == "report");
}

/// `canvoy run lift --lifts 4`: the options that select the run, except for the seed.
std::string command_of(const Verb& command, const RunOptions& options) {
  constexpr std::array left_out = {
      "--seed", "--speed", "--web",   "--allow-write",    "--out",
      "--log",  "--json",  "--print", "--help",           "--allow-record",
      "--link", "--fault", "--act",   "--require-decided"};
  std::string text;
  for (const Verb* verb = &command; verb != nullptr; verb = verb->parent()) {
    const std::string name = verb->name();
    text.insert(0, (name == "report" ? "run" : name) + (text.empty() ? "" : " "));
  }
  for (const OptionInfo& option : command.options()) {
    if (std::ranges::find(left_out, option.name) != left_out.end()) continue;
    for (const std::string& value : option.said) {
      if (!option.is_place) text += " " + option.name;
      if (!option.is_flag) text += " " + value;
    }
  }
  for (const std::string& fault : options.faults) text += " --fault " + fault;
  for (const std::string& act : options.acts) text += " --act " + act;
  return text;
}

/// `http://127.0.0.1:8080/#seed=7&fault=pilot-loss@1min`: the part after the # selects the run.
struct RunLink {
  std::uint64_t seed = 0;
  std::vector<std::string> faults = {};
  std::vector<std::string> acts = {};
};
std::optional<RunLink> parse_link(const std::string& text) {
  const std::size_t mark = text.find('#');
  const std::optional<web::RequestTarget> target =
      mark == std::string::npos ? std::nullopt : web::parse_target("/?" + text.substr(mark + 1));
  const std::string_view seed = target ? target->value("seed").value_or("") : "";
  RunLink link;
  const auto [stop, error] = std::from_chars(seed.data(), seed.data() + seed.size(), link.seed);
  if (!target || seed.empty() || error != std::errc{} || stop != seed.data() + seed.size()) {
    return std::nullopt;
  }
  for (const auto& [name, value] : target->query) {
    if (name == "fault") link.faults.push_back(value);
    if (name == "act") link.acts.push_back(value);
  }
  return link;
}
std::string a_link(const std::string& text) {
  return parse_link(text) ? "" : "give what Share this run says: http://.../#seed=1";
}

/// Replaces the message of the library, which gives 2^64 in decimal places.
std::string whole_number(const std::string& text) {
  std::uint64_t value = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error == std::errc{} && stop == end) return {};
  return fmt::format("'{}' is no whole number from 0 to {}", text, UINT64_MAX);
}

/// Suggestion for an unknown fault.
std::string meant_fault(const FaultGrammar& grammar, const std::string& text) {
  const std::string name = text.substr(0, text.find_first_of("@:"));
  std::vector<std::string> names;
  for (const FaultRow& kind : grammar.kinds) {
    if (kind.name == name) return {};  // another error
    names.emplace_back(kind.name);
  }
  return did_you_mean(name, names);
}

}  // namespace

AnyFault parse_run_fault(const FaultGrammar& grammar, const std::string& text, Time end) {
  const FaultParse parsed = parse_fault(grammar, text);
  if (!parsed.fault) throw UsageError(parsed.error + meant_fault(grammar, text));
  if (parsed.fault->start >= end) {
    throw UsageError(fmt::format("fault '{}' begins after the end: run longer, with --for", text));
  }
  return *parsed.fault;
}

namespace {

void add_show_options(Verb& command, RunOptions& options) {
  command.add({
      {"--speed", options.speed,
       "times faster than the clock; 0: as fast as it goes, the default where no terminal "
       "shows it",
       between(0.0, 1e6)},
      {"--log", options.log, log_option_text("write all frames as a log")},
      {"--json", options.json, "events and values, one JSON object a line"},
      {"--require-decided", options.require_decided,
       "exit status 3 where all held, but something was never there to be judged"},
      {"--print", options.print,
       "print the network as a file that `canvoy run FILE` plays, and end"},
      {"--allow-write", options.allow_write,
       "what people at the page may write and command by SDO and NMT: all, or a "
       "list as nmt,1017,6000-67FF,10:6010 (default: nothing)"},
      {"--allow-record", options.allow_record,
       "a folder for logs that people at the page begin by a button, as "
       "canvoy-1.log (default: they begin none)"},
      {"--web", options.web,
       "a page of it in the browser, to watch, play with and break: at a port of this "
       "machine (default: a free one), or an address that others reach as well",
       may_be_bare},
  });
}

/// Sets what follows from all options.
void complete(const Verb& command, RunOptions& options) {
  if (const std::optional<RunLink> link = parse_link(options.link)) {
    options.seed = link->seed;
    options.faults.insert(options.faults.end(), link->faults.begin(), link->faults.end());
    options.acts.insert(options.acts.end(), link->acts.begin(), link->acts.end());
  }
  options.command = command_of(command, options);
  const bool is_web = !is_of_report(command) && command.count("--web") != 0;
  if (is_web && !options.web) options.web.emplace();
}

}  // namespace

void add_run_options(Verb& command, RunOptions& options, const std::string& fault_help) {
  command.add({
      {"--for", options.duration, "virtual time: 30s, 10min, 8h"},
      {"--seed", options.seed, "of all that is left to chance (default 1)",
       checked_by(whole_number)},
      {"--fault", options.faults, fault_help, one_each},
      {"--act", options.acts,
       "what a person did, as Share of the page says it; one of " + std::string(act_forms),
       one_each},
      {"--link", options.link, "a link of the page: its seed, its faults, and what was done",
       checked_by(a_link)},
  });
  if (is_of_report(command)) {
    command.add({{"--out",
                  options.report,
                  "write the page into this file",
                  {.is_required = command.name() != "report"}}});
  } else {
    add_show_options(command, options);
  }
  command.when_parsed([&command, &options] { complete(command, options); });
}

PlayOptions play_options(const RunOptions& options, Duration duration) {
  PlayOptions play;
  play.duration = options.duration ? parse_duration_argument(*options.duration) : duration;
  play.log = options.log;
  play.speed = options.speed;
  play.json = options.json;
  play.require_decided = options.require_decided;
  return play;
}

void take_real_bus(TomlTable& table, BusIndex bus, std::vector<RealBus>& real) {
  std::string address;
  table.take("real", address);
  if (!table.has("real")) return;
  try {
    static_cast<void>(real_bus(address));
  } catch (const Failure& failure) {
    table.refuse("real", failure.what());
  }
  real.push_back({bus, address});
}

}  // namespace canvoy::tools
