// Draws a building with lifts on a terminal, one row per floor:
//
//   8     ^2 v1  ^v |      :  |  [ 4]  |
//   7              |  ]12[^  |        |
//
// A car is `[ 4]` with closed doors, `] 4[` with open ones, `) 4(` while they move, followed by ^
// or v for its direction. A dot marks a floor that a passenger has requested.
//
//     out << lift_picture(network.description(), network.snapshot(), speed, 24, 80);
#pragma once

#include <string>

#include "canvoy/worlds/lift/lift_network_description.hpp"
#include "canvoy/worlds/lift/lift_snapshot.hpp"

namespace canvoy::tools {

/// Picture for a terminal: the shafts with cars, doors, calls and people. If the building has more
/// floors than `rows_max`, a row stands for several floors.
std::string lift_picture(const lift::LiftNetworkDescription& network,
                         const lift::LiftNetworkSnapshot& snapshot, double speed, unsigned rows_max,
                         unsigned columns_max = 200);
}  // namespace canvoy::tools
