// canvoy run excavator: plays a shift of an excavator.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>

#include "canvoy/tools/failure.hpp"
#include "canvoy/tools/help/verb_help.hpp"
#include "canvoy/tools/live/play_world.hpp"
#include "canvoy/tools/run/excavator_file.hpp"
#include "canvoy/tools/run/excavator_text.hpp"
#include "canvoy/tools/run/run.hpp"
#include "canvoy/words/text.hpp"

namespace canvoy::tools {

namespace {

class PlayedExcavator : public PlayedNetwork {
 public:
  explicit PlayedExcavator(const excavator::ExcavatorOptions& options) : network_(options) {}

  World& world() override { return network_.world(); }
  void run_until(Time until) override { network_.run_until(until); }
  std::vector<std::string> bus_names() const override { return {"sim0"}; }
  std::string take_events(bool json) override {
    std::string text;
    const auto events = network_.events();
    for (; told_ < events.size(); ++told_) {
      const excavator::ExcavatorEvent& event = events[told_];
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
  excavator::ExcavatorNetwork network_;
  std::size_t told_ = 0;
};

int run_excavator(ExcavatorRun run, const RunOptions& options) {
  PlayOptions play_as = play_options(options, run.network.length);
  run.network.length = play_as.duration;
  if (options.seed) run.network.faults.seed = *options.seed;
  for (const std::string& fault : options.faults) add_fault(run, fault);
  if (options.print) {
    fmt::print("{}", excavator_run_text(run));
    return exit_done;
  }
  play_as.real = run.real;
  play_as.terminal_speed = 1;
  const auto make = [](const ExcavatorRun& made) {
    return std::make_unique<PlayedExcavator>(made.network);
  };
  return play_world({.kind = "excavator",
                     .grammar = excavator::fault_grammar(),
                     .make = maker_of(run, make),
                     .plan = {.seed = run.network.faults.seed},
                     .decoding = {.profiles = {"852", "401"}}},
                    play_as, options);
}

}  // namespace

int run_excavator_file(TomlTable& table, const RunOptions& options) {
  return run_excavator(read_excavator_run(table), options);
}

void add_run_excavator(CLI::App& app, std::function<int()>& action) {
  CLI::App* shift =
      app.add_subcommand("excavator", "A shift of an excavator: CiA 852 and CiA 401 (8h)");
  const auto options = std::make_shared<RunOptions>();
  add_run_options(*shift, *options, fault_help(excavator::fault_grammar()));
  add_examples(*shift,
               "  canvoy run excavator --for 10min\n"
               "  canvoy run excavator --for 10min --fault lost-node@2min+10s");
  shift->callback([options, &action] {
    action = [options] { return run_excavator(ExcavatorRun{}, *options); };
  });
}

}  // namespace canvoy::tools
