#include "canvoy/devices/cia417/drive/car_drive_device.hpp"

#include "canvoy/devices/cia417/kit/kinds.hpp"

namespace canvoy::cia417 {

const DeviceKind car_drive_kind = {.info = CarDriveKind<>::info,
                                   .profile = &profile,
                                   .forms = only_form<CarDriveKind<>>,
                                   .keeping_forms = form_with_storage<CarDriveKind<>>};

}  // namespace canvoy::cia417
