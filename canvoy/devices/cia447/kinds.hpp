// The kinds of devices of CiA 447, each made in the source of its unit, for the catalogue.
#pragma once

#include "canvoy/devices/device_kind.hpp"

namespace canvoy::cia447 {

extern const DeviceKind ivn_gateway_kind;
extern const DeviceKind blue_light_kind;
extern const DeviceKind gps_kind;
extern const DeviceKind navigation_kind;
extern const DeviceKind printer_kind;
extern const DeviceKind terminal_kind;
extern const DeviceKind driver_identification_kind;
extern const DeviceKind real_time_clock_kind;
extern const DeviceKind tariff_display_kind;
extern const DeviceKind taxi_alarm_kind;
extern const DeviceKind taximeter_kind;

}  // namespace canvoy::cia447
