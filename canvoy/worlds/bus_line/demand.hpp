// Values at the stops of a line, by direction and hour, as they were counted: numbers of people
// that get in and out, in place of an even mean, and delays.
//
//     Demand demand;
//     demand.add({.stop = 3, .hour = 7, .value = {.boarding = 4.5}});
//     demand.at(3, false, 7).boarding;
//
// The most specific row of a stop counts: first the one for its direction and hour, then that for
// its direction, then that for its hour, then that for all. Where there is no row, no passengers
// come, and there is no delay.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <tuple>

#include "canvoy/can/time.hpp"

namespace canvoy::bus_line {

/// Hour of the day of service: above 23 after its midnight.
inline unsigned hour_of(Duration of_day) {
  return static_cast<unsigned>(std::chrono::floor<std::chrono::hours>(of_day).count());
}

/// Values of stops by direction and hour.
template <class Value>
class StopTable {
 public:
  /// Value of a stop.
  struct Row {
    std::size_t stop = 0;               ///< index in BusLine::stops
    std::optional<bool> is_backward{};  ///< empty: in either direction
    std::optional<unsigned> hour{};     ///< of the day of service, may be above 23; empty: every
                                        ///< hour
    Value value{};                      ///< as counted
  };

  /// False where a row for the same stop, direction and hour exists.
  bool add(const Row& row) { return rows_.try_emplace(key_of(row), row.value).second; }
  /// Logarithmic in the number of rows.
  Value at(std::size_t stop, bool is_backward, unsigned hour) const {
    const int direction = is_backward ? 1 : 0;
    for (const Key& key : {Key(stop, direction, hour), Key(stop, direction, any),
                           Key(stop, any, hour), Key(stop, any, any)}) {
      if (const auto found = rows_.find(key); found != rows_.end()) return found->second;
    }
    return {};
  }

 private:
  using Key = std::tuple<std::size_t, int, std::int64_t>;
  static constexpr int any = -1;  // direction or hour

  static Key key_of(const Row& row) {
    return {row.stop, row.is_backward ? (*row.is_backward ? 1 : 0) : any,
            row.hour ? std::int64_t{*row.hour} : any};
  }

  std::map<Key, Value> rows_;
};

/// People that get in and out at a stop.
struct Exchange {
  double boarding = 0;   ///< mean for each journey
  double alighting = 0;  ///< mean for each journey; boarding passengers choose their stops in
                         ///< proportion to it
};
/// Numbers of people, as counted.
using Demand = StopTable<Exchange>;

/// Usual delays of arrivals at a stop; negative: early.
using Delays = StopTable<Duration>;

}  // namespace canvoy::bus_line
