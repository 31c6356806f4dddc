// The kinds of devices of CiA 447, for the catalogue. One source makes them, with memory from the
// heap: boards link units, and none of these.
#pragma once

#include "canvoy/devices/kit/device_kind.hpp"

namespace canvoy::cia447 {

extern const DeviceKind ivn_gateway_kind;            ///< gateway to the car's own network
extern const DeviceKind audio_switch_kind;           ///< 4.2.19
extern const DeviceKind blue_light_kind;             ///< 4.2.22
extern const DeviceKind discrete_inputs_kind;        ///< 4.2.8
extern const DeviceKind driver_identification_kind;  ///< 4.2.15
extern const DeviceKind emergency_fresh_air_kind;    ///< 4.2.6
extern const DeviceKind fire_extinguishing_kind;     ///< 4.2.5
extern const DeviceKind gps_kind;                    ///< 4.2.10
extern const DeviceKind hands_free_kind;             ///< 4.2.23
extern const DeviceKind navigation_kind;             ///< 4.2.11
extern const DeviceKind power_supply_kind;           ///< 4.2.7
extern const DeviceKind printer_kind;                ///< 4.2.13
extern const DeviceKind radio_kind;                  ///< 4.2.18
extern const DeviceKind real_time_clock_kind;        ///< 4.2.14
extern const DeviceKind roof_bar_light_kind;         ///< 4.2.20
extern const DeviceKind roof_bar_sound_kind;         ///< 4.2.21
extern const DeviceKind tariff_display_kind;         ///< 4.2.16
extern const DeviceKind taxi_alarm_kind;             ///< 4.2.17
extern const DeviceKind taximeter_kind;              ///< 4.2.12
extern const DeviceKind terminal_kind;               ///< 4.2.9

}  // namespace canvoy::cia447
