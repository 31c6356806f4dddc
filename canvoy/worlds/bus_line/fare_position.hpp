// Fare position of a vehicle, for ticket devices: fare zone and route segment, and the ones before
// (CiA 407, 3.1.3, Table 1).
//
//     FarePosition fare;
//     fare.reach(1, 2);      // zone 1, segment 2
//     fare.reach(2, 1);      // at its border: previous zone 1, previous segment 2
#pragma once

#include <cstdint>
#include <optional>

namespace canvoy::bus_line {

struct FarePosition {
  std::uint8_t zone = 0;                            ///< 6111h
  std::uint16_t segment = 0;                        ///< 6110h
  std::optional<std::uint8_t> previous_zone{};      ///< the last other zone; empty: none yet
  std::optional<std::uint16_t> previous_segment{};  ///< the last other segment; empty: none yet
  bool is_known = false;                            ///< false: it has reached no segment yet

  /// Sets the present segment. The number of a segment is unique within its zone alone: the same
  /// number in another zone is another segment.
  void reach(std::uint8_t new_zone, std::uint16_t new_segment) {
    if (is_known && (new_zone != zone || new_segment != segment)) {
      previous_segment = segment;
      if (new_zone != zone) previous_zone = zone;
    }
    is_known = true;
    zone = new_zone;
    segment = new_segment;
  }

  friend bool operator==(const FarePosition&, const FarePosition&) = default;
};

}  // namespace canvoy::bus_line
