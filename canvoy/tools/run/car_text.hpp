// What happens in the network of a car, in words and as JSON: the same in a taxi and in a police
// car.
#pragma once

#include "canvoy/sim/car/network_changed.hpp"
#include "canvoy/tools/run/world_text.hpp"

namespace canvoy::tools {

Told told(const WorldNames& names, const car::NetworkChanged& event);

}  // namespace canvoy::tools
