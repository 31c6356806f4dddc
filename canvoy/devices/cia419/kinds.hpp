// The kind of a charger, for the catalogue.
#pragma once

#include "canvoy/devices/kit/device_kind.hpp"

namespace canvoy::cia419 {

extern const DeviceKind charger_kind;  ///< charger of one battery

}  // namespace canvoy::cia419
