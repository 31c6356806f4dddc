// canvoy run police: plays a patrol of a police car.
#include <fmt/format.h>

#include <functional>
#include <memory>
#include <nlohmann/json.hpp>

#include "canvoy/tools/failure.hpp"
#include "canvoy/tools/help/verb_help.hpp"
#include "canvoy/tools/live/play_world.hpp"
#include "canvoy/tools/run/police_file.hpp"
#include "canvoy/tools/run/police_text.hpp"
#include "canvoy/tools/run/run.hpp"
#include "canvoy/words/text.hpp"

namespace canvoy::tools {

namespace {

class PlayedPolice : public PlayedNetwork {
 public:
  explicit PlayedPolice(const police::PoliceOptions& options) : network_(options) {}

  World& world() override { return network_.world(); }
  void run_until(Time until) override { network_.run_until(until); }
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

 private:
  police::PoliceNetwork network_;
};

int run_police(PoliceRun run, const RunOptions& options) {
  PlayOptions play_as = play_options(options, run.network.length);
  run.network.length = play_as.duration;
  if (options.seed) run.network.faults.seed = *options.seed;
  for (const std::string& fault : options.faults) add_fault(run, fault);
  play_as.real = run.real;
  const auto make = [](const PoliceRun& made) {
    return std::make_unique<PlayedPolice>(made.network);
  };
  return play_world({.kind = "police",
                     .grammar = police::fault_grammar(),
                     .make = maker_of(run, make),
                     .file = file_of(run, police_run_text),
                     .plan = {.seed = run.network.faults.seed},
                     .decoding = {.profiles = {"447-3"}}},
                    play_as, options);
}

}  // namespace

int run_police_file(TomlTable& table, const RunOptions& options) {
  return run_police(read_police_run(table), options);
}

void add_run_police(Verb& app) {
  Verb& patrol = app.add_verb("police", "A patrol of a police car: CiA 447-3 (8h)");
  const auto options = std::make_shared<RunOptions>();
  add_run_options(patrol, *options, fault_help(police::fault_grammar()));
  patrol.add_examples(
      "  canvoy run police --for 1h\n"
      "  canvoy run police --for 30min --fault dead-client@10min+5min");
  patrol.runs([options] { return run_police(PoliceRun{}, *options); });
}

}  // namespace canvoy::tools
