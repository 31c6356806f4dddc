#include "canvoy/tools/run/bus_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <filesystem>

#include "canvoy/formats/gtfs/feed_reader.hpp"
#include "canvoy/sim/bus/line_of_feed.hpp"
#include "canvoy/sim/duration_text.hpp"
#include "canvoy/tools/failure.hpp"
#include "canvoy/tools/run/network_text.hpp"
#include "canvoy/tools/run/run.hpp"
#include "canvoy/tools/run/time_zone.hpp"

namespace canvoy::tools {

namespace {

/// `2026-11-23`.
gtfs::Date date_of(const std::string& text) {
  int year = 0;
  unsigned month = 0;
  unsigned day = 0;
  const char* const end = text.data() + text.size();
  const auto take = [end](const char* at, auto& number) {
    const auto [next, error] = std::from_chars(at, end, number);
    return error == std::errc{} && next != end && *next == '-' ? next + 1 : next;
  };
  const char* const last = take(take(take(text.data(), year), month), day);
  const gtfs::Date date{std::chrono::year(year), std::chrono::month(month), std::chrono::day(day)};
  const bool is_whole = last == end && text == fmt::format("{:04}-{:02}-{:02}", year, month, day);
  // What the clocks of CiA 407 can hold (610Eh).
  constexpr int first = 1985;
  constexpr int beyond = 2235;
  if (!is_whole || !date.ok() || year < first || year >= beyond) {
    throw UsageError(fmt::format("'{}' is no date such as 2026-11-23", text));
  }
  return date;
}

std::string date_text(const gtfs::Date& date) {
  return fmt::format("{:04}-{:02}-{:02}", static_cast<int>(date.year()),
                     static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()));
}

/// The first day on which a trip of the route runs.
gtfs::Date first_day(const gtfs::Feed& feed, const std::string& name) {
  constexpr int days_of_week = 7;
  std::optional<gtfs::Date> first;
  const auto consider = [&](const gtfs::Date& day) {
    const bool runs = std::ranges::any_of(
        feed.trips, [&](const gtfs::Trip& trip) { return feed.runs_on(trip, day); });
    if (runs && (!first || day < *first)) first = day;
  };
  for (const gtfs::Service& service : feed.services) {
    for (const gtfs::Date& day : service.added) consider(day);
    if (!service.start) continue;
    for (int i = 0; i < days_of_week; ++i) {
      consider(std::chrono::sys_days(*service.start) + std::chrono::days(i));
    }
  }
  if (!first) throw Failure(fmt::format("{}: no trip of the route runs on any day", name));
  return *first;
}

/// The clocks of the feed's agency for more than a year from the day of service; those of a longer
/// run stay as they were last.
bus::LocalClock clock_of(const gtfs::Feed& feed, const std::string& name, const gtfs::Date& date) {
  constexpr std::chrono::days before{2};
  constexpr std::chrono::days known{400};
  auto changes =
      offsets_of(feed.agency.timezone, std::chrono::sys_days(date) - before, before + known);
  if (!changes) {
    throw Failure(fmt::format(
        "{}: agency_timezone '{}' is not one of this system's; write it as Europe/Berlin, or "
        "install the package tzdata",
        name, feed.agency.timezone));
  }
  return bus::LocalClock(std::move(*changes));
}

}  // namespace

void choose_line(BusRun& run, const LineChoice& choice) {
  run.line = choice;
  bus::BusNetworkOptions& network = run.network;
  if (!choice.date.empty()) network.date = date_of(choice.date);
  if (choice.feed.empty()) {
    if (!choice.route.empty()) throw UsageError("a route is one of a feed: give --gtfs as well");
  } else {
    const gtfs::Feed feed = value_or_throw(gtfs::read_feed(choice.feed, choice.route));
    if (choice.date.empty()) network.date = first_day(feed, choice.feed);
    bus::LineOfFeed made = bus::line_of_feed(feed, network.date);
    if (!made.problem.empty()) {
      throw Failure(fmt::format("{}: {}: {}", choice.feed, date_text(network.date), made.problem));
    }
    network.line = std::move(made.line);
    network.clock = clock_of(feed, choice.feed, network.date);
  }
  const auto& blocks = network.line.blocks;
  const auto block = std::ranges::find(blocks, choice.block, &bus::Block::number);
  if (block == blocks.end()) {
    throw UsageError(
        fmt::format("there is no block {}: the line has {} of them", choice.block, blocks.size()));
  }
  network.block = static_cast<std::size_t>(block - blocks.begin());
}

BusRun run_on_line(const LineChoice& line) {
  BusRun run;
  choose_line(run, line);
  return run;
}

void add_fault(BusRun& run, const std::string& text) {
  const Duration length = run.network.length;
  const Time end = length > Duration::zero() ? Time(length) : never;
  const bus::ScheduledFault fault =
      bus::scheduled(parse_run_fault(bus::fault_grammar(), text, end));
  if (fault.node != 0 && !bus::has_node(fault.kind)) {
    throw UsageError(fmt::format("fault '{}': it is not one of a node", text));
  }
  const bool is_there = std::ranges::find(bus::device_places, fault.node, &bus::DevicePlace::id) !=
                        bus::device_places.end();
  if (fault.node != 0 && !is_there) {
    std::vector<unsigned> ids;
    ids.reserve(bus::device_places.size());
    for (const bus::DevicePlace& place : bus::device_places) ids.push_back(place.id);
    throw UsageError(fmt::format("fault '{}': there are nodes {}", text, fmt::join(ids, ", ")));
  }
  run.network.faults.faults.push_back(fault);
}

namespace {

void check_bus(TomlTable& table, const BusRun& run) {
  if (run.network.real.empty()) return;
  for (const NodeId id : run.network.real) {
    const BusIndex index = bus::car_of(id) - 1;
    const bool has_bus = std::ranges::find(run.real, index, &RealBus::bus) != run.real.end();
    if (has_bus) continue;
    table.refuse(fmt::format("who is not played is on a real bus: write real = \"can{}\" in [{}]",
                             index, index == 0 ? "bus" : "second_bus"));
  }
  if (!run.network.faults.faults.empty()) {
    table.refuse("faults", "only where all devices are played");
  }
}

void take_line(TomlTable table, const std::string& folder, BusRun& run) {
  LineChoice line;
  table.take("gtfs", line.feed);
  table.take("route", line.route);
  table.take("date", line.date);
  table.take("block", line.block, Range<std::uint32_t>{1, 1'000'000});
  if (!line.feed.empty()) line.feed = (std::filesystem::path(folder) / line.feed).string();
  table.finish();
  try {
    choose_line(run, line);
  } catch (const Failure& failure) {
    table.refuse(failure.what());
  }
}

}  // namespace

BusRun read_bus_run(TomlTable& table, const std::string& folder) {
  BusRun run;
  bus::BusNetworkOptions& network = run.network;
  if (table.has("for")) table.take("for", network.length);
  table.take("seed", network.faults.seed);
  std::vector<std::string> faults;
  table.take("faults", faults);
  TomlTable bus = table.table("bus");
  bus.take<std::uint32_t>("bit_rate", network.bit_rate, {50'000, 1'000'000});
  take_real_bus(bus, 0, run.real);
  bus.finish();
  TomlTable second = table.table("second_bus");
  take_real_bus(second, 1, run.real);
  second.finish();
  take_line(table.table("line"), folder, run);
  for (const bus::DevicePlace& place : bus::device_places) {
    TomlTable device = table.table(place.name);
    bool is_played = true;
    device.take("played", is_played);
    if (!is_played) network.real.push_back(place.id);
    device.finish();
  }
  table.finish();
  try {
    for (const std::string& fault : faults) add_fault(run, fault);
  } catch (const Failure& failure) {
    table.refuse("faults", failure.what());
  }
  check_bus(table, run);
  return run;
}

namespace {

std::string real_text(const BusRun& run, BusIndex index) {
  const auto real = std::ranges::find(run.real, index, &RealBus::bus);
  if (real != run.real.end()) return fmt::format("real = {}\n", text_value(real->address));
  return fmt::format(
      "# real = \"can{}\"  # a real bus is a part of it; all runs at the speed of the clock\n",
      index);
}

}  // namespace

std::string bus_run_text(const BusRun& run) {
  const bus::BusNetworkOptions& network = run.network;
  std::vector<std::string> faults;
  faults.reserve(network.faults.faults.size());
  for (const bus::ScheduledFault& fault : network.faults.faults) {
    faults.push_back(fmt::format("\"{}\"", fault_text(bus::fault_grammar(), bus::written(fault))));
  }
  std::string text = "# A bus on its line: CiA 407.\nnetwork = \"bus\"\n";
  text += network.length > Duration::zero()
              ? fmt::format("for = \"{}\"  # virtual time\n", canvoy::written(network.length))
              : "# for = \"4h\"  # virtual time; else until the block is over\n";
  text += fmt::format(
      R"(seed = {}  # of all that is left to chance
faults = [{}]  # NAME@START or NAME@START+DURATION; canvoy run bus --help lists them

[bus]
bit_rate = {}  # bit/s
)",
      network.faults.seed, fmt::join(faults, ", "), network.bit_rate);
  text += real_text(run, 0);
  text += "\n[second_bus]  # in the second car\n" + real_text(run, 1);
  text += "\n[line]\n";
  if (run.line.feed.empty()) {
    text += "# gtfs = \"feed.zip\"  # a timetable in place of the built-in one\n";
  } else {
    const std::string feed = std::filesystem::absolute(run.line.feed).string();
    text += fmt::format("gtfs = {}\nroute = {}\n", text_value(feed), text_value(run.line.route));
  }
  text += fmt::format("date = \"{}\"  # the day of service\nblock = {}  # of the vehicle\n",
                      date_text(network.date), run.line.block);
  for (const bus::DevicePlace& place : bus::device_places) {
    const bool is_played = std::ranges::find(network.real, place.id) == network.real.end();
    text += fmt::format("\n[{}]  # node {}\nplayed = {}{}\n", place.name, place.id, is_played,
                        place.id == 1 ? "  # false: a real one is on the bus" : "");
  }
  return text;
}

}  // namespace canvoy::tools
