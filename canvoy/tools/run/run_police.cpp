// canvoy run police: plays a patrol of a police car.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
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
  std::string take_events(bool json) override {
    std::string text;
    const auto events = network_.events();
    for (; told_ < events.size(); ++told_) {
      const police::PoliceEvent& event = events[told_];
      text += json ? event_json(event, network_).dump() + "\n"
                   : fmt::format("{:>20}  {}\n", words::duration_text(event.at - Time{}),
                                 event_text(event, network_));
    }
    return text;
  }
  std::string picture(double speed) override { return dashboard_text(network_, speed); }
  nlohmann::ordered_json snapshot() override { return snapshot_json(network_); }
  std::string summary_text() override { return tools::summary_text(network_); }
  nlohmann::ordered_json summary_json() override { return tools::summary_json(network_); }
  bool all_hold() const override { return network_.all_hold(); }

 private:
  police::PoliceNetwork network_;
  std::size_t told_ = 0;
};

int run_police(PoliceRun run, const RunOptions& options) {
  PlayOptions play_as = play_options(options, run.network.length);
  run.network.length = play_as.duration;
  if (options.seed) run.network.faults.seed = *options.seed;
  for (const std::string& fault : options.faults) add_fault(run, fault);
  if (options.print) {
    fmt::print("{}", police_run_text(run));
    return exit_done;
  }
  play_as.real = run.real;
  const auto make = [](const PoliceRun& made) {
    return std::make_unique<PlayedPolice>(made.network);
  };
  return play_world({.kind = "police",
                     .grammar = police::fault_grammar(),
                     .make = maker_of(run, make),
                     .plan = {.seed = run.network.faults.seed},
                     .decoding = {.profiles = {"447-3"}}},
                    play_as, options);
}

}  // namespace

int run_police_file(TomlTable& table, const RunOptions& options) {
  return run_police(read_police_run(table), options);
}

void add_run_police(CLI::App& app, std::function<int()>& action) {
  CLI::App* patrol = app.add_subcommand("police", "A patrol of a police car: CiA 447-3 (8h)");
  const auto options = std::make_shared<RunOptions>();
  add_run_options(*patrol, *options, fault_help(police::fault_grammar()));
  add_examples(*patrol,
               "  canvoy run police --for 1h\n"
               "  canvoy run police --for 30min --fault dead-client@10min+5min");
  patrol->callback(
      [options, &action] { action = [options] { return run_police(PoliceRun{}, *options); }; });
}

}  // namespace canvoy::tools
