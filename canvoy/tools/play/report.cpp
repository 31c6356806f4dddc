// canvoy report RUN: a run, a log or a bus as one page without a server.
#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "canvoy/can/host/event_loop.hpp"
#include "canvoy/tools/argument/bus_argument.hpp"
#include "canvoy/tools/argument/duration_argument.hpp"
#include "canvoy/tools/cli/commands.hpp"
#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/cli/spelling.hpp"
#include "canvoy/tools/cli/verb_help.hpp"
#include "canvoy/tools/page/live_bus.hpp"
#include "canvoy/tools/page/live_log.hpp"
#include "canvoy/tools/page/report_page.hpp"
#include "canvoy/tools/play/world.hpp"
#include "canvoy/tools/player/run_options.hpp"

namespace canvoy::tools {

namespace {

struct ReportOptions {
  std::string source;
  RunOptions run;
  FramePrinterOptions decoding;
};

/// From now on, for the given time, or until an interruption.
int report_bus(const ReportOptions& options) {
  if (!options.run.duration) throw UsageError("--for is missing: how long is the bus to be heard?");
  if (options.run.seed || !options.run.faults.empty()) {
    throw UsageError("--seed and --fault are of runs, and this is a bus");
  }
  const std::unique_ptr<host::EventLoop> loop = value_or_throw(host::EventLoop::create());
  ok_or_throw(loop->stop_on_signals());
  LiveBus bus(options.source, "", options.decoding, {}, *loop);
  const Time begin = loop->now();
  const Duration length = parse_duration_argument(*options.run.duration);
  const Duration part_time = length / (report_pictures - 1);
  return write_report(
      bus,
      [&](std::size_t part) {
        const auto parts = static_cast<Duration::rep>(part);
        return loop->run_until(begin + part_time * parts) != host::EventLoop::End::stopped;
      },
      *options.run.report);
}

int report(const ReportOptions& options) {
  if (options.source.empty()) {
    throw UsageError(fmt::format(
        "what is reported is missing: {}, a network file or a log; see canvoy report --help",
        world_names(", ")));
  }
  if (!options.run.report) throw UsageError("--out is missing: name the file of the report");
  if (!std::filesystem::exists(options.source)) {
    if (names_bus(options.source)) return report_bus(options);
    throw UsageError(
        fmt::format("'{}' is neither a built-in network nor a file{}; see canvoy report --help",
                    options.source, did_you_mean(options.source, built_in_networks())));
  }
  if (options.source.ends_with(".toml")) return run_network_file(options.source, options.run);
  if (options.run.duration || options.run.seed || !options.run.faults.empty()) {
    throw UsageError("--for, --seed and --fault are of runs, and this is a log");
  }
  LiveLog log(options.source, options.decoding);
  return write_report(log, *options.run.report);
}

}  // namespace

void add_report(Verb& app) {
  const auto options = std::make_shared<ReportOptions>();
  Verb& command = app.add_verb(
      "report", "Write a run, a log or a bus as one page, with pictures, verdicts and statistics");
  command.add({
      {"source", options->source,
       "a network file (lift.toml), a log of any format that canvoy decode reads, or a bus (can0)"},
  });
  add_run_options(command, options->run, "as the network has it; see canvoy run NETWORK --help");
  add_networks(command);
  for (const std::unique_ptr<Verb>& network : command.verbs()) {
    network->add_examples(
        fmt::format("  canvoy report {0} --for 10min --out {0}.html", network->name()));
  }
  options->decoding.add_nodes_to(command);
  command.add_examples(
      "  canvoy report charger --for 10min --seed 7 --out charger.html\n"
      "  canvoy report night.log --node 10=418 --out night.html\n"
      "  canvoy report can0 --for 2s --out bus.html");
  command.allow_verb();
  command.runs([options] { return report(*options); });
}

}  // namespace canvoy::tools
