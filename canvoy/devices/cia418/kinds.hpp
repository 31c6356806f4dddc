// The kind of a battery, for the catalogue.
#pragma once

#include "canvoy/devices/kit/device_kind.hpp"

namespace canvoy::cia418 {

extern const DeviceKind battery_kind;  ///< battery module of 400 Ah

}  // namespace canvoy::cia418
