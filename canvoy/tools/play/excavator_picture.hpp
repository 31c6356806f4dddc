// Picture of an excavator on a terminal of 80 columns and 24 lines: the arm from the side, the seat
// with its sticks and lamps, the bus.
//
//     out << arm_picture(network.snapshot());
#pragma once

#include <string>

#include "canvoy/worlds/excavator/excavator_network.hpp"

namespace canvoy::tools {

/// The arm from the side, as lines of text: `metres` in front of the slew and around the ground.
std::string arm_picture(const excavator::ExcavatorSnapshot& now);

}  // namespace canvoy::tools
