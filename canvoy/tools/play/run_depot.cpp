#include "canvoy/tools/play/run_depot.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

#include "canvoy/text/text.hpp"
#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/cli/interruption.hpp"
#include "canvoy/tools/play/bus_words.hpp"
#include "canvoy/tools/player/ordered_work.hpp"
#include "canvoy/tools/player/player.hpp"
#include "canvoy/worlds/bus_line/bus_depot.hpp"

namespace canvoy::tools {

namespace {

/// Time that a vehicle is played between two checks of signals.
constexpr Duration depot_look_period = 1min;

using MaybeReport = std::optional<bus_line::VehicleReport>;

/// One for each vehicle of a block.
using LineDays = std::vector<std::shared_ptr<const bus_line::LineDay>>;

LineDays line_days(const DepotOptions& options) {
  LineDays days;
  for (std::uint32_t number = 1; number <= options.vehicles && !is_interrupted();) {
    const bus_line::BusNetworkOptions first = bus_line::depot_vehicle(options.vehicle, number);
    Duration until{};
    for (; number <= options.vehicles && day_of(options.vehicle, number) == days.size(); ++number) {
      until = std::max(until, last_time_of(bus_line::depot_vehicle(options.vehicle, number)));
    }
    days.push_back(bus_line::line_day_of(first, until));
  }
  return days;
}

/// Nothing if it was interrupted.
MaybeReport played_vehicle(const DepotOptions& options, const LineDays& days,
                           std::uint32_t number) {
  bus_line::BusNetworkOptions vehicle = bus_line::depot_vehicle(options.vehicle, number);
  bus_line::share_people(vehicle, days[bus_line::day_of(options.vehicle, number)]);
  bus_line::BusNetwork network(std::move(vehicle));
  while (network.now() < network.end()) {
    network.run_until(std::min(network.end(), network.now() + depot_look_period));
    if (is_interrupted()) return std::nullopt;
  }
  return bus_line::report_of(network, number);
}

class DepotPrinter {
 public:
  explicit DepotPrinter(const DepotOptions& options)
      : options_(options), names_(options.vehicle), is_waited_for_(isatty(STDERR_FILENO) == 1) {}

  void take(const MaybeReport& vehicle) {
    if (!vehicle) return;
    totals_.add(*vehicle);
    clear_progress();
    if (options_.json) {
      fmt::print("{}\n", vehicle_json(*vehicle).dump());
    } else if (!vehicle->all_hold()) {
      fmt::print("{}", failed_text(*vehicle));
    }
    std::fflush(stdout);
    show_progress();
  }

  int finish() {
    clear_progress();
    fmt::print("{}", options_.json ? summary_json().dump() + "\n" : summary_text());
    return verdict_status(summary_json(), options_.require_decided);
  }

 private:
  bool all_hold() const { return totals_.vehicles == options_.vehicles && totals_.failed.empty(); }

  /// Includes the command that plays the vehicle alone.
  std::string failed_text(const bus_line::VehicleReport& vehicle) const {
    std::string text = fmt::format("vehicle {} (--seed {} --block {})\n", vehicle.number,
                                   vehicle.seed, vehicle.block);
    for (const bus_line::Invariant& invariant : vehicle.invariants) {
      if (!invariant.held) text += invariant_line(names_, judged(invariant));
    }
    return text;
  }

  Json vehicle_json(const bus_line::VehicleReport& vehicle) const {
    Json json = line_json(Time(vehicle.length), "vehicle");
    json["vehicle"] = vehicle.number;
    json["seed"] = vehicle.seed;
    json["block"] = vehicle.block;
    add_service(json, vehicle.statistics, vehicle.riders, vehicle.odometer, vehicle.bus);
    add_invariants(json, names_, std::span(vehicle.invariants));
    return json;
  }

  std::string summary_text() const {
    const std::string how_many =
        totals_.vehicles == options_.vehicles
            ? fmt::format("{}", totals_.vehicles)
            : fmt::format("interrupted: {} of {}", totals_.vehicles, options_.vehicles);
    std::string text = fmt::format(
        "{} vehicles, {} at most: {}\n", how_many, text::duration_text(totals_.longest),
        service_text(totals_.statistics, totals_.riders, totals_.odometer, totals_.bus));
    text += invariants_text(names_, std::span<const bus_line::Invariant>(totals_.invariants));
    if (totals_.failed.empty()) return text;
    return text + fmt::format("{} of {} vehicles failed: {}\n", totals_.failed.size(),
                              totals_.vehicles, fmt::join(totals_.failed, ", "));
  }

  Json summary_json() const {
    Json json = line_json(Time(totals_.longest), "summary");
    json["vehicles"] = options_.vehicles;
    json["played"] = totals_.vehicles;
    json["failed"] = totals_.failed;
    add_service(json, totals_.statistics, totals_.riders, totals_.odometer, totals_.bus);
    add_invariants(json, names_, std::span<const bus_line::Invariant>(totals_.invariants));
    json["all_held"] = all_hold();  // also requires that all were played
    return json;
  }

  static void add_service(Json& json, const bus_line::BusNetworkStatistics& statistics,
                          const bus_line::RiderStatistics& riders, double odometer,
                          const BusSnapshot& bus) {
    json["distance_m"] = odometer;
    json["statistics"] = bus_statistics_json(statistics, riders);
    json["frames"] = bus.frames;
    json["error_frames"] = bus.error_frames;
  }

  void show_progress() const {
    if (is_waited_for_) fmt::print(stderr, "\r{} of {} ", totals_.vehicles, options_.vehicles);
  }
  void clear_progress() const {
    if (is_waited_for_) fmt::print(stderr, "\r\x1b[K");
  }

  const DepotOptions& options_;
  BusNames names_;
  bool is_waited_for_;
  bus_line::DepotTotals totals_;
};

unsigned threads_of(const DepotOptions& options) {
  return options.threads != 0 ? options.threads : std::max(1U, std::thread::hardware_concurrency());
}

}  // namespace

int run_depot(const DepotOptions& options) {
  heed_interruption();
  const LineDays days = line_days(options);
  DepotPrinter printer(options);
  in_order<MaybeReport>(
      options.vehicles, threads_of(options),
      [&](std::size_t i) -> MaybeReport {
        if (is_interrupted()) return std::nullopt;
        return played_vehicle(options, days, static_cast<std::uint32_t>(i + 1));
      },
      [&](const MaybeReport& vehicle) { printer.take(vehicle); });
  return printer.finish();
}

}  // namespace canvoy::tools
