// Arrivals of people, with their origins and destinations: a Poisson process by a seed, or a list.
//
//     Traffic traffic(building, {.pattern = TrafficPattern::up_peak, .seed = 1});
//     while (const std::optional<Arrival> arrival = traffic.next()) ...
//
// The shares of the patterns are those of CIBSE Guide D (Transportation systems in buildings) for
// offices: an up-peak of people who only come in, a down-peak of people who leave, lunch with 45 %
// of each and 10 % between floors.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "canvoy/can/random.hpp"
#include "canvoy/can/time.hpp"
#include "canvoy/worlds/lift/building.hpp"

namespace canvoy::lift {

/// A person who wants to go from one floor to another.
struct Arrival {
  Time at{};             ///< when the person comes to the landing
  FloorNumber from = 1;  ///< floor of the landing
  FloorNumber to = 2;    ///< destination
  double mass_kg = 75;   ///< EN 81-20 counts 75 kg for a person

  friend bool operator==(const Arrival&, const Arrival&) = default;
};

/// Where people come from, and go to; shares_of() says how many.
enum class TrafficPattern : std::uint8_t { up_peak, down_peak, interfloor, lunch };

/// Options of drawn arrivals; the same options give the same people.
struct TrafficOptions {
  TrafficPattern pattern = TrafficPattern::interfloor;  ///< origins and destinations
  /// Share of the building's population that comes within five minutes.
  double percent_in_5_minutes = 6;
  Time from{};                    ///< first time at which people come
  Time until = never;             ///< end of the arrivals
  double mass_kg_mean = 75;       ///< of a person
  double mass_kg_deviation = 12;  ///< of a triangular distribution
  std::uint64_t seed = 1;         ///< of times, floors and masses
};

/// Division of the people of a pattern; the sum is 1.
struct TrafficShares {
  double incoming = 0;    ///< from the main floor
  double outgoing = 0;    ///< to the main floor
  double interfloor = 0;  ///< between other floors
};
/// 0 to 1 each, for a pattern.
TrafficShares shares_of(TrafficPattern pattern);

/// Arrivals in the order of their times. Floors are drawn by their populations.
class Traffic {
 public:
  /// `building` needs at least two floors, with a population at one of them beside the main floor;
  /// otherwise no people come. It must outlive this object.
  Traffic(const Building& building, const TrafficOptions& options);
  /// These arrivals and no others; they need not be sorted.
  explicit Traffic(std::vector<Arrival> list);

  /// Empty when no further people come.
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
