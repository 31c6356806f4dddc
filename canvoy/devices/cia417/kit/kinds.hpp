// The kinds of devices of a lift, for the catalogue. The source of each device makes its kind.
#pragma once

#include "canvoy/devices/kit/device_kind.hpp"

namespace canvoy::cia417 {

extern const DeviceKind lift_controller_kind;
extern const DeviceKind call_controller_kind;
extern const DeviceKind group_controller_kind;
/// Half of a lift controller: not in the catalogue.
extern const DeviceKind group_member_kind;
extern const DeviceKind car_door_controller_kind;
extern const DeviceKind car_drive_controller_kind;
extern const DeviceKind car_drive_kind;
extern const DeviceKind car_position_kind;
extern const DeviceKind position_cam_kind;
extern const DeviceKind car_door_kind;
extern const DeviceKind light_barrier_kind;
extern const DeviceKind load_kind;
extern const DeviceKind sensor_kind;
extern const DeviceKind input_panel_kind;
extern const DeviceKind output_panel_kind;
extern const DeviceKind landing_panel_kind;
extern const DeviceKind car_panel_kind;

}  // namespace canvoy::cia417
