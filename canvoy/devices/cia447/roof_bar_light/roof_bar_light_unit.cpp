#include "canvoy/devices/cia447/roof_bar_light/roof_bar_light_unit.hpp"

#include "canvoy/devices/cia447/kinds.hpp"

namespace canvoy::cia447 {

const DeviceKind roof_bar_light_kind = car_device_kind<RoofBarLightKind>();

}  // namespace canvoy::cia447
