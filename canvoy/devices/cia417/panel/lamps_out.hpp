// The first records of a call controller after its start: all lamps of its lift are switched off.
// Panels still show an older state, which is not known (CiA 417-4, 4.4.1).
//
//     LampsOut lamps_out;
//     while (lamps_out.waits()) send(lamps_out.next(lift_bit(1)));
#pragma once

#include <cstdint>

#include "canvoy/devices/cia417/virtual_io/virtual_io.hpp"

namespace canvoy::cia417 {

/// A record for each kind of lamp: calls in car and landings, keys, special indications, and
/// lanterns. Position and direction are always sent, and need none.
class LampsOut {
 public:
  void begin() { position_ = 0; }
  /// True if a record has to be sent.
  bool waits() const { return position_ < count; }
  /// Returns the next record, and marks it as sent. Call it only while one is waiting.
  VirtualOutput next(std::uint8_t lifts);

 private:
  static constexpr unsigned call_functions = 12;     ///< 02h to 0Dh
  static constexpr unsigned special_functions = 22;  ///< 01h to 16h, in the car and at landings
  static constexpr unsigned count = call_functions + 2 * special_functions + 3;

  std::uint8_t position_ = count;
};

}  // namespace canvoy::cia417
