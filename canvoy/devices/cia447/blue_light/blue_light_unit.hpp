// The "blue" light flasher module: eight flashers that are switched on and off (6140h, 6141h; CiA
// 447-3, 4.2.22).
//
//     BlueLightUnit flashers(network, {}, {});
//     flashers.switching().sense(blue_light_flasher_status_front_left, Sensing::failure);
#pragma once

#include "canvoy/devices/cia447/kit/car_kind.hpp"
#include "canvoy/devices/cia447/kit/switching.hpp"
#include "canvoy/profiles/cia447/devices.hpp"

namespace canvoy::cia447 {

inline constexpr const ObjectInfo* blue_light_commands[] = {&blue_light_flasher_command_object};
/// The status of a flasher is on when its power stage has reported that.
inline constexpr Mirror blue_light_mirrors[] = {
    {&blue_light_flasher_command_object, &blue_light_flasher_status_object, 50ms}};
inline constexpr SwitchedTable blue_light_table = {.commands = blue_light_commands,
                                                   .mirrors = blue_light_mirrors};

/// The unit is its table.
using BlueLightUnit = SwitchedUnit<blue_light_table>;

/// Catalogue row of the blue light flasher module (4.2.22); car_unit makes it a part of a device.
struct BlueLightKind : CarKind<BlueLightUnit, SwitchedHardware, SwitchedSettings> {
  static constexpr DeviceInfo info = {.name = "blue-light",
                                      .title = "blue light flasher module",
                                      .product = "Canvoy CiA 447 blue light",
                                      .product_code = 44719,
                                      .node_id = 15,
                                      .hardware = "eight flashers: on or off"};
  static constexpr const VirtualDeviceInfo& provides = blue_light_flasher_module_device;
};

}  // namespace canvoy::cia447
