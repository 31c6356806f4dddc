// canvoy run bus: plays a day of a bus on its line.
#include <algorithm>
#include <charconv>
#include <chrono>
#include <filesystem>

#include "canvoy/formats/gtfs/feed_reader.hpp"
#include "canvoy/formats/plain_text.hpp"
#include "canvoy/sim/duration_text.hpp"
#include "canvoy/tools/cli/interruption.hpp"
#include "canvoy/tools/play/bus_realtime.hpp"
#include "canvoy/tools/play/bus_settings.hpp"
#include "canvoy/tools/play/bus_text.hpp"
#include "canvoy/tools/play/display_folder.hpp"
#include "canvoy/tools/play/run_depot.hpp"
#include "canvoy/tools/play/time_zone.hpp"
#include "canvoy/tools/play/world.hpp"
#include "canvoy/tools/terminal/message.hpp"
#include "canvoy/worlds/bus_line/bus_depot.hpp"
#include "canvoy/worlds/bus_line/line_of_feed.hpp"

namespace canvoy::tools {

namespace {

using bus_line::BusNetwork;
using bus_line::BusNetworkOptions;

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
  // Range of the clocks of CiA 407 (610Eh).
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
    const bool runs = std::ranges::any_of(feed.trips, [&](const gtfs::Trip& trip) {
      return trip.other_route == gtfs::none && feed.runs_on(trip, day);
    });
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

/// The clock of the agency of the feed, for more than a year from the day of service; a longer run
/// keeps the last offset.
bus_line::LocalClock clock_of(const gtfs::Feed& feed, const std::string& name,
                              const gtfs::Date& date) {
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
  return bus_line::LocalClock(std::move(*changes));
}

/// Reads the feed, if one is given, and selects the block. A feed without a date is played on the
/// first day on which its route runs. Throws Failure.
void choose_line(BusRun& run, const LineChoice& choice) {
  run.line = choice;
  bus_line::BusNetworkOptions& network = run.network;
  if (!choice.date.empty()) network.date = date_of(choice.date);
  if (choice.feed.empty()) {
    if (!choice.route.empty()) throw UsageError("a route is one of a feed: give --gtfs as well");
  } else {
    const gtfs::Feed feed = value_or_throw(gtfs::read_feed(choice.feed, choice.route));
    for (const std::string& note : feed.notes) print_message(fmt::format("canvoy: {}", note));
    if (choice.date.empty()) network.date = first_day(feed, choice.feed);
    bus_line::LineOfFeed made = bus_line::line_of_feed(feed, network.date);
    if (!made.problem.empty()) {
      throw Failure(fmt::format("{}: {}: {}", choice.feed, date_text(network.date),
                                formats::plain_text(made.problem)));
    }
    network.line = std::move(made.line);
    network.clock = clock_of(feed, choice.feed, network.date);
  }
  const auto& blocks = network.line.blocks;
  const auto block = std::ranges::find(blocks, choice.block, &bus_line::Block::number);
  if (block == blocks.end()) {
    throw UsageError(
        fmt::format("there is no block {}: the line has {} of them", choice.block, blocks.size()));
  }
  network.block = static_cast<std::size_t>(block - blocks.begin());
}

/// Interval of GTFS-Realtime updates.
constexpr Duration realtime_period = 15s;

/// Output beside lines; empty: none.
struct BusOutlets {
  std::string realtime{};  ///< a file or a listening address
  std::string displays{};  ///< a folder

  bool has_any() const { return !realtime.empty() || !displays.empty(); }
};

class PlayedBus : public Played<BusNetwork> {
 public:
  PlayedBus(const BusNetworkOptions& options, const BusOutlets& outlets) : Played(options) {
    if (!outlets.displays.empty()) displays_.emplace(outlets.displays);
    if (outlets.realtime.empty()) return;
    heed_interruption();  // before the address is printed
    realtime_ = open_realtime(outlets.realtime, network_);
  }

  std::vector<std::string> bus_names() const override {
    std::vector<std::string> names;
    const unsigned cars = bus_line::cars_made(network_.options().design.cars);
    for (unsigned bus = 0; bus < cars; ++bus) names.push_back(fmt::format("sim{}", bus));
    return names;
  }
  void run_until(Time until) override {
    for (Time next = next_outlet(); next <= until; next = next_outlet()) {
      network_.run_until(next);
      if (realtime_ && next == next_realtime_) {
        realtime_->tell(network_);
        next_realtime_ += realtime_period;
      }
      if (displays_ && next == next_look_) {
        displays_->look(network_);
        next_look_ += DisplayFolder::period;
      }
    }
    network_.run_until(until);
  }

 private:
  Time next_outlet() const {
    return std::min(realtime_ ? next_realtime_ : never, displays_ ? next_look_ : never);
  }

  std::unique_ptr<RealtimeOutlet> realtime_;
  Time next_realtime_ = Time(realtime_period);
  std::optional<DisplayFolder> displays_;
  Time next_look_{};
};

struct BusWorld {
  using Run = BusRun;
  using Kind = bus_line::FaultKind;
  struct Choice {
    LineChoice line{};
    BusOutlets outlets{};
    std::uint32_t vehicles = 0;  ///< 0: one bus, no depot
    unsigned threads = 0;
  };
  static constexpr std::string_view name = "bus";
  static constexpr auto network = &Run::network;

  static WorldInfo info();
  static WorldInfo info(const Run& run);
  static WorldFile<Run> file(const std::string& folder);
  static void check(const TomlTable& file, const std::string&, Run& run) {
    check_real(file, run, [](NodeId id) -> BusIndex { return bus_line::car_of(id) - 1U; },
               {"bus", "second_bus", "third_bus", "fourth_bus"});
    check_cars(file, run);
    for (const bus_line::DevicePlace& place : bus_line::device_places) {
      if (!run.network.design.node_ids.contains(place.id)) continue;
      const std::string wrong = problem_of_node_id(run.network.design, place);
      if (!wrong.empty()) file.refuse(place.name, "id: " + wrong);
    }
    const std::string problem = problem_of(run.network.design);
    if (!problem.empty()) file.refuse(problem);
  }
  static void check_cars(const TomlTable& file, const Run& run);
  static Run run_of_file() { return {}; }
  static Duration& length(Run& run) { return run.network.length; }
  static std::string check_fault_node(const Run& run, NodeId id);
  static void add_options(Verb& verb, Choice& choice);
  static int run_chosen(const Verb& verb, const RunOptions& options, const Choice& choice);
  static std::optional<int> play(const Run& run, PlayOptions& play_as, const RunOptions& options,
                                 const Choice& choice);
  static MadeWorld make(const Run& run, const Choice& choice) {
    BusNetworkOptions options = run.network;
    share_people(options, line_day_of(options, last_time_of(options)));
    return {.network = std::make_unique<PlayedBus>(options, choice.outlets)};
  }
  static std::vector<DescribedNode> describe(const Run& run) {
    return describe_network(*std::make_unique<BusNetwork>(run.network));
  }
};

/// What the devices of a bus are, for who decodes their frames.
void add_nodes(WorldInfo& info, const bus_line::BusDesign& design) {
  for (const bus_line::DevicePlace& place : bus_line::places_of(design.cars)) {
    info.decoding.nodes.push_back(
        fmt::format("{}={}", id_of(design, place.id), bus_line::device_name_of(place.id)));
  }
}

WorldInfo BusWorld::info() {
  WorldInfo info{.about = "A bus on its line: CiA 407 (a day)",
                 .examples =
                     "  canvoy run bus --for 30min\n"
                     "  canvoy run bus --for 20min --log bus.log --json",
                 .page = "bus-line",
                 .decoding = {.profiles = {"407"}}};
  add_nodes(info, {});
  return info;
}

WorldInfo BusWorld::info(const Run& run) {
  WorldInfo info = BusWorld::info();
  info.decoding.nodes.clear();
  add_nodes(info, run.network.design);
  return info;
}

/// By default, until the end of the block.
Setting<BusRun> length_of_day() {
  return {.key = "for",
          .takes = "a time, as `\"30s\"`",
          .help = "virtual time; else until the block is over",
          .take = [](TomlTable& table, BusRun& run) { table.take("for", run.network.length); },
          .value =
              [](const BusRun& run) {
                const Duration length = run.network.length;
                return length > Duration::zero()
                           ? fmt::format("\"{}\"  # virtual time", written(length))
                           : "";
              },
          .example = "\"4h\""};
}

SettingTable<BusRun> line_table(const std::string& folder) {
  using Run = BusRun;
  constexpr auto line = &Run::line;
  auto feed = setting<line, &LineChoice::feed>("gtfs", "a timetable in place of the built-in one")
                  .as_example("\"feed.zip\"");
  feed.value = [](const Run& run) {
    return run.line.feed.empty() ? ""
                                 : text_value(std::filesystem::absolute(run.line.feed).string());
  };
  auto route = setting<line, &LineChoice::route>("route");
  route.value = [](const Run& run) {
    return run.line.feed.empty() ? "" : text_value(run.line.route);
  };
  auto date = setting<line, &LineChoice::date>("date", "the day of service");
  date.value = [](const Run& run) { return fmt::format("\"{}\"", date_text(run.network.date)); };
  return {"line",
          "",
          {std::move(feed), std::move(route), std::move(date),
           setting<line, &LineChoice::block>("block", "of the vehicle", {{1, 1'000'000}})},
          [folder](const TomlTable& table, Run& run) {
            LineChoice wanted = run.line;
            if (!wanted.feed.empty())
              wanted.feed = (std::filesystem::path(folder) / wanted.feed).string();
            try {
              choose_line(run, wanted);
            } catch (const Failure& failure) {
              table.refuse(failure.what());
            }
          }};
}

WorldFile<BusRun> BusWorld::file(const std::string& folder) {
  WorldFile<Run> file{
      .network = name,
      .title = "A bus on its line: CiA 407.",
      .head = world_head(length_of_day(), name),
      .parts = {
          SettingTable<Run>{"bus",
                            "",
                            {setting<network, &BusNetworkOptions::bit_rate>("bit_rate", "bit/s",
                                                                            {{50'000, 1'000'000}}),
                             real_setting<Run>(0)}},
          SettingTable<Run>{"second_bus", "in the second car", {real_setting<Run>(1)}},
          part_of_car(3,
                      SettingTable<Run>{"third_bus", "in the third car", {real_setting<Run>(2)}}),
          part_of_car(4,
                      SettingTable<Run>{"fourth_bus", "in the fourth car", {real_setting<Run>(3)}}),
          line_table(folder)}};
  add_bus_settings(file.parts, folder);
  return file;
}

/// Refuses tables of cars that the bus does not have.
void BusWorld::check_cars(const TomlTable& file, const Run& run) {
  const unsigned cars = run.network.design.cars;
  const auto refuse = [&](unsigned car, std::string_view table) {
    if (car <= bus_line::cars_made(cars) || !file.has(table)) return;
    file.refuse(table,
                cars == 1 ? "the bus has one car" : fmt::format("the bus has {} cars", cars));
  };
  refuse(3, "third_bus");
  refuse(4, "fourth_bus");
  for (const bus_line::DevicePlace& place : bus_line::device_places) refuse(place.car, place.name);
}

std::string BusWorld::check_fault_node(const Run& run, NodeId id) {
  const bus_line::BusDesign& design = run.network.design;
  std::vector<unsigned> ids;
  for (const bus_line::DevicePlace& place : bus_line::places_of(design.cars)) {
    ids.push_back(id_of(design, place.id));
  }
  if (std::ranges::find(ids, id) != ids.end()) return {};
  std::ranges::sort(ids);
  return fmt::format("there are nodes {}", fmt::join(ids, ", "));
}

void BusWorld::add_options(Verb& verb, Choice& choice) {
  verb.add({
      {"--gtfs", choice.line.feed,
       "a timetable: a folder or zip archive of GTFS (default: a built-in line)"},
      {"--route", choice.line.route,
       "which route of the feed: its route_id or short name; not needed where it has one"},
      {"--date", choice.line.date,
       "the day of service, as 2026-11-23 (default: the first on which the route runs)"},
      {"--block", choice.line.block, "which vehicle of the line (default 1)"},
      {"--gtfs-rt", choice.outlets.realtime,
       "says where the bus is, how full and how late, as GTFS-Realtime, anew each 15 s of "
       "its time: in a file, or by HTTP at :PORT, 127.0.0.1:PORT or [::1]:PORT (0: a free "
       "one)"},
      {"--displays", choice.outlets.displays,
       "a folder for pictures of all displays, one whenever a display looks different: "
       "next-stop-0001.png and so on"},
      {"--vehicles", choice.vehicles,
       "a depot: so many vehicles, each a bus of its own with the next seed and the next "
       "block of the line; says who failed, and totals",
       between(1U, bus_line::depot_vehicles_max)},
      {"--threads", choice.threads, "on which a depot is played (default: one for each core)",
       between(1U, depot_threads_max)},
  });
}

/// Refuses options of one bus for a depot, and options of a depot for one bus.
void check_options(const Verb& bus, const BusWorld::Choice& options) {
  if (options.vehicles == 0) {
    if (bus.count("--threads") != 0) throw UsageError("--threads is of a depot: give --vehicles");
    return;
  }
  for (const char* name : {"--log", "--print", "--speed", "--gtfs-rt", "--displays", "--block",
                           "--web", "--out", "--act"}) {
    if (bus.count(name) == 0) continue;
    throw UsageError(fmt::format("{} is of one bus: leave it out, or --vehicles", name));
  }
}

std::optional<int> BusWorld::play(const Run& run, PlayOptions& play_as, const RunOptions& options,
                                  const Choice& choice) {
  if (options.is_watched() && choice.outlets.has_any()) {
    throw UsageError("--gtfs-rt and --displays are of a run on the terminal");
  }
  play_as.duration = bus_line::end_of(run.network) - Time{};
  return std::nullopt;
}

int BusWorld::run_chosen(const Verb& verb, const RunOptions& options, const Choice& choice) {
  check_options(verb, choice);
  Run run;
  choose_line(run, choice.line);
  if (choice.vehicles == 0) return play_run<BusWorld>(std::move(run), options, choice);
  apply<BusWorld>(options, run);
  return run_depot({.vehicle = std::move(run.network),
                    .vehicles = choice.vehicles,
                    .threads = choice.threads,
                    .json = options.json,
                    .require_decided = options.require_decided});
}

}  // namespace

WorldEntry bus_world() {
  return world_entry<BusWorld>();
}

}  // namespace canvoy::tools
