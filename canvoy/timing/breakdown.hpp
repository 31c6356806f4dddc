// The remaining capacity of a bus: the load at which its first message is late.
//
//     if (const auto at = breakdown(model)) show(at->utilisation);
#pragma once

#include <optional>

#include "canvoy/timing/bus_message.hpp"

namespace canvoy::timing {

struct Breakdown {
  /// Factor of all periods at which all deadlines are just met; below 1: there is room.
  double scale = 1;
  double utilisation = 0;  ///< utilisation of the bus at that scale, 0 to 1
};

/// Model with all messages `scale` times as far apart: periods, `ahead`, `distance`, bursts and
/// places behind SYNC grow, and so do deadlines equal to the period; jitters, other deadlines,
/// errors and the bit rate stay. Not below a microsecond.
BusModel scaled(const BusModel& model, double scale);

/// Finds the load at which the first message is late, to a thousandth of the scale. Nothing if
/// there is no message, or if one is late even at scale_max. Takes some 15 times as long as
/// response_times().
std::optional<Breakdown> breakdown(const BusModel& model);

/// Limit of the scale in breakdown() if messages are late.
inline constexpr double scale_max = 1024;

}  // namespace canvoy::timing
