// canvoy run bus: plays a day of a bus on its line.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>

#include "canvoy/tools/failure.hpp"
#include "canvoy/tools/run/bus_file.hpp"
#include "canvoy/tools/run/bus_realtime.hpp"
#include "canvoy/tools/run/bus_text.hpp"
#include "canvoy/tools/run/run.hpp"
#include "canvoy/words/text.hpp"

namespace canvoy::tools {

namespace {

/// How often who asks for GTFS-Realtime is told where the bus is.
constexpr Duration realtime_period = 15s;

class PlayedBus : public PlayedNetwork {
 public:
  /// `realtime`: a file; empty: none.
  PlayedBus(const bus::BusNetworkOptions& options, std::string realtime)
      : network_(options), realtime_(std::move(realtime)) {
    if (!realtime_.empty()) write_realtime(realtime_, network_);
  }

  Time end() const { return network_.end(); }

  World& world() override { return network_.world(); }
  void run_until(Time until) override {
    while (!realtime_.empty() && next_realtime_ <= until) {
      network_.run_until(next_realtime_);
      write_realtime(realtime_, network_);
      next_realtime_ += realtime_period;
    }
    network_.run_until(until);
  }
  std::vector<std::string> bus_names() const override { return {"sim0"}; }
  std::string take_events(bool json) override {
    std::string text;
    const auto events = network_.events();
    for (; told_ < events.size(); ++told_) {
      const bus::NetworkEvent& event = events[told_];
      text += json ? event_json(event, network_).dump() + "\n"
                   : fmt::format("{:>20}  {}\n", words::duration_text(event.at - Time{}),
                                 event_text(event, network_));
    }
    return text;
  }
  std::string picture(double speed) override { return dashboard_text(network_, speed); }
  nlohmann::ordered_json snapshot() override { return snapshot_json(network_); }
  std::string summary_text() override { return tools::summary_text(network_); }
  nlohmann::ordered_json summary_json() override { return tools::summary_json(network_); }
  bool all_hold() const override { return network_.all_hold(); }

 private:
  bus::BusNetwork network_;
  std::size_t told_ = 0;
  std::string realtime_;
  Time next_realtime_ = Time(realtime_period);
};

int run_bus(BusRun run, const RunOptions& options, const std::string& realtime = {}) {
  PlayOptions play_as = play_options(options, run.network.length);
  run.network.length = play_as.duration;
  if (options.seed) run.network.faults.seed = *options.seed;
  for (const std::string& fault : options.faults) add_fault(run, fault);
  if (options.print) {
    fmt::print("{}", bus_run_text(run));
    return exit_done;
  }
  play_as.real = run.real;
  PlayedBus network(run.network, realtime);
  play_as.duration = network.end() - Time{};
  return play(network, play_as);
}

}  // namespace

int run_bus_file(TomlTable& table, const std::string& path, const RunOptions& options) {
  return run_bus(read_bus_run(table, std::filesystem::path(path).parent_path().string()), options);
}

void add_run_bus(CLI::App& app, std::function<int()>& action) {
  CLI::App* bus = app.add_subcommand("bus", "A bus on its line: CiA 407 (a day)");
  struct BusCommand {
    RunOptions run;
    LineChoice line;
    std::string realtime;
  };
  const auto options = std::make_shared<BusCommand>();
  add_run_options(*bus, options->run, fault_help(bus::fault_grammar()));
  bus->add_option("--gtfs", options->line.feed,
                  "a timetable: a folder or zip archive of GTFS (default: a built-in line)");
  bus->add_option(
      "--route", options->line.route,
      "which route of the feed: its route_id or short name; not needed where it has one");
  bus->add_option("--date", options->line.date,
                  "the day of service, as 2026-11-23 (default: the first on which the route runs)");
  bus->add_option("--block", options->line.block, "which vehicle of the line (default 1)");
  bus->add_option("--gtfs-rt", options->realtime,
                  "a file that says where the bus is, how full and how late, as GTFS-Realtime; "
                  "written anew each 15 s of its time");
  bus->callback([options, &action] {
    action = [options] {
      return run_bus(run_on_line(options->line), options->run, options->realtime);
    };
  });
}

}  // namespace canvoy::tools
