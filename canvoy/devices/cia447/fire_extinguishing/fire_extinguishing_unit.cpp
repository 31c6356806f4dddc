#include "canvoy/devices/cia447/fire_extinguishing/fire_extinguishing_unit.hpp"

#include "canvoy/devices/cia447/kinds.hpp"

namespace canvoy::cia447 {

const DeviceKind fire_extinguishing_kind = car_device_kind<FireExtinguishingKind>();

}  // namespace canvoy::cia447
