// What an application on a node of a car is, beside the virtual devices there: it provides no
// objects, and consumes those that it wants to know of.
//
//     struct FareDisplayKind : cia447::CarKind<FareDisplay, NoHardware, FareDisplaySettings> {
//       static constexpr const VirtualDeviceInfo& provides = car::no_virtual_device;
#pragma once

#include "canvoy/profiles/description.hpp"

namespace canvoy::car {

inline constexpr VirtualDeviceInfo no_virtual_device = {.name = "application"};

/// Of an application that needs none.
struct NoHardware {};

}  // namespace canvoy::car
