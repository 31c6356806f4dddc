// canvoy run excavator: plays a shift of an excavator.
#include <fmt/format.h>

#include <filesystem>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>

#include "canvoy/tools/failure.hpp"
#include "canvoy/tools/help/verb_help.hpp"
#include "canvoy/tools/live/play_world.hpp"
#include "canvoy/tools/run/excavator_file.hpp"
#include "canvoy/tools/run/excavator_picture.hpp"
#include "canvoy/tools/run/excavator_text.hpp"
#include "canvoy/tools/run/run.hpp"
#include "canvoy/tools/run/shift_file.hpp"
#include "canvoy/words/text.hpp"

namespace canvoy::tools {

namespace {

class PlayedExcavator : public PlayedNetwork {
 public:
  explicit PlayedExcavator(const excavator::ExcavatorOptions& options) : network_(options) {}

  World& world() override { return network_.world(); }
  void run_until(Time until) override { network_.run_until(until); }
  std::vector<std::string> bus_names() const override { return {"sim0", "sim1"}; }
  std::size_t event_count() const override { return network_.events().size(); }
  ToldEvent event(std::size_t number) const override {
    return told_event(network_.events()[number], network_);
  }
  std::string picture(double speed) override { return dashboard_text(network_, speed); }
  nlohmann::ordered_json snapshot() override { return snapshot_json(network_); }
  std::string summary_text() override { return tools::summary_text(network_); }
  nlohmann::ordered_json summary_json() override { return tools::summary_json(network_); }
  bool all_hold() const override { return network_.all_hold(); }
  const excavator::RecordedShift& shift() const { return network_.recorded_shift(); }

 private:
  excavator::ExcavatorNetwork network_;
};

/// Of the command line, beside what all networks have.
struct ShiftFiles {
  std::string played{};
  std::string recorded{};
};

int play_and_record(ExcavatorRun run, const PlayOptions& play_as, const std::string& path) {
  run.network.records_shift = true;
  PlayedExcavator network(run.network);
  const int status = play(network, play_as);
  write_shift(path, network.shift());
  return status;
}

int run_excavator(ExcavatorRun run, const RunOptions& options, const ShiftFiles& files = {}) {
  if (!files.played.empty()) choose_shift(run, files.played);
  PlayOptions play_as = play_options(options, run.network.length);
  run.network.length = play_as.duration;
  if (options.seed) run.network.faults.seed = *options.seed;
  for (const std::string& fault : options.faults) add_fault(run, fault);
  play_as.real = run.real;
  play_as.terminal_speed = 1;
  if (!files.recorded.empty()) {
    if (options.is_watched()) throw UsageError("--record-shift is of a run on the terminal");
    return play_and_record(run, play_as, files.recorded);
  }
  const auto make = [](const ExcavatorRun& made) {
    return std::make_unique<PlayedExcavator>(made.network);
  };
  return play_world({.kind = "excavator",
                     .grammar = excavator::fault_grammar(),
                     .make = maker_of(run, make),
                     .file = file_of(run, excavator_run_text),
                     .plan = {.seed = run.network.faults.seed},
                     .decoding = {.profiles = {"852", "401"}}},
                    play_as, options);
}

}  // namespace

int run_excavator_file(TomlTable& table, const std::string& path, const RunOptions& options) {
  const std::string folder = std::filesystem::path(path).parent_path().string();
  return run_excavator(read_excavator_run(table, folder), options);
}

void add_run_excavator(Verb& app) {
  Verb& shift = app.add_verb("excavator", "A shift of an excavator: CiA 852 and CiA 401 (8h)");
  const auto options = std::make_shared<RunOptions>();
  const auto files = std::make_shared<ShiftFiles>();
  add_run_options(shift, *options, fault_help(excavator::fault_grammar()));
  shift.add({
      {"--shift", files->played,
       "a recorded shift that is played again, as CSV (docs/excavator.md)"},
      {"--record-shift", files->recorded, "write what hands do into a file that --shift takes"},
  });
  shift.add_examples(
      "  canvoy run excavator --for 10min\n"
      "  canvoy run excavator --for 10min --fault lost-node@2min+10s");
  shift.runs([options, files] { return run_excavator(ExcavatorRun{}, *options, *files); });
}

}  // namespace canvoy::tools
