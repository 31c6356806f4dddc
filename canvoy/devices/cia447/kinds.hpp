// The kinds of devices of CiA 447, each made in the source of its unit, for the catalogue.
#pragma once

#include "canvoy/devices/device_kind.hpp"

namespace canvoy::cia447 {

extern const DeviceKind blue_light_kind;
extern const DeviceKind gps_kind;
extern const DeviceKind navigation_kind;
extern const DeviceKind printer_kind;
extern const DeviceKind terminal_kind;

}  // namespace canvoy::cia447
