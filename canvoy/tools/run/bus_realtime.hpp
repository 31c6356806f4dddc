// Where a simulated bus is, how full and how late, as GTFS-Realtime: an old network feeds today's
// passenger information.
//
//     write_realtime(path, network);
#pragma once

#include <string>

#include "canvoy/formats/gtfs/realtime.hpp"
#include "canvoy/sim/bus/bus_network.hpp"

namespace canvoy::tools {

/// Of this moment. How full it is says its counting manager, as far as the on-board computer knows.
gtfs::RealtimeFeed realtime_of(bus::BusNetwork& network);

/// In place of what the file held, at once and whole. Throws Failure.
void write_realtime(const std::string& path, bus::BusNetwork& network);

}  // namespace canvoy::tools
