// canvoy run charger: plays the network of a battery and its charger.
#include <algorithm>
#include <functional>
#include <iterator>
#include <memory>
#include <utility>

#include "canvoy/text/time_text.hpp"
#include "canvoy/tools/device/wired_hands.hpp"
#include "canvoy/tools/device/wired_things.hpp"
#include "canvoy/tools/play/charger_text.hpp"
#include "canvoy/tools/play/hand_file.hpp"
#include "canvoy/tools/play/world.hpp"
#include "canvoy/tools/play/yard_settings.hpp"
#include "canvoy/tools/play/yard_text.hpp"
#include "canvoy/worlds/charger/charger_network.hpp"
#include "canvoy/worlds/charger/charging_yard.hpp"

namespace canvoy::tools {

namespace {

using charger::ChargerOptions;

struct ChargerRun : WorldRun {
  Duration duration = 8h;
  ChargerOptions network{};
  std::vector<HandOfFile> hands{};
  YardSettings yard{};
};

/// The device that a hand acts on.
struct ChargerPlace {
  NodeId id = 0;
  bool is_played = true;
};

ChargerPlace place_of(const ChargerOptions& options, std::string_view device) {
  if (device == "charger") return {options.charger_id, options.plays_charger};
  return {options.battery_id, options.plays_battery};
}

SettingTable<HandOfFile> charging_hand_table() {
  SettingTable<HandOfFile> table = hand_table(R"(`"charger"` or `"battery"`)");
  table.settings.push_back(place_setting(
      "bay", "of a yard; without it, the first one", charger::yard_chargers_max,
      [](const HandOfFile& hand) { return hand.bay; },
      [](HandOfFile& hand, unsigned value) { hand.bay = value; }));
  return table;
}

constexpr std::string_view not_played_here = "it is not played here: its hands are where it is";

/// Reads each `[[hands]]`, after the tables of the devices.
FilePart<ChargerRun> charging_hands() {
  return several<ChargerRun, HandOfFile>(
      [](const ChargerRun&) { return charging_hand_table(); },
      [](const ChargerRun& run) { return run.hands; },
      [](const TomlTable& table, ChargerRun& run, HandOfFile hand) {
        if (hand.device != "charger" && hand.device != "battery") {
          table.refuse("device",
                       fmt::format("there is no '{}': there are charger, battery", hand.device));
        }
        if (!place_of(run.network, hand.device).is_played) {
          table.refuse("device", not_played_here);
        }
        const std::vector<DeviceHand> hands = wired_hands(hand.device, Environment());
        const HandTable of_device = {hand.device, hands};
        order_of(table, hand, {&of_device, 1});
        add_hand(table, run.hands, std::move(hand));
      });
}

/// Hands of a file at charger and battery of a bay.
class BayHands : private WiredThings {
 public:
  using Note = std::function<void(Time, const HandActed&)>;

  /// All must outlive the last run of `world`, as this object must.
  BayHands(World& world, ChargingPlant& plant, Note note)
      : world_(world), plant_(plant), note_(std::move(note)) {}

  /// `options` are those of the bay.
  void plan(const HandOfFile& hand, const ChargerOptions& options) {
    const bool is_charger = hand.device == "charger";
    const HandTable table = {is_charger ? "charger" : "battery",
                             is_charger ? charger_hands_ : battery_hands_};
    const NodeId node = place_of(options, hand.device).id;
    plan_hand(world_, hand, checked_order(hand, {&table, 1}),
              [this, node](Time now, const HandOrder& order, const std::string& text) {
                const bool is_done =
                    order.hand->act({.unit = static_cast<WiredThings*>(this)}, order.value);
                note_(now,
                      {.node = node, .what = text, .refused = is_done ? "" : "not in this state"});
              });
  }

 private:
  ChargingPlant* charging() override { return &plant_; }

  World& world_;
  ChargingPlant& plant_;
  Note note_;
  std::vector<DeviceHand> charger_hands_ = wired_hands("charger", Environment());
  std::vector<DeviceHand> battery_hands_ = wired_hands("battery", Environment());
};

/// The network, with the hands of a file.
class PlayedCharging : public Played<charger::ChargerNetwork> {
 public:
  explicit PlayedCharging(const ChargerRun& run)
      : Played(run.network),
        hands_(network_.world(), network_.plant(),
               [this](Time now, const HandActed& acted) { network_.note_hand(now, acted); }) {
    for (const HandOfFile& hand : run.hands) hands_.plan(hand, run.network);
  }

 private:
  BayHands hands_;
};

class PlayedYard : public Played<charger::ChargingYard> {
 public:
  explicit PlayedYard(const ChargerRun& run) : Played(yard_of(run.yard, run.network)) {
    for (std::size_t i = 0; i < network_.bays(); ++i) {
      charger::ChargingBay& bay = network_.bay(i);
      hands_.push_back(std::make_unique<BayHands>(
          network_.world(), bay.devices().plant(),
          [&bay](Time now, const HandActed& acted) { bay.note(now, acted); }));
    }
    for (const HandOfFile& hand : run.hands) {
      const std::size_t bay = hand.bay == 0 ? 0 : hand.bay - 1;
      hands_[bay]->plan(hand, network_.bay(bay).options());
    }
  }

  std::vector<std::string> bus_names() const override {
    std::vector<std::string> names;
    for (std::size_t bus = 0; bus < network_.buses(); ++bus) {
      names.push_back(fmt::format("sim{}", bus));
    }
    return names;
  }
  std::vector<Judged> judged() const override { return judged_of(network_); }

 private:
  std::vector<std::unique_ptr<BayHands>> hands_;
};

bool is_at_real_device(const HandOfFile& hand, const YardSettings& yard) {
  const unsigned of_hand = std::max(hand.bay, 1U);
  return std::ranges::any_of(yard.bays, [&](const BayOfFile& bay) {
    const bool is_played = hand.device == "charger" ? bay.plays_charger : bay.plays_battery;
    return bay.bay == of_hand && !is_played;
  });
}

/// The real bus of `[bus]`; bays with a bus of their own have theirs.
Setting<ChargerRun> real_bus() {
  Setting<ChargerRun> real = real_setting<ChargerRun>(0);
  real.value = [of_bus = std::move(real.value)](const ChargerRun& run) {
    return run.yard.is_given && !run.yard.one_bus ? std::string() : of_bus(run);
  };
  return real;
}

/// `[yard]`, each `[[bay]]` and each `[[vehicle]]`, which are not in the file of one charger.
FilePart<ChargerRun> charging_yard() {
  const SettingTable<YardSettings> yard = yard_table();
  const SettingTable<VehicleOfFile> vehicles = yard_vehicle_table();
  const SettingTable<BayOfFile> bays = yard_bay_table();
  return {[yard, vehicles, bays](TomlTable& file, ChargerRun& run) {
            run.yard.is_given =
                file.has(yard.name) || file.has(vehicles.name) || file.has(bays.name);
            take_settings(file, yard, run.yard);
            for (TomlTable& each : file.tables(bays.name)) {
              take_settings(each, bays.settings, run.yard.bays.emplace_back());
              each.finish();
            }
            for (TomlTable& each : file.tables(vehicles.name)) {
              take_settings(each, vehicles.settings, run.yard.vehicles.emplace_back());
              each.finish();
            }
          },
          [yard, vehicles, bays](const ChargerRun& run) {
            if (!run.yard.is_given) return std::string();
            std::string text = settings_text(yard, run.yard);
            for (const BayOfFile& each : run.yard.bays) text += settings_text(bays, each, true);
            for (const VehicleOfFile& each : run.yard.vehicles) {
              text += settings_text(vehicles, each, true);
            }
            return text;
          },
          keys_text("[" + yard.name + "]", yard.settings) +
              keys_text("[[" + bays.name + "]]", bays.settings) +
              keys_text("[[" + vehicles.name + "]]", vehicles.settings)};
}

struct ChargerWorld {
  using Run = ChargerRun;
  using Kind = charger::FaultKind;
  struct Choice {
    double state_of_charge = 20;  ///< in %
    double ambience = 20;
    std::string begin = "2026-11-21 18:00:00";
    bool no_sdo_manager = false;
    YardChoice yard{};
  };
  static constexpr std::string_view name = "charger";
  static constexpr auto network = &Run::network;
  static constexpr double percent = 100;

  static WorldInfo info();
  static WorldInfo info(const Run& run);
  static WorldFile<Run> file(const std::string& folder);
  static void check(const TomlTable& file, const std::string& folder, Run& run);
  static Run run_of_file();
  static Duration& length(Run& run) { return run.duration; }
  static void add_options(Verb& verb, Choice& choice);
  static Run chosen(const Choice& choice);
  static void check_run(const Run& run);
  static MadeWorld make(const Run& run, const Choice&) {
    if (run.yard.is_given) return {.network = std::make_unique<PlayedYard>(run)};
    return {.network = std::make_unique<PlayedCharging>(run)};
  }
};

WorldInfo ChargerWorld::info() {
  return {
      .about = "A CiA 419 charger charges a CiA 418 battery (8h), or a yard of them many vehicles",
      .examples =
          "  canvoy run charger --for 20min --fault heartbeat-loss@5min+30s --log bus.log\n"
          "  canvoy run charger --for 10min --state-of-charge 80 --seed 7 --json\n"
          "  canvoy run charger --chargers 3 --batteries 5 --goal 80@06:00\n"
          "  canvoy run charger --print",
      .page = "charger",
      .decoding = {.nodes = {"5=419", "10=418"}}};
}

/// On one bus, nodes count up with the bays.
WorldInfo ChargerWorld::info(const Run& run) {
  WorldInfo info = ChargerWorld::info();
  if (!run.yard.is_given) return info;
  info.page = "charging-yard";
  info.decoding.nodes.clear();
  const unsigned nodes = run.yard.one_bus ? run.yard.chargers : 1;
  for (unsigned i = 0; i < nodes; ++i) {
    info.decoding.nodes.push_back(fmt::format("{}=419", run.network.charger_id + i));
    info.decoding.nodes.push_back(fmt::format("{}=418", run.network.battery_id + i));
  }
  return info;
}

Setting<ChargerRun> state_of_charge() {
  return mapped<ChargerRun, double>(
      {.key = "state_of_charge",
       .takes = "a number from 0 to 100",
       .read = [](ChargerRun& run,
                  double charge) { run.network.state_of_charge = charge / ChargerWorld::percent; },
       .write =
           [](const ChargerRun& run) {
             return run.network.state_of_charge * ChargerWorld::percent;
           },
       .range = {0, ChargerWorld::percent}},
      "%");
}

WorldFile<ChargerRun> ChargerWorld::file(const std::string&) {
  constexpr Range<NodeId> ids{1, node_id_max};
  return {.network = name,
          .title = "A CiA 419 charger charges a CiA 418 battery.",
          .head = world_head(setting<&Run::duration>("for", "virtual time"), name),
          .parts = {
              SettingTable<Run>{"bus",
                                "",
                                {setting<network, &ChargerOptions::bit_rate>("bit_rate", "bit/s",
                                                                             {{10'000, 1'000'000}}),
                                 real_bus()}},
              SettingTable<Run>{"charger",
                                "",
                                {setting<network, &ChargerOptions::charger_id>("id", "", {ids}),
                                 setting<network, &ChargerOptions::plays_charger>(
                                     "played", "false: a real one is on the bus"),
                                 setting<network, &ChargerOptions::begin>(
                                     "begin", "what its clock shows at the start")}},
              SettingTable<Run>{
                  "battery",
                  "",
                  {setting<network, &ChargerOptions::battery_id>("id", "", {ids}),
                   setting<network, &ChargerOptions::plays_battery>("played"), state_of_charge(),
                   setting<network, &ChargerOptions::ambience_celsius>(
                       "ambience", "degrees Celsius", {{-40, 85}})}},
              SettingTable<Run>{
                  "manager",
                  "",
                  {setting<network, &ChargerOptions::manager_id>(
                      "id", "gives the charger its SDO connection to the battery; 0: there is none",
                      {{0, node_id_max}})}},
              charging_hands(), charging_yard()}};
}

/// Faults have their bays, and vehicles theirs.
void ChargerWorld::check_run(const Run& run) {
  const unsigned bays = run.yard.is_given ? run.yard.chargers : 1;
  for (const auto& fault : run.network.faults.faults) {
    if (fault.part >= 1 && fault.part <= bays) continue;
    throw UsageError(fmt::format(
        "fault '{}': there {}", fault_text(fault),
        bays == 1 ? "is one bay, without a number" : fmt::format("are bays 1 to {}", bays)));
  }
}

void ChargerWorld::check(const TomlTable& file, const std::string&, Run& run) {
  const ChargerOptions& options = run.network;
  if (options.charger_id == options.battery_id || options.charger_id == options.manager_id ||
      options.battery_id == options.manager_id) {
    file.refuse("two nodes have one node-ID");
  }
  try {
    check_run(run);
  } catch (const UsageError& wrong) {
    file.refuse("faults", wrong.what());
  }
  if (run.yard.is_given) {
    const std::string wrong = wrong_of_yard(run.yard, options, !run.real.empty());
    if (!wrong.empty()) file.refuse("yard", wrong);
    std::ranges::copy(real_buses_of(run.yard), std::back_inserter(run.real));
  }
  const unsigned bays = run.yard.is_given ? run.yard.chargers : 1;
  if (std::ranges::any_of(run.hands, [bays](const HandOfFile& hand) { return hand.bay > bays; })) {
    file.refuse("hands", bays == 1 ? "there is one bay" : fmt::format("bays are 1 to {}", bays));
  }
  for (const HandOfFile& hand : run.hands) {
    if (is_at_real_device(hand, run.yard)) file.refuse("hands", not_played_here);
  }
  if (options.plays_charger && options.plays_battery) return;
  if (run.real.empty()) file.refuse("who is not played is on a real bus: write real = \"can0\"");
  if (!options.faults.faults.empty()) {
    file.refuse("faults", "only where charger and battery are both played");
  }
}

ChargerRun ChargerWorld::run_of_file() {
  Run run;
  run.network.manager_id = 1;  // the vehicle has a CANopen manager; no other node has this node-ID
  return run;
}

void ChargerWorld::add_options(Verb& verb, Choice& choice) {
  verb.add({
      {"--state-of-charge", choice.state_of_charge,
       "of the battery at the start, in % (default 20); a vehicle of a yard comes with this, or up "
       "to 30 % more",
       between(0.0, 100.0)},
      {"--ambience", choice.ambience, "temperature, in °C (default 20)", between(-40.0, 85.0)},
      {"--begin", choice.begin,
       "date and time of the charger's clock at the start (default 2026-11-21 "
       "18:00:00); it tells them each minute (TIME)"},
      {"--no-sdo-manager", choice.no_sdo_manager,
       "no CANopen manager gives the charger its SDO connection to the battery: it "
       "takes the default channel"},
  });
  add_yard_options(verb, choice.yard);
}

ChargerRun ChargerWorld::chosen(const Choice& choice) {
  ChargerRun run = run_of_file();
  const std::optional<TimeOfDay> begin = text::parse_time_of_day(choice.begin);
  if (!begin || !begin->valid()) {
    throw UsageError(fmt::format("--begin: '{}' is no time after 1984: write 2026-11-21 18:00:00",
                                 choice.begin));
  }
  run.network.begin = to_civil_time(*begin);
  if (choice.no_sdo_manager) run.network.manager_id = 0;
  run.network.state_of_charge = choice.state_of_charge / percent;
  run.network.ambience_celsius = choice.ambience;
  run.yard = chosen_yard(choice.yard);
  if (!run.yard.is_given) return run;
  const bool has_room = run.network.charger_id + run.yard.chargers <= run.network.battery_id;
  if (run.yard.one_bus && !has_room) {
    run.network.battery_id = static_cast<NodeId>(run.network.charger_id + run.yard.chargers);
  }
  const std::string wrong = wrong_of_yard(run.yard, run.network);
  if (!wrong.empty()) throw UsageError(wrong);
  const charger::YardOptions yard = yard_of(run.yard, run.network);
  if (yard.goal) run.duration = yard.goal->at - Time{} + 10min;
  return run;
}

}  // namespace

WorldEntry charger_world() {
  return world_entry<ChargerWorld>();
}

}  // namespace canvoy::tools
