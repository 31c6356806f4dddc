// The kind of an input and output module, for the catalogue.
#pragma once

#include "canvoy/devices/kit/device_kind.hpp"

namespace canvoy::cia401 {

extern const DeviceKind io_kind;  ///< 64 digital inputs and outputs, 12 analogue ones each

}  // namespace canvoy::cia401
