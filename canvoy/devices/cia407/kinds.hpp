// The kinds of devices of CiA 407, for the catalogue. One source makes them, with memory from the
// heap: boards link units, and none of these.
#pragma once

#include <cstddef>
#include <span>

#include "canvoy/devices/kit/device_kind.hpp"

namespace canvoy::cia407 {

inline constexpr std::size_t kind_count = 36;  ///< of virtual devices
/// In the order of the codes of their virtual devices.
std::span<const DeviceKind> kinds();

}  // namespace canvoy::cia407
