// canvoy lss BUS COMMAND: finds nodes without node-ID, and assigns node-IDs and bit rates (CiA
// 305).
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <memory>
#include <optional>

#include "canvoy/can/host/can_link.hpp"
#include "canvoy/text/text.hpp"
#include "canvoy/tools/argument/duration_argument.hpp"
#include "canvoy/tools/cli/commands.hpp"
#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/cli/json_event.hpp"
#include "canvoy/tools/cli/spelling.hpp"
#include "canvoy/tools/cli/verb_help.hpp"
#include "canvoy/tools/network/lss_argument.hpp"
#include "canvoy/tools/network/lss_session.hpp"
#include "canvoy/tools/session/session.hpp"
#include "canvoy/tools/terminal/message.hpp"

namespace canvoy::tools {

namespace {

struct LssOptions {
  std::string bus;
  std::string command;
  std::string value;
  std::string select;
  std::string assign;
  std::string only;
  std::string bit_rate;
  bool store = false;
  bool json = false;
  std::string time_out_text = {};
  std::string first_time_out_text = {};

  AnswerTime time_out() const { return parse_answer_time(time_out_text); }
  Duration first_time_out() const { return parse_duration_argument(first_time_out_text, 100ms); }
};

/// Less would be below the resolution of an operating system.
constexpr Duration bit_time_out_min = 10ms;

void say(const std::string& line) {
  fmt::print("{}\n", line);
  std::fflush(stdout);
}

/// Keys of an address, as in `canvoy scan`.
void add_address(JsonEvent& event, const LssAddress& address) {
  constexpr std::array<std::string_view, 4> parts = {"vendor_id", "product_code", "revision",
                                                     "serial_number"};
  for (std::size_t i = 0; i < parts.size(); ++i)
    event->key(parts.at(i)).text(fmt::format("{:08X}", address.parts.at(i)));
}

void report_setting(const LssOptions& options, std::string_view what, std::uint32_t value,
                    const std::string& text) {
  if (!options.json) return say(text + (options.store ? ", stored" : ""));
  JsonEvent event("configured");
  if (value == 0) {
    event->key(what).null();
  } else {
    event->key(what).number(value);
  }
  event->key("stored").truth(options.store);
  event.print();
}

std::optional<LssAddress> selected_address(const LssOptions& options) {
  if (options.select.empty()) return std::nullopt;
  return parse_lss_address(options.select);
}

/// Switches one node to state configuration, and always back to waiting at the end.
class ConfiguredNode {
 public:
  explicit ConfiguredNode(const LssOptions& options)
      : ConfiguredNode(selected_address(options), options) {
    session_.switch_global(LssState::waiting);
    if (address_) {
      session_.select(*address_);
    } else {
      session_.switch_global(LssState::configuration);
      session_.require_one_node();
    }
  }
  ~ConfiguredNode() {
    try {
      session_.switch_global(LssState::waiting);
    } catch (const Failure&) {  // the bus is gone: the first error says more
    }
  }
  ConfiguredNode(const ConfiguredNode&) = delete;
  ConfiguredNode& operator=(const ConfiguredNode&) = delete;

  LssSession* operator->() { return &session_; }

 private:
  /// From the end of the constructor on, there is something to undo.
  ConfiguredNode(const std::optional<LssAddress>& address, const LssOptions& options)
      : address_(address), session_(options.bus, options.time_out()) {}

  std::optional<LssAddress> address_;
  LssSession session_;
};

// Commands

class Scan {
 public:
  explicit Scan(const LssOptions& options) : store_(options.store), json_(options.json) {
    if (!options.assign.empty()) ids_ = parse_node_ids(options.assign);
    has_ids_ = !ids_.empty();
    std::ranges::reverse(ids_);
    if (!options.only.empty()) pattern_ = parse_lss_pattern(options.only);
    if (store_ && !has_ids_) throw UsageError("--store keeps node-IDs: give them by --assign");
  }

  int run(const LssOptions& options) {
    LssSession session(options.bus, options.time_out());
    const LssScan::Outcome outcome =
        session.scan({.pattern = pattern_, .store = store_},
                     {.first_time_out = options.first_time_out(), .time_out_min = bit_time_out_min},
                     {.choose = LssScan::Choose::to<&Scan::choose>(*this),
                      .found = LssScan::Report::to<&Scan::found>(*this),
                      .passed = [this] { show_progress(); }});
    clear_progress();
    check(outcome);
    if (session.came_again()) {
      print_message(fmt::format(
          "a node that has its node-ID answered Fastscan again, as some stacks do; or a "
          "second one has its address"));
    }
    return problem_ ? exit_failed : exit_done;
  }

 private:
  NodeId choose(const LssAddress&) {
    if (ids_.empty()) return node_id_unconfigured;
    const NodeId id = ids_.back();
    ids_.pop_back();
    return id;
  }

  /// On a terminal: Fastscan sends requests for 128 bits of each node, which takes seconds.
  void show_progress() {
    if (json_ || ::isatty(STDERR_FILENO) != 1) return;
    fmt::print(stderr, "\r{} s, {} found; it asks for the next ", ++seconds_, count_);
    is_on_line_ = true;
  }
  void clear_progress() {
    if (is_on_line_) fmt::print(stderr, "\r{:40}\r", "");
    is_on_line_ = false;
  }

  void found(const LssScan::Found& node) {
    clear_progress();
    ++count_;
    std::string line = lss_address_text(node.address);
    if (is_node_id(node.id)) line += fmt::format(": {}", text::node_text(node.id));
    if (node.configured.outcome == LssMaster::Outcome::refused) {
      line += ": " + lss_error_text(lss::Command::configure_node_id, node.configured.error);
    }
    const bool named = is_node_id(node.id);
    if (has_ids_ && !named && !node.configured.error.code) line += ": no node-ID is left";
    if (named && store_) {
      line += node.stored.ok() ? ", stored"
              : node.stored.outcome == LssMaster::Outcome::refused
                  ? ", not stored: " + lss_error_text(lss::Command::store, node.stored.error)
                  : ", not stored: no answer";
    }
    if (node.duplicate) line += "; several nodes have this address";
    problem_ = problem_ || (has_ids_ && !named) || (named && store_ && !node.stored.ok()) ||
               node.duplicate;
    if (json_) {
      tell(node, line);
    } else {
      say(line);
    }
  }

  void tell(const LssScan::Found& node, const std::string& text) const {
    JsonEvent event("found");
    add_address(event, node.address);
    if (is_node_id(node.id)) event->key("node").number(node.id);
    if (is_node_id(node.id) && store_) event->key("stored").truth(node.stored.ok());
    event->key("duplicate").truth(node.duplicate);
    event->key("text").text(text);
    event.print();
  }

  void check(LssScan::Outcome outcome) const {
    switch (outcome) {
      case LssScan::Outcome::complete:
        if (count_ == 0) throw Failure("no node without node-ID answered");
        return;
      case LssScan::Outcome::duplicate:
        throw Failure("a node with an address that was found already answered; are there two?");
      case LssScan::Outcome::hidden:
        throw Failure(
            "a node answers Fastscan for others, and may hide some; give node-IDs by --assign: "
            "then they are found one after the other");
      case LssScan::Outcome::lost:
        throw Failure("a node answered, and could not be identified; try a longer --first-timeout");
      case LssScan::Outcome::full:
        throw Failure("more than 127 nodes answered");
    }
  }

  LssPattern pattern_;
  std::vector<NodeId> ids_;
  bool has_ids_ = false;
  bool store_ = false;
  bool json_ = false;
  bool problem_ = false;
  unsigned count_ = 0;
  unsigned seconds_ = 0;
  bool is_on_line_ = false;
};

int scan(const LssOptions& options) {
  return Scan(options).run(options);
}

int inquire(const LssOptions& options) {
  ConfiguredNode node(options);
  const LssAddress address = node->inquire_address();
  const NodeId id = node->inquire_node_id();
  const std::string text = fmt::format("{}: {}", lss_address_text(address),
                                       is_node_id(id) ? text::node_text(id) : "no node-ID");
  if (!options.json) {
    say(text);
    return exit_done;
  }
  JsonEvent event("found");
  add_address(event, address);
  if (is_node_id(id)) event->key("node").number(id);
  event->key("text").text(text);
  event.print();
  return exit_done;
}

int set_node_id(const LssOptions& options) {
  const NodeId id = options.value == "none" ? node_id_unconfigured : parse_node_id(options.value);
  ConfiguredNode node(options);
  const NodeId before = node->inquire_node_id();
  node->configure_node_id(id);
  if (options.store) node->store();
  report_setting(
      options, "node", id == node_id_unconfigured ? 0 : id,
      id == node_id_unconfigured ? "no node-ID is set" : text::node_text(id) + " is set");
  if (!options.json && is_node_id(before) && id != before) {
    say(fmt::format("{} takes it at the next reset: canvoy nmt {} {} reset-communication",
                    text::node_text(before), options.bus, before));
  }
  return exit_done;
}

int set_bit_rate(const LssOptions& options) {
  const std::uint8_t index = parse_bit_timing(options.value);
  ConfiguredNode node(options);
  node->configure_bit_timing(index);
  if (options.store) node->store();
  const std::uint32_t bit_rate = lss_bit_timing::bit_rate(index);
  report_setting(
      options, "bit_rate", bit_rate,
      bit_rate == 0 ? "the bit rate is to be found" : fmt::format("{} bit/s are set", bit_rate));
  return exit_done;
}

/// Action of this machine when the others switch: none, or the same bit rate.
class OwnSwitch {
 public:
  /// Throws before anything is sent if the interface has no settable bit rate.
  explicit OwnSwitch(const LssOptions& options) : bus_(options.bus), is_quiet_(options.json) {
    if (options.bit_rate.empty()) return;
    bit_rate_ = lss_bit_timing::bit_rate(parse_bit_timing(options.bit_rate));
    if (bit_rate_ == 0) throw UsageError("--bit-rate: give one of the table, as 125k");
    const host::BusAddress address = real_bus(options.bus);
    const bool has_controller =
        address.kind == host::BusType::socketcan &&
        value_or_throw(host::read_can_link(address.interface)).has_controller;
    if (!has_controller) {
      throw Failure(
          fmt::format("{}: it has no bit rate to switch; leave --bit-rate out", options.bus));
    }
  }

  /// Switches in the middle of both delays, like a slave (CiA 305). False if nothing was to be
  /// done.
  bool run(LssSession& session, Duration delay) const {
    if (bit_rate_ == 0) return false;
    session.wait(delay);
    ok_or_throw(host::restart_can_link(bus_, bit_rate_, false));
    session.wait(delay);
    if (!is_quiet_) say(fmt::format("{} has {} bit/s now", bus_, bit_rate_));
    return true;
  }

 private:
  std::string bus_;
  bool is_quiet_ = false;
  std::uint32_t bit_rate_ = 0;
};

/// For all nodes: those without a new bit rate keep theirs.
int activate(const LssOptions& options) {
  constexpr Duration delay_max = 65535ms;
  const Duration length = parse_duration_argument(options.value);
  if (length > delay_max || length % Duration(1ms) != Duration{}) {
    throw UsageError(fmt::format("'{}' is no delay: give 1ms to 65535ms", options.value));
  }
  const auto delay = length / Duration(1ms);
  const OwnSwitch own(options);
  LssSession session(options.bus, options.time_out());
  session.switch_global(LssState::configuration);
  session.activate_bit_timing(std::chrono::milliseconds(delay));
  if (options.json) {
    JsonEvent event("switch");
    event->key("delay_s").number(static_cast<double>(delay) / 1000);
    event.print();
  } else {
    say(fmt::format("all nodes switch in {} ms, and are heard again after {} ms", delay,
                    2 * delay));
  }
  if (own.run(session, std::chrono::milliseconds(delay))) session.switch_global(LssState::waiting);
  return exit_done;
}

int store_settings(const LssOptions& options) {
  ConfiguredNode node(options);
  node->store();
  if (options.json) {
    JsonEvent("stored").print();
  } else {
    say("stored");
  }
  return exit_done;
}

int identify(const LssOptions& options) {
  const std::optional<LssAddress> address = selected_address(options);
  LssSession session(options.bus, options.time_out());
  const bool there = address ? session.identify(*address) : session.identify_unconfigured();
  if (!there) {
    throw Failure(address ? "no node has this address" : "no node without node-ID answered");
  }
  const char* const text = address ? "a node has this address" : "there are nodes without node-ID";
  if (options.json) {
    JsonEvent event("identified");
    if (address) add_address(event, *address);
    event->key("text").text(text);
    event.print();
  } else {
    say(text);
  }
  return exit_done;
}

int switch_state(const LssOptions& options) {
  const bool waiting = options.value == "waiting";
  if (!waiting && options.value != "configuration") {
    throw UsageError(fmt::format("'{}' is no LSS state: waiting or configuration{}", options.value,
                                 did_you_mean(options.value, {"waiting", "configuration"})));
  }
  const std::optional<LssAddress> address = selected_address(options);
  if (waiting && address)
    throw UsageError("to waiting, all nodes are switched: leave --select out");
  LssSession session(options.bus, options.time_out());
  if (address) {
    session.select(*address);
  } else {
    session.switch_global(waiting ? LssState::waiting : LssState::configuration);
  }
  if (options.json) {
    JsonEvent event("lss-state");
    event->key("state").text(options.value);
    event.print();
  } else {
    say(fmt::format("{} in LSS state {}",
                    address ? lss_address_text(*address) + " is" : "all nodes are", options.value));
  }
  return exit_done;
}

struct CommandEntry {
  std::string_view name;
  int (*run)(const LssOptions& options);
  std::string_view value;  ///< the needed value, or empty
};
constexpr auto lss_commands = std::to_array<CommandEntry>({
    {"scan", scan, ""},
    {"inquire", inquire, ""},
    {"set-node-id", set_node_id, "a node-ID, or none"},
    {"set-bit-rate", set_bit_rate, "a bit rate, as 125k"},
    {"activate", activate, "a delay, as 1s"},
    {"store", store_settings, ""},
    {"identify", identify, ""},
    {"switch", switch_state, "waiting or configuration"},
});

int run_lss(const LssOptions& options) {
  const auto* command = std::ranges::find(lss_commands, options.command, &CommandEntry::name);
  if (command == lss_commands.end()) {
    std::vector<std::string> names;
    names.reserve(lss_commands.size());
    for (const CommandEntry& each : lss_commands) names.emplace_back(each.name);
    throw UsageError(
        fmt::format("'{}' is no LSS command: scan, inquire, set-node-id, set-bit-rate, activate, "
                    "store, identify or switch{}",
                    options.command, did_you_mean(options.command, names)));
  }
  if (options.value.empty() && !command->value.empty()) {
    throw UsageError(fmt::format("{}: give {}", command->name, command->value));
  }
  if (!options.value.empty() && command->value.empty()) {
    throw UsageError(fmt::format("{}: '{}' is too much", command->name, options.value));
  }
  return command->run(options);
}

}  // namespace

void add_lss(Verb& app) {
  const auto options = std::make_shared<LssOptions>();
  Verb& command =
      app.add_verb("lss", "Find nodes without node-ID; set node-IDs and bit rates (LSS)");
  command.add({
      {"bus", options->bus, bus_text, required},
      {"command", options->command,
       "scan; inquire; set-node-id ID; set-bit-rate RATE; activate DELAY; store; "
       "identify; switch waiting|configuration",
       required},
      {"value", options->value, "what the command needs: 10, 125k, 1s"},
      {"--select", options->select,
       "VENDOR:PRODUCT:REVISION:SERIAL of the one node that is meant (default: all; "
       "then only one may be there)"},
      {"--assign", options->assign,
       "scan: node-IDs to give, as 10-20 or 10,12 (default: none, only look)"},
      {"--only", options->only,
       "scan: VENDOR[:PRODUCT[:REVISION[:SERIAL]]] of the nodes to look for"},
      {"--store", options->store, "let the node keep it without power"},
      {"--bit-rate", options->bit_rate,
       "activate: that this machine's interface takes along with the nodes, as 250k "
       "(needs root; default: it keeps its own)"},
      {"--timeout", options->time_out_text, answer_time_text, answer_time_rules},
      {"--first-timeout", options->first_time_out_text,
       "scan: for the first answers (default 100ms); the rest is measured"},
      {"--json", options->json, "one JSON object a line"},
  });
  command.add_examples(
      "  canvoy lss can0 scan --assign 20-30 --store\n"
      "  canvoy lss can0 inquire --select 1:2:3:4 --timeout 500ms\n"
      "  canvoy lss can0 set-node-id 10 --store\n"
      "  canvoy lss can0 activate 1s");
  command.runs([options] { return run_lss(*options); });
}

}  // namespace canvoy::tools
