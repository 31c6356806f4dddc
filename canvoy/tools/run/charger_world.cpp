// canvoy run charger: plays the network of a battery and its charger.
#include "canvoy/sim/charging/charging_network.hpp"
#include "canvoy/tools/run/charging_text.hpp"
#include "canvoy/tools/run/world.hpp"
#include "canvoy/words/time_text.hpp"

namespace canvoy::tools {

namespace {

using charging::ChargingOptions;

struct ChargingRun : WorldRun {
  Duration duration = 8h;
  ChargingOptions network{};
};

struct ChargerWorld {
  using Run = ChargingRun;
  using Kind = charging::FaultKind;
  struct Choice {
    double state_of_charge = 20;  ///< in %
    double ambience = 20;
    std::string begin = "2026-11-21 18:00:00";
    bool no_sdo_manager = false;
  };
  static constexpr std::string_view name = "charger";
  static constexpr auto network = &Run::network;
  static constexpr double percent = 100;

  static WorldInfo info();
  static WorldFile<Run> file(const std::string& folder);
  static void check(const TomlTable& file, const std::string& folder, Run& run);
  static Run run_of_file();
  static Duration& length(Run& run) { return run.duration; }
  static void add_options(Verb& verb, Choice& choice);
  static Run chosen(const Choice& choice);
  static MadeWorld make(const Run& run, const Choice&) {
    return {.network = std::make_unique<Played<charging::ChargingNetwork>>(run.network)};
  }
};

WorldInfo ChargerWorld::info() {
  return {.about = "A CiA 419 charger charges a CiA 418 battery (8h)",
          .examples =
              "  canvoy run charger --for 20min --fault heartbeat-loss@5min+30s --log bus.log\n"
              "  canvoy run charger --for 10min --state-of-charge 80 --seed 7 --json\n"
              "  canvoy run charger --print",
          .page = "charger",
          .decoding = {.nodes = {"5=419", "10=418"}}};
}

Setting<ChargingRun> state_of_charge() {
  return mapped<ChargingRun, double>(
      {.key = "state_of_charge",
       .takes = "a number from 0 to 100",
       .read = [](ChargingRun& run,
                  double charge) { run.network.state_of_charge = charge / ChargerWorld::percent; },
       .write =
           [](const ChargingRun& run) {
             return run.network.state_of_charge * ChargerWorld::percent;
           },
       .range = {0, ChargerWorld::percent}},
      "%");
}

WorldFile<ChargingRun> ChargerWorld::file(const std::string&) {
  constexpr Range<NodeId> ids{1, node_id_max};
  return {.network = name,
          .title = "A CiA 419 charger charges a CiA 418 battery.",
          .head = world_head(setting<&Run::duration>("for", "virtual time"), name),
          .parts = {
              SettingTable<Run>{"bus",
                                "",
                                {setting<network, &ChargingOptions::bit_rate>(
                                     "bit_rate", "bit/s", {{10'000, 1'000'000}}),
                                 real_setting<Run>(0)}},
              SettingTable<Run>{"charger",
                                "",
                                {setting<network, &ChargingOptions::charger_id>("id", "", {ids}),
                                 setting<network, &ChargingOptions::plays_charger>(
                                     "played", "false: a real one is on the bus"),
                                 setting<network, &ChargingOptions::begin>(
                                     "begin", "what its clock shows at the start")}},
              SettingTable<Run>{
                  "battery",
                  "",
                  {setting<network, &ChargingOptions::battery_id>("id", "", {ids}),
                   setting<network, &ChargingOptions::plays_battery>("played"), state_of_charge(),
                   setting<network, &ChargingOptions::ambience_celsius>(
                       "ambience", "degrees Celsius", {{-40, 85}})}},
              SettingTable<Run>{
                  "manager",
                  "",
                  {setting<network, &ChargingOptions::manager_id>(
                      "id", "gives the charger its SDO connection to the battery; 0: there is none",
                      {{0, node_id_max}})}}}};
}

void ChargerWorld::check(const TomlTable& file, const std::string&, Run& run) {
  const ChargingOptions& options = run.network;
  if (options.charger_id == options.battery_id || options.charger_id == options.manager_id ||
      options.battery_id == options.manager_id) {
    file.refuse("two nodes have one node-ID");
  }
  if (options.plays_charger && options.plays_battery) return;
  if (run.real.empty()) file.refuse("who is not played is on a real bus: write real = \"can0\"");
  if (!options.faults.faults.empty()) {
    file.refuse("faults", "only where charger and battery are both played");
  }
}

ChargingRun ChargerWorld::run_of_file() {
  Run run;
  run.network.manager_id =
      1;  // in the vehicle there is a CANopen manager; nobody else has this node-ID
  return run;
}

void ChargerWorld::add_options(Verb& verb, Choice& choice) {
  verb.add({
      {"--state-of-charge", choice.state_of_charge,
       "of the battery at the start, in % (default 20)", between(0.0, 100.0)},
      {"--ambience", choice.ambience, "temperature, in °C (default 20)", between(-40.0, 85.0)},
      {"--begin", choice.begin,
       "date and time of the charger's clock at the start (default 2026-11-21 "
       "18:00:00); it tells them each minute (TIME)"},
      {"--no-sdo-manager", choice.no_sdo_manager,
       "no CANopen manager gives the charger its SDO connection to the battery: it "
       "takes the default channel"},
  });
}

ChargingRun ChargerWorld::chosen(const Choice& choice) {
  ChargingRun run = run_of_file();
  const std::optional<TimeOfDay> begin = words::parse_time_of_day(choice.begin);
  if (!begin || !begin->valid()) {
    throw UsageError(fmt::format("--begin: '{}' is no time after 1984: write 2026-11-21 18:00:00",
                                 choice.begin));
  }
  run.network.begin = to_civil_time(*begin);
  if (choice.no_sdo_manager) run.network.manager_id = 0;
  run.network.state_of_charge = choice.state_of_charge / percent;
  run.network.ambience_celsius = choice.ambience;
  return run;
}

}  // namespace

WorldEntry charger_world() {
  return world_entry<ChargerWorld>();
}

}  // namespace canvoy::tools
