// canvoy run lift: plays a building with lifts.
#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "canvoy/sim/lift/lift_network.hpp"
#include "canvoy/tools/failure.hpp"
#include "canvoy/tools/help/verb_help.hpp"
#include "canvoy/tools/live/play_world.hpp"
#include "canvoy/tools/run/arrival_list.hpp"
#include "canvoy/tools/run/lift_file.hpp"
#include "canvoy/tools/run/lift_picture.hpp"
#include "canvoy/tools/run/lift_text.hpp"
#include "canvoy/tools/run/run.hpp"
#include "canvoy/tools/terminal/screen.hpp"
#include "canvoy/words/text.hpp"

namespace canvoy::tools {

namespace {

/// How many rows of floors a terminal has room for, beside what is around them and some events.
unsigned floor_rows(const Screen::Size& size) {
  constexpr unsigned rows_around = 10;
  constexpr unsigned rows_of_events = 4;
  constexpr unsigned rows_least = 8;
  return std::max(size.rows, rows_around + rows_of_events + rows_least) - rows_around -
         rows_of_events;
}

class PlayedLifts : public PlayedNetwork {
 public:
  explicit PlayedLifts(const lift::LiftNetworkDescription& description) : network_(description) {}

  World& world() override { return network_.world(); }
  void run_until(Time until) override { network_.run_until(until); }
  std::vector<std::string> bus_names() const override {
    std::vector<std::string> names;
    for (const lift::BusDescription& bus : description().buses) names.push_back(bus.name);
    return names;
  }
  std::size_t event_count() const override { return network_.events().size(); }
  ToldEvent event(std::size_t number) const override {
    return told_event(network_.events()[number], description());
  }
  std::string picture(double speed) override {
    const Screen::Size size = Screen::size();
    return lift_picture(description(), network_.snapshot(), speed, floor_rows(size), size.columns);
  }
  nlohmann::ordered_json snapshot() override {
    return lift_snapshot_json(description(), network_.snapshot());
  }
  std::string summary_text() override {
    return lift_summary_text(network_.summary(), network_.invariants(), description());
  }
  nlohmann::ordered_json summary_json() override {
    return lift_summary_json(network_.summary(), network_.invariants(), description());
  }
  bool all_hold() const override { return network_.all_hold(); }
  bool visit(unsigned from, unsigned to) {
    return network_.visit(static_cast<lift::FloorNumber>(from), static_cast<lift::FloorNumber>(to));
  }

  /// Throws where a node does not take a value that the file gives it.
  void check_values() const {
    const std::optional<lift::RefusedValue> refused = network_.refused();
    if (!refused) return;
    const auto& [node, refusal] = *refused;
    throw UsageError(fmt::format("{} with node-ID {} on bus {} does not take {}: {}",
                                 lift::device_kind_name(node.kind), node.id,
                                 description().buses[node.bus].name,
                                 words::object_text(refusal.value.index, refusal.value.sub),
                                 words::abort_text(refusal.reason)));
  }

 private:
  const lift::LiftNetworkDescription& description() const { return network_.description(); }

  lift::LiftNetwork network_;
};

/// Traffic and people of a file may have seeds of their own: they stay until another one is wanted.
LiftRun planned(LiftRun run, const WorldPlan& plan) {
  lift::LiftNetworkDescription& network = run.network;
  if (plan.seed != network.seed) {
    network.seed = network.traffic.seed = network.people.seed = plan.seed;
  }
  add_lift_faults(run, plan.faults);
  const std::string error = lift::check(network);
  if (!error.empty()) throw UsageError(error);
  return run;
}

MadeWorld made(const LiftRun& run) {
  const lift::LiftNetworkDescription& network = run.network;
  auto played = std::make_unique<PlayedLifts>(network);
  played->check_values();
  MadeWorld world{
      .network = nullptr,
      .scenery = std::make_shared<const nlohmann::ordered_json>(building_json(network))};
  world.visit = [&lifts = *played](unsigned from, unsigned to) { return lifts.visit(from, to); };
  world.network = std::move(played);
  return world;
}

int run(LiftRun run, const RunOptions& options) {
  PlayOptions play_as = play_options(options, run.duration);
  run.duration = play_as.duration;
  lift::LiftNetworkDescription& network = run.network;
  if (options.seed) network.seed = network.traffic.seed = network.people.seed = *options.seed;
  add_lift_faults(run, options.faults);
  const std::string error = lift::check(network);
  if (!error.empty()) throw UsageError(error);
  play_as.real = run.real;
  play_as.terminal_speed = 10;
  return play_world(
      {.kind = "lift",
       .grammar = lift::fault_grammar(),
       .make = [run](const WorldPlan& plan) { return made(planned(run, plan)); },
       .file = [run](const WorldPlan& plan) { return lift_run_text(planned(run, plan)); },
       .plan = {.seed = network.seed},
       .decoding = {.profiles = {"417"}}},
      play_as, options);
}

struct LiftOptions {
  RunOptions run;
  unsigned lifts = 1;
  unsigned floors = 10;
  std::string traffic = "interfloor";
  std::string people;
  std::optional<double> percent;
  bool destination_control = false;
};

LiftRun chosen(const LiftOptions& options) {
  lift::StandardLifts standard;
  standard.lifts = static_cast<lift::LiftNumber>(options.lifts);
  standard.floors = static_cast<lift::FloorNumber>(options.floors);
  standard.destination_control = options.destination_control;
  standard.traffic.pattern = parse_traffic_pattern(options.traffic);
  if (options.percent) standard.traffic.percent_in_5_minutes = *options.percent;
  LiftRun run;
  run.network = lift::standard_lift_network(standard);
  if (!options.people.empty()) {
    run.arrival_list = options.people;
    run.network.arrivals = read_arrivals(options.people, run.network.building);
  }
  return run;
}

}  // namespace

int run_lift_file(TomlTable& table, const std::string& path, const RunOptions& options) {
  return run(read_lift_run(table, std::filesystem::path(path).parent_path().string()), options);
}

void add_run_lift(Verb& app) {
  Verb& command = app.add_verb("lift", "A building with lifts of CiA 417 (1h)");
  const auto options = std::make_shared<LiftOptions>();
  add_run_options(command, options->run, fault_help(lift::fault_grammar()));
  command.add({
      {"--lifts", options->lifts, "1 (default) to 8", between(1U, unsigned{lift::lifts_max})},
      {"--floors", options->floors, "2 to 254 (default 10)",
       between(2U, unsigned{lift::floors_max})},
      {"--traffic", options->traffic, "up-peak, down-peak, interfloor (default), lunch"},
      {"--percent", options->percent,
       "of the population (50 a floor) that comes within five minutes (default 6)",
       between(0.0, 100.0)},
      {"--people", options->people,
       "a CSV file of those who come, in place of --traffic: seconds,from,to,kg",
       excludes("--traffic", "--percent")},
      {"--destination-control", options->destination_control,
       "people say at the landing where they want to go"},
  });
  command.add_examples(
      "  canvoy run lift --lifts 2 --floors 6 --for 5min\n"
      "  canvoy run lift --traffic lunch --percent 12 --for 2min --fault dead-encoder@1min+30s\n"
      "  canvoy run lift --lifts 4 --print");
  command.runs([options] { return run(chosen(*options), options->run); });
}

}  // namespace canvoy::tools
