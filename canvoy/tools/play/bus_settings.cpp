#include "canvoy/tools/play/bus_settings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <utility>

#include "canvoy/sim/duration_text.hpp"
#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/play/demand_file.hpp"
#include "canvoy/worlds/bus_line/bus_displays.hpp"

namespace canvoy::tools {

namespace {

using BusRow = Setting<BusRun>;
using BusTable = SettingTable<BusRun>;
using DoorWords = std::vector<std::string>;

constexpr unsigned bus_capacity_max = 500;
constexpr std::size_t display_columns_max = 80;
constexpr std::size_t display_lines_max = 8;
constexpr std::uint32_t added_node_max = 127;

bus_line::DoorUse door_of(const std::string& word) {
  if (word == "in") return {.boards = true, .alights = false};
  if (word == "out") return {.boards = false, .alights = true};
  if (word == "both") return {.boards = true, .alights = true};
  throw Failure(fmt::format("'{}' is none of in, out, both", word));
}
std::string word_of(const bus_line::DoorUse& door) {
  if (!door.alights) return "in";
  return door.boards ? "both" : "out";
}

BusRow bus_capacity() {
  return {.key = "capacity",
          .takes = fmt::format("a whole number from 1 to {}", bus_capacity_max),
          .help = "people; without it 75, and the counting manager counts to 80",
          .take =
              [](TomlTable& table, BusRun& run) {
                unsigned people = 0;
                table.take("capacity", people, {1, bus_capacity_max});
                if (people != 0) run.network.design.capacity = people;
              },
          .value =
              [](const BusRun& run) {
                const auto& own = run.network.design.capacity;
                return own ? fmt::format("{}", *own) : "";
              },
          .example = "60"};
}

BusRow bus_doors() {
  return mapped<BusRun, DoorWords>(
      {.key = "doors",
       .takes = "a list of 1 to 4 of the texts `in`, `out`, `both`",
       .read =
           [](BusRun& run, const DoorWords& words) {
             if (words.empty() || words.size() > bus_line::counted_doors_max) {
               throw Failure(fmt::format("1 to {} doors", bus_line::counted_doors_max));
             }
             std::vector<bus_line::DoorUse> doors;
             for (const std::string& word : words) doors.push_back(door_of(word));
             run.network.design.doors = std::move(doors);
           },
       .write = [](const BusRun& run) -> std::optional<DoorWords> {
         DoorWords words;
         for (const bus_line::DoorUse& door : vehicle_options(run.network).doors) {
           words.push_back(word_of(door));
         }
         return words;
       }},
      "from the front; the third and fourth want a passenger-counter of their own");
}

/// A file of what was counted, relative to the folder; `read` gives it to the run.
template <auto file, class Read>
auto counts_of(const std::string& folder, const Read& read) {
  return [folder, read](const TomlTable& table, BusRun& run) {
    if ((run.*file).empty()) return;
    run.*file = (std::filesystem::path(folder) / (run.*file)).string();
    try {
      read(run);
    } catch (const Failure& failure) {
      table.refuse(failure.what());
    }
  };
}
template <auto file>
BusRow counts_row(const std::string& key, const std::string& help, const std::string& example) {
  auto row = setting<file>(key, help).as_example(example);
  row.value = [](const BusRun& run) {
    return (run.*file).empty() ? "" : text_value(std::filesystem::absolute(run.*file).string());
  };
  return row;
}

BusTable vehicle_table(const std::string& folder) {
  constexpr auto network = &BusRun::network;
  using bus_line::BusNetworkOptions;
  using bus_line::BusOptions;
  auto late = setting<network, &BusNetworkOptions::vehicle, &BusOptions::late>(
      "late", "the first journey begins so much behind the timetable", {1ms, 2h});
  auto red_lights = setting<network, &BusNetworkOptions::vehicle, &BusOptions::red_light_percent>(
      "red_lights", "% of the ways between stops with one", {{0, 100}});
  return {
      "vehicle",
      "",
      {setting<network, &BusNetworkOptions::design, &bus_line::BusDesign::cars>(
           "cars", "one of them has no gateway and no second bus", {{1, bus_line::cars_max}}),
       bus_capacity(), bus_doors(), std::move(late).as_example("\"3min\""), std::move(red_lights),
       counts_row<&BusRun::delays>("delays", "by how much it arrives late, as measured",
                                   "\"delays.csv\"")},
      counts_of<&BusRun::delays>(folder, [](BusRun& run) {
        run.network.vehicle.delays =
            std::make_shared<const bus_line::Delays>(read_delays(run.delays, run.network.line));
      })};
}

/// People, and their boarding times.
BusTable passenger_table(const std::string& folder) {
  constexpr auto network = &BusRun::network;
  using bus_line::BusNetworkOptions;
  using bus_line::BusOptions;
  using bus_line::RiderOptions;
  constexpr auto options = &BusNetworkOptions::vehicle;
  constexpr auto riders = &BusOptions::riders;
  return {"passengers",
          "means of one person in a door",
          {counts_row<&BusRun::demand>("demand", "who was counted, in place of an even mean",
                                       "\"counts.csv\""),
           setting<network, options, riders, &RiderOptions::boarding_time>("boarding_time", "",
                                                                           {100ms, 1min}),
           setting<network, options, riders, &RiderOptions::alighting_time>("alighting_time", "",
                                                                            {100ms, 1min}),
           setting<network, options, riders, &RiderOptions::buying_time>(
               "buying_time", "who buys from the driver, beside that", {100ms, 5min})},
          counts_of<&BusRun::demand>(folder, [](BusRun& run) {
            run.network.vehicle.riders.demand =
                std::make_shared<const bus_line::Demand>(read_demand(run.demand, run.network.line));
          })};
}

/// The CAN-ID of a message.
template <std::uint32_t bus_line::MessageIds::*id>
BusRow can_id_of(std::string key, std::string help) {
  return {.key = key,
          .takes = "a CAN-ID, as `0x18B`",
          .help = std::move(help),
          .take =
              [key](TomlTable& table, BusRun& run) {
                table.take(key, run.network.design.ids.*id, {1, Frame::id_max});
              },
          .value =
              [](const BusRun& run) {
                return fmt::format("0x{:X}", message_ids(run.network.design).*id);
              }};
}

BusTable message_table() {
  using bus_line::MessageIds;
  return {"messages",
          "CAN-IDs of messages beside those of CiA 407, 8.1.4.3",
          {can_id_of<&MessageIds::motion>("motion", "of vehicle-gateway: speed, direction, doors"),
           can_id_of<&MessageIds::mileage>("mileage", "of the same: mileage, temperature"),
           can_id_of<&MessageIds::position>("position", "of positioning-time"),
           can_id_of<&MessageIds::movement>("movement", "of the same: speed and mileage by GPS"),
           can_id_of<&MessageIds::universal_time>("universal_time", "of the same"),
           can_id_of<&MessageIds::first_count>("count_1", "of counter-1"),
           can_id_of<&MessageIds::second_count>("count_2", "of counter-2"),
           can_id_of<&MessageIds::aboard>("aboard", "of counting-manager"),
           can_id_of<&MessageIds::train_stop_request>("train_stop_request", "of train-gateway"),
           can_id_of<&MessageIds::stop_request>(
               "stop_request", "of on-board-computer, and of second-gateway in its car")}};
}

BusRow heartbeat_of(NodeId id) {
  return {.key = "heartbeat",
          .takes = fmt::format("a time from 100ms to {}", written(bus_line::heartbeat_max(id))),
          .help = id == bus_line::computer_id ? "its period (1017h)" : "",
          .take =
              [id](TomlTable& table, BusRun& run) {
                Duration period{};
                detail::take_time(table, "heartbeat", period, {100ms, bus_line::heartbeat_max(id)});
                if (period % Duration(1ms) != Duration{}) {
                  table.refuse("heartbeat", "milliseconds");
                }
                if (period != Duration{}) run.network.design.heartbeats[id] = period;
              },
          .value =
              [id](const BusRun& run) {
                const auto own = run.network.design.heartbeats.find(id);
                const bool is_usual = own == run.network.design.heartbeats.end();
                return detail::value_text(is_usual ? bus_line::heartbeat_max(id) : own->second);
              }};
}

/// `columns` and `lines`.
std::vector<BusRow> display_size(NodeId id) {
  const auto side = [id](std::string key, std::size_t most,
                         std::size_t BusDisplay::Size::*member) -> BusRow {
    return {.key = key,
            .takes = fmt::format("a whole number from 1 to {}", most),
            .help = {},
            .take =
                [=](TomlTable& table, BusRun& run) {
                  std::size_t own = 0;
                  table.take(key, own, {1, most});
                  if (own == 0) return;
                  auto& sizes = run.network.design.displays;
                  sizes.try_emplace(id, bus_line::usual_size(id)).first->second.*member = own;
                },
            .value =
                [=](const BusRun& run) {
                  const auto own = run.network.design.displays.find(id);
                  const bool is_usual = own == run.network.design.displays.end();
                  return fmt::format("{}",
                                     (is_usual ? bus_line::usual_size(id) : own->second).*member);
                }};
  };
  return {side("columns", display_columns_max, &BusDisplay::Size::columns),
          side("lines", display_lines_max, &BusDisplay::Size::lines)};
}

/// `id`, which is written where it is not the usual one.
BusRow node_id_of(const bus_line::DevicePlace& place) {
  return {.key = "id",
          .takes = fmt::format("a whole number from 1 to {}", node_id_max),
          .help = fmt::format("its node-ID; without it {}", place.id),
          .take =
              [key = place.id](TomlTable& table, BusRun& run) {
                NodeId id = key;
                table.take("id", id, {node_id_min, node_id_max});
                if (id != key) run.network.design.node_ids[key] = id;
              },
          .value =
              [key = place.id](const BusRun& run) {
                const NodeId id = id_of(run.network.design, key);
                return id == key ? "" : fmt::format("{}", id);
              }};
}

/// The table of a device, which has this node-ID.
BusTable device_table(const bus_line::DevicePlace& place, NodeId id) {
  BusTable table{std::string(place.name),
                 fmt::format("node {}", id),
                 {node_id_of(place), played<BusRun>(place.id, place.id == bus_line::computer_id),
                  heartbeat_of(place.id)}};
  if (std::ranges::find(bus_line::display_ids, place.id) != bus_line::display_ids.end()) {
    for (BusRow& row : display_size(place.id)) table.settings.push_back(std::move(row));
  }
  return table;
}

FilePart<BusRun> device_part(const bus_line::DevicePlace& place) {
  FilePart<BusRun> part(device_table(place, place.id));
  part.text = [place](const BusRun& run) {
    const NodeId id = id_of(run.network.design, place.id);
    return settings_text(device_table(place, id), run);
  };
  return part_of_car(place.car, std::move(part));
}

FilePart<BusRun> added_devices() {
  using bus_line::AddedDevice;
  return several<BusRun, AddedDevice>(
      [](const BusRun&) {
        auto node = setting<&AddedDevice::id>("node", "its node-ID", {{1, added_node_max}});
        auto door = setting<&AddedDevice::door>("door", "of a passenger-counter",
                                                {{1, bus_line::counted_doors_max}});
        door.value = [](const AddedDevice& device) {
          return device.door == 0 ? "" : fmt::format("{}", device.door);
        };
        return SettingTable<AddedDevice>{
            "device",
            "rides along",
            {setting<&AddedDevice::kind>("kind", "of CiA 407: canvoy device --list"),
             std::move(node), setting<&AddedDevice::car>("car", "", {{1, bus_line::cars_max}}),
             std::move(door)}};
      },
      [](const BusRun& run) { return run.network.design.added; },
      [](const TomlTable& table, BusRun& run, AddedDevice device) {
        std::vector<AddedDevice>& added = run.network.design.added;
        added.push_back(std::move(device));
        const std::string problem = problem_of(added.back(), run.network.design);
        if (!problem.empty()) table.refuse(problem);
      });
}

}  // namespace

FilePart<BusRun> part_of_car(unsigned car, FilePart<BusRun> part) {
  if (car <= bus_line::cars_made(1)) return part;
  part.text = [text = std::move(part.text), car](const BusRun& run) {
    return car <= run.network.design.cars ? text(run) : "";
  };
  return part;
}

void add_bus_settings(std::vector<FilePart<BusRun>>& parts, const std::string& folder) {
  add_line_changes(parts);
  parts.emplace_back(vehicle_table(folder));
  parts.emplace_back(passenger_table(folder));
  parts.emplace_back(message_table());
  for (const bus_line::DevicePlace& place : bus_line::device_places)
    parts.push_back(device_part(place));
  parts.push_back(added_devices());
}

}  // namespace canvoy::tools
