#include "canvoy/tools/play/demand_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <filesystem>
#include <span>
#include <string_view>

#include "canvoy/formats/gtfs/table.hpp"
#include "canvoy/formats/plain_text.hpp"
#include "canvoy/tools/cli/failure.hpp"

namespace canvoy::tools {

namespace {

constexpr double counted_max = 200;  ///< people at one stop
constexpr double earliest_s = -600;
constexpr double latest_s = 7200;
constexpr std::uint32_t counted_hour_max = 47;

/// Columns of both files; what was counted follows.
namespace column {
enum : std::size_t { stop, direction, hour, counted };
}
constexpr std::array<std::string_view, 5> demand_columns = {"stop", "direction", "hour", "boarding",
                                                            "alighting"};
constexpr std::array<std::string_view, 4> delay_columns = {"stop", "direction", "hour", "delay"};

/// The stops with this id, or else with this name.
std::size_t stop_of(gtfs::Table& table, const bus_line::BusLine& line) {
  const std::string_view wanted = table.needed(column::stop);
  const auto id = std::ranges::find(line.stops, wanted, &bus_line::BusStop::id);
  if (id != line.stops.end()) return static_cast<std::size_t>(id - line.stops.begin());
  const auto name = std::ranges::find(line.stops, wanted, &bus_line::BusStop::name);
  const auto count = std::ranges::count(line.stops, wanted, &bus_line::BusStop::name);
  if (count != 1) {
    table.fail(column::stop, fmt::format("'{}' is {} of the line", formats::plain_text(wanted),
                                         count == 0 ? "no stop" : "the name of several stops"));
    return 0;
  }
  return static_cast<std::size_t>(name - line.stops.begin());
}

/// Reads the value of each row by `read`.
template <class Value, class Read>
bus_line::StopTable<Value> read_counts(const std::string& path, const bus_line::BusLine& line,
                                       std::span<const std::string_view> columns,
                                       const Read& read) {
  const std::filesystem::path file(path);
  const std::string folder = file.has_parent_path() ? file.parent_path().string() : ".";
  const auto archive = value_or_throw(gtfs::FeedArchive::open(folder));
  auto table = value_or_throw(gtfs::Table::open(archive, file.filename().string(), columns));
  if (!table.is_there()) throw Failure(fmt::format("{}: there is no such file", path));
  bus_line::StopTable<Value> made;
  while (table.next()) {
    typename bus_line::StopTable<Value>::Row row{.stop = stop_of(table, line)};
    if (const auto one = table.count(column::direction, 1)) row.is_backward = *one == 1;
    row.hour = table.count(column::hour, counted_hour_max);
    table.needed(column::counted);
    row.value = read(table);
    if (!table.error() && !made.add(row)) {
      table.fail(column::stop, "there is a row of this stop, direction and hour already");
    }
  }
  if (table.error()) throw Failure(table.error()->line());
  return made;
}

}  // namespace

bus_line::Demand read_demand(const std::string& path, const bus_line::BusLine& line) {
  return read_counts<bus_line::Exchange>(
      path, line, demand_columns, [](gtfs::Table& table) -> bus_line::Exchange {
        return {.boarding = table.number(column::counted, 0, counted_max).value_or(0),
                .alighting = table.number(column::counted + 1, 0, counted_max).value_or(0)};
      });
}

bus_line::Delays read_delays(const std::string& path, const bus_line::BusLine& line) {
  return read_counts<Duration>(path, line, delay_columns, [](gtfs::Table& table) {
    const double late = table.number(column::counted, earliest_s, latest_s).value_or(0);
    return std::chrono::duration_cast<Duration>(std::chrono::duration<double>(late));
  });
}

}  // namespace canvoy::tools
