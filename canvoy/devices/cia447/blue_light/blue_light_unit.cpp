#include "canvoy/devices/cia447/blue_light/blue_light_unit.hpp"

#include "canvoy/devices/cia447/kinds.hpp"

namespace canvoy::cia447 {

const DeviceKind blue_light_kind = car_device_kind<BlueLightKind>();

}  // namespace canvoy::cia447
