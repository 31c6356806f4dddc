// canvoy run taxi: plays a shift of a taxi.
#include <fmt/format.h>

#include <filesystem>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "canvoy/tools/failure.hpp"
#include "canvoy/tools/help/verb_help.hpp"
#include "canvoy/tools/live/play_world.hpp"
#include "canvoy/tools/run/drive_file.hpp"
#include "canvoy/tools/run/receipt_folder.hpp"
#include "canvoy/tools/run/run.hpp"
#include "canvoy/tools/run/taxi_file.hpp"
#include "canvoy/tools/run/taxi_report.hpp"
#include "canvoy/tools/run/taxi_text.hpp"
#include "canvoy/words/text.hpp"

namespace canvoy::tools {

namespace {

class PlayedTaxi : public PlayedNetwork {
 public:
  /// Receipts are drawn where `receipts` names a folder for them.
  PlayedTaxi(const taxi::TaxiOptions& options, const std::string& receipts) : network_(options) {
    if (receipts.empty()) return;
    receipts_.emplace(receipts);
    network_.paper().copy_to(receipts_->paper().paper());
  }

  World& world() override { return network_.world(); }
  void run_until(Time until) override {
    network_.run_until(until);
    if (receipts_) receipts_->write();
  }
  std::vector<std::string> bus_names() const override { return {"sim0"}; }
  std::size_t event_count() const override { return network_.events().size(); }
  ToldEvent event(std::size_t number) const override {
    return told_event(network_.events()[number], network_);
  }
  std::string picture(double speed) override { return dashboard_text(network_, speed); }
  nlohmann::ordered_json snapshot() override { return snapshot_json(network_); }
  std::string summary_text() override { return tools::summary_text(network_); }
  nlohmann::ordered_json summary_json() override { return tools::summary_json(network_); }
  bool all_hold() const override { return network_.all_hold(); }
  taxi::TaxiNetwork& network() { return network_; }

 private:
  std::optional<ReceiptFolder> receipts_;
  taxi::TaxiNetwork network_;
};

/// What is written beside what is printed; empty: not.
struct TaxiFiles {
  std::string report;
  std::string receipts;  ///< a folder
};

int run(TaxiRun run, const RunOptions& options, const TaxiFiles& files = {}) {
  PlayOptions play_as = play_options(options, run.network.length);
  run.network.length = play_as.duration;
  if (options.seed) run.network.faults.seed = *options.seed;
  for (const std::string& fault : options.faults) add_fault(run, fault);
  const auto folder = std::filesystem::path(files.report).parent_path();
  if (!folder.empty() && !std::filesystem::is_directory(folder)) {
    throw UsageError(fmt::format("--report: '{}' is no folder", folder.string()));
  }
  play_as.real = run.real;
  if (!files.report.empty()) {
    if (options.is_watched()) throw UsageError("--report is of a run on the terminal");
    PlayedTaxi network(run.network, files.receipts);
    const int status = play(network, play_as);
    write_taxi_report(network.network(), files.report);
    return status;
  }
  const auto make = [files](const TaxiRun& made) {
    return std::make_unique<PlayedTaxi>(made.network, files.receipts);
  };
  return play_world({.kind = "taxi",
                     .grammar = taxi::fault_grammar(),
                     .make = maker_of(run, make),
                     .file = file_of(run, taxi_run_text),
                     .plan = {.seed = run.network.faults.seed},
                     .decoding = {.profiles = {"447-3"}}},
                    play_as, options);
}

}  // namespace

int run_taxi_file(TomlTable& table, const std::string& path, const RunOptions& options) {
  return run(read_taxi_run(table, std::filesystem::path(path).parent_path().string()), options);
}

void add_run_taxi(Verb& app) {
  Verb& taxi = app.add_verb("taxi", "A shift of a taxi: CiA 447-3 (12h)");
  struct TaxiCommand {
    RunOptions run;
    TaxiFiles files;
    std::string nmea;
  };
  const auto options = std::make_shared<TaxiCommand>();
  add_run_options(taxi, options->run, fault_help(taxi::fault_grammar()));
  taxi.add({
      {"--report", options->files.report,
       "write what a verification of a taximeter asks for: as JSON where the name ends "
       "with .json, else as text"},
      {"--receipts", options->files.receipts,
       "a folder for pictures of all receipts: receipt-0001.png and so on"},
      {"--nmea", options->nmea,
       "a drive that a satellite receiver recorded, as NMEA 0183 (RMC, GGA, VTG): the "
       "car goes as it went then, and each way between two stops of 2 min is a trip"},
  });
  taxi.add_examples(
      "  canvoy run taxi --for 1h\n"
      "  canvoy run taxi --for 30min --fault lost-node:node=5@16min+1min --json");
  taxi.runs([options] {
    TaxiRun chosen;
    chosen.nmea = options->nmea;
    if (!chosen.nmea.empty()) chosen.network.record = read_drive_file(chosen.nmea);
    return run(std::move(chosen), options->run, options->files);
  });
}

}  // namespace canvoy::tools
