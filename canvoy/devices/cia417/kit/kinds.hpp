// The kinds of devices of a lift, for the catalogue: a row each, in ../kinds.cpp or in the source
// of a device that is put together of several units.
#pragma once

#include "canvoy/devices/kit/device_kind.hpp"

namespace canvoy::cia417 {

extern const DeviceKind lift_controller_kind;   ///< NMT master: calls, doors and drive
extern const DeviceKind call_controller_kind;   ///< calls of panels only
extern const DeviceKind group_controller_kind;  ///< of up to 8 lifts
/// Half of a lift controller: not in the catalogue.
extern const DeviceKind group_member_kind;
extern const DeviceKind car_door_controller_kind;   ///< commands doors only
extern const DeviceKind car_drive_controller_kind;  ///< commands the drive only
extern const DeviceKind car_drive_kind;             ///< drive of CiA 402
extern const DeviceKind car_position_kind;          ///< encoder
extern const DeviceKind position_cam_kind;          ///< cams from a received position
extern const DeviceKind car_door_kind;              ///< one door, or several
extern const DeviceKind light_barrier_kind;         ///< state of the light barriers of doors
extern const DeviceKind load_kind;                  ///< weighs the car
extern const DeviceKind sensor_kind;                ///< smoke, glass and other sensors
extern const DeviceKind input_panel_kind;           ///< buttons and keys
extern const DeviceKind output_panel_kind;          ///< lamps and displays
extern const DeviceKind landing_panel_kind;         ///< both, of landings
extern const DeviceKind car_panel_kind;             ///< both, in a car

}  // namespace canvoy::cia417
