// Hands of a GPS receiver (CiA 447-3, 4.2.10), and times as text.
#pragma once

#include <string_view>

#include "canvoy/can/time.hpp"
#include "canvoy/tools/device/car/car_hand_tables.hpp"

namespace canvoy::tools {

CarHandTable gps_hands();

/// Reads `2026-10-25T01:59:50` as seconds since 1970-01-01 on the same clock. Throws UsageError.
Duration parse_clock_text(std::string_view text);
inline void check_clock_text(const HandValue& value) {
  parse_clock_text(value.text);
}

}  // namespace canvoy::tools
