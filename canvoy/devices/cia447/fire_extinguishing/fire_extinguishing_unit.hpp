// The fire extinguishing system: reports its state, and takes no commands (6069h; CiA 447-3,
// 4.2.5).
//
//     FireExtinguishingUnit fire(network, {}, {});
//     fire.switching().report(fire_extinguishing_system_status,
//                             FireExtinguishing::automatic_started);
#pragma once

#include "canvoy/devices/cia447/kit/car_kind.hpp"
#include "canvoy/devices/cia447/kit/switching.hpp"
#include "canvoy/profiles/cia447/devices.hpp"
#include "canvoy/profiles/cia447/terminal_handles.hpp"

namespace canvoy::cia447 {

/// It starts with a self-test.
inline constexpr Rest fire_extinguishing_rests[] = {rest(fire_extinguishing_system_status,
                                                         FireExtinguishing::initialization,
                                                         FireExtinguishing::standby, 3s)};
inline constexpr SwitchedTable fire_extinguishing_table = {.rests = fire_extinguishing_rests};

/// The unit is its table.
using FireExtinguishingUnit = SwitchedUnit<fire_extinguishing_table>;

/// Catalogue row of the fire extinguishing system (4.2.5); car_unit makes it a part of a device.
struct FireExtinguishingKind : CarKind<FireExtinguishingUnit, SwitchedHardware, SwitchedSettings> {
  static constexpr DeviceInfo info = {.name = "fire-extinguishing",
                                      .title = "fire extinguishing system",
                                      .product = "Canvoy CiA 447 fire extinguisher",
                                      .product_code = 44702,
                                      .node_id = 8,
                                      .hardware = "extinguishers: what they do"};
  static constexpr const VirtualDeviceInfo& provides = fire_extinguishing_system_device;
};

}  // namespace canvoy::cia447
