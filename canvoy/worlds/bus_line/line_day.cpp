#include "canvoy/worlds/bus_line/line_day.hpp"

#include <algorithm>
#include <functional>
#include <memory>
#include <queue>
#include <utility>

namespace canvoy::bus_line {

LineDay::LineDay(const BusLine& line, std::vector<BusOptions> vehicles, Duration until)
    : runs_(runs_of(line)) {
  play(line, std::move(vehicles), until);
  for (const auto& [key, run] : runs_) {
    for (std::size_t stop = 0; stop + 1 < run.left.size(); ++stop) {
      const std::optional<VehicleAhead> ahead = ahead_of(run, stop);
      if (!ahead || !ahead->left || !run.left[stop]) continue;
      headways_.add(ahead->headway, *run.left[stop] - *ahead->left);
    }
  }
}

LineDay::Runs LineDay::runs_of(const BusLine& line) {
  Runs runs;
  std::map<std::size_t, std::vector<Run*>> of_routes;
  for (std::size_t block = 0; block < line.blocks.size(); ++block) {
    for (const Journey& journey : line.blocks[block].journeys) {
      Run& run = runs[{block, journey.number}];
      for (const Passing& passing : journey.passings) run.planned.push_back(passing.departure);
      run.left.resize(journey.passings.size());
      of_routes[journey.route].push_back(&run);
    }
  }
  for (auto& [route, all] : of_routes) {
    std::ranges::stable_sort(all, {}, [](const Run* run) { return run->planned.front(); });
    for (std::size_t i = 1; i < all.size(); ++i) all[i]->ahead = all[i - 1];
  }
  return runs;
}

std::optional<VehicleAhead> LineDay::ahead_of(const Run& run, std::size_t stop) {
  if (run.ahead == nullptr) return std::nullopt;
  const Duration headway = run.planned[stop] - run.ahead->planned[stop];
  if (headway <= Duration{} || headway > random_headway_max) return std::nullopt;
  return VehicleAhead{.left = run.ahead->left[stop], .headway = headway};
}

bool LineDay::is_frequent(const BusLine& line) {
  return std::ranges::any_of(runs_of(line),
                             [](const auto& each) { return ahead_of(each.second, 0).has_value(); });
}

std::optional<VehicleAhead> LineDay::ahead(std::size_t block, std::uint32_t journey,
                                           std::size_t stop) const {
  const auto run = runs_.find({block, journey});
  if (run == runs_.end() || stop >= run->second.left.size()) return std::nullopt;
  return ahead_of(run->second, stop);
}

/// Moves the vehicle that has something to do first, again and again; of several, the one of the
/// first block.
void LineDay::play(const BusLine& line, std::vector<BusOptions> vehicles, Duration until) {
  std::vector<std::unique_ptr<BusVehicle>> all;
  for (std::size_t block = 0; block < vehicles.size(); ++block) {
    vehicles[block].riders.ahead = [this, block](std::uint32_t journey, std::size_t stop) {
      return ahead(block, journey, stop);
    };
    all.push_back(std::make_unique<BusVehicle>(line, block, vehicles[block]));
    BusVehicle& bus = *all.back();
    bus.on_event([this, block, &bus](Time now, BusEvent event, std::size_t stop) {
      if (event != BusEvent::leaves && event != BusEvent::passes) return;
      const BusTruth truth = bus.truth();
      Run& run = runs_.at({block, truth.journey->number});
      run.left[stop] = bus.time_of_day(now);
      run.aboard_max = std::max(run.aboard_max, truth.aboard);
    });
  }
  using Next = std::pair<Duration, std::size_t>;  // the time of a vehicle, and its block
  std::priority_queue<Next, std::vector<Next>, std::greater<>> queue;
  const auto wait = [&](std::size_t block) {
    const Time deadline = all[block]->deadline();
    if (deadline != never) queue.emplace(all[block]->time_of_day(deadline), block);
  };
  for (std::size_t block = 0; block < all.size(); ++block) wait(block);
  while (!queue.empty() && queue.top().first <= until) {
    const std::size_t block = queue.top().second;
    queue.pop();
    all[block]->advance(all[block]->deadline());
    wait(block);
  }
}

double LineDay::greatest_load(bool is_late) const {
  double sum = 0;
  double count = 0;
  for (const auto& [key, run] : runs_) {
    const std::optional<VehicleAhead> ahead = ahead_of(run, 0);
    if (!ahead || !ahead->left || !run.left[0]) continue;
    if ((*run.left[0] - *ahead->left > ahead->headway) != is_late) continue;
    sum += run.aboard_max;
    ++count;
  }
  return count > 0 ? sum / count : 0;
}

}  // namespace canvoy::bus_line
