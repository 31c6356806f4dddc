// Files of what was counted on the line of a bus: comma-separated values with the columns `stop`
// (its id, or its name if unique) and, if known, `direction` (0 or 1, as direction_id of GTFS) and
// `hour` (of the day of service, 0 to 47). One of passengers has `boarding` (mean number of a
// journey) and, if known, `alighting`; one of delays has `delay` (s by which the bus arrives late;
// negative: early).
//
//     stop,direction,hour,boarding,alighting        stop,direction,hour,delay
//     MARKET,0,7,4.5,0.5                            MARKET,0,7,140
#pragma once

#include <string>

#include "canvoy/worlds/bus_line/bus_line.hpp"
#include "canvoy/worlds/bus_line/demand.hpp"

namespace canvoy::tools {

/// Throws Failure with file, line and column for an invalid file.
bus_line::Demand read_demand(const std::string& path, const bus_line::BusLine& line);
/// Likewise.
bus_line::Delays read_delays(const std::string& path, const bus_line::BusLine& line);

}  // namespace canvoy::tools
