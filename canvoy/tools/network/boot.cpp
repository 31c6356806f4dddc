// canvoy boot BUS: boots a network as its NMT master, and reports the step of each slave, and why a
// slave fails.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <vector>

#include "canvoy/can/host/attachment.hpp"
#include "canvoy/can/host/bus_address.hpp"
#include "canvoy/text/text.hpp"
#include "canvoy/tools/argument/duration_argument.hpp"
#include "canvoy/tools/cli/commands.hpp"
#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/cli/verb_help.hpp"
#include "canvoy/tools/network/boot_master.hpp"
#include "canvoy/tools/network/boot_plan.hpp"
#include "canvoy/tools/network/boot_simulation.hpp"
#include "canvoy/tools/network/boot_text.hpp"
#include "canvoy/tools/network/program_text.hpp"
#include "canvoy/tools/session/session.hpp"

namespace canvoy::tools {

namespace {

struct BootCommand {
  std::string bus;
  std::vector<std::string> slaves;
  std::string config;
  std::string master;
  std::string boot_time;
  std::string start;
  std::string duration;
  bool no_reset = false;
  bool stays = false;
  bool json = false;
};

/// Time for the last commands to be sent before the command ends.
constexpr Duration farewell = 100ms;

/// A master with a plan, and what it has reported so far.
class Boot {
 public:
  Boot(const BootPlan& plan, const Port& port, bool json)
      : plan_(plan), master_(plan, port), json_(json) {
    master_.boot_manager().on_report(callback<&Boot::told>(*this));
    master_.boot_manager().on_network(callback<&Boot::network_is>(*this));
    master_.configurations().on_done(ConfigurationManager::Done::to<&Boot::configured>(*this));
    master_.programs().on_update(callback<&Boot::updated>(*this));
  }

  Node& node() { return master_.node(); }
  void begin_at(Time time) { begin_ = time; }
  /// True if each slave was tried, and nothing more comes by itself.
  bool is_settled() {
    return network_ != NetworkBoot::idle && network_ != NetworkBoot::booting &&
           std::ranges::all_of(plan_.slaves, [this](const SlavePlan& slave) {
             const auto state = master_.boot_manager().slave_state(slave.id);
             const bool is_over = state == BootManager::SlaveState::booted ||
                                  state == BootManager::SlaveState::failed;
             return slave.is_mandatory ? is_over : tried_[slave.id];
           });
  }
  /// True if all mandatory slaves are up.
  bool is_good() {
    return network_ == NetworkBoot::complete &&
           std::ranges::all_of(plan_.slaves, [this](const SlavePlan& slave) {
             return !slave.is_mandatory || is_up(slave.id);
           });
  }
  void summarise();

 private:
  void told(const BootReport& report);
  void network_is(NetworkBoot state);
  void configured(NodeId slave, const ConfigurationOutcome& outcome);
  void updated(NodeId slave, const ProgramOutcome& outcome);
  void say(const BootReport& report);
  void say(NodeId slave, std::string_view event, const std::string& text);
  bool is_up(NodeId slave) {
    return master_.boot_manager().slave_state(slave) == BootManager::SlaveState::booted;
  }
  std::string name_of(NodeId slave) const;
  std::string letters_of(NodeId slave) const;
  std::string reported_before(NodeId slave, BootError now) const;
  void report_strangers() const;
  double seconds() { return std::chrono::duration<double>(node().now() - begin_).count(); }

  const BootPlan& plan_;
  BootMaster master_;
  bool json_;
  Time begin_{};
  NetworkBoot network_ = NetworkBoot::idle;
  std::array<bool, node_id_max + 1> tried_{};
  std::array<BootReport, node_id_max + 1> last_{};    ///< the result of the last attempt
  std::map<NodeId, std::vector<BootError>> letters_;  ///< all reported errors, in order
};

std::string Boot::name_of(NodeId slave) const {
  const auto found = std::ranges::find(plan_.slaves, slave, &SlavePlan::id);
  const bool has_name = found != plan_.slaves.end() && !found->name.empty();
  return has_name ? fmt::format("{} {}", text::node_text(slave), found->name)
                  : text::node_text(slave);
}

/// `BL`
std::string Boot::letters_of(NodeId slave) const {
  std::string text;
  const auto told = letters_.find(slave);
  if (told == letters_.end()) return text;
  for (const BootError error : told->second) text += letter(error);
  return text;
}

/// Errors reported for a slave beside the present one.
std::string Boot::reported_before(NodeId slave, BootError now) const {
  std::string text;
  const auto told = letters_.find(slave);
  if (told == letters_.end()) return text;
  for (const BootError error : told->second) {
    if (error == now) continue;
    text += fmt::format("{} {}: {}", text.empty() ? "; told before:" : ",", letter(error),
                        boot_error_text(error));
  }
  return text;
}

/// Nodes with a report that are no slaves.
void Boot::report_strangers() const {
  for (const auto& [node, told] : letters_) {
    if (std::ranges::find(plan_.slaves, node, &SlavePlan::id) != plan_.slaves.end()) continue;
    for (const BootError error : told) {
      fmt::print("{:<20} {:<9} {}: {}\n", name_of(node), "unknown", letter(error),
                 boot_error_text(error));
    }
  }
}

void Boot::told(const BootReport& report) {
  const BootError error = report.outcome.error;
  std::vector<BootError>& letters = letters_[report.slave];
  const bool is_new = std::ranges::find(letters, error) == letters.end();
  if (error != BootError::none && is_new) letters.push_back(error);
  const bool ends = report.event == BootEvent::retried || report.event == BootEvent::failed ||
                    report.event == BootEvent::booted || report.event == BootEvent::given_up;
  if (ends) {
    tried_[report.slave] = true;
    last_[report.slave] = report;
  }
  say(report);
}

/// Reports the result of a configuration; nothing if there was none.
void Boot::configured(NodeId slave, const ConfigurationOutcome& outcome) {
  if (outcome.kind == ConfigurationOutcome::Kind::nothing_known) return;
  say(slave, "configuration", configuration_line(outcome));
}

void Boot::updated(NodeId slave, const ProgramOutcome& outcome) {
  say(slave, "program", outcome ? "has got its program" : program_failure_text(outcome));
}

void Boot::say(NodeId slave, std::string_view event, const std::string& text) {
  if (json_) {
    const nlohmann::ordered_json line = {
        {"time", seconds()}, {"node", slave}, {"event", event}, {"step", event}, {"text", text}};
    fmt::print("{}\n", line.dump());
  } else {
    fmt::print("{:8.3f}s  {:<20} {}\n", seconds(), name_of(slave), text);
  }
  std::fflush(stdout);
}

void Boot::say(const BootReport& report) {
  if (!json_) {
    fmt::print("{:8.3f}s  {:<20} {}\n", seconds(), name_of(report.slave), boot_line(report));
    std::fflush(stdout);
    return;
  }
  nlohmann::ordered_json line = {{"time", seconds()},
                                 {"node", report.slave},
                                 {"event", boot_event_word(report.event)},
                                 {"step", boot_step_word(report.step)}};
  const BootError error = report.outcome.error;
  if (error != BootError::none) line["error"] = std::string(1, letter(error));
  const SdoEnd end = report.outcome.end;
  if (!end && !end.is_silence()) line["abort"] = text::abort_text(end.abort());
  if (report.expected != report.found) {
    line["expected"] = report.expected;
    line["found"] = report.found;
  }
  line["text"] = boot_line(report);
  fmt::print("{}\n", line.dump());
  std::fflush(stdout);
}

void Boot::network_is(NetworkBoot state) {
  network_ = state;
  if (json_ || state == NetworkBoot::idle) return;
  const std::string_view text = state == NetworkBoot::booting ? "is booted"
                                : state == NetworkBoot::complete
                                    ? "all mandatory slaves are up"
                                    : "a mandatory slave did not come up: it stays in "
                                      "pre-operational, and is waited for";
  fmt::print("{:8.3f}s  {:<20} {}\n", seconds(), "network", text);
  std::fflush(stdout);
}

void Boot::summarise() {
  nlohmann::ordered_json slaves = nlohmann::json::array();
  if (!json_) fmt::print("\n");
  for (const SlavePlan& slave : plan_.slaves) {
    const BootError error = master_.boot_manager().slave_error(slave.id);
    if (json_) {
      slaves.push_back({{"node", slave.id},
                        {"mandatory", slave.is_mandatory},
                        {"up", is_up(slave.id)},
                        {"error", error == BootError::none ? "" : std::string(1, letter(error))},
                        {"told", letters_of(slave.id)}});
      continue;
    }
    const BootReport& last = last_[slave.id];
    const bool is_left_up = is_up(slave.id);
    const std::string state =
        (is_left_up ? "up" : boot_reason(last)) +
        reported_before(slave.id, is_left_up ? BootError::none : last.outcome.error);
    fmt::print("{:<20} {:<9} {}\n", name_of(slave.id),
               slave.is_mandatory ? "mandatory" : "optional",
               error == BootError::none && !is_up(slave.id) ? "not finished" : state);
  }
  if (!json_) report_strangers();
  if (json_) {
    const nlohmann::ordered_json line = {
        {"time", seconds()}, {"event", "summary"}, {"complete", is_good()}, {"slaves", slaves}};
    fmt::print("{}\n", line.dump());
  }
}

BootPlan plan_of(const BootCommand& command, bool simulated) {
  BootPlan plan;
  if (!command.config.empty()) {
    plan = read_boot_plan(command.config);
  } else if (simulated && command.slaves.empty()) {
    plan = BootSimulation::plan();
  }
  for (const std::string& slave : command.slaves) add_slave(plan, slave);
  if (!command.master.empty()) plan.master = parse_node_id(command.master);
  if (!command.boot_time.empty()) plan.boot_time = parse_duration_argument(command.boot_time);
  if (!command.start.empty()) plan.start = parse_start(command.start);
  if (command.no_reset) plan.resets = false;
  check(plan);
  return plan;
}

bool may_end(const BootCommand& command, Boot& boot) {
  return !command.stays && boot.is_settled();
}

int boot_simulated(const BootCommand& command, const BootPlan& plan, Duration limit) {
  BootSimulation simulation;
  Boot boot(plan, simulation.master_port(), command.json);
  const Time begin = simulation.now();
  boot.begin_at(begin);
  simulation.begin(boot.node());
  constexpr Duration step = 10ms;
  while (!may_end(command, boot) && simulation.now() - begin < limit) simulation.run_for(step);
  simulation.run_for(farewell);
  boot.summarise();
  return boot.is_good() ? exit_done : exit_failed;
}

int boot_on_host(const BootCommand& command, const BootPlan& plan, Duration limit) {
  const auto loop = value_or_throw(host::EventLoop::create());
  const auto bus = value_or_throw(host::open_bus(*loop, real_bus(command.bus)));
  auto attachment = std::make_unique<host::Attachment>(*loop, *bus);
  Boot boot(plan, attachment->port(), command.json);
  attachment->attach(boot.node());
  std::string trouble;
  bus->on_trouble([&](const host::Error& error) { trouble = error.line(); });
  ok_or_throw(loop->stop_on_signals());
  const Time begin = loop->now();
  boot.begin_at(begin);
  boot.node().start(begin);
  constexpr Duration step = 10ms;
  while (loop->signal() == 0 && !may_end(command, boot) && loop->now() - begin < limit) {
    loop->run_until(loop->now() + step);
  }
  if (loop->signal() == 0) loop->run_until(loop->now() + farewell);
  attachment.reset();
  boot.summarise();
  if (!trouble.empty() && !boot.is_good()) throw Failure(trouble);
  return boot.is_good() ? exit_done : exit_failed;
}

int boot_network(const BootCommand& command) {
  const bool simulated = command.bus == "sim";
  const Duration limit = command.duration.empty()
                             ? (simulated && command.stays ? Duration(1min) : Duration::max())
                             : parse_duration_argument(command.duration);
  const BootPlan plan = plan_of(command, simulated);
  return simulated ? boot_simulated(command, plan, limit) : boot_on_host(command, plan, limit);
}

}  // namespace

void add_boot(Verb& app) {
  const auto options = std::make_shared<BootCommand>();
  Verb& command = app.add_verb(
      "boot", "Boot a network as its NMT master, and say why a slave does not come up");
  command.add({
      {"bus", options->bus,
       "can0, udp:239.74.163.2:43113, tcp:HOST:PORT/can0 of a socketcand, or sim: a "
       "network of this process with the usual defects",
       required},
      {"--node", options->slaves,
       "a slave, what is expected of it and what it is given: "
       "5:mandatory,vendor=0x123,heartbeat=500ms,configuration=pump.cdcf; there are "
       "mandatory, keep-alive, watch-only, name, device, vendor, product, revision, "
       "serial, heartbeat, guard=200ms*3; configuration, configuration-date, restore; "
       "program, program-id, program-date, update",
       one_each},
      {"--config", options->config, "a TOML file with [master] and [[slave]]"},
      {"--node-id", options->master, "of the master (default 127)"},
      {"--boot-time", options->boot_time, "how long mandatory slaves are waited for (default 10s)"},
      {"--start", options->start,
       "each slave when it is up (the default), all by one command, or none"},
      {"--no-reset", options->no_reset, "the slaves are not reset before they are asked"},
      {"--stay", options->stays, "watch over the network afterwards, and boot again what is lost"},
      {"--for", options->duration, "end after this time: 30s, 10min, 8h"},
      {"--json", options->json, "one JSON object a line"},
  });
  command.add_examples(
      "  canvoy boot sim --for 20s\n"
      "  canvoy boot can0 --node 10:mandatory,heartbeat=2s,name=battery --for 5s\n"
      "  canvoy boot can0 --config network.toml --json");
  command.runs([options] { return boot_network(*options); });
}

}  // namespace canvoy::tools
