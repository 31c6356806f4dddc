#include "canvoy/devices/cia447/discrete_inputs/discrete_inputs_unit.hpp"

#include "canvoy/devices/cia447/kinds.hpp"

namespace canvoy::cia447 {

const DeviceKind discrete_inputs_kind = car_device_kind<DiscreteInputsKind>();

}  // namespace canvoy::cia447
