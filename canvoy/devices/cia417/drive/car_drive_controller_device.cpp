#include "canvoy/devices/cia417/drive/car_drive_controller_device.hpp"

#include "canvoy/devices/cia417/kit/kinds.hpp"

namespace canvoy::cia417 {

const DeviceKind car_drive_controller_kind = {.info = CarDriveControllerKind<>::info,
                                              .profile = &profile,
                                              .forms = only_form<CarDriveControllerKind<>>};

}  // namespace canvoy::cia417
