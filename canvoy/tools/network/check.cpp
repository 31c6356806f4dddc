// canvoy check BUS NODE: conformance of a device to CiA 301, its data sheet and its profile.
#include <fmt/chrono.h>
#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <deque>
#include <fstream>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "canvoy/can/host/atomic_file.hpp"
#include "canvoy/can/host/event_loop.hpp"
#include "canvoy/can/host/host_bus.hpp"
#include "canvoy/formats/plain_text.hpp"
#include "canvoy/profiles/registry.hpp"
#include "canvoy/text/check/bench/bench.hpp"
#include "canvoy/text/check/report_text.hpp"
#include "canvoy/tools/argument/profile_argument.hpp"
#include "canvoy/tools/cli/commands.hpp"
#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/cli/value_file.hpp"
#include "canvoy/tools/node/ask_options.hpp"
#include "canvoy/tools/node/junit.hpp"
#include "canvoy/tools/session/session.hpp"
#include "canvoy/tools/sheet/sheet_file.hpp"
#include "canvoy/tools/terminal/message.hpp"
#include "canvoy/version.hpp"

namespace canvoy::tools {

namespace {

// Performs the requests of a conformance test at a device and answers its questions: a person at
// the terminal, or a file with a command for each request.
//
//     CheckHands hands("hands.txt");
//     hands.answer({.words = "press the alarm key"});   // runs the command of that line

class CheckHands {
 public:
  /// `source` is `-` for a person, or a file of lines `request = command`; blanks around both are
  /// ignored, and a line that begins with # is a comment. `wait` returns when standard input is
  /// readable. Throws Failure if the file cannot be read, or a line is not valid.
  CheckHands(const std::string& source, std::function<void()> wait);

  /// Exit status of a command: 0 if done or true, 1 if not true. Any other status, or a request
  /// without a command, means not possible.
  conformance::HandAnswer answer(const conformance::HandRequest& request);

 private:
  conformance::HandAnswer ask_person(const conformance::HandRequest& request);

  bool is_person_;
  std::function<void()> wait_;
  std::map<std::string, std::string, std::less<>> commands_;
};

using conformance::HandAnswer;
using conformance::HandRequest;

std::map<std::string, std::string, std::less<>> read_commands(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw Failure(fmt::format("{}: cannot be read: check the path", path));
  std::map<std::string, std::string, std::less<>> commands;
  std::string text;
  for (unsigned number = 1; std::getline(file, text); ++number) {
    const std::string_view line = formats::trimmed(text);
    if (line.empty() || line.front() == '#') continue;
    const std::size_t equals = line.find('=');
    const std::string request(formats::trimmed(line.substr(0, equals)));
    const std::string command(
        equals == std::string_view::npos ? "" : formats::trimmed(line.substr(equals + 1)));
    if (request.empty() || command.empty()) {
      throw Failure(fmt::format("{}:{}: a line is `request = command`", path, number));
    }
    if (!commands.emplace(request, command).second) {
      throw Failure(
          fmt::format("{}:{}: there is a command for '{}' already", path, number, request));
    }
  }
  if (file.bad()) throw Failure(fmt::format("{}: cannot be read: is it a file?", path));
  return commands;
}

/// Reads standard input byte by byte: what follows the line is for the next question. Nothing at
/// its end.
std::optional<std::string> read_line(const std::function<void()>& wait) {
  constexpr std::size_t line_max = 1000;
  std::string line;
  while (line.size() < line_max) {
    wait();
    char byte = 0;
    if (::read(STDIN_FILENO, &byte, 1) != 1) return std::nullopt;
    if (byte == '\n') return line;
    line += byte;
  }
  return line;
}

HandAnswer run_command(const std::string& command, bool is_question) {
  // A command of the user, from a file that the user has named.
  const int status = std::system(command.c_str());  // NOLINT(cert-env33-c,concurrency-mt-unsafe)
  if (status == -1 || !WIFEXITED(status)) return HandAnswer::cannot;
  if (WEXITSTATUS(status) == 0) return HandAnswer::done;
  return is_question && WEXITSTATUS(status) == 1 ? HandAnswer::no : HandAnswer::cannot;
}

CheckHands::CheckHands(const std::string& source, std::function<void()> wait)
    : is_person_(source == "-"), wait_(std::move(wait)) {
  if (!is_person_) commands_ = read_commands(source);
}

HandAnswer CheckHands::ask_person(const HandRequest& request) {
  if (request.is_question) {
    fmt::print("Look whether {}: Enter if so, n if not, ? if nobody can see it: ", request.words);
  } else {
    fmt::print("Please {}, then Enter; ? if nobody can: ", request.words);
  }
  std::fflush(stdout);
  const std::optional<std::string> said = read_line(wait_);
  if (!said) return HandAnswer::cannot;
  const std::string_view line = formats::trimmed(*said);
  if (line.empty() || line == "y") return HandAnswer::done;
  return line == "n" && request.is_question ? HandAnswer::no : HandAnswer::cannot;
}

HandAnswer CheckHands::answer(const HandRequest& request) {
  if (is_person_) return ask_person(request);
  const auto found = commands_.find(request.words);
  if (found == commands_.end()) return HandAnswer::cannot;
  std::fflush(stdout);
  return run_command(found->second, request.is_question);
}

/// Differs from the status of a verb that could not run.
constexpr int exit_not_conforming = 4;

struct CheckVerbOptions {
  AskOptions ask;
  std::string sheet;
  std::string profile;
  std::string only;
  std::string json;
  std::string junit;
  std::string html;
  std::string hands;
  bool lists = false;
  bool moves = false;
  bool stores = false;
  bool tells_all = false;
};

/// A real bus as the line of a test.
class BusLine {
 public:
  explicit BusLine(const std::string& bus)
      : loop_(value_or_throw(host::EventLoop::create())),
        bus_(value_or_throw(host::open_bus(*loop_, real_bus(bus)))) {
    bus_->on_frame([this](const host::BusFrame& heard) {
      if (heard.origin == host::Origin::elsewhere && !heard.frame.is_error()) keep(heard);
      loop_->stop();
    });
    bus_->on_trouble(
        [](const host::Error& error) { print_message(fmt::format("canvoy: {}", error.line())); });
    ok_or_throw(loop_->stop_on_signals());
  }

  conformance::Line line() {
    return {.send = [this](const Frame& frame) { return send(frame); },
            .next = [this](Time until) { return next(until); },
            .now = [this] { return loop_->now(); },
            .is_interrupted = [this] { return loop_->signal() != 0; }};
  }
  bool is_interrupted() const { return loop_->signal() != 0; }
  /// Waits until standard input is readable, or an interruption; received frames are kept. A file
  /// is always readable.
  void wait_for_input() {
    bool is_readable = false;
    auto ready = [this, &is_readable](host::Readiness) {
      is_readable = true;
      loop_->stop();
    };
    const auto watch =
        loop_->watch(STDIN_FILENO, {.readable = true}, Callback<void(host::Readiness)>::of(ready));
    if (!watch) return;
    while (!is_readable && !is_interrupted()) loop_->run();
    loop_->unwatch(*watch);
  }

 private:
  /// On a bus with more frames, the oldest are dropped.
  static constexpr std::size_t waiting_max = 20'000;
  static constexpr Duration sending_max = 1s;

  void keep(const host::BusFrame& heard) {
    waiting_.push_back({heard.time, heard.frame});
    if (waiting_.size() > waiting_max) waiting_.pop_front();
  }
  bool send(const Frame& frame) {
    const std::uint64_t sent = bus_->counters().sent;
    if (!bus_->send(frame)) return false;
    const Time until = loop_->now() + sending_max;
    while (bus_->counters().sent == sent && loop_->now() < until) {
      loop_->run_until(until);
    }
    return bus_->counters().sent != sent;
  }
  std::optional<conformance::Heard> next(Time until) {
    // Each frame ends one run of the loop.
    for (bool is_first = true; waiting_.empty(); is_first = false) {
      if (!is_first && loop_->now() >= until) return std::nullopt;
      loop_->run_until(until);
    }
    if (waiting_.front().time > until && loop_->now() >= until) return std::nullopt;
    const conformance::Heard heard = waiting_.front();
    waiting_.pop_front();
    return heard;
  }

  std::unique_ptr<host::EventLoop> loop_;
  std::unique_ptr<host::HostBus> bus_;
  std::deque<conformance::Heard> waiting_;
};

void write_text(const std::string& path, std::string_view text) {
  if (path.empty()) return;
  write_value_file(path, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

/// A report that cannot be written is told before the test, which may take minutes.
void refuse_unwritable(const CheckVerbOptions& options) {
  for (const std::string* path : {&options.json, &options.junit, &options.html}) {
    if (!path->empty()) static_cast<void>(value_or_throw(host::AtomicFile::begin(*path)));
  }
}

std::string junit_of(const conformance::Report& report, const std::string& name) {
  JunitSuite suite{.name = name};
  for (const conformance::TestResult& each : report.results) {
    suite.cases.push_back(
        {.name = fmt::format("{} {}", each.test->id, each.test->title), .time = each.took});
    if (each.verdict.outcome == conformance::Outcome::failed) {
      suite.cases.back().failure = fmt::format("{} ({}; expected: {})", each.verdict.why,
                                               each.test->clause, each.test->expects);
    }
    suite.cases.back().is_skipped = each.verdict.outcome == conformance::Outcome::not_applicable;
  }
  return junit_text(suite);
}

/// The named profile, or that of 1000h of the sheet, or of the device.
const Profile* profile_of(const CheckVerbOptions& options, BusLine& bus, NodeId node) {
  if (!options.profile.empty()) return &parse_profile(options.profile);
  conformance::Bench bench(bus.line(), node, {});
  const auto type = bench.number(0x1000, 0);
  const Profile* profile = type ? find_profile(*type) : nullptr;
  return profile == &base_profile() ? nullptr : profile;
}

[[noreturn]] void throw_no_case(const std::string& only) {
  throw UsageError(fmt::format(
      "--only {}: no case begins so; see canvoy check --list, with the --profile of the device",
      only));
}

int list_cases(const CheckVerbOptions& options) {
  const Profile* profile = options.profile.empty() ? nullptr : &parse_profile(options.profile);
  conformance::TestCases cases = conformance::all_cases(profile);
  std::erase_if(cases, [&options](const conformance::TestCase& each) {
    return !conformance::is_selected(each, options.only);
  });
  if (cases.empty()) throw_no_case(options.only);
  if (!options.json.empty()) {
    write_text(options.json, conformance::list_json(cases));
    return exit_done;
  }
  fmt::print("{}", conformance::list_text(cases));
  return exit_done;
}

void show_result(const CheckVerbOptions& options, const conformance::TestResult& result) {
  if (!options.tells_all && result.verdict.outcome != conformance::Outcome::failed) return;
  fmt::print("{}", conformance::result_text(result));
  std::fflush(stdout);
}

/// Empty without a person or file.
std::function<conformance::HandAnswer(const conformance::HandRequest&)> hand_of(
    std::optional<CheckHands>& hands) {
  if (!hands) return {};
  return [&hands](const conformance::HandRequest& request) { return hands->answer(request); };
}

int check_device(const CheckVerbOptions& options) {
  const NodeId node = options.ask.node_id();
  const Duration time_out = options.ask.answer_time().usual;
  std::optional<formats::DataSheet> sheet;
  formats::Findings findings;
  if (!options.sheet.empty()) sheet = read_sheet_file(options.sheet, findings);
  refuse_unwritable(options);
  BusLine bus(options.ask.bus);
  std::optional<CheckHands> hands;
  if (!options.hands.empty()) {
    hands.emplace(options.hands, [&bus] { bus.wait_for_input(); });
  }
  const Profile* profile = profile_of(options, bus, node);
  const conformance::ReportHead head{
      .bus = options.ask.bus,
      .bit_rate = bit_rate_of(options.ask.bus, 0),
      .sheet = options.sheet,
      .profile = profile == nullptr ? std::string() : std::string(profile->name),
      .version = std::string(version),
      .date = fmt::format("{:%Y-%m-%d %H:%M} UTC", fmt::gmtime(std::chrono::system_clock::now())),
      .moves = options.moves};
  conformance::Check check(bus.line(), node,
                           {.time_out = time_out,
                            .moves = options.moves,
                            .stores = options.stores,
                            .sheet = sheet ? &*sheet : nullptr,
                            .profile = profile,
                            .hand = hand_of(hands)});
  const conformance::Report report =
      check.run([&options](const conformance::TestResult& result) { show_result(options, result); },
                options.only);
  if (bus.is_interrupted()) {
    for (const std::string& note : report.notes) print_message(fmt::format("canvoy: {}", note));
    throw Failure("interrupted: the device is as it was, but for what is said above");
  }
  if (!report.has_answered) {
    throw Failure(
        fmt::format("node {} on {}: no answer to an SDO request; is the node on it, with "
                    "power and this node-ID, and not stopped (canvoy nmt {} {} pre-operational)?",
                    unsigned{node}, options.ask.bus, options.ask.bus, unsigned{node}));
  }
  if (report.results.empty() && report.is_whole) {
    throw_no_case(options.only);
  }
  fmt::print("{}", conformance::summary_text(head, report));
  write_text(options.json, conformance::report_json(head, report));
  write_text(options.junit,
             junit_of(report, fmt::format("canvoy check {} {}", options.ask.bus, unsigned{node})));
  write_text(options.html, conformance::report_html(head, report));
  if (!report.is_whole) return exit_failed;
  return report.count(conformance::Outcome::failed) == 0 ? exit_done : exit_not_conforming;
}

}  // namespace

void add_check(Verb& app) {
  const auto options = std::make_shared<CheckVerbOptions>();
  Verb& command =
      app.add_verb("check", "Test whether a device conforms to CiA 301 and its profile");
  command.add({
      {"bus", options->ask.bus, bus_text},
      {"node", options->ask.node, "10, 0x0A, 0Ah, or its name in the file of --network"},
      {"--eds", options->sheet, "its data sheet: EDS, DCF, XDD or XDC"},
      {"--profile", options->profile, "447-3, 419 (default: what the node's 1000h says)"},
      {"--only", options->only, "cases whose name begins so, or a class: sdo, tpdo-04, behaviour"},
      {"--moves", options->moves, "objects of the application may be written: a machine may move"},
      {"--stores", options->stores, "what the device keeps without power may change: 1010h, 1011h"},
      {"--hands", options->hands,
       "who moves and looks: - asks at the terminal; a file has a line `request = command` each"},
      {"--all", options->tells_all, "tell what has passed, and what does not apply and why"},
      {"--list", options->lists, "show all cases, with their clauses, and try none"},
      {"--json", options->json, "write a report into this file, one JSON object a line"},
      {"--junit", options->junit, "write a report, as JUnit has it, into this file"},
      {"--html", options->html, "write a report as a page into this file"},
  });
  options->ask.add_time_out(command);
  command.set_footer(
      "The device is commanded by NMT, reset, and started; parameters that are changed are put\n"
      "back. Try it on a bench: what it starts, it does. Nobody else on the bus is commanded.\n"
      "The exit status is 0 where all cases passed that apply, and 4 where one failed.\n"
      "Examples:\n"
      "  canvoy check can0 10 --eds battery.eds\n"
      "  canvoy check can0 10 --only sdo --all\n"
      "  canvoy check can0 10 --eds battery.eds --junit check.xml --html check.html\n"
      "  canvoy check can0 5 --only behaviour --moves --hands -\n"
      "  canvoy check --list --profile 447-3");
  command.runs([options] {
    if (options->lists) return list_cases(*options);
    if (options->ask.bus.empty() || options->ask.node.empty()) {
      throw UsageError(
          "canvoy check BUS NODE: which device? (canvoy check --list shows the cases)");
    }
    return check_device(*options);
  });
}

}  // namespace canvoy::tools
