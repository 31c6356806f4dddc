// A building with lifts as a drawing on a terminal, a row a floor:
//
//      8     ^2 v1  ^v |      :  |  [ 4]  |
//      7              |  ]12[^  |        |
//
// A car is `[ 4]` with closed doors, `] 4[` with open ones, `) 4(` while they move; behind it ^ or
// v for where it goes on. A dot is a floor that somebody in the car wants to.
//
//     out << lift_picture(network.description(), network.snapshot(), speed, rows, columns);
#pragma once

#include <string>

#include "canvoy/sim/lift/lift_network_description.hpp"
#include "canvoy/sim/lift/lift_snapshot.hpp"

namespace canvoy::tools {

/// What a terminal shows: the shafts with cars, doors, calls and people. Where the building has
/// more floors than `rows_max`, a row is several of them.
std::string lift_picture(const lift::LiftNetworkDescription& network,
                         const lift::LiftNetworkSnapshot& snapshot, double speed, unsigned rows_max,
                         unsigned columns_max = 200);
}  // namespace canvoy::tools
