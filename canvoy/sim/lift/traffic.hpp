// Who comes when, from where to where: a Poisson process by a seed, or a list.
//
//     Traffic traffic(building, {.pattern = TrafficPattern::up_peak, .seed = 1});
//     while (const std::optional<Arrival> arrival = traffic.next()) ...
//
// The shares of the patterns are those that CIBSE Guide D (Transportation systems in buildings)
// takes for offices: an up-peak of people who come in only, a down-peak of those who leave, lunch
// with 45 % of each and 10 % between floors.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "canvoy/can/random.hpp"
#include "canvoy/can/time.hpp"
#include "canvoy/sim/lift/building.hpp"

namespace canvoy::lift {

/// A person who wants to go from one floor to another.
struct Arrival {
  Time at{};
  FloorNumber from = 1;
  FloorNumber to = 2;
  double mass_kg = 75;

  friend bool operator==(const Arrival&, const Arrival&) = default;
};

enum class TrafficPattern : std::uint8_t { up_peak, down_peak, interfloor, lunch };

struct TrafficOptions {
  TrafficPattern pattern = TrafficPattern::interfloor;
  /// Of the building's population, how many come within five minutes.
  double percent_in_5_minutes = 6;
  Time from{};
  Time until = never;
  double mass_kg_mean = 75;
  double mass_kg_deviation = 12;  ///< they are distributed as a triangle
  std::uint64_t seed = 1;
};

/// How the people of a pattern are divided; the sum is 1.
struct TrafficShares {
  double incoming = 0;    ///< from the main floor
  double outgoing = 0;    ///< to the main floor
  double interfloor = 0;  ///< between other floors
};
TrafficShares shares_of(TrafficPattern pattern);

/// Arrivals in the order of their times. Floors are drawn by their populations.
class Traffic {
 public:
  /// `building` has two floors or more, and people on one beside the main floor at least; else
  /// nobody comes. It must outlive this.
  Traffic(const Building& building, const TrafficOptions& options);
  /// These and no others; they need not be sorted.
  explicit Traffic(std::vector<Arrival> list);

  /// Empty when nobody comes any more.
  std::optional<Arrival> next();

 private:
  double uniform();
  FloorNumber draw_floor(FloorNumber other_than);
  double draw_mass_kg();
  Arrival draw_way();

  const Building* building_ = nullptr;
  TrafficOptions options_{};
  Random random_;
  Time at_{};
  double people_per_second_ = 0;
  std::vector<Arrival> list_{};
  std::size_t next_of_list_ = 0;
};

}  // namespace canvoy::lift
