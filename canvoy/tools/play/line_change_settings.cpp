// Parts of the file of a bus for its day: short turns, detours, the depot, and changes of drivers.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/play/bus_settings.hpp"

namespace canvoy::tools {

namespace {

using BusRow = Setting<BusRun>;
using BusTable = SettingTable<BusRun>;

constexpr std::uint32_t journey_max = 0xFFFF;  ///< 6195h

/// Coordinates as a list: latitude, longitude, and so on.
std::vector<bus_line::GeoPoint> points_of(const std::vector<double>& numbers) {
  constexpr double pole = 90;
  constexpr double date_line = 180;
  if (numbers.size() % 2 != 0) throw Failure("each place has a latitude and a longitude");
  std::vector<bus_line::GeoPoint> points;
  for (std::size_t i = 0; i < numbers.size(); i += 2) {
    if (std::abs(numbers[i]) > pole || std::abs(numbers[i + 1]) > date_line) {
      throw Failure("a latitude is from -90 to 90, a longitude from -180 to 180");
    }
    points.push_back({numbers[i], numbers[i + 1]});
  }
  return points;
}
std::vector<double> numbers_of(const std::vector<bus_line::GeoPoint>& points) {
  std::vector<double> numbers;
  for (const bus_line::GeoPoint& point : points) {
    numbers.insert(numbers.end(), {point.latitude, point.longitude});
  }
  return numbers;
}

BusRow depot_place() {
  BusRow row = mapped<BusRun, std::vector<double>>(
      {.key = "place",
       .takes = "a latitude and a longitude, as `[50.1, 8.5]`",
       .read =
           [](BusRun& run, const std::vector<double>& numbers) {
             const auto points = points_of(numbers);
             if (points.size() != 1) throw Failure("one place");
             run.depot.emplace().place = points.front();
           },
       .write = [](const BusRun& run) -> std::optional<std::vector<double>> {
         if (!run.depot) return std::nullopt;
         return numbers_of({run.depot->place});
       }},
      "without it, the vehicle begins at the first stop");
  return std::move(row).as_example("[50.1, 8.5]");
}

template <std::string bus_line::Depot::*text>
BusRow depot_text(const std::string& key, const std::string& help) {
  return {
      .key = key,
      .takes = "a text",
      .help = help,
      .take =
          [key](TomlTable& table, BusRun& run) {
            if (!table.has(key)) return;
            if (!run.depot) table.refuse(key, "a depot has a place");
            table.take(key, (*run.depot).*text);
          },
      .value = [](const BusRun& run) { return run.depot ? text_value((*run.depot).*text) : ""; }};
}

BusTable depot_table() {
  using bus_line::Depot;
  return {"depot",
          "ways out and in, without passengers",
          {depot_place(), depot_text<&Depot::name>("name", "of the stop there"),
           depot_text<&Depot::sign>("sign", "the destination on the ways out and in")},
          [](const TomlTable& table, BusRun& run) {
            if (!run.depot) return;
            const std::string problem = add_depot(run.network.line, *run.depot);
            if (!problem.empty()) table.refuse(problem);
          }};
}

FilePart<BusRun> short_turns() {
  using bus_line::ShortTurn;
  return several<BusRun, ShortTurn>(
      [](const BusRun&) {
        return SettingTable<ShortTurn>{
            "short_turn",
            "ends before its last stop; the next journey begins there",
            {setting<&ShortTurn::journey>("journey", "its number in the block", {{1, journey_max}}),
             setting<&ShortTurn::stop>("stop", "its id or name")}};
      },
      [](const BusRun& run) { return run.short_turns; },
      [](const TomlTable& table, BusRun& run, ShortTurn change) {
        const std::string problem = turn_short(run.network.line, run.network.block, change);
        if (!problem.empty()) table.refuse(problem);
        run.short_turns.push_back(std::move(change));
      });
}

FilePart<BusRun> detours() {
  using bus_line::Detour;
  return several<BusRun, Detour>(
      [](const BusRun&) {
        return SettingTable<Detour>{
            "detour",
            "leaves out stops",
            {setting<&Detour::journey>("journey", "its number in the block", {{1, journey_max}}),
             mapped<Detour, std::vector<std::string>>(
                 {.key = "without",
                  .takes = "a list of stops that follow each other, by id or name",
                  .read = [](Detour& detour,
                             const std::vector<std::string>& stops) { detour.without = stops; },
                  .write = [](const Detour& detour) { return std::optional(detour.without); }}),
             mapped<Detour, std::vector<double>>(
                 {.key = "via",
                  .takes = "a list of latitudes and longitudes in turn",
                  .read = [](Detour& detour,
                             const std::vector<double>& way) { detour.via = points_of(way); },
                  .write = [](const Detour& detour) -> std::optional<std::vector<double>> {
                    if (detour.via.empty()) return std::nullopt;
                    return numbers_of(detour.via);
                  }},
                 "corners of the way; else straight ahead")}};
      },
      [](const BusRun& run) { return run.detours; },
      [](const TomlTable& table, BusRun& run, Detour change) {
        const std::string problem = divert(run.network.line, run.network.block, change);
        if (!problem.empty()) table.refuse(problem);
        run.detours.push_back(std::move(change));
      });
}

FilePart<BusRun> driver_changes() {
  using bus_line::DriverChange;
  return several<BusRun, DriverChange>(
      [](const BusRun&) {
        return SettingTable<DriverChange>{
            "driver",
            "takes over",
            {setting<&DriverChange::journey>("journey", "from this one on", {{1, journey_max}}),
             setting<&DriverChange::driver>("number", "of the driver (6190h)",
                                            {{1, std::numeric_limits<std::uint32_t>::max()}})}};
      },
      [](const BusRun& run) { return run.network.drivers; },
      [](const TomlTable& table, BusRun& run, DriverChange change) {
        const auto& journeys = run.network.line.blocks[run.network.block].journeys;
        if (std::ranges::find(journeys, change.journey, &bus_line::Journey::number) ==
            journeys.end()) {
          table.refuse(fmt::format("the block has no journey {}", change.journey));
        }
        run.network.drivers.push_back(change);
      });
}

}  // namespace

void add_line_changes(std::vector<FilePart<BusRun>>& parts) {
  parts.push_back(short_turns());
  parts.push_back(detours());
  parts.emplace_back(depot_table());
  parts.push_back(driver_changes());
}

}  // namespace canvoy::tools
