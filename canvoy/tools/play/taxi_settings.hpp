// Parts of the file of a taxi: its shift, its clocks, and assumptions about the network of a car,
// since parts 1 and 4 of CiA 447 are not available.
#pragma once

#include <vector>

#include "canvoy/tools/play/taxi_run.hpp"

namespace canvoy::tools {

/// `time_zone = "Europe/Berlin"`
Setting<TaxiRun> time_zone_setting();
/// Adds `[shift]` and `[car_network]`.
void add_taxi_settings(std::vector<FilePart<TaxiRun>>& parts);

}  // namespace canvoy::tools
