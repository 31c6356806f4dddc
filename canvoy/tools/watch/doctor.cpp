// canvoy doctor SOURCE: listens to a bus or reads a log, and describes its faults.
#include <fmt/format.h>

#include <bitset>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/canopen/protocol/little_endian.hpp"
#include "canvoy/formats/plain_text.hpp"
#include "canvoy/formats/trace/trace.hpp"
#include "canvoy/text/doctor/doctor.hpp"
#include "canvoy/text/doctor/report_text.hpp"
#include "canvoy/tools/argument/duration_argument.hpp"
#include "canvoy/tools/cli/commands.hpp"
#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/session/log_source.hpp"
#include "canvoy/tools/session/session.hpp"
#include "canvoy/tools/session/unknown_nodes.hpp"
#include "canvoy/tools/terminal/message.hpp"
#include "canvoy/tools/watch/frame_printer.hpp"
#include "canvoy/tools/watch/log_reader.hpp"
#include "canvoy/tools/watch/trace_complaints.hpp"
#include "canvoy/tools/watch/trace_progress.hpp"

namespace canvoy::tools {

namespace {

// Differs from the status of a verb that could not run.
constexpr int exit_warned = 3;
constexpr int exit_sick = 4;

constexpr Duration usual_listening = 60s;

struct DoctorVerbOptions {
  std::string source;
  std::string duration;
  unsigned bit_rate = 0;  ///< in kbit/s; 0: that of the interface
  bool ask = false;
  bool json = false;
  FramePrinterOptions nodes;
};

/// One doctor for each bus.
class Surgery {
 public:
  static constexpr std::size_t buses_max = 64;

  Surgery(const DoctorVerbOptions& options, unsigned bit_rate)
      : json_(options.json), bit_rate_(bit_rate), told_(options.nodes) {}

  /// Null: more than `buses_max`.
  text::Doctor* of(std::string_view bus) {
    const auto found = doctors_.find(bus);
    if (found != doctors_.end()) return found->second.get();
    if (doctors_.size() == buses_max) {
      ++left_out_;
      return nullptr;
    }
    auto made = std::make_unique<text::Doctor>(text::DoctorOptions{.bit_rate = bit_rate_});
    told_.report_network(bus, made->network());
    for (const FramePrinter::SheetOfNode& sheet : told_.sheets_of_nodes()) {
      if (sheet.bus.empty() || sheet.bus == bus) made->add_sheet(sheet.node, sheet.sheet);
    }
    return doctors_.emplace(bus, std::move(made)).first->second.get();
  }

  /// Prints the findings up to `end`, and returns the exit status.
  int report(Time end) {
    std::optional<text::Severity> worst;
    bool is_first = true;
    for (auto& [bus, doctor] : doctors_) {
      const text::Findings findings = doctor->findings(end);
      worst = std::max(worst, text::worst_of(findings));
      const std::string name = formats::plain_text(bus);
      if (json_) {
        fmt::print("{}", text::report_json(name, doctor->observed(), findings));
        continue;
      }
      fmt::print("{}{}", is_first ? "" : "\n",
                 text::report_text(name, doctor->observed(), findings));
      is_first = false;
    }
    report_unjudged();
    if (worst == text::Severity::error) return exit_sick;
    return worst == text::Severity::warning ? exit_warned : exit_done;
  }

 private:
  void report_unjudged() const {
    if (left_out_ != 0) {
      print_message(fmt::format("frames of more than {} buses are left out", buses_max));
    }
    if (json_ || bit_rate_ != 0) return;
    fmt::print("the load was not judged: --bit-rate 125 tells what the bus can carry\n");
  }

  bool json_;
  unsigned bit_rate_;
  FramePrinter told_;
  std::map<std::string, std::unique_ptr<text::Doctor>, std::less<>> doctors_;
  std::uint64_t left_out_ = 0;
};

/// Reads the properties of a node: those of ask_node(), and its name, heartbeats, SYNC, and the
/// types and times of its TPDOs. False if it has left a request unanswered.
class NodeQuestions {
 public:
  NodeQuestions(Session& session, NodeId node) : session_(session), node_(node) {}

  bool ask() {
    if (!ask_node(session_, node_)) return false;
    try {
      namespace index = object_index;
      for (const std::uint16_t object : {index::device_name, index::cob_id_sync, index::sync_period,
                                         index::sync_window, index::heartbeat_producer})
        number(object, 0);
      ask_consumers();
      ask_tpdos();
    } catch (const Failure&) {
      return false;
    }
    return true;
  }

 private:
  std::optional<std::uint32_t> number(std::uint16_t index, std::uint8_t sub) {
    const auto answer = session_.try_read(node_, index, sub);
    if (!answer) return std::nullopt;
    if (answer->size() > sizeof(std::uint32_t)) return std::nullopt;
    return static_cast<std::uint32_t>(load_unsigned(*answer));
  }
  void ask_consumers() {
    const std::uint32_t count = std::min<std::uint32_t>(
        number(object_index::heartbeat_consumers, 0).value_or(0), node_id_max);
    for (std::uint8_t sub = 1; sub <= count; ++sub) number(object_index::heartbeat_consumers, sub);
  }
  /// Reads TPDO parameters from 1800h on, until several consecutive ones are missing.
  void ask_tpdos() {
    constexpr unsigned missing_max = 4;
    unsigned missing = 0;
    for (std::uint16_t index = object_index::tpdo_parameter;
         index <= object_index::tpdo_parameter_last && missing < missing_max; ++index) {
      const auto type = number(index, 2);
      missing = type ? 0 : missing + 1;
      if (!type) continue;
      number(index, 3);
      number(index, 5);
    }
  }

  Session& session_;
  NodeId node_;
};

class BusDoctor {
 public:
  explicit BusDoctor(const DoctorVerbOptions& options)
      : options_(options),
        limit_(parse_duration_argument(options.duration, usual_listening)),
        session_(options.source),
        surgery_(options, bit_rate_of(options.source, options.bit_rate)) {
    for (host::HostBus* bus : session_.buses()) listen(*bus);
  }

  int run() {
    const Time end = session_.loop().now() + limit_;
    while (!is_over_ && session_.loop().now() < end) {
      const Time until = options_.ask ? std::min(end, session_.loop().now() + look_period) : end;
      if (session_.loop().run_until(until) == host::EventLoop::End::stopped) is_over_ = true;
      if (options_.ask && !is_over_) ask_next();
    }
    return surgery_.report(session_.loop().now());
  }

 private:
  /// Interval of the search for nodes to read.
  static constexpr Duration look_period = 100ms;

  void listen(host::HostBus& bus) {
    text::Doctor* doctor = surgery_.of(bus.name());
    if (doctor == nullptr) return;
    doctor->begin(session_.loop().now());
    bus.on_frame([doctor](const host::BusFrame& heard) { doctor->hear(heard.time, heard.frame); });
    bus.on_trouble([this, doctor](const host::Error& error) {
      print_message(fmt::format("canvoy: {}", error.line()));
      doctor->lose(session_.loop().now(), error.line());
    });
  }

  /// The answers are heard like all other frames.
  void ask_next() {
    for (host::HostBus* bus : session_.buses()) {
      const text::Doctor* doctor = surgery_.of(bus->name());
      if (doctor == nullptr) continue;
      auto& asked = asked_[std::string(bus->name())];
      for (NodeId node = node_id_min; node <= node_id_max; ++node) {
        if (asked[node] || !doctor->observed().traffic.is_heard(node)) continue;
        asked[node] = true;
        session_.speak_on(*bus);
        NodeQuestions(session_, node).ask();
        is_over_ = session_.loop().signal() != 0;
        return;
      }
    }
  }

  const DoctorVerbOptions& options_;
  Duration limit_;
  Session session_;
  Surgery surgery_;
  std::map<std::string, std::bitset<node_id_max + 1>> asked_;
  bool is_over_ = false;
};

int examine_log(const DoctorVerbOptions& options) {
  if (options.ask) throw UsageError("--ask is for a bus: nobody answers in a log");
  const Duration limit =
      options.duration.empty() ? Duration::max() : parse_duration_argument(options.duration);
  LogReader trace(value_or_throw(formats::TraceReader::open(options.source)));
  constexpr unsigned kilo = 1000;
  Surgery surgery(options, options.bit_rate * kilo);
  std::optional<Time> first;
  Time last{};
  {
    TraceProgress progress(trace);
    formats::TraceFrame heard;
    for (formats::TraceRead read; (read = trace.next(heard)) != formats::TraceRead::end;) {
      if (read == formats::TraceRead::bad) show_bad(options.source, trace);
      progress.show(trace);
      if (read != formats::TraceRead::frame) continue;
      if (!first) first = heard.time;
      if (heard.time - *first > limit) break;
      last = std::max(last, heard.time);
      text::Doctor* doctor = surgery.of(heard.channel);
      if (doctor != nullptr) doctor->hear(heard.time, heard.frame);
    }
  }
  refuse_log_without_frames(options.source, trace);
  return surgery.report(last);
}

}  // namespace

void add_doctor(Verb& app) {
  const auto options = std::make_shared<DoctorVerbOptions>();
  Verb& command =
      app.add_verb("doctor", "Say what is wrong with a bus or in a log, and what to do");
  command.add({
      {"source", options->source,
       "can0, udp:239.74.163.2:43113, tcp:HOST:PORT/can0 of a socketcand; several as "
       "can0,can1; or a log of any format that canvoy decode reads: night.log, ./night",
       required},
      {"--for", options->duration,
       "listen for so long: 30s, 10min (default 60s; of a log, all of it)"},
      {"--ask", options->ask,
       "ask each node that is heard for its identity, heartbeats and PDOs, by SDO"},
      {"--bit-rate", options->bit_rate,
       "in kbit/s, for the bus load (default: that of the interface)", between(1U, 1000U)},
      {"--json", options->json, "one JSON object for each finding, and one for each bus"},
  });
  options->nodes.add_nodes_to(command);
  command.set_footer(
      "Nobody is changed by it. With --ask it reads objects; a node with --eds 5=FILE is compared\n"
      "with its data sheet, as far as its objects are read. The exit status is 0 where nothing is\n"
      "wrong, 3 where there are warnings, 4 where there are errors.\n"
      "Examples:\n"
      "  canvoy doctor night.log --bit-rate 125\n"
      "  canvoy doctor can0 --for 5s\n"
      "  canvoy doctor can0 --for 5s --ask --eds 10=battery.eds --json");
  command.runs([options] {
    return is_log_source(options->source) ? examine_log(*options) : BusDoctor(*options).run();
  });
}

}  // namespace canvoy::tools
