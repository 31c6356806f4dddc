#include "canvoy/devices/cia417/position/car_position_device.hpp"

#include "canvoy/devices/cia417/kit/kinds.hpp"

namespace canvoy::cia417 {

const DeviceKind car_position_kind = {.info = CarPositionKind<>::info,
                                      .profile = &profile,
                                      .forms = only_form<CarPositionKind<>>,
                                      .keeping_forms = form_with_storage<CarPositionKind<>>};

}  // namespace canvoy::cia417
