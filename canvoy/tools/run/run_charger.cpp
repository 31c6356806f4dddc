// canvoy run charger: plays the network of a battery and its charger.
#include <fmt/format.h>

#include <functional>
#include <memory>
#include <nlohmann/json.hpp>

#include "canvoy/tools/failure.hpp"
#include "canvoy/tools/help/verb_help.hpp"
#include "canvoy/tools/live/play_world.hpp"
#include "canvoy/tools/run/charging_file.hpp"
#include "canvoy/tools/run/charging_text.hpp"
#include "canvoy/tools/run/run.hpp"
#include "canvoy/words/text.hpp"
#include "canvoy/words/time_text.hpp"

namespace canvoy::tools {

namespace {

class PlayedCharging : public PlayedNetwork {
 public:
  explicit PlayedCharging(const charging::ChargingOptions& options) : network_(options) {}

  World& world() override { return network_.world(); }
  void run_until(Time until) override { network_.run_until(until); }
  std::vector<std::string> bus_names() const override { return {"sim0"}; }
  std::size_t event_count() const override { return network_.events().size(); }
  ToldEvent event(std::size_t number) const override {
    return told_event(network_.events()[number], network_.options());
  }
  std::string picture(double speed) override { return table_text(network_, speed); }
  nlohmann::ordered_json snapshot() override { return snapshot_json(network_); }
  std::string summary_text() override { return tools::summary_text(network_); }
  nlohmann::ordered_json summary_json() override { return tools::summary_json(network_); }
  bool all_hold() const override { return network_.all_hold(); }

 private:
  charging::ChargingNetwork network_;
};

int run(ChargingRun run, const RunOptions& options) {
  PlayOptions play_as = play_options(options, run.duration);
  run.duration = play_as.duration;
  if (options.seed) run.network.faults.seed = *options.seed;
  for (const std::string& fault : options.faults) add_fault(run, fault);
  play_as.real = run.real;
  const auto make = [](const ChargingRun& made) {
    return std::make_unique<PlayedCharging>(made.network);
  };
  return play_world({.kind = "charger",
                     .grammar = charging::fault_grammar(),
                     .make = maker_of(run, make),
                     .file = file_of(run, charging_run_text),
                     .plan = {.seed = run.network.faults.seed},
                     .decoding = {.nodes = {"5=419", "10=418"}}},
                    play_as, options);
}

struct ChargerOptions {
  RunOptions run;
  double state_of_charge = 20;
  double ambience = 20;
  std::string begin = "2026-11-21 18:00:00";
  bool no_sdo_manager = false;
};

ChargingRun chosen(const ChargerOptions& options) {
  ChargingRun run = default_charging_run();
  const std::optional<TimeOfDay> begin = words::parse_time_of_day(options.begin);
  if (!begin || !begin->valid()) {
    throw UsageError(fmt::format("--begin: '{}' is no time after 1984: write 2026-11-21 18:00:00",
                                 options.begin));
  }
  run.network.begin = to_civil_time(*begin);
  if (options.no_sdo_manager) run.network.manager_id = 0;
  run.network.state_of_charge = options.state_of_charge / 100;
  run.network.ambience_celsius = options.ambience;
  return run;
}

}  // namespace

int run_charger_file(TomlTable& table, const RunOptions& options) {
  return run(read_charging_run(table), options);
}

void add_run_charger(Verb& app) {
  Verb& charger = app.add_verb("charger", "A CiA 419 charger charges a CiA 418 battery (8h)");
  const auto options = std::make_shared<ChargerOptions>();
  add_run_options(charger, options->run, fault_help(charging::fault_grammar()));
  charger.add({
      {"--state-of-charge", options->state_of_charge,
       "of the battery at the start, in % (default 20)", between(0.0, 100.0)},
      {"--ambience", options->ambience, "temperature, in °C (default 20)", between(-40.0, 85.0)},
      {"--begin", options->begin,
       "date and time of the charger's clock at the start (default 2026-11-21 "
       "18:00:00); it tells them each minute (TIME)"},
      {"--no-sdo-manager", options->no_sdo_manager,
       "no CANopen manager gives the charger its SDO connection to the battery: it "
       "takes the default channel"},
  });
  charger.add_examples(
      "  canvoy run charger --for 20min --fault heartbeat-loss@5min+30s --log bus.log\n"
      "  canvoy run charger --for 10min --state-of-charge 80 --seed 7 --json\n"
      "  canvoy run charger --print");
  charger.runs([options] { return run(chosen(*options), options->run); });
}

}  // namespace canvoy::tools
