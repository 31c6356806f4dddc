#include "canvoy/tools/run/lift_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <filesystem>

#include "canvoy/canopen/little_endian.hpp"
#include "canvoy/sim/duration_text.hpp"
#include "canvoy/tools/failure.hpp"
#include "canvoy/tools/run/arrival_list.hpp"
#include "canvoy/tools/run/network_text.hpp"
#include "canvoy/tools/run/run.hpp"
#include "canvoy/tools/sheet/configuration_file.hpp"

namespace canvoy::tools {

namespace {

using lift::Building;
using lift::BusDescription;
using lift::LiftDesign;
using lift::LiftNetworkDescription;
using lift::NodeDescription;

constexpr std::array<std::string_view, 4> pattern_names = {"up-peak", "down-peak", "interfloor",
                                                           "lunch"};

// What a building can be; beyond, something is misspelt.
constexpr Range<double> height_m{0, 1000};
constexpr Range<double> people{0, 10'000};
constexpr Range<double> mass_kg{1, 50'000};
constexpr Range<double> time_s{0.1, 60};
constexpr Range<double> length_m{0.01, 10};
constexpr Range<double> speed_m_s{0.05, 25};
constexpr Range<double> acceleration_m_s2{0.05, 5};
constexpr Range<double> jerk_m_s3{0.05, 10};
constexpr Range<double> share{0, 1};

/// Doors and floors are written as lists of numbers from 1 on.
template <class Visit>
void take_numbers(TomlTable& table, std::string_view key, double most, Visit visit) {
  std::vector<double> numbers;
  table.take(key, numbers, {1, most});
  for (const double number : numbers) visit(static_cast<unsigned>(number));
}

void take_doors(TomlTable& table, unsigned& doors) {
  if (table.has("doors")) doors = 0;
  take_numbers(table, "doors", lift::doors_max,
               [&doors](unsigned door) { doors |= 1U << (door - 1); });
}

void read_floors(TomlTable& table, Building& building) {
  std::vector<double> heights;
  std::vector<double> populations;
  std::vector<std::string> names;
  table.take("heights_m", heights, height_m);
  table.take("populations", populations, people);
  table.take("names", names);
  if (populations.size() != heights.size()) {
    table.refuse("populations",
                 fmt::format("{} for {} floors", populations.size(), heights.size()));
  }
  if (table.has("names") && names.size() != heights.size()) {
    table.refuse("names", fmt::format("{} for {} floors", names.size(), heights.size()));
  }
  for (std::size_t i = 0; i < heights.size(); ++i) {
    building.floors.push_back({.height_m = heights[i],
                               .population = populations[i],
                               .name = names.empty() ? fmt::format("{}", i + 1) : names[i]});
  }
  table.take<std::uint8_t>("main_floor", building.main_floor, {1, lift::floors_max});
}

void take_floors(TomlTable& table, const std::string& key, lift::FloorList& floors) {
  take_numbers(table, key, lift::floors_max, [&floors](unsigned floor) {
    floors.push_back(static_cast<lift::FloorNumber>(floor));
  });
}

void read_zones(TomlTable& table, Building& building) {
  for (TomlTable& each : table.tables("zone")) {
    lift::Zone& zone = building.zones.emplace_back();
    each.take("name", zone.name);
    take_floors(each, "floors", zone.floors);
    each.finish();
  }
}

LiftDesign read_lift(TomlTable& table) {
  LiftDesign design;
  take_doors(table, design.doors);
  table.take("zone", design.zone);
  take_floors(table, "floors", design.floors);
  for (std::size_t i = 0; i < design.floors_of_door.size(); ++i) {
    take_floors(table, fmt::format("floors_of_door_{}", i + 1), design.floors_of_door.at(i));
  }
  for (std::size_t i = 0; i < design.locked_by_key.size(); ++i) {
    take_floors(table, fmt::format("locked_by_key_{}", i + 1), design.locked_by_key.at(i));
  }
  table.take("car_kg", design.car.mass_kg, mass_kg);
  table.take("rated_load_kg", design.car.rated_load_kg, mass_kg);
  table.take<unsigned>("rated_persons", design.car.rated_persons, {1, 200});
  table.take("overload_share", design.car.overload_share, {1, 2});
  table.take("rope_stretch_um_per_kg", design.car.rope_stretch_um_per_kg, {0, 100});
  table.take("balance", design.balance, share);
  table.take("speed_m_s", design.speed_m_s, speed_m_s);
  table.take("acceleration_m_s2", design.acceleration_m_s2, acceleration_m_s2);
  table.take("jerk_m_s3", design.jerk_m_s3, jerk_m_s3);
  table.take("overtravel_m", design.overtravel_m, length_m);
  table.take("door_zone_m", design.door_zone_m, length_m);
  table.take("door_width_m", design.door.width_m, length_m);
  table.take("door_open_s", design.door.open_time_s, time_s);
  table.take("door_close_s", design.door.close_time_s, time_s);
  table.finish();
  return design;
}

/// By their names.
template <class Item, class Find>
void take_names(TomlTable& table, std::string_view key, std::optional<std::vector<Item>>& items,
                const Find& find, const std::vector<std::string_view>& known) {
  std::vector<std::string> names;
  table.take(key, names);
  if (!table.has(key)) return;
  items.emplace();
  for (const std::string& name : names) {
    const std::optional<Item> item = find(name);
    if (!item) {
      table.refuse(key, fmt::format("'{}' is none; there are {}", name, fmt::join(known, ", ")));
    }
    if (std::ranges::find(*items, *item) != items->end()) {
      table.refuse(key, fmt::format("'{}' is given twice", name));
    }
    items->push_back(*item);
  }
}

void read_panel(TomlTable& table, lift::PanelDescription& panel) {
  take_names(table, "keys", panel.keys, lift::special_function_of, lift::special_function_names());
  take_names(table, "displays", panel.displays, lift::panel_display_of,
             lift::panel_display_names());
  table.take("parameters", panel.parameters);
}

std::size_t bus_of(TomlTable& table, const std::vector<BusDescription>& buses) {
  std::string name;
  table.take("bus", name);
  const auto bus = std::ranges::find(buses, name, &BusDescription::name);
  if (bus == buses.end()) {
    table.refuse("bus", fmt::format("'{}' is no bus; write [[bus]] with this name", name));
  }
  return static_cast<std::size_t>(bus - buses.begin());
}

void add_values(NodeDescription& node, const Configuration& configuration) {
  for (const ConfigurationEntry& entry : configuration.entries) {
    node.values.push_back({entry.index, entry.sub, entry.value});
  }
}

/// What a node is given at each boot-up: what a file has, and then line by line.
void read_values(TomlTable& table, const std::string& folder, NodeDescription& node) {
  std::string file;
  std::vector<std::string> lines;
  table.take("configuration", file);
  table.take("values", lines);
  if (!file.empty()) {
    const std::string path = (std::filesystem::path(folder) / file).string();
    add_values(node, read_configuration(path, node.id));
  }
  if (lines.empty()) return;
  const std::string text = fmt::format("{}", fmt::join(lines, "\n"));
  const std::span bytes(reinterpret_cast<const std::uint8_t*>(text.data()), text.size());
  try {
    add_values(node, parse_configuration("values", bytes, node.id));
  } catch (const Failure& failure) {
    table.refuse("values", failure.what());
  }
}

void read_node(TomlTable& table, const std::vector<BusDescription>& buses,
               const std::string& folder, NodeDescription& node) {
  node.bus = bus_of(table, buses);
  table.take<NodeId>("id", node.id, {1, 127});
  std::string device;
  table.take("device", device);
  const std::optional<lift::DeviceKind> kind = lift::device_kind_of(device);
  if (!kind)
    table.refuse("device",
                 fmt::format("'{}' is none, as lift-drive or lift-landing-panel", device));
  node.kind = *kind;
  table.take<std::uint8_t>("lift", node.lift, {0, lift::lifts_max});
  take_doors(table, node.doors);
  take_numbers(table, "floors", lift::floors_max, [&node](unsigned floor) {
    node.floors.push_back(static_cast<lift::FloorNumber>(floor));
  });
  read_panel(table, node.panel);
  table.take("played", node.played);
  read_values(table, folder, node);
  if (!node.played && !node.values.empty()) {
    table.refuse("values", "who is not played is configured by whoever plays it");
  }
  table.finish();
}

void read_nodes(TomlTable& table, const std::string& folder, LiftRun& run) {
  LiftNetworkDescription& network = run.network;
  for (TomlTable& bus : table.tables("bus")) {
    BusDescription& made = network.buses.emplace_back();
    bus.take("name", made.name);
    bus.take<std::uint32_t>("bit_rate", made.bit_rate, {10'000, 1'000'000});
    take_real_bus(bus, network.buses.size() - 1, run.real);
    bus.finish();
  }
  for (TomlTable& each : table.tables("node")) {
    NodeDescription node;
    read_node(each, network.buses, folder, node);
    const bool has_real_bus =
        std::ranges::find(run.real, node.bus, &RealBus::bus) != run.real.end();
    if (!node.played && !has_real_bus) {
      each.refuse("played", "who is not played is on a real bus: write real = \"can0\" at its bus");
    }
    network.nodes.push_back(node);
  }
}

void read_service(TomlTable table, LiftNetworkDescription& network) {
  table.take("destination_control", network.service.destination_control);
  table.take("door_dwell", network.service.door_dwell);
  table.take<std::uint8_t>("fire_floor", network.service.fire_floor, {1, lift::floors_max});
  table.take<std::uint8_t>("parking_floor", network.service.parking_floor, {0, lift::floors_max});
  table.take("parking_after", network.service.parking_after);
  network.people.destination_control = network.service.destination_control;
  table.finish();
}

void read_traffic(TomlTable table, const std::string& folder, LiftRun& run) {
  lift::TrafficOptions& traffic = run.network.traffic;
  std::string pattern(traffic_pattern_name(traffic.pattern));
  table.take("pattern", pattern);
  try {
    traffic.pattern = parse_traffic_pattern(pattern);
  } catch (const Failure& failure) {
    table.refuse("pattern", failure.what());
  }
  table.take("percent_in_5_minutes", traffic.percent_in_5_minutes, {0, 100});
  table.take("mass_kg_mean", traffic.mass_kg_mean, {1, 1000});
  table.take("mass_kg_deviation", traffic.mass_kg_deviation, {0, 500});
  table.take("list", run.arrival_list);
  table.finish();
  if (run.arrival_list.empty()) return;
  const std::filesystem::path path = std::filesystem::path(folder) / run.arrival_list;
  run.network.arrivals = read_arrivals(path.string(), run.network.building);
}

std::string floors_text(const Building& building) {
  std::vector<double> heights;
  std::vector<double> populations;
  std::vector<std::string> names;
  for (const lift::Floor& floor : building.floors) {
    heights.push_back(floor.height_m);
    populations.push_back(floor.population);
    names.push_back(text_value(floor.name));
  }
  return fmt::format(
      "[building]  # floors from below, the first one is number 1\n"
      "heights_m = [{}]\npopulations = [{}]\nnames = [{}]\nmain_floor = {}\n",
      fmt::join(heights, ", "), fmt::join(populations, ", "), fmt::join(names, ", "),
      building.main_floor);
}

std::vector<unsigned> doors_of(unsigned mask) {
  std::vector<unsigned> doors;
  for (unsigned door = 1; door <= lift::doors_max; ++door) {
    if ((mask >> (door - 1) & 1U) != 0) doors.push_back(door);
  }
  return doors;
}

std::string floors_line(const std::string& key, const lift::FloorList& floors) {
  return floors.empty() ? "" : fmt::format("{} = [{}]\n", key, fmt::join(floors, ", "));
}

std::string zones_text(const Building& building) {
  std::string text;
  for (const lift::Zone& zone : building.zones) {
    text += fmt::format("\n[[zone]]  # of the building, for some lifts\nname = {}\n{}",
                        text_value(zone.name), floors_line("floors", zone.floors));
  }
  return text;
}

/// Where a lift does not serve all floors, for whoever comes.
std::string served_text(const LiftDesign& design) {
  std::string text;
  if (!design.zone.empty()) text += fmt::format("zone = {}\n", text_value(design.zone));
  text += floors_line("floors", design.floors);
  for (std::size_t i = 0; i < design.floors_of_door.size(); ++i) {
    text += floors_line(fmt::format("floors_of_door_{}", i + 1), design.floors_of_door.at(i));
  }
  for (std::size_t i = 0; i < design.locked_by_key.size(); ++i) {
    text += floors_line(fmt::format("locked_by_key_{}", i + 1), design.locked_by_key.at(i));
  }
  return text;
}

std::string lift_text(const LiftDesign& design) {
  return fmt::format(R"(
[[lift]]
doors = [{}]
car_kg = {}
rated_load_kg = {}
rated_persons = {}
overload_share = {}  # of the rated load; with more it does not leave
rope_stretch_um_per_kg = {}  # what the car sinks by its load
balance = {}  # share of the rated load that the counterweight carries
speed_m_s = {}
acceleration_m_s2 = {}
jerk_m_s3 = {}
overtravel_m = {}
door_zone_m = {}
door_width_m = {}
door_open_s = {}
door_close_s = {}
)",
                     fmt::join(doors_of(design.doors), ", "), design.car.mass_kg,
                     design.car.rated_load_kg, design.car.rated_persons, design.car.overload_share,
                     design.car.rope_stretch_um_per_kg, design.balance, design.speed_m_s,
                     design.acceleration_m_s2, design.jerk_m_s3, design.overtravel_m,
                     design.door_zone_m, design.door.width_m, design.door.open_time_s,
                     design.door.close_time_s) +
         served_text(design);
}

std::string bus_table(const LiftRun& run, std::size_t place) {
  const BusDescription& bus = run.network.buses[place];
  std::string text =
      fmt::format("\n[[bus]]\nname = {}\nbit_rate = {}\n", text_value(bus.name), bus.bit_rate);
  const auto real = std::ranges::find(run.real, place, &RealBus::bus);
  if (real != run.real.end()) return text + fmt::format("real = {}\n", text_value(real->address));
  if (place != 0) return text;
  return text +
         "# real = \"can0\"  # a real bus is a part of it; all runs at the speed of the clock\n";
}

/// As a line of a configuration file.
std::string value_line(const NodeValue& value) {
  const std::string place = fmt::format("{:04X} {:02X}", value.index, value.sub);
  const std::size_t size = value.bytes.size();
  if (size != 1 && size != 2 && size != 4 && size != 8) {
    return fmt::format("{} os hex:{:02X}", place, fmt::join(value.bytes, " "));
  }
  std::array<std::uint8_t, 8> bytes{};
  std::ranges::copy(value.bytes, bytes.begin());
  return fmt::format("{} u{} 0x{:X}", place, size * 8, load<std::uint64_t>(bytes.data()));
}

std::string values_text(const NodeDescription& node) {
  if (node.values.empty()) return {};
  std::vector<std::string> lines;
  lines.reserve(node.values.size());
  for (const NodeValue& value : node.values) lines.push_back(text_value(value_line(value)));
  return fmt::format("values = [{}]\n", fmt::join(lines, ", "));
}

std::string panel_text(const lift::PanelDescription& panel) {
  std::string text;
  std::vector<std::string> names;
  const auto add = [&](std::string_view name) { names.push_back(fmt::format("\"{}\"", name)); };
  if (panel.keys) {
    for (const auto key : *panel.keys) add(lift::special_function_name(key));
    text += fmt::format("keys = [{}]\n", fmt::join(names, ", "));
  }
  names.clear();
  if (panel.displays) {
    for (const auto& display : *panel.displays) add(lift::panel_display_name(display));
    text += fmt::format("displays = [{}]\n", fmt::join(names, ", "));
  }
  return text + (panel.parameters ? "parameters = true\n" : "");
}

std::string node_table(const NodeDescription& node, const std::string& bus) {
  std::string text =
      fmt::format("\n[[node]]\nbus = {}\nid = {}\ndevice = \"{}\"\nlift = {}\n", text_value(bus),
                  node.id, lift::device_kind_name(node.kind), node.lift);
  if (!node.floors.empty()) text += fmt::format("floors = [{}]\n", fmt::join(node.floors, ", "));
  text += fmt::format("doors = [{}]\n", fmt::join(doors_of(node.doors), ", "));
  text += panel_text(node.panel);
  if (!node.played) text += "played = false  # a real device\n";
  return text + values_text(node);
}

std::string conditions_text(const LiftRun& run) {
  const LiftNetworkDescription& network = run.network;
  std::string text = fmt::format(
      R"(
[service]
destination_control = {}  # people say at the landing where they want to go
door_dwell = "{}"
fire_floor = {}
parking_floor = {}  # where a car goes that has nothing to do; 0: it stays
parking_after = "{}"

[traffic]
pattern = "{}"  # up-peak, down-peak, interfloor, lunch
percent_in_5_minutes = {}  # of the population
mass_kg_mean = {}
mass_kg_deviation = {}
)",
      network.service.destination_control, canvoy::written(network.service.door_dwell),
      network.service.fire_floor, network.service.parking_floor,
      canvoy::written(network.service.parking_after), traffic_pattern_name(network.traffic.pattern),
      network.traffic.percent_in_5_minutes, network.traffic.mass_kg_mean,
      network.traffic.mass_kg_deviation);
  return text + (run.arrival_list.empty()
                     ? "# list = \"people.csv\"  # in place of a pattern: seconds,from,to,kg\n"
                     : fmt::format("list = {}\n", text_value(run.arrival_list)));
}

}  // namespace

std::string_view traffic_pattern_name(lift::TrafficPattern pattern) {
  return pattern_names.at(static_cast<std::size_t>(pattern));
}

lift::TrafficPattern parse_traffic_pattern(std::string_view name) {
  const auto* const found = std::ranges::find(pattern_names, name);
  if (found == pattern_names.end()) {
    throw UsageError(fmt::format("'{}' is no traffic: {}", name, fmt::join(pattern_names, ", ")));
  }
  return static_cast<lift::TrafficPattern>(found - pattern_names.begin());
}

void add_lift_faults(LiftRun& run, const std::vector<std::string>& texts) {
  for (const std::string& text : texts) {
    run.network.faults.push_back(
        lift::scheduled(parse_run_fault(lift::fault_grammar(), text, Time(run.duration))));
  }
}

LiftRun read_lift_run(TomlTable& table, const std::string& folder) {
  LiftRun run;
  LiftNetworkDescription& network = run.network;
  table.take("name", network.name);
  table.take("for", run.duration);
  table.take("seed", network.seed);
  network.traffic.seed = network.people.seed = network.seed;
  std::vector<std::string> faults;
  table.take("faults", faults);
  TomlTable building = table.table("building");
  read_floors(building, network.building);
  building.finish();
  read_zones(table, network.building);
  for (TomlTable& each : table.tables("lift")) network.building.lifts.push_back(read_lift(each));
  read_nodes(table, folder, run);
  read_service(table.table("service"), network);
  read_traffic(table.table("traffic"), folder, run);
  table.finish();
  try {
    add_lift_faults(run, faults);
  } catch (const Failure& failure) {
    table.refuse("faults", failure.what());
  }
  const std::string error = lift::check(network);
  if (!error.empty()) table.refuse(error);
  return run;
}

std::string lift_run_text(const LiftRun& run) {
  const LiftNetworkDescription& network = run.network;
  std::vector<std::string> faults;
  faults.reserve(network.faults.size());
  for (const lift::ScheduledFault& fault : network.faults) {
    faults.push_back(
        fmt::format("\"{}\"", fault_text(lift::fault_grammar(), lift::written(fault))));
  }
  std::string text = fmt::format(
      R"(network = "lift"
name = {}
for = "{}"  # virtual time
seed = {}  # of all that is left to chance
faults = [{}]  # NAME@START or NAME@START+DURATION; canvoy run lift --help lists them

)",
      text_value(network.name), canvoy::written(run.duration), network.seed,
      fmt::join(faults, ", "));
  text += floors_text(network.building);
  text += zones_text(network.building);
  for (const LiftDesign& design : network.building.lifts) text += lift_text(design);
  text += conditions_text(run);
  for (std::size_t bus = 0; bus < network.buses.size(); ++bus) text += bus_table(run, bus);
  for (const NodeDescription& node : network.nodes) {
    text += node_table(node, network.buses[node.bus].name);
  }
  return text;
}

}  // namespace canvoy::tools
