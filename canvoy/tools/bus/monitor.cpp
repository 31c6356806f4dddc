// canvoy monitor SOURCE: every frame on a bus, or in a log, with its service in words.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>

#include "canvoy/can/host/candump_log.hpp"
#include "canvoy/formats/trace_writer.hpp"
#include "canvoy/sim/duration_text.hpp"
#include "canvoy/tools/bus/session.hpp"
#include "canvoy/tools/commands.hpp"
#include "canvoy/tools/duration_argument.hpp"
#include "canvoy/tools/failure.hpp"
#include "canvoy/tools/log/decode_log.hpp"
#include "canvoy/tools/log/frame_printer.hpp"
#include "canvoy/tools/log/line_output.hpp"
#include "canvoy/words/text.hpp"

namespace canvoy::tools {

namespace {

struct MonitorOptions {
  std::string source;
  std::string log;
  std::string duration;
  std::uint64_t count = 0;
  FramePrinterOptions printer;

  /// No bus has such a name.
  bool source_is_log() const {
    if (source.starts_with("tcp:")) return false;
    return source == "-" || source.find('/') != std::string::npos ||
           formats::trace_format_of(source).has_value();
  }
  Duration limit() const {
    return duration.empty() ? Duration::max() : parse_duration_argument(duration);
  }
};

class BusMonitor {
 public:
  explicit BusMonitor(const MonitorOptions& options)
      : options_(options),
        limit_(options.limit()),
        session_(options.source),
        printer_(options.printer) {
    if (!options.log.empty()) {
      log_.emplace(
          value_or_throw(host::CandumpWriter::create(options.log, session_.loop().epoch())));
    }
    for (host::HostBus* bus : session_.buses()) listen(*bus);
  }

  int run() {
    session_.loop().run_until(limit_ == Duration::max() ? never : session_.loop().now() + limit_);
    if (log_) check(log_->flush());
    const std::string without_match = printer_.without_match();
    if (!without_match.empty()) fmt::print(stderr, "{}: {}\n", options_.source, without_match);
    if (failure_) throw Failure(*failure_);
    return exit_done;
  }

 private:
  void listen(host::HostBus& bus) {
    bus.on_frame([this, &bus](const host::BusFrame& heard) { show(bus.name(), heard); });
    bus.on_state([&bus](BusState state, Time) {
      fmt::print(stderr, "{} is {}\n", bus.name(), words::bus_state_text(state));
    });
    bus.on_trouble(
        [](const host::Error& error) { fmt::print(stderr, "canvoy: {}\n", error.line()); });
  }

  void show(std::string_view bus, const host::BusFrame& heard) {
    if (shown_ == options_.count && options_.count != 0) return;
    const Duration time = session_.loop().epoch() + heard.time.time_since_epoch();
    const bool printed = printer_.append(lines_.lines(), time, bus, heard.frame);
    lines_.flush();
    if (log_) check(log_->write(heard.time, bus, heard.frame));
    if (printed && ++shown_ == options_.count) session_.loop().stop();
  }

  /// A log that cannot be written any more ends the monitor.
  void check(const host::Result<void>& written) {
    if (written) return;
    failure_ = written.error().line();
    session_.loop().stop();
  }

  MonitorOptions options_;
  Duration limit_;
  Session session_;
  FramePrinter printer_;
  LineOutput lines_{options_.printer.json};
  std::optional<host::CandumpWriter> log_;
  std::optional<std::string> failure_;
  std::uint64_t shown_ = 0;
};

int show_log(const MonitorOptions& options) {
  if (!options.log.empty()) throw UsageError("--log is for a bus: this is a log already");
  LogOptions log = {.log = options.source, .count = options.count, .printer = options.printer};
  if (!options.duration.empty()) log.limit = options.limit();
  return decode_log(log);
}

}  // namespace

void add_monitor(CLI::App& app, Action& action) {
  const auto options = std::make_shared<MonitorOptions>();
  CLI::App* command =
      app.add_subcommand("monitor", "Show every frame on a bus or in a log in words");
  command
      ->add_option("source", options->source,
                   "can0, udp:239.74.163.2:43113, tcp:HOST:PORT/can0 of a socketcand; several as "
                   "can0,can1; or a log (candump, ASC, TRC, pcapng): night.log, ./night")
      ->required();
  command->add_option("--log", options->log, "write a candump log as well");
  command->add_option("--for", options->duration, "end after this time: 30s, 10min, 8h");
  command->add_option("--count", options->count, "end after as many frames")
      ->check(CLI::PositiveNumber);
  options->printer.add_to(*command);
  command->footer(
      "Examples:\n"
      "  canvoy monitor can0\n"
      "  canvoy monitor can0,can1 --for 500ms\n"
      "  canvoy monitor can0 --log night.log --for 8h\n"
      "  canvoy monitor can0 --filter 'id=180..4FF and not node=5'\n"
      "  canvoy monitor night.log --filter 'boot-up or service=SDO' --count 3\n"
      "  canvoy monitor night.log --node 10=418 --filter 'battery_status=ready'\n"
      "  canvoy monitor ./night.log --filter 'object=6000..6FFF' --json");
  command->callback([options, &action] {
    action = [options] {
      return options->source_is_log() ? show_log(*options) : BusMonitor(*options).run();
    };
  });
}

}  // namespace canvoy::tools
