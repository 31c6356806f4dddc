// What the gateway of a car reports of its network, as an event of a world.
#pragma once

#include "canvoy/devices/cia447/kit/car_master.hpp"

namespace canvoy::car {

/// The gateway has found, started or lost a device, or the network sleeps.
struct NetworkChanged {
  cia447::CarEvent event;  ///< as the gateway reports it
};

}  // namespace canvoy::car
