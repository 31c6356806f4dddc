// canvoy run bus: plays a day of a bus on its line.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "canvoy/sim/bus/bus_depot.hpp"
#include "canvoy/tools/failure.hpp"
#include "canvoy/tools/help/verb_help.hpp"
#include "canvoy/tools/interruption.hpp"
#include "canvoy/tools/live/play_world.hpp"
#include "canvoy/tools/run/bus_file.hpp"
#include "canvoy/tools/run/bus_realtime.hpp"
#include "canvoy/tools/run/bus_text.hpp"
#include "canvoy/tools/run/display_folder.hpp"
#include "canvoy/tools/run/run.hpp"
#include "canvoy/tools/run/run_depot.hpp"
#include "canvoy/words/text.hpp"

namespace canvoy::tools {

namespace {

/// How often who asks for GTFS-Realtime is told where the bus is.
constexpr Duration realtime_period = 15s;

/// What is told beside lines; empty: nothing.
struct BusOutlets {
  std::string realtime;  ///< a file or where to listen
  std::string displays;  ///< a folder
};

class PlayedBus : public PlayedNetwork {
 public:
  PlayedBus(const bus::BusNetworkOptions& options, const BusOutlets& outlets) : network_(options) {
    if (!outlets.displays.empty()) displays_.emplace(outlets.displays);
    if (outlets.realtime.empty()) return;
    heed_interruption();  // before anybody is told that it is there
    realtime_ = open_realtime(outlets.realtime, network_);
  }

  World& world() override { return network_.world(); }
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
  std::vector<std::string> bus_names() const override { return {"sim0", "sim1"}; }
  std::size_t event_count() const override { return network_.events().size(); }
  ToldEvent event(std::size_t number) const override {
    return told_event(network_.events()[number], network_);
  }
  std::string picture(double speed) override { return dashboard_text(network_, speed); }
  nlohmann::ordered_json snapshot() override { return snapshot_json(network_); }
  std::string summary_text() override { return tools::summary_text(network_); }
  nlohmann::ordered_json summary_json() override { return tools::summary_json(network_); }
  bool all_hold() const override { return network_.all_hold(); }

 private:
  Time next_outlet() const {
    return std::min(realtime_ ? next_realtime_ : never, displays_ ? next_look_ : never);
  }

  bus::BusNetwork network_;
  std::unique_ptr<RealtimeOutlet> realtime_;
  Time next_realtime_ = Time(realtime_period);
  std::optional<DisplayFolder> displays_;
  Time next_look_{};
};

/// `11=vehicle-gateway`, as frames are decoded.
std::vector<std::string> node_devices() {
  std::vector<std::string> devices;
  devices.reserve(bus::device_places.size());
  for (const bus::DevicePlace& place : bus::device_places) {
    devices.push_back(fmt::format("{}={}", place.id, bus::device_name_of(place.id)));
  }
  return devices;
}

/// What the command line says of it goes before what it has.
PlayOptions apply(const RunOptions& options, BusRun& run) {
  PlayOptions play_as = play_options(options, run.network.length);
  run.network.length = play_as.duration;
  if (options.seed) run.network.faults.seed = *options.seed;
  for (const std::string& fault : options.faults) add_fault(run, fault);
  return play_as;
}

int run_bus(BusRun run, const RunOptions& options, const BusOutlets& outlets = {}) {
  PlayOptions play_as = apply(options, run);
  play_as.real = run.real;
  const bool has_outlets = !outlets.realtime.empty() || !outlets.displays.empty();
  if (options.is_watched() && has_outlets) {
    throw UsageError("--gtfs-rt and --displays are of a run on the terminal");
  }
  play_as.duration = bus::end_of(run.network) - Time{};
  const auto make = [outlets](const BusRun& made) {
    return std::make_unique<PlayedBus>(made.network, outlets);
  };
  return play_world({.kind = "bus-line",
                     .grammar = bus::fault_grammar(),
                     .make = maker_of(run, make),
                     .file = file_of(run, bus_run_text),
                     .plan = {.seed = run.network.faults.seed},
                     .decoding = {.nodes = node_devices(), .profiles = {"407"}}},
                    play_as, options);
}

}  // namespace

int run_bus_file(TomlTable& table, const std::string& path, const RunOptions& options) {
  return run_bus(read_bus_run(table, std::filesystem::path(path).parent_path().string()), options);
}

namespace {

struct BusCommand {
  RunOptions run;
  LineChoice line;
  BusOutlets outlets;
  std::uint32_t vehicles = 0;  ///< 0: one, which is no depot
  unsigned threads = 0;
};

void add_line_options(Verb& bus, LineChoice& line) {
  bus.add({
      {"--gtfs", line.feed,
       "a timetable: a folder or zip archive of GTFS (default: a built-in line)"},
      {"--route", line.route,
       "which route of the feed: its route_id or short name; not needed where it has one"},
      {"--date", line.date,
       "the day of service, as 2026-11-23 (default: the first on which the route runs)"},
      {"--block", line.block, "which vehicle of the line (default 1)"},
  });
}

void add_depot_options(Verb& bus, BusCommand& options) {
  bus.add({
      {"--vehicles", options.vehicles,
       "a depot: so many vehicles, each a bus of its own with the next seed and the next "
       "block of the line; says who failed, and totals",
       between(1U, bus::depot_vehicles_max)},
      {"--threads", options.threads, "on which a depot is played (default: one for each core)",
       between(1U, depot_threads_max)},
  });
}

/// Of a depot that has options of one bus, or one bus that has those of a depot.
void check_options(const Verb& bus, const BusCommand& options) {
  if (options.vehicles == 0) {
    if (bus.count("--threads") != 0) throw UsageError("--threads is of a depot: give --vehicles");
    return;
  }
  for (const char* name :
       {"--log", "--print", "--speed", "--gtfs-rt", "--displays", "--block", "--web", "--out"}) {
    if (bus.count(name) == 0) continue;
    throw UsageError(fmt::format("{} is of one bus: leave it out, or --vehicles", name));
  }
}

int run_chosen(const BusCommand& options) {
  BusRun run = run_on_line(options.line);
  if (options.vehicles == 0) return run_bus(std::move(run), options.run, options.outlets);
  apply(options.run, run);
  return run_depot({.vehicle = std::move(run.network),
                    .vehicles = options.vehicles,
                    .threads = options.threads,
                    .json = options.run.json});
}

}  // namespace

void add_run_bus(Verb& app) {
  Verb& bus = app.add_verb("bus", "A bus on its line: CiA 407 (a day)");
  const auto options = std::make_shared<BusCommand>();
  add_run_options(bus, options->run, fault_help(bus::fault_grammar()));
  add_line_options(bus, options->line);
  bus.add({
      {"--gtfs-rt", options->outlets.realtime,
       "says where the bus is, how full and how late, as GTFS-Realtime, anew each 15 s of "
       "its time: in a file, or by HTTP at :PORT, 127.0.0.1:PORT or [::1]:PORT (0: a free "
       "one)"},
      {"--displays", options->outlets.displays,
       "a folder for pictures of all displays, one whenever a display looks different: "
       "next-stop-0001.png and so on"},
  });
  add_depot_options(bus, *options);
  bus.add_examples(
      "  canvoy run bus --for 30min\n"
      "  canvoy run bus --for 20min --log bus.log --json");
  bus.runs([&bus, options] {
    check_options(bus, *options);
    return run_chosen(*options);
  });
}

}  // namespace canvoy::tools
