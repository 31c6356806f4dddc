// A file of counted passengers for the line of a bus: comma-separated values with the columns
// `stop` (its id, or its name if unique), `boarding` (mean number of boarding passengers of a
// journey) and, if known, `alighting`, `direction` (0 or 1, as direction_id of GTFS) and `hour` (of
// the day of service, 0 to 47).
//
//     stop,direction,hour,boarding,alighting
//     MARKET,0,7,4.5,0.5
#pragma once

#include <string>

#include "canvoy/worlds/bus_line/bus_line.hpp"
#include "canvoy/worlds/bus_line/demand.hpp"

namespace canvoy::tools {

/// Throws Failure with file, line and column for an invalid file.
bus_line::Demand read_demand(const std::string& path, const bus_line::BusLine& line);

}  // namespace canvoy::tools
