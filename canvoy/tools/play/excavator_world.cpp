// canvoy run excavator: plays a shift of an excavator.
#include <filesystem>

#include "canvoy/tools/play/excavator_picture.hpp"
#include "canvoy/tools/play/excavator_text.hpp"
#include "canvoy/tools/play/shift_file.hpp"
#include "canvoy/tools/play/world.hpp"
#include "canvoy/worlds/excavator/excavator_network.hpp"
#include "canvoy/worlds/excavator/machine_control.hpp"

namespace canvoy::tools {

namespace {

using excavator::ExcavatorNetwork;
using excavator::ExcavatorOptions;

struct ExcavatorRun : WorldRun {
  ExcavatorOptions network{};
  std::string shift{};  ///< file of a recorded shift; empty: none
};

struct ExcavatorWorld {
  using Run = ExcavatorRun;
  using Kind = excavator::FaultKind;
  struct Choice {
    std::string played{};
    std::string recorded{};
  };
  static constexpr std::string_view name = "excavator";
  static constexpr auto network = &Run::network;

  static WorldInfo info();
  static WorldFile<Run> file(const std::string& folder);
  static void check(const TomlTable& file, const std::string& folder, Run& run);
  static Run run_of_file() { return {}; }
  static Duration& length(Run& run) { return run.network.length; }
  static std::string check_fault_node(NodeId id);
  static void add_options(Verb& verb, Choice& choice);
  static Run chosen(const Choice& choice);
  static std::optional<int> play(Run run, const PlayOptions& play_as, const RunOptions& options,
                                 const Choice& choice);
  static MadeWorld make(const Run& run, const Choice&) {
    return {.network = std::make_unique<Played<ExcavatorNetwork, 2>>(run.network)};
  }
  static std::vector<DescribedNode> describe(const Run& run);

  /// Plays the shift of a file. Throws Failure.
  static void choose_shift(Run& run, const std::string& path) {
    run.network.shift.recorded = read_shift(path);
    run.shift = path;
  }
  static BusIndex bus_of(NodeId id) { return id == excavator::armrest_id ? 1 : 0; }
};

WorldInfo ExcavatorWorld::info() {
  return {.about = "A shift of an excavator: CiA 852 and CiA 401 (8h)",
          .examples =
              "  canvoy run excavator --for 10min\n"
              "  canvoy run excavator --for 10min --fault lost-node@2min+10s",
          .page = "excavator",
          .terminal_speed = 1,
          .decoding = {.profiles = {"852", "401"}}};
}

Setting<ExcavatorRun> recorded_shift(const std::string& folder) {
  auto row = setting<&ExcavatorRun::shift>("recorded", "played again in place of that")
                 .as_example("\"shift.csv\"");
  row.value = [](const ExcavatorRun& run) {
    return run.shift.empty() ? "" : text_value(std::filesystem::absolute(run.shift).string());
  };
  row.take = [folder](TomlTable& table, ExcavatorRun& run) {
    std::string recorded;
    table.take("recorded", recorded);
    if (recorded.empty()) return;
    ExcavatorWorld::choose_shift(run, (std::filesystem::path(folder) / recorded).string());
  };
  return row;
}

WorldFile<ExcavatorRun> ExcavatorWorld::file(const std::string& folder) {
  using Shift = excavator::OperatorOptions;
  constexpr auto shift = &ExcavatorOptions::shift;
  WorldFile<Run> file{
      .network = name,
      .title = "A shift of an excavator: CiA 852 and CiA 401.",
      .head = world_head(setting<network, &ExcavatorOptions::length>("for", "virtual time"), name),
      .parts = {SettingTable<Run>{"bus",
                                  "",
                                  {setting<network, &ExcavatorOptions::bit_rate>(
                                       "bit_rate", "bit/s", {{125'000, 1'000'000}}),
                                   real_setting<Run>(0)}},
                SettingTable<Run>{
                    "embedded", "the bus behind the seat: network 2", {real_setting<Run>(1)}},
                SettingTable<Run>{
                    "shift",
                    "",
                    {setting<network, shift, &Shift::work>("work", "between two breaks"),
                     setting<network, shift, &Shift::rest>("rest"),
                     setting<network, &ExcavatorOptions::has_trainer>(
                         "trainer", "on a second seat, who takes the command over now and then"),
                     recorded_shift(folder)}}}};
  for (const excavator::DevicePlace& place : excavator::device_places) {
    SettingTable<Run> device{
        std::string(place.name), "", {played<Run>(place.id, place.id == excavator::host_id)}};
    if (place.id == excavator::seat_id) {
      device.settings.push_back(setting<network, &ExcavatorOptions::sensing_period>(
                                    "sensing_period", "without it, it is told of each movement")
                                    .as_example("\"2ms\""));
    }
    file.parts.emplace_back(std::move(device));
  }
  file.parts.emplace_back(SettingTable<Run>{
      std::string(excavator::armrest_place.name), "", {played<Run>(excavator::armrest_id)}});
  return file;
}

void ExcavatorWorld::check(const TomlTable& file, const std::string&, Run& run) {
  // A real seat has its own bus behind it, or none.
  run.network.has_armrest = run.network.plays(excavator::seat_id) || run.has_real(1);
  check_real(file, run, bus_of, {"bus", "embedded"});
}

std::string ExcavatorWorld::check_fault_node(NodeId id) {
  if (std::ranges::find(excavator::device_places, id, &excavator::DevicePlace::id) !=
      excavator::device_places.end()) {
    return {};
  }
  return fmt::format("there are nodes {} (host), {} (seat) and {} (valves)", excavator::host_id,
                     excavator::seat_id, excavator::valves_id);
}

void ExcavatorWorld::add_options(Verb& verb, Choice& choice) {
  verb.add({
      {"--shift", choice.played,
       "a recorded shift that is played again, as CSV (docs/excavator.md)"},
      {"--record-shift", choice.recorded, "write what hands do into a file that --shift takes"},
  });
}

ExcavatorRun ExcavatorWorld::chosen(const Choice& choice) {
  Run run;
  if (!choice.played.empty()) choose_shift(run, choice.played);
  return run;
}

/// Records the shift.
std::optional<int> ExcavatorWorld::play(Run run, const PlayOptions& play_as,
                                        const RunOptions& options, const Choice& choice) {
  if (choice.recorded.empty()) return std::nullopt;
  if (options.is_watched()) throw UsageError("--record-shift is of a run on the terminal");
  run.network.records_shift = true;
  Played<ExcavatorNetwork, 2> played(run.network);
  const int status = tools::play(played, play_as);
  write_shift(choice.recorded, played.network().recorded_shift());
  return status;
}

/// Describes the nodes as set up by the host, which writes a COB-ID twice: the last one counts.
std::vector<DescribedNode> ExcavatorWorld::describe(const Run& run) {
  std::vector<DescribedNode> nodes;
  const auto made_network = std::make_unique<ExcavatorNetwork>(run.network);
  for (const auto& node : made_network->nodes()) {
    const NodeId id = node->place().id;
    // The host is not in the catalogue.
    DescribedNode& made = nodes.emplace_back(
        id == excavator::host_id
            ? DescribedNode{.id = id}
            : describe_device(id == excavator::seat_id ? "operator" : "io-401", id));
    made.name = node->place().name;
    made.bus = fmt::format("sim{}", node->bus());
    std::vector<excavator::SetupWrite> setup;
    if (id == excavator::seat_id) setup = seat_setup(made_network->host_settings());
    if (id == excavator::valves_id) setup = valves_setup(made_network->host_settings());
    for (const excavator::SetupWrite& write : setup)
      set_entry(made.sheet, write.index, write.sub, write.value);
  }
  return nodes;
}

}  // namespace

WorldEntry excavator_world() {
  return world_entry<ExcavatorWorld>();
}

}  // namespace canvoy::tools
