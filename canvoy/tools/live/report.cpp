// canvoy report RUN: a run or a log as one page that needs no server.
#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "canvoy/tools/commands.hpp"
#include "canvoy/tools/failure.hpp"
#include "canvoy/tools/help/verb_help.hpp"
#include "canvoy/tools/live/live_log.hpp"
#include "canvoy/tools/live/report_page.hpp"
#include "canvoy/tools/run/run.hpp"
#include "canvoy/tools/run/world.hpp"
#include "canvoy/tools/spelling.hpp"

namespace canvoy::tools {

namespace {

struct ReportOptions {
  std::string source;
  RunOptions run;
  FramePrinterOptions decoding;
};

int report(const ReportOptions& options) {
  if (options.source.empty()) {
    throw UsageError(fmt::format(
        "what is reported is missing: {}, a network file or a log; see canvoy report --help",
        world_names(", ")));
  }
  if (!options.run.report) throw UsageError("--out is missing: name the file of the report");
  if (!std::filesystem::exists(options.source)) {
    throw UsageError(
        fmt::format("'{}' is neither a built-in network nor a file{}; see canvoy report --help",
                    options.source, did_you_mean(options.source, built_in_networks())));
  }
  if (options.source.ends_with(".toml")) return run_network_file(options.source, options.run);
  if (options.run.duration || options.run.seed || !options.run.faults.empty()) {
    throw UsageError("--for, --seed and --fault are of runs, and this is a log");
  }
  LiveLog log(options.source, options.decoding, true);
  return write_report(log, *options.run.report);
}

}  // namespace

void add_report(Verb& app) {
  const auto options = std::make_shared<ReportOptions>();
  Verb& command = app.add_verb(
      "report", "Write a run or a log as one page, with pictures, verdicts and statistics");
  command.add({
      {"source", options->source,
       "a network file (lift.toml), or a log of any format that canvoy decode reads"},
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
      "  canvoy report night.log --node 10=418 --out night.html");
  command.allow_verb();
  command.runs([options] { return report(*options); });
}

}  // namespace canvoy::tools
