// Devices of one door, in the catalogue: four dictionaries.
//
//     .forms = forms_of_doors<LightBarrierKind>
#pragma once

#include "canvoy/devices/kit/device_kind.hpp"
#include "canvoy/profiles/cia417/lift_device.hpp"

namespace canvoy::cia417 {

/// Options of a device for one door, 1 to 4.
constexpr LiftDeviceOptions only_door(unsigned door) {
  return {.doors = 1U << (door - 1)};
}

/// The four forms of a kind, for doors 1 to 4.
template <template <LiftDeviceOptions> class Kind>
inline constexpr DeviceForm forms_of_doors[4] = {
    only_form<Kind<only_door(1)>>[0], only_form<Kind<only_door(2)>>[0],
    only_form<Kind<only_door(3)>>[0], only_form<Kind<only_door(4)>>[0]};

}  // namespace canvoy::cia417
