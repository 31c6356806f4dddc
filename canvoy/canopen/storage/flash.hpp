// What storage needs of a flash memory (or of anything that keeps bytes without power): sectors
// that are erased whole, and units that are programmed once until then.
//
// The maker of a device writes these few functions for the chip, canvoy/canopen/host has them for a
// file. None of them has to wait: an operation that takes time is begun, and asked for later.
//
//     const Flash flash{.sector_size = 2048, .unit = 8, .erase = {...}, .program = {...}, ...};
#pragma once

#include <cstdint>
#include <span>

#include "canvoy/can/callback.hpp"

namespace canvoy {

/// How an operation stands.
enum class FlashState : std::uint8_t {
  done,
  busy,    ///< it goes on by itself; poll() tells when it is over
  failed,  ///< the memory is broken, or protected
};

/// Addresses count from 0 at the start of the memory that is given to us. An erased byte reads FFh.
/// All functions but poll and sync must be there. What they refer to must outlive who uses them.
struct Flash {
  std::uint32_t sector_size = 0;  ///< bytes that are erased together
  /// Bytes that are programmed together, and once only: 1 to 32, a power of two.
  std::uint32_t unit = 1;
  /// Begins to erase the sector at an address.
  Callback<FlashState(std::uint32_t address)> erase;
  /// Begins to program whole units; the bytes need not live longer than the call.
  Callback<FlashState(std::uint32_t address, std::span<const std::uint8_t> bytes)> program;
  /// False where the memory does not answer.
  Callback<bool(std::uint32_t address, std::span<std::uint8_t> bytes)> read;
  /// How the operation stands that was begun last. Not needed where none is ever busy; where one
  /// is, a chip has one user at a time, who does not read meanwhile.
  Callback<FlashState()> poll;
  /// What was programmed outlives a loss of power from here on. Not needed where it always does.
  Callback<FlashState()> sync;
};

}  // namespace canvoy
