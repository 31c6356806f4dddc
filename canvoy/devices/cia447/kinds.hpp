// The kinds of devices of CiA 447, for the catalogue. One source makes them, with memory from the
// heap: boards link units, and none of these.
#pragma once

#include "canvoy/devices/kit/device_kind.hpp"

namespace canvoy::cia447 {

extern const DeviceKind ivn_gateway_kind;
extern const DeviceKind audio_switch_kind;
extern const DeviceKind blue_light_kind;
extern const DeviceKind discrete_inputs_kind;
extern const DeviceKind driver_identification_kind;
extern const DeviceKind emergency_fresh_air_kind;
extern const DeviceKind fire_extinguishing_kind;
extern const DeviceKind gps_kind;
extern const DeviceKind hands_free_kind;
extern const DeviceKind navigation_kind;
extern const DeviceKind power_supply_kind;
extern const DeviceKind printer_kind;
extern const DeviceKind radio_kind;
extern const DeviceKind real_time_clock_kind;
extern const DeviceKind roof_bar_light_kind;
extern const DeviceKind roof_bar_sound_kind;
extern const DeviceKind tariff_display_kind;
extern const DeviceKind taxi_alarm_kind;
extern const DeviceKind taximeter_kind;
extern const DeviceKind terminal_kind;

}  // namespace canvoy::cia447
