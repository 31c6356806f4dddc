// Numbers of people that get in and out at a stop of a line, by direction and hour: counted values,
// in place of an even mean.
//
//     Demand demand;
//     demand.add({.stop = 3, .hour = 7, .boarding = 4.5});
//     demand.at(3, false, 7).boarding;
//
// The most specific row of a stop counts: first the one for its direction and hour, then that for
// its direction, then that for its hour, then that for all. Where there is no row, no passengers
// come.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <tuple>

namespace canvoy::bus_line {

class Demand {
 public:
  /// People that get in and out at a stop.
  struct Exchange {
    double boarding = 0;   ///< mean for each journey
    double alighting = 0;  ///< mean for each journey; boarding passengers choose their stops in
                           ///< proportion to it
  };
  /// Counts of a stop.
  struct Row {
    std::size_t stop = 0;               ///< index in BusLine::stops
    std::optional<bool> is_backward{};  ///< empty: in either direction
    std::optional<unsigned> hour{};     ///< of the day of service, may be above 23; empty: every
                                        ///< hour
    Exchange exchange{};                ///< the counts
  };

  /// False where a row for the same stop, direction and hour exists.
  bool add(const Row& row);
  /// Logarithmic in the number of rows.
  Exchange at(std::size_t stop, bool is_backward, unsigned hour) const;

 private:
  using Key = std::tuple<std::size_t, std::optional<bool>, std::optional<unsigned>>;
  std::map<Key, Exchange> rows_;
};

}  // namespace canvoy::bus_line
