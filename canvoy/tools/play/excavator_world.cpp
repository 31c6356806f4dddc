// canvoy run excavator: plays a shift of an excavator.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "canvoy/text/text.hpp"
#include "canvoy/text/time_text.hpp"
#include "canvoy/tools/play/excavator_text.hpp"
#include "canvoy/tools/play/shift_file.hpp"
#include "canvoy/tools/play/world.hpp"
#include "canvoy/tools/player/world_text.hpp"
#include "canvoy/worlds/excavator/excavator_network.hpp"
#include "canvoy/worlds/excavator/machine_control.hpp"

namespace canvoy::tools {

namespace {

// Picture of an excavator on a terminal of 80 columns and 24 lines: the arm from the side, the seat
// with its sticks and lamps, the bus.
//
//     out << arm_picture(network.snapshot());

using excavator::ExcavatorSnapshot;

constexpr int picture_columns = 40;
constexpr int picture_lines = 11;
constexpr double metres_a_column = 0.28;
constexpr double metres_a_line = 0.9;
constexpr double top_metres = 7;
constexpr int axis_column = 6;  ///< axis of the slew

using Canvas = std::vector<std::string>;

void set_letter(Canvas& canvas, const Excavator::Point& at, char letter) {
  const int column = axis_column + static_cast<int>(std::lround(at.x / metres_a_column));
  const int line = static_cast<int>(std::lround((top_metres - at.z) / metres_a_line));
  if (column < 0 || column >= picture_columns || line < 0 || line >= picture_lines) return;
  canvas[static_cast<std::size_t>(line)][static_cast<std::size_t>(column)] = letter;
}

void draw_line(Canvas& canvas, const Excavator::Point& from, const Excavator::Point& to,
               char letter) {
  constexpr int parts = 40;
  for (int i = 0; i <= parts; ++i) {
    const double share = static_cast<double>(i) / parts;
    set_letter(canvas, {from.x + share * (to.x - from.x), from.z + share * (to.z - from.z)},
               letter);
  }
}

/// `<---o---->` with the hand in it.
std::string slider_text(double place) {
  constexpr int half = 4;
  std::string text(2 * half + 1, '-');
  text[half] = '|';
  const int at = half + static_cast<int>(std::lround(place * half));
  text[static_cast<std::size_t>(std::clamp(at, 0, 2 * half))] = 'O';
  return text;
}

std::string lamps_line(const ExcavatorSnapshot& now) {
  constexpr std::array<std::string_view, excavator::lamp_count> names = {
      "light", "beacon", "fast", "locked", "FAULT", "fuel", "hot", "ready"};
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    text += fmt::format("{}{} ", now.lit[i] ? "(*)" : "( )", names[i]);
  }
  return text;
}

std::string shown_text(std::int16_t value, std::string_view unit) {
  return value == excavator::no_value ? "--" : fmt::format("{} {}", value, unit);
}

/// Beside the arm, line by line.
std::vector<std::string> seat_lines(const ExcavatorSnapshot& now) {
  const auto hand = [&now](Movement movement) {
    return slider_text(now.hands[static_cast<std::size_t>(movement)]);
  };
  const auto shown = [&now](excavator::Shown what, std::string_view unit) {
    return shown_text(now.display[static_cast<std::size_t>(what)], unit);
  };
  using excavator::Shown;
  return {
      fmt::format("left  stick {}", hand(Movement::stick)),
      fmt::format("      slew  {}", hand(Movement::slew)),
      fmt::format("right boom  {}", hand(Movement::boom)),
      fmt::format("     bucket {}", hand(Movement::bucket)),
      fmt::format("pedals {} {}", hand(Movement::left_track), hand(Movement::right_track)),
      fmt::format("display  fuel {:<7} oil {}", shown(Shown::fuel, "%"), shown(Shown::oil, "degC")),
      fmt::format("  slew {:<9} {}", shown(Shown::slew, "deg"), shown(Shown::rpm, "rpm")),
      fmt::format("  tip {} high, {} out", shown(Shown::height, "cm"), shown(Shown::reach, "cm")),
      fmt::format("horn {}  light {}  beacon {}", now.switched[0] ? "TOOT" : "-",
                  now.switched[1] ? "on" : "off", now.switched[2] ? "on" : "off"),
  };
}

/// The arm from the side, as lines of text: `metres` in front of the slew and around the ground.
std::string arm_picture(const ExcavatorSnapshot& now) {
  Canvas canvas(picture_lines, std::string(picture_columns, ' '));
  for (int column = 0; column < picture_columns; ++column) {
    set_letter(canvas, {(column - axis_column) * metres_a_column, 0}, '_');
  }
  draw_line(canvas, {-1.4, 0.9}, {1.2, 0.9}, '=');
  draw_line(canvas, {-1.4, 1.8}, {0.2, 1.8}, '#');
  draw_line(canvas, now.arm[0], now.arm[1], 'B');
  draw_line(canvas, now.arm[1], now.arm[2], 's');
  draw_line(canvas, now.arm[2], now.arm[3], now.statistics.earth.in_bucket > 0.1 ? '@' : 'u');
  std::string text;
  for (const std::string& line : canvas) text += line + "\n";
  return text;
}

}  // namespace

std::string WorldText<excavator::ExcavatorNetwork>::picture(excavator::ExcavatorNetwork& network,
                                                            double speed) {
  const ExcavatorSnapshot now = network.snapshot();
  std::string text = fmt::format(
      "Canvoy: an excavator, CiA 852 on {} kbit/s   {}{}\n\n", network.options().bit_rate / 1000,
      text::duration_text(now.at - Time{}), speed > 0 ? fmt::format("  (x{:g})", speed) : "");
  const std::string arm = arm_picture(now);
  const std::vector<std::string> seat = seat_lines(now);
  std::size_t line = 0;
  for (std::size_t at = 0; at < arm.size(); ++line) {
    const std::size_t end = arm.find('\n', at);
    text += fmt::format("{}{}\n", arm.substr(at, end - at), line < seat.size() ? seat[line] : "");
    at = end + 1;
  }
  text += "  " + lamps_line(now) + "\n";
  text += fmt::format("  heap {:.1f} m3, bucket {:.1f} m3; {} cycles; slewed to {:.0f} deg\n",
                      now.statistics.earth.heaped, now.statistics.earth.in_bucket,
                      now.statistics.cycles, now.angles[0]);
  for (std::size_t i = 0; i < now.nodes.size(); ++i) {
    text += fmt::format("  {} {}", now.names[i], tools::state_text(now.nodes[i]));
  }
  text += fmt::format("\n  bus load {:.1f} %, {} frames, {} error frames\n", now.bus.load * 100,
                      now.bus.frames, now.bus.error_frames);
  const auto events = network.events();
  constexpr std::size_t shown = 4;
  for (const excavator::ExcavatorEvent& event : events.last(std::min(shown, events.size()))) {
    text += fmt::format("  {:>16}  {:.60}\n", text::duration_text(event.at - Time{}),
                        WorldText<excavator::ExcavatorNetwork>::event(event, network).text);
  }
  return text;
}

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
