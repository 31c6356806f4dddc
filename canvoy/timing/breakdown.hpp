// How much more a bus could carry: the load at which its first message is late.
//
//     if (const auto at = breakdown(model)) show(at->utilisation);
#pragma once

#include <optional>

#include "canvoy/timing/bus_message.hpp"

namespace canvoy::timing {

struct Breakdown {
  double scale = 1;  ///< of all periods, when all deadlines are just met; below 1: there is room
  double utilisation = 0;  ///< of the bus then, 0 to 1
};

/// All messages come `scale` times as far apart: periods, `ahead`, `distance`, bursts and places
/// behind SYNC grow, and so do deadlines that are the period; jitters, other deadlines, errors and
/// the bit rate stay. Not below a microsecond.
BusModel scaled(const BusModel& model, double scale);

/// To a thousandth of the scale. Nothing where there is no message, or where one is late even with
/// scale_max. Takes some 15 times as long as response_times().
std::optional<Breakdown> breakdown(const BusModel& model);

/// As far as breakdown() goes where messages are late.
inline constexpr double scale_max = 1024;

}  // namespace canvoy::timing
