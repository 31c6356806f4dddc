// canvoy run police: plays a patrol of a police car.
#include "canvoy/tools/play/car_file.hpp"
#include "canvoy/tools/play/police_text.hpp"
#include "canvoy/tools/play/world.hpp"
#include "canvoy/tools/play/world_hands.hpp"
#include "canvoy/worlds/police/police_network.hpp"

namespace canvoy::tools {

namespace {

using police::PoliceOptions;

struct PoliceRun : WorldRun {
  PoliceOptions network{};
  std::vector<HandOfFile> hands{};
};

class PlayedPatrol : public Played<police::PoliceNetwork> {
 public:
  explicit PlayedPatrol(const PoliceRun& run) : Played(run.network) {
    plan_hands(network_, run.hands);
  }
};

struct PoliceWorld {
  using Run = PoliceRun;
  using Kind = police::FaultKind;
  struct Choice {};
  static constexpr std::string_view name = "police";
  static constexpr auto network = &Run::network;

  static WorldInfo info();
  static WorldFile<Run> file(const std::string& folder);
  static void check(const TomlTable& file, const std::string&, Run& run) {
    check_real(file, run, [](NodeId) { return BusIndex{0}; }, {"bus"});
    check_identities(file, run, police::armoured_names);
    for (const NodeId real : run.network.real) {
      if (real <= node_count(run)) continue;
      file.refuse(fmt::format("[{}] rides in an armoured car: write armoured = true",
                              police::armoured_names.at(real - 1U)));
    }
  }
  static std::size_t node_count(const Run& run) {
    return run.network.is_armoured ? police::armoured_names.size() : police::device_names.size();
  }
  static Run run_of_file() { return {}; }
  static Duration& length(Run& run) { return run.network.length; }
  static std::string check_fault_node(const Run& run, NodeId id) {
    return check_node_up_to(node_count(run), id);
  }
  static Run chosen(const Choice&) { return {}; }
  static MadeWorld make(const Run& run, const Choice&) {
    return {.network = std::make_unique<PlayedPatrol>(run)};
  }
  static std::vector<DescribedNode> describe(const Run& run) {
    return describe_car<police::PoliceNetwork>(run.network, cia447::listed_offsets());
  }
};

WorldInfo PoliceWorld::info() {
  return {.about = "A patrol of a police car: CiA 447-3 (8h)",
          .examples =
              "  canvoy run police --for 1h\n"
              "  canvoy run police --for 30min --fault dead-client@10min+5min",
          .page = "police",
          .decoding = {.profiles = {"447-3"}}};
}

WorldFile<PoliceRun> PoliceWorld::file(const std::string&) {
  WorldFile<Run> file{.network = name,
                      .title = "A patrol of a police car: CiA 447-3.",
                      .head = world_head(setting<network, &PoliceOptions::length>(
                                             "for", "virtual time; the patrol ends an hour before"),
                                         name),
                      .parts = {SettingTable<Run>{"bus",
                                                  "",
                                                  {setting<network, &PoliceOptions::bit_rate>(
                                                       "bit_rate", "bit/s", {{50'000, 1'000'000}}),
                                                   real_setting<Run>(0)}}}};
  file.head.push_back(setting<network, &PoliceOptions::is_armoured>(
      "armoured", "fire extinguishing and fresh-air systems ride along"));
  for (std::size_t i = 0; i < police::armoured_names.size(); ++i) {
    const auto id = static_cast<NodeId>(i + 1);
    SettingTable<Run> device{std::string(police::armoured_names.at(i)), "", played_in_car<Run>(id)};
    if (id == police::power_supply_id) {
      using Supply = cia447::PowerSupplySettings;
      constexpr auto supply = &PoliceOptions::supply;
      device.settings.push_back(setting<network, supply, &Supply::radio_after_run>(
          "radio_after_run", "of the power when the ignition is off"));
      device.settings.push_back(
          setting<network, supply, &Supply::periphery_after_run>("periphery_after_run"));
    }
    file.parts.emplace_back(std::move(device));
  }
  file.parts.push_back(
      hands_part<police::PoliceNetwork, Run>(PoliceOptions{.is_armoured = true}, node_count));
  return file;
}

}  // namespace

WorldEntry police_world() {
  return world_entry<PoliceWorld>();
}

}  // namespace canvoy::tools
