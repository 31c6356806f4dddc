#include "canvoy/tools/play/demand_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>

#include "canvoy/formats/gtfs/table.hpp"
#include "canvoy/formats/plain_text.hpp"
#include "canvoy/tools/cli/failure.hpp"

namespace canvoy::tools {

namespace {

constexpr double counted_max = 200;  ///< people at one stop
constexpr std::uint32_t counted_hour_max = 47;

namespace demand_column {
enum : std::size_t { stop, direction, hour, boarding, alighting };
constexpr std::array<std::string_view, 5> names = {"stop", "direction", "hour", "boarding",
                                                   "alighting"};
}  // namespace demand_column

/// The stops with this id, or else with this name.
std::size_t stop_of(gtfs::Table& table, const bus_line::BusLine& line) {
  const std::string_view wanted = table.needed(demand_column::stop);
  const auto id = std::ranges::find(line.stops, wanted, &bus_line::BusStop::id);
  if (id != line.stops.end()) return static_cast<std::size_t>(id - line.stops.begin());
  const auto name = std::ranges::find(line.stops, wanted, &bus_line::BusStop::name);
  const auto count = std::ranges::count(line.stops, wanted, &bus_line::BusStop::name);
  if (count != 1) {
    table.fail(demand_column::stop,
               fmt::format("'{}' is {} of the line", formats::plain_text(wanted),
                           count == 0 ? "no stop" : "the name of several stops"));
    return 0;
  }
  return static_cast<std::size_t>(name - line.stops.begin());
}

}  // namespace

bus_line::Demand read_demand(const std::string& path, const bus_line::BusLine& line) {
  namespace column = demand_column;
  const std::filesystem::path file(path);
  const std::string folder = file.has_parent_path() ? file.parent_path().string() : ".";
  const auto archive = value_or_throw(gtfs::FeedArchive::open(folder));
  auto table =
      value_or_throw(gtfs::Table::open(archive, file.filename().string(), demand_column::names));
  if (!table.is_there()) throw Failure(fmt::format("{}: there is no such file", path));
  bus_line::Demand demand;
  while (table.next()) {
    bus_line::Demand::Row row{.stop = stop_of(table, line)};
    if (const auto one = table.count(column::direction, 1)) row.is_backward = *one == 1;
    row.hour = table.count(column::hour, counted_hour_max);
    table.needed(column::boarding);
    row.exchange = {.boarding = table.number(column::boarding, 0, counted_max).value_or(0),
                    .alighting = table.number(column::alighting, 0, counted_max).value_or(0)};
    if (!table.error() && !demand.add(row)) {
      table.fail(demand_column::stop, "there is a row of this stop, direction and hour already");
    }
  }
  if (table.error()) throw Failure(table.error()->line());
  return demand;
}

}  // namespace canvoy::tools
