#include "canvoy/tools/play/lift_world.hpp"

#include "canvoy/text/text.hpp"
#include "canvoy/tools/play/arrival_list.hpp"
#include "canvoy/tools/play/lift_hands.hpp"
#include "canvoy/tools/play/lift_text.hpp"
#include "canvoy/worlds/lift/lift_network.hpp"

namespace canvoy::tools {

namespace {

using lift::LiftNetwork;
using lift::LiftNetworkDescription;

class PlayedLifts : public Played<LiftNetwork> {
 public:
  explicit PlayedLifts(const LiftRun& run) : Played(run.network), hands_(network_, run.hands) {}

  std::vector<std::string> bus_names() const override {
    std::vector<std::string> names;
    for (const lift::BusDescription& bus : network_.description().buses) names.push_back(bus.name);
    return names;
  }
  bool takes_visitors() const override { return true; }
  bool has_way(unsigned from, unsigned to) const override {
    const lift::Building& building = network_.description().building;
    const auto is_floor = [&](unsigned floor) {
      return floor >= 1 && floor <= building.floor_count();
    };
    return is_floor(from) && is_floor(to) && from != to &&
           building.has_way(static_cast<lift::FloorNumber>(from),
                            static_cast<lift::FloorNumber>(to));
  }
  void visit(unsigned from, unsigned to) override {
    network_.visit(static_cast<lift::FloorNumber>(from), static_cast<lift::FloorNumber>(to));
  }

 private:
  LiftHands hands_;
};

}  // namespace

WorldInfo LiftWorld::info() {
  return {.about = "A building with lifts of CiA 417 (1h)",
          .examples =
              "  canvoy run lift --lifts 2 --floors 6 --for 5min\n"
              "  canvoy run lift --traffic lunch --percent 12 --for 2min --fault "
              "dead-encoder@1min+30s\n"
              "  canvoy run lift --lifts 4 --print",
          .page = "lift",
          .terminal_speed = 10,
          .decoding = {.profiles = {"417"}}};
}

WorldFile<LiftRun> LiftWorld::file(const std::string& folder) {
  WorldFile<Run> file{.network = name,
                      .head = world_head(setting<&Run::duration>("for", "virtual time"), name),
                      .parts = lift_parts(folder)};
  auto called = setting<&Run::network, &LiftNetworkDescription::name>("name");
  called.value = [](const Run& run) { return text_value(run.network.name); };
  file.head.insert(file.head.begin(), std::move(called));
  Setting<Run>& seed = file.head.at(2);
  seed.take = [](TomlTable& table, Run& run) {
    std::uint64_t seed = run.network.faults.seed;
    table.take("seed", seed);
    set_seed(run, seed);
  };
  return file;
}

void LiftWorld::add_options(Verb& verb, Choice& choice) {
  verb.add({
      {"--lifts", choice.lifts, "1 (default) to 8", between(1U, unsigned{lift::lifts_max})},
      {"--floors", choice.floors, "2 to 254 (default 10)", between(2U, unsigned{lift::floors_max})},
      {"--traffic", choice.traffic, "up-peak, down-peak, interfloor (default), lunch"},
      {"--percent", choice.percent,
       "of the population (50 a floor) that comes within five minutes (default 6)",
       between(0.0, 100.0)},
      {"--people", choice.people,
       "a CSV file of those who come, in place of --traffic: seconds,from,to,kg",
       excludes("--traffic", "--percent")},
      {"--destination-control", choice.destination_control,
       "people say at the landing where they want to go"},
  });
}

LiftRun LiftWorld::chosen(const Choice& choice) {
  lift::StandardLifts standard;
  standard.lifts = static_cast<lift::LiftNumber>(choice.lifts);
  standard.floors = static_cast<lift::FloorNumber>(choice.floors);
  standard.destination_control = choice.destination_control;
  standard.traffic.pattern = parse_traffic_pattern(choice.traffic);
  if (choice.percent) standard.traffic.percent_in_5_minutes = *choice.percent;
  Run run;
  run.network = lift::standard_lift_network(standard);
  if (!choice.people.empty()) {
    run.arrival_list = choice.people;
    run.network.arrivals = read_arrivals(choice.people, run.network.building);
  }
  return run;
}

namespace {

/// Throws if a node refuses a value of the file.
void check_values(const LiftNetwork& network) {
  const std::optional<lift::RefusedValue> refused = network.refused();
  if (!refused) return;
  const auto& [node, refusal] = *refused;
  throw UsageError(fmt::format(
      "{} with node-ID {} on bus {} does not take {}: {}", lift::device_kind_name(node.kind),
      node.id, network.description().buses[node.bus].name,
      text::object_text(refusal.value.index, refusal.value.sub), text::abort_text(refusal.reason)));
}

}  // namespace

MadeWorld LiftWorld::make(const Run& run, const Choice&) {
  auto played = std::make_unique<PlayedLifts>(run);
  check_values(played->network());
  MadeWorld world{
      .network = nullptr,
      .scenery = std::make_shared<const nlohmann::ordered_json>(building_json(run.network))};
  world.network = std::move(played);
  return world;
}

WorldEntry lift_world() {
  return world_entry<LiftWorld>();
}

}  // namespace canvoy::tools
