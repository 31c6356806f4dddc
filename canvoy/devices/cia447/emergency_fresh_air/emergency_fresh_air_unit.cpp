#include "canvoy/devices/cia447/emergency_fresh_air/emergency_fresh_air_unit.hpp"

#include "canvoy/devices/cia447/kinds.hpp"

namespace canvoy::cia447 {

const DeviceKind emergency_fresh_air_kind = car_device_kind<EmergencyFreshAirKind>();

}  // namespace canvoy::cia447
