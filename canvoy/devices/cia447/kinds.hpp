// The kinds of devices of CiA 447, for the catalogue. One source makes them, with memory from the
// heap: boards link units, and none of these.
#pragma once

#include <cstddef>
#include <span>

#include "canvoy/devices/kit/device_kind.hpp"

namespace canvoy::cia447 {

/// Number of kinds.
inline constexpr std::size_t kind_count = 20;
/// In the order of their clauses.
std::span<const DeviceKind> kinds();

}  // namespace canvoy::cia447
