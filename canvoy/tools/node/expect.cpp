// canvoy expect BUS NODE OBJECT > VALUE within 2s, canvoy wait BUS ...: expectations on a node or a
// bus.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <memory>
#include <optional>

#include "canvoy/sim/duration_text.hpp"
#include "canvoy/text/text.hpp"
#include "canvoy/tools/argument/duration_argument.hpp"
#include "canvoy/tools/argument/object_argument.hpp"
#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/node/ask_options.hpp"
#include "canvoy/tools/node/ask_verbs.hpp"
#include "canvoy/tools/node/expectation.hpp"
#include "canvoy/tools/node/remote_object.hpp"
#include "canvoy/tools/watch/frame_printer.hpp"

namespace canvoy::tools {

namespace {

constexpr Duration poll_usual = 50ms;
constexpr Duration wait_usual = 10s;

// -- expect

struct ExpectOptions : AskOptions {
  std::vector<std::string> words = {};
  std::string interval = {};
  std::string type = {};
};

/// Last value of the object, and whether it was as expected.
struct Verdict {
  bool held = false;
  std::vector<std::uint8_t> bytes = {};
  Duration after{};
};

Verdict judge(const ExpectOptions& options, const Expectation& expected, const RemoteObject& object,
              Session& session) {
  const Duration interval = parse_duration_argument(options.interval, poll_usual);
  const Time begin = session.loop().now();
  const Time end = begin + expected.within.value_or(expected.holding.value_or(Duration{}));
  // Ends when it is true, or when it is false.
  const bool ends_with = !expected.holding.has_value();
  while (true) {
    Verdict verdict{.bytes = object.read(session)};
    verdict.held = expected.holds(object.entry(), verdict.bytes);
    const Time now = session.loop().now();
    verdict.after = now - begin;
    if (verdict.held == ends_with || now >= end) return verdict;
    session.run_for(std::min(interval, end - now));
  }
}

void report_verdict(const ExpectOptions& options, const RemoteObject& object,
                    const Verdict& verdict, const std::string& text) {
  if (!options.json) {
    if (verdict.held) {
      fmt::print("PASS {}, expected {}\n", text, fmt::join(options.words, " "));
    }
    return;
  }
  std::string line;
  text::JsonLine json(line);
  json.begin_object();
  json.key("event").text("expectation");
  object.append_place(json);
  object.append_value(json, line, verdict.bytes);
  json.key("held");
  json.written(verdict.held ? "true" : "false");
  json.key("text").text(text);
  json.end_object();
  fmt::print("{}\n", line);
}

Expectation expectation_of(const ExpectOptions& options) {
  return parse_expectation(fmt::format("{}", fmt::join(options.words, " ")));
}

/// What can be known of a line of a script before the first one is run.
void check_expecting(const ExpectOptions& options) {
  options.node_id();
  check_object(expectation_of(options).object, options.profile);
  if (!options.interval.empty()) parse_duration_argument(options.interval);
}

int expect_value(const ExpectOptions& options, Sessions& sessions) {
  const NodeId node = options.node_id();
  const Expectation expected = expectation_of(options);
  Session& session = options.open(sessions);
  const RemoteObject object(session, node, expected.object, options.profile, options.type);
  const Verdict verdict = judge(options, expected, object, session);
  const std::string said =
      fmt::format("{}: {} = {}", text::node_text(node), object.name(), object.text(verdict.bytes));
  report_verdict(options, object, verdict, said);
  if (verdict.held) return exit_done;
  const bool was_waited_for = expected.within || expected.holding;
  const std::string when =
      was_waited_for ? fmt::format(" after {}", text::duration_text(verdict.after)) : "";
  throw Failure(fmt::format("FAIL {}{}, expected {}", said, when, fmt::join(options.words, " ")));
}

// -- wait

/// Its time-out is how long it waits.
struct WaitOptions : AskOptions {
  std::vector<std::string> words = {};
  std::vector<std::string> profiles = {};
};

/// A session that other verbs use too, or for several buses, one that listens to all from now on.
class WaitSession {
 public:
  WaitSession(const WaitOptions& options, Sessions& sessions) {
    const bool has_several = options.bus.find(',') != std::string::npos;
    session_ = has_several ? &own_.emplace(options.bus) : &options.open(sessions);
  }

  Session* operator->() const { return session_; }
  template <class Hears>
  void hear(Hears hears) {
    if (!own_) {
      const std::string name(session_->bus().name());
      return session_->hear([=](const host::BusFrame& heard) { hears(name, heard); });
    }
    for (host::HostBus* bus : own_->buses()) {
      const std::string name(bus->name());
      bus->on_frame([=](const host::BusFrame& heard) { hears(name, heard); });
    }
  }

 private:
  std::optional<Session> own_;
  Session* session_ = nullptr;
};

void wait_time(const WaitOptions& options, Sessions& sessions, Duration time) {
  WaitSession(options, sessions)->run_for(time);
}

/// Waits until a frame passes the filter.
void wait_frame(const WaitOptions& options, Sessions& sessions, std::string filter) {
  const Duration within = take_span(filter, "within").value_or(options.time_out_of(wait_usual));
  FramePrinterOptions wanted;
  wanted.filters = {filter};
  wanted.nodes = options.profiles;
  wanted.json = options.json;
  FramePrinter printer(wanted);
  WaitSession session(options, sessions);
  std::string lines;
  session.hear([&](const std::string& bus, const host::BusFrame& heard) {
    const Duration time = session->loop().epoch() + heard.time.time_since_epoch();
    if (!lines.empty() || !printer.append(lines, time, bus, heard.frame)) return;
    session->loop().stop();
  });
  session->run_for(within);
  session->hear({});
  if (lines.empty()) {
    throw Failure(
        fmt::format("no frame passes '{}' within {}", filter, text::duration_text(within)));
  }
  fmt::print("{}", lines);
}

int wait_for(const WaitOptions& options, Sessions& sessions) {
  const std::string text = fmt::format("{}", fmt::join(options.words, " "));
  if (const auto time = parse_duration(text)) {
    wait_time(options, sessions, *time);
  } else {
    wait_frame(options, sessions, text);
  }
  return exit_done;
}

}  // namespace

void add_expect(Verb& app, Sessions& sessions) {
  const auto options = std::make_shared<ExpectOptions>();
  Verb& command = app.add_verb(
      "expect", "See whether an object of a node is as expected, or becomes so in time");
  options->add_bus(command);
  options->add_any_node(command);
  command.add({
      {"condition", options->words,
       "OBJECT = VALUE, with =, !=, <, <=, > or >=, or OBJECT in FROM..TO; within 2s: it may "
       "take so long; for 2s: it has to stay so",
       required},
      {"--every", options->interval, "how often it is read (default 50ms)"},
      {"--type", options->type, "of an object that no profile knows: u16, vs, ..."},
  });
  options->add_profile(command);
  options->add_time_out(command);
  options->add_json(command);
  command.add_examples(
      "  canvoy expect can0 10 'temperature > -20degC within 2s'\n"
      "  canvoy expect can0 10 'battery_voltage < 60 V' --json\n"
      "  canvoy expect can0 10 'temperature in 15..30degC'\n"
      "  canvoy expect can0 10 'temperature < 60degC for 300ms' --every 100ms");
  command.when_parsed([options] { check_expecting(*options); });
  command.runs([options, &sessions] { return expect_value(*options, sessions); });
}

void add_wait(Verb& app, Sessions& sessions) {
  const auto options = std::make_shared<WaitOptions>();
  Verb& command = app.add_verb("wait", "Wait for a frame on a bus, or for some time");
  options->add_bus(command);
  command.add({
      {"what", options->words,
       "500ms, or a filter as that of monitor: 'heartbeat and node=10 within 5s' "
       "(default: within 10s)",
       required},
      {"--node", options->profiles, "which profile a node has: 5=419"},
      {"--timeout", options->time_out, "as within: 5s", checked_by(wrong_duration)},
  });
  options->add_json(command);
  command.add_examples(
      "  canvoy wait can0 200ms\n"
      "  canvoy wait can0 'heartbeat and node=10 within 5s'\n"
      "  canvoy wait can0,can1 'heartbeat within 5s'\n"
      "  canvoy wait can0 'temperature > -20' --node 10=418 --json");
  command.runs([options, &sessions] { return wait_for(*options, sessions); });
}

}  // namespace canvoy::tools
