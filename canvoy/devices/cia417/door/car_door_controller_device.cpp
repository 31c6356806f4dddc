#include "canvoy/devices/cia417/door/car_door_controller_device.hpp"

#include "canvoy/devices/cia417/kit/kinds.hpp"

namespace canvoy::cia417 {

const DeviceKind car_door_controller_kind = {.info = CarDoorControllerKind<>::info,
                                             .profile = &profile,
                                             .forms = only_form<CarDoorControllerKind<>>};

}  // namespace canvoy::cia417
