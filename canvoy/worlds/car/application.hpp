// An application on a node of a car, beside the virtual devices there: it provides no objects, and
// consumes those that it needs.
//
//     struct FareDisplayKind
//         : cia447::CarKind<taxi::FareDisplay, NoHardware, taxi::FareDisplaySettings> {
//       static constexpr DeviceInfo info = {.name = "fare-display", .title = "display of a fare"};
//       static constexpr const VirtualDeviceInfo& provides = car::no_virtual_device;
//     };
#pragma once

#include "canvoy/profiles/model/description.hpp"

namespace canvoy::car {

/// What an application beside virtual devices provides: nothing.
inline constexpr VirtualDeviceInfo no_virtual_device = {.name = "application"};

/// Hardware of an application that needs none.
struct NoHardware {};

}  // namespace canvoy::car
