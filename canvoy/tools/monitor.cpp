// canvoy monitor SOURCE: every frame on a bus, or in a candump log, with its service in words.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>

#include "canvoy/can/host/candump_log.hpp"
#include "canvoy/sim/duration_text.hpp"
#include "canvoy/tools/commands.hpp"
#include "canvoy/tools/duration_argument.hpp"
#include "canvoy/tools/failure.hpp"
#include "canvoy/tools/frame_printer.hpp"
#include "canvoy/tools/session.hpp"
#include "canvoy/tools/text.hpp"

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
    return source.find('/') != std::string::npos || source.ends_with(".log");
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
    session_.bus().on_frame([this](const host::BusFrame& heard) { show(heard); });
    session_.bus().on_state(
        [](BusState state, Time) { fmt::print(stderr, "the bus is {}\n", bus_state_text(state)); });
    session_.bus().on_trouble(
        [](const host::Error& error) { fmt::print(stderr, "canvoy: {}\n", error.line()); });
  }

  int run() {
    session_.loop().run_until(limit_ == Duration::max() ? never : session_.loop().now() + limit_);
    if (log_) check(log_->flush());
    if (failure_) throw Failure(*failure_);
    return exit_done;
  }

 private:
  void show(const host::BusFrame& heard) {
    if (shown_ == options_.count && options_.count != 0) return;
    const Duration time = session_.loop().epoch() + heard.time.time_since_epoch();
    const bool printed = printer_.print(time, session_.bus().name(), heard.frame);
    std::fflush(stdout);
    if (log_) check(log_->write(heard.time, session_.bus().name(), heard.frame));
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
  std::optional<host::CandumpWriter> log_;
  std::optional<std::string> failure_;
  std::uint64_t shown_ = 0;
};

int show_log(const MonitorOptions& options) {
  if (!options.log.empty()) throw UsageError("--log is for a bus: this is a log already");
  const Duration limit = options.limit();
  host::CandumpReader reader = value_or_throw(host::CandumpReader::open(options.source));
  FramePrinter printer(options.printer);
  std::optional<Time> first;
  for (std::uint64_t shown = 0; options.count == 0 || shown < options.count;) {
    const std::optional<host::LogEntry> entry = value_or_throw(reader.next());
    if (!entry) break;
    if (!first) first = entry->time;
    if (entry->time - *first > limit) break;
    const Duration time = entry->time.time_since_epoch();
    if (printer.print(time, entry->interface, entry->frame)) ++shown;
  }
  if (reader.fd_skipped() > 0) {
    fmt::print(stderr, "{}: {} CAN FD frames are left out\n", options.source, reader.fd_skipped());
  }
  return exit_done;
}

}  // namespace

void add_monitor(CLI::App& app, Action& action) {
  const auto options = std::make_shared<MonitorOptions>();
  CLI::App* command =
      app.add_subcommand("monitor", "Show every frame on a bus or in a log in words");
  command
      ->add_option("source", options->source,
                   "can0, vcan0, udp:239.74.163.2:43113, or a candump log: night.log, ./night")
      ->required();
  command->add_option("--log", options->log, "write a candump log as well");
  command->add_option("--for", options->duration, "end after this time: 30s, 10min, 8h");
  command->add_option("--count", options->count, "end after as many frames")
      ->check(CLI::PositiveNumber);
  options->printer.add_to(*command);
  command->callback([options, &action] {
    action = [options] {
      return options->source_is_log() ? show_log(*options) : BusMonitor(*options).run();
    };
  });
}

}  // namespace canvoy::tools
