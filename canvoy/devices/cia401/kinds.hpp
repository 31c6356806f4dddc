// The kind of an input and output module, for the catalogue.
#pragma once

#include "canvoy/devices/kit/device_kind.hpp"

namespace canvoy::cia401 {

extern const DeviceKind io_kind;

}  // namespace canvoy::cia401
