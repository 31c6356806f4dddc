// canvoy monitor BUS: every frame on a bus, with its service in words.
#include <fmt/chrono.h>
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "canvoy/can/frame_text.hpp"
#include "canvoy/can/host/candump_log.hpp"
#include "canvoy/sim/duration_text.hpp"
#include "canvoy/tools/commands.hpp"
#include "canvoy/tools/duration_argument.hpp"
#include "canvoy/tools/failure.hpp"
#include "canvoy/tools/frame_decoder.hpp"
#include "canvoy/tools/session.hpp"
#include "canvoy/tools/text.hpp"

namespace canvoy::tools {

namespace {

struct MonitorOptions {
  std::string bus;
  std::string log;
  std::string duration;
  std::uint64_t count = 0;
  bool json = false;
};

class Monitor {
 public:
  explicit Monitor(const MonitorOptions& options) : options_(options), session_(options.bus) {
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
    const Duration duration =
        options_.duration.empty() ? Duration::max() : parse_duration_argument(options_.duration);
    session_.loop().run_until(duration == Duration::max() ? never
                                                          : session_.loop().now() + duration);
    if (log_) check(log_->flush());
    if (failure_) throw Failure(*failure_);
    return exit_done;
  }

 private:
  void show(const host::BusFrame& heard) {
    const FrameWords words = decoder_.decode(heard.frame);
    const double seconds =
        static_cast<double>((session_.loop().epoch() + heard.time.time_since_epoch()).count()) /
        1e6;
    const FrameText frame(heard.frame);
    if (options_.json) {
      nlohmann::ordered_json line = {{"time", seconds},
                                     {"bus", session_.bus().name()},
                                     {"frame", frame.view()},
                                     {"service", words.service}};
      if (words.node != 0) line["node"] = words.node;
      if (!words.text.empty()) line["text"] = words.text;
      fmt::print("{}\n", line.dump());
    } else {
      fmt::print("({:.6f}) {} {:<21} {:<13} {}{}{}\n", seconds, session_.bus().name(), frame.view(),
                 words.service, words.node == 0 ? "" : node_text(words.node),
                 words.node == 0 || words.text.empty() ? "" : ": ", words.text);
    }
    std::fflush(stdout);
    if (log_) check(log_->write(heard.time, session_.bus().name(), heard.frame));
    if (++shown_ == options_.count) session_.loop().stop();
  }

  /// A log that cannot be written any more ends the monitor.
  void check(const host::Result<void>& written) {
    if (written) return;
    failure_ = written.error().line();
    session_.loop().stop();
  }

  MonitorOptions options_;
  Session session_;
  FrameDecoder decoder_;
  std::optional<host::CandumpWriter> log_;
  std::optional<std::string> failure_;
  std::uint64_t shown_ = 0;
};

}  // namespace

void add_monitor(CLI::App& app, Action& action) {
  const auto options = std::make_shared<MonitorOptions>();
  CLI::App* command = app.add_subcommand("monitor", "Show every frame on a bus in words");
  command->add_option("bus", options->bus, "can0, vcan0, udp:239.74.163.2:43113")->required();
  command->add_option("--log", options->log, "write a candump log as well");
  command->add_option("--for", options->duration, "end after this time: 30s, 10min, 8h");
  command->add_option("--count", options->count, "end after as many frames");
  command->add_flag("--json", options->json, "one JSON object a line");
  command->callback([options, &action] { action = [options] { return Monitor(*options).run(); }; });
}

}  // namespace canvoy::tools
