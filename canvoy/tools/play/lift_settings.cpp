// The tables of the file of a building with lifts, and of its network.

#include <algorithm>
#include <array>
#include <filesystem>

#include "canvoy/canopen/protocol/little_endian.hpp"
#include "canvoy/tools/play/arrival_list.hpp"
#include "canvoy/tools/play/lift_hands.hpp"
#include "canvoy/tools/play/lift_world.hpp"
#include "canvoy/tools/sheet/configuration_file.hpp"

namespace canvoy::tools {

namespace {

using lift::Building;
using lift::BusDescription;
using lift::FloorList;
using lift::LiftDesign;
using lift::LiftNetworkDescription;
using lift::NodeDescription;
using lift::PanelDescription;

constexpr std::array<std::string_view, 4> pattern_names = {"up-peak", "down-peak", "interfloor",
                                                           "lunch"};

// Plausible range of a building; other values are typing errors.
constexpr Range<double> mass_kg{1, 50'000};
constexpr Range<double> time_s{0.1, 60};
constexpr Range<double> length_m{0.01, 10};

using Numbers = std::vector<double>;
using Texts = std::vector<std::string>;

/// A list of floors; an empty one is not written.
template <class Owner>
Setting<Owner> floors(std::string key, std::function<FloorList&(Owner&)> list) {
  return mapped<Owner, Numbers>(
      {.key = std::move(key),
       .takes = "a list of floors, from 1 on",
       .read = [list](Owner& owner,
                      const Numbers& all) { list(owner).assign(all.begin(), all.end()); },
       .write = [list](const Owner& owner) -> std::optional<Numbers> {
         Owner same = owner;
         const FloorList& all = list(same);
         return all.empty() ? std::nullopt : std::optional(Numbers(all.begin(), all.end()));
       },
       .range = {1, lift::floors_max}});
}

template <class Owner>
Setting<Owner> doors() {
  return mapped<Owner, Numbers>({.key = "doors",
                                 .takes = "a list of doors, 1 to 4",
                                 .read =
                                     [](Owner& owner, const Numbers& all) {
                                       owner.doors = 0;
                                       for (const double door : all)
                                         owner.doors |= 1U << (static_cast<unsigned>(door) - 1);
                                     },
                                 .write =
                                     [](const Owner& owner) {
                                       Numbers all;
                                       for (unsigned door = 1; door <= lift::doors_max; ++door) {
                                         if ((owner.doors >> (door - 1) & 1U) != 0)
                                           all.push_back(door);
                                       }
                                       return all;
                                     },
                                 .range = {1, lift::doors_max}});
}

/// A value for each floor, from the bottom: the heights give their number.
template <class Item>
Setting<LiftRun> of_floors(std::string key, std::string takes, Item lift::Floor::*member,
                           Range<double> range = {}) {
  const bool is_needed = std::is_same_v<Item, double>;
  return mapped<LiftRun, std::vector<Item>>(
      {.key = key,
       .takes = std::move(takes),
       .read =
           [key, member](LiftRun& run, const std::vector<Item>& all) {
             std::vector<lift::Floor>& floors = run.network.building.floors;
             while (key == "heights_m" && floors.size() < all.size()) {
               floors.push_back({.name = fmt::format("{}", floors.size() + 1)});
             }
             if (all.size() != floors.size()) {
               throw UsageError(fmt::format("{} for {} floors", all.size(), floors.size()));
             }
             for (std::size_t i = 0; i < all.size(); ++i) floors[i].*member = all[i];
           },
       .write =
           [member](const LiftRun& run) {
             const std::vector<lift::Floor>& floors = run.network.building.floors;
             std::vector<Item> all;
             all.reserve(floors.size());
             for (const lift::Floor& floor : floors) all.push_back(floor.*member);
             return all;
           },
       .is_needed = is_needed,
       .range = range});
}

SettingTable<LiftRun> building_table() {
  return {"building",
          "floors from below, the first one is number 1",
          {of_floors("heights_m", "a list of numbers from 0 to 1000", &lift::Floor::height_m,
                     {0, 1000}),
           of_floors("populations", "a list of numbers from 0 to 10000", &lift::Floor::population,
                     {0, 10'000}),
           of_floors("names", "a list of texts; without it, floors have their numbers",
                     &lift::Floor::name),
           setting<&LiftRun::network, &LiftNetworkDescription::building, &Building::main_floor>(
               "main_floor", "", {{1, lift::floors_max}})}};
}

FilePart<LiftRun> zones() {
  return several<LiftRun, lift::Zone>(
      [](const LiftRun&) {
        return SettingTable<lift::Zone>{
            "zone",
            "of the building, for some lifts",
            {setting<&lift::Zone::name>("name"),
             floors<lift::Zone>("floors",
                                [](lift::Zone& zone) -> FloorList& { return zone.floors; })}};
      },
      [](const LiftRun& run) { return run.network.building.zones; },
      [](const TomlTable&, LiftRun& run, lift::Zone zone) {
        run.network.building.zones.push_back(std::move(zone));
      });
}

/// Properties of a lift, and then the floors that it does not serve.
std::vector<Setting<LiftDesign>> lift_settings() {
  constexpr auto car = &LiftDesign::car;
  constexpr auto door = &LiftDesign::door;
  using lift::CarDesign;
  using lift::DoorDesign;
  std::vector<Setting<LiftDesign>> rows = {
      doors<LiftDesign>(),
      setting<car, &CarDesign::mass_kg>("car_kg", "", {mass_kg}),
      setting<car, &CarDesign::rated_load_kg>("rated_load_kg", "", {mass_kg}),
      setting<car, &CarDesign::rated_persons>("rated_persons", "", {{1, 200}}),
      setting<car, &CarDesign::overload_share>("overload_share",
                                               "of the rated load; with more it does not leave; EN "
                                               "81-20: 10 % or 75 kg too much at most",
                                               {{1, 2}}),
      setting<car, &CarDesign::rope_stretch_um_per_kg>(
          "rope_stretch_um_per_kg", "what the car sinks by its load", {{0, 100}}),
      setting<&LiftDesign::balance>(
          "balance", "share of the rated load that the counterweight carries", {{0, 1}}),
      setting<&LiftDesign::speed_m_s>("speed_m_s", "", {{0.05, 25}}),
      setting<&LiftDesign::acceleration_m_s2>("acceleration_m_s2", "", {{0.05, 5}}),
      setting<&LiftDesign::jerk_m_s3>("jerk_m_s3", "", {{0.05, 10}}),
      setting<&LiftDesign::overtravel_m>("overtravel_m", "", {length_m}),
      setting<&LiftDesign::door_zone_m>("door_zone_m", "EN 81-20: 0.35 at most", {length_m}),
      setting<door, &DoorDesign::width_m>("door_width_m", "", {length_m}),
      setting<door, &DoorDesign::open_time_s>("door_open_s",
                                              "180 kg of doors; EN 81-20: 10 J at most", {time_s}),
      setting<door, &DoorDesign::close_time_s>("door_close_s", "the same", {time_s}),
      setting<&LiftDesign::zone>("zone"),
      floors<LiftDesign>("floors", [](LiftDesign& lift) -> FloorList& { return lift.floors; })};
  for (std::size_t i = 0; i < lift::doors_max; ++i) {
    rows.push_back(floors<LiftDesign>(
        fmt::format("floors_of_door_{}", i + 1),
        [i](LiftDesign& lift) -> FloorList& { return lift.floors_of_door.at(i); }));
  }
  for (std::size_t i = 0; i < lift::key_locks; ++i) {
    rows.push_back(floors<LiftDesign>(
        fmt::format("locked_by_key_{}", i + 1),
        [i](LiftDesign& lift) -> FloorList& { return lift.locked_by_key.at(i); }));
  }
  return rows;
}

FilePart<LiftRun> lifts() {
  return several<LiftRun, LiftDesign>(
      [](const LiftRun&) {
        return SettingTable<LiftDesign>{"lift", "", lift_settings()};
      },
      [](const LiftRun& run) { return run.network.building.lifts; },
      [](const TomlTable&, LiftRun& run, LiftDesign design) {
        run.network.building.lifts.push_back(std::move(design));
      });
}

SettingTable<LiftRun> service_table() {
  constexpr auto network = &LiftRun::network;
  constexpr auto service = &LiftNetworkDescription::service;
  using Service = lift::LiftService;
  return {
      "service",
      "",
      {setting<network, service, &Service::destination_control>(
           "destination_control", "people say at the landing where they want to go"),
       setting<network, service, &Service::door_dwell>("door_dwell"),
       setting<network, service, &Service::fire_floor>("fire_floor", "", {{1, lift::floors_max}}),
       setting<network, service, &Service::parking_floor>(
           "parking_floor", "where a car goes that has nothing to do; 0: it stays",
           {{0, lift::floors_max}}),
       setting<network, service, &Service::parking_after>("parking_after"),
       setting<network, service, &Service::technician>(
           "technician",
           "comes to a lift that only a hand resets or that stays out of order, and lets people "
           "out")},
      [](const TomlTable&, LiftRun& run) {
        run.network.people.destination_control = run.network.service.destination_control;
      }};
}

Setting<LiftRun> pattern_setting() {
  return mapped<LiftRun, std::string>(
      {.key = "pattern",
       .takes = "one of `up-peak`, `down-peak`, `interfloor`, `lunch`",
       .read =
           [](LiftRun& run, const std::string& name) {
             run.network.traffic.pattern = parse_traffic_pattern(name);
           },
       .write =
           [](const LiftRun& run) {
             return std::string(traffic_pattern_name(run.network.traffic.pattern));
           }},
      "up-peak, down-peak, interfloor, lunch");
}

SettingTable<LiftRun> traffic_table(const std::string& folder) {
  constexpr auto network = &LiftRun::network;
  constexpr auto traffic = &LiftNetworkDescription::traffic;
  using Traffic = lift::TrafficOptions;
  return {
      "traffic",
      "",
      {pattern_setting(),
       setting<network, traffic, &Traffic::percent_in_5_minutes>("percent_in_5_minutes",
                                                                 "of the population", {{0, 100}}),
       setting<network, traffic, &Traffic::mass_kg_mean>("mass_kg_mean", "", {{1, 1000}}),
       setting<network, traffic, &Traffic::mass_kg_deviation>("mass_kg_deviation", "", {{0, 500}}),
       setting<&LiftRun::arrival_list>("list", "in place of a pattern: seconds,from,to,kg")
           .as_example("\"people.csv\"")},
      [folder](const TomlTable&, LiftRun& run) {
        if (run.arrival_list.empty()) return;
        const std::filesystem::path path = std::filesystem::path(folder) / run.arrival_list;
        run.network.arrivals = read_arrivals(path.string(), run.network.building);
      }};
}

/// A bus of a file, with its real part.
struct BusOfFile {
  BusDescription bus{};
  std::string real{};
  bool is_first = false;
};

FilePart<LiftRun> buses() {
  return several<LiftRun, BusOfFile>(
      [](const LiftRun&) {
        Setting<BusOfFile> real{
            .key = "real",
            .takes = "a bus, as `\"can0\"`",
            .help = "a real bus is a part of it; all runs at the speed of the clock",
            .take =
                [](TomlTable& table, BusOfFile& bus) {
                  std::vector<RealBus> real;
                  take_real_bus(table, 0, real);
                  if (!real.empty()) bus.real = real.front().address;
                },
            .value =
                [](const BusOfFile& bus) { return bus.real.empty() ? "" : text_value(bus.real); },
            .example = "\"can0\"",
            .has_example = [](const BusOfFile& bus) { return bus.is_first; }};
        return SettingTable<BusOfFile>{"bus",
                                       "",
                                       {setting<&BusOfFile::bus, &BusDescription::name>("name"),
                                        setting<&BusOfFile::bus, &BusDescription::bit_rate>(
                                            "bit_rate", "", {{10'000, 1'000'000}}),
                                        std::move(real)}};
      },
      [](const LiftRun& run) {
        std::vector<BusOfFile> all;
        for (std::size_t i = 0; i < run.network.buses.size(); ++i) {
          const auto real = std::ranges::find(run.real, i, &RealBus::bus);
          all.push_back(
              {run.network.buses[i], real == run.real.end() ? "" : real->address, i == 0});
        }
        return all;
      },
      [](const TomlTable&, LiftRun& run, BusOfFile bus) {
        if (!bus.real.empty()) run.real.push_back({run.network.buses.size(), bus.real});
        run.network.buses.push_back(std::move(bus.bus));
      });
}

/// What a panel has instead of its defaults, by name.
template <class Item, class Name>
Setting<NodeDescription> of_panel(std::string key,
                                  std::optional<std::vector<Item>> PanelDescription::*items,
                                  std::optional<Item> (*find)(std::string_view),
                                  const std::vector<std::string_view>& known, const Name& name) {
  return mapped<NodeDescription, Texts>(
      {.key = std::move(key),
       .takes = fmt::format("a list of `{}`", fmt::join(known, "`, `")),
       .read =
           [items, find, known](NodeDescription& node, const Texts& names) {
             std::vector<Item>& all = (node.panel.*items).emplace();
             for (const std::string& each : names) {
               const std::optional<Item> item = find(each);
               if (!item)
                 throw UsageError(
                     fmt::format("'{}' is none; there are {}", each, fmt::join(known, ", ")));
               if (std::ranges::find(all, *item) != all.end()) {
                 throw UsageError(fmt::format("'{}' is given twice", each));
               }
               all.push_back(*item);
             }
           },
       .write = [items, name](const NodeDescription& node) -> std::optional<Texts> {
         if (!(node.panel.*items)) return std::nullopt;
         Texts names;
         for (const Item& item : *(node.panel.*items)) names.emplace_back(name(item));
         return names;
       }});
}

Setting<NodeDescription> bus_of_node(const std::vector<BusDescription>& buses) {
  return mapped<NodeDescription, std::string>(
      {.key = "bus",
       .takes = "the name of a bus",
       .read =
           [buses](NodeDescription& node, const std::string& name) {
             const auto bus = std::ranges::find(buses, name, &BusDescription::name);
             if (bus == buses.end()) {
               throw UsageError(fmt::format("'{}' is no bus; write [[bus]] with this name", name));
             }
             node.bus = static_cast<std::size_t>(bus - buses.begin());
           },
       .write = [buses](const NodeDescription& node) { return buses[node.bus].name; },
       .is_needed = true});
}

Setting<NodeDescription> device_of_node() {
  return mapped<NodeDescription, std::string>(
      {.key = "device",
       .takes = "a device of a lift, as `\"lift-drive\"`",
       .read =
           [](NodeDescription& node, const std::string& device) {
             const std::optional<lift::DeviceKind> kind = lift::device_kind_of(device);
             if (!kind)
               throw UsageError(
                   fmt::format("'{}' is none, as lift-drive or lift-landing-panel", device));
             node.kind = *kind;
           },
       .write =
           [](const NodeDescription& node) {
             return std::string(lift::device_kind_name(node.kind));
           },
       .is_needed = true});
}

void add_values(NodeDescription& node, const Configuration& configuration) {
  for (const ConfigurationEntry& entry : configuration.entries) {
    node.values.push_back({entry.index, entry.sub, entry.value});
  }
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

/// Values for a node at each boot-up: a file, and then lines.
Setting<NodeDescription> configuration_of_node(const std::string& folder) {
  return {.key = "configuration",
          .takes = "a file: DCF, XDC, concise DCF or lines",
          .help = {},
          .take =
              [folder](TomlTable& table, NodeDescription& node) {
                std::string file;
                table.take("configuration", file);
                if (file.empty()) return;
                const std::string path = (std::filesystem::path(folder) / file).string();
                add_values(node, read_configuration(path, node.id));
              },
          .value = [](const NodeDescription&) { return std::string(); }};
}

Setting<NodeDescription> values_of_node() {
  return mapped<NodeDescription, Texts>(
      {.key = "values",
       .takes = "a list of lines, as `\"1017 0 u16 500\"`",
       .read =
           [](NodeDescription& node, const Texts& lines) {
             const std::string text = fmt::format("{}", fmt::join(lines, "\n"));
             const std::span bytes(reinterpret_cast<const std::uint8_t*>(text.data()), text.size());
             if (!lines.empty()) add_values(node, parse_configuration("values", bytes, node.id));
           },
       .write = [](const NodeDescription& node) -> std::optional<Texts> {
         if (node.values.empty()) return std::nullopt;
         Texts lines;
         for (const NodeValue& value : node.values) lines.push_back(value_line(value));
         return lines;
       }});
}

SettingTable<NodeDescription> node_table(const LiftRun& run, const std::string& folder) {
  // Missing values are not written.
  Setting<NodeDescription> has_parameters =
      setting<&NodeDescription::panel, &PanelDescription::parameters>("parameters");
  has_parameters.value = [](const NodeDescription& node) {
    return node.panel.parameters ? "true" : "";
  };
  Setting<NodeDescription> has_calls = setting<&NodeDescription::panel, &PanelDescription::calls>(
      "calls", "`false`: a panel without call buttons, as an inspection station");
  has_calls.value = [](const NodeDescription& node) { return node.panel.calls ? "" : "false"; };
  Setting<NodeDescription> is_played = setting<&NodeDescription::played>("played", "a real device");
  is_played.value = [](const NodeDescription& node) { return node.played ? "" : "false"; };
  return {
      "node",
      "",
      {bus_of_node(run.network.buses), setting<&NodeDescription::id>("id", "", {{1, node_id_max}}),
       device_of_node(), setting<&NodeDescription::lift>("lift", "", {{0, lift::lifts_max}}),
       floors<NodeDescription>("floors",
                               [](NodeDescription& node) -> FloorList& { return node.floors; }),
       doors<NodeDescription>(),
       of_panel("keys", &PanelDescription::keys, lift::special_function_of,
                lift::special_function_names(), lift::special_function_name),
       of_panel("displays", &PanelDescription::displays, lift::panel_display_of,
                lift::panel_display_names(), lift::panel_display_name),
       std::move(has_calls), std::move(has_parameters), std::move(is_played),
       configuration_of_node(folder), values_of_node()},
      [](const TomlTable& table, const NodeDescription& node) {
        if (node.played || node.values.empty()) return;
        table.refuse("values", "who is not played is configured by whoever plays it");
      }};
}

FilePart<LiftRun> nodes(const std::string& folder) {
  return several<LiftRun, NodeDescription>(
      [folder](const LiftRun& run) { return node_table(run, folder); },
      [](const LiftRun& run) { return run.network.nodes; },
      [](const TomlTable& table, LiftRun& run, NodeDescription node) {
        if (!node.played && !run.has_real(node.bus)) {
          table.refuse("played",
                       "who is not played is on a real bus: write real = \"can0\" at its bus");
        }
        run.network.nodes.push_back(std::move(node));
      });
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

std::vector<FilePart<LiftRun>> lift_parts(const std::string& folder) {
  return {building_table(),      zones(), lifts(),       service_table(),
          traffic_table(folder), buses(), nodes(folder), lift_hands_part()};
}

}  // namespace canvoy::tools
