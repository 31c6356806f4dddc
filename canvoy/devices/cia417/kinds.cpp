// Rows of the kinds of one unit; what is put together of several has its row in its own source.
#include "canvoy/devices/cia417/kit/kinds.hpp"

#include "canvoy/devices/cia417/door/car_door_controller_device.hpp"
#include "canvoy/devices/cia417/door/car_door_device.hpp"
#include "canvoy/devices/cia417/drive/car_drive_controller_device.hpp"
#include "canvoy/devices/cia417/drive/car_drive_device.hpp"
#include "canvoy/devices/cia417/kit/lift_forms.hpp"
#include "canvoy/devices/cia417/load/load_measuring_device.hpp"
#include "canvoy/devices/cia417/position/car_position_device.hpp"
#include "canvoy/devices/cia417/sensor/light_barrier_device.hpp"
#include "canvoy/devices/cia417/sensor/sensor_unit_device.hpp"

namespace canvoy::cia417 {

const DeviceKind car_door_controller_kind = {.info = CarDoorControllerKind<>::info,
                                             .profile = &profile,
                                             .forms = only_form<CarDoorControllerKind<>>};

const DeviceKind car_drive_controller_kind = {.info = CarDriveControllerKind<>::info,
                                              .profile = &profile,
                                              .forms = only_form<CarDriveControllerKind<>>};

const DeviceKind car_drive_kind = {.info = CarDriveKind<>::info,
                                   .profile = &profile,
                                   .forms = only_form<CarDriveKind<>>,
                                   .keeping_forms = form_with_storage<CarDriveKind<>>};

const DeviceKind car_position_kind = {.info = CarPositionKind<>::info,
                                      .profile = &profile,
                                      .forms = only_form<CarPositionKind<>>,
                                      .keeping_forms = form_with_storage<CarPositionKind<>>};

/// A fourth door has no recommended node-ID.
static constexpr NodeId ids_of_doors[] = {6, 7, 8, 12};

const DeviceKind car_door_kind = {.info = CarDoorKind<>::info,
                                  .profile = &profile,
                                  .forms = forms_of_doors<CarDoorKind>,
                                  .node_ids_of_doors = ids_of_doors};

const DeviceKind light_barrier_kind = {.info = LightBarrierKind<>::info,
                                       .profile = &profile,
                                       .forms = forms_of_doors<LightBarrierKind>};

const DeviceKind load_kind = {
    .info = LoadKind<>::info, .profile = &profile, .forms = only_form<LoadKind<>>};

const DeviceKind sensor_kind = {
    .info = SensorKind<8>::info, .profile = &profile, .forms = only_form<SensorKind<8>>};

}  // namespace canvoy::cia417
