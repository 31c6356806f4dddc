// Requirements of storage on a flash memory (or any memory that keeps bytes without power): sectors
// that are erased as a whole, and units that are programmed once until the next erasure.
//
// The maker of a device writes these few functions for the chip; canvoy/canopen/host has them for a
// file. None of them waits: an operation that takes time is begun, and polled later.
//
//     const Flash flash{.sector_size = 2048, .unit = 8, .erase = {...}, .program = {...}, ...};
#pragma once

#include <cstdint>
#include <span>

#include "canvoy/can/callback.hpp"

namespace canvoy {

/// State of an operation.
enum class FlashState : std::uint8_t {
  done,
  busy,    ///< in progress; poll() returns when it is over
  failed,  ///< the memory is broken or protected
};

/// A flash memory. Addresses count from 0 at the start of the assigned memory. An erased byte reads
/// FFh. All functions except poll and sync are mandatory. What they refer to must outlive their
/// users.
struct Flash {
  std::uint32_t sector_size = 0;  ///< number of bytes that are erased together
  /// Number of bytes that are programmed together, and once only: 1 to 32, a power of two.
  std::uint32_t unit = 1;
  /// Begins to erase the sector at an address.
  Callback<FlashState(std::uint32_t address)> erase;
  /// Begins to program whole units; the bytes need not live longer than the call.
  Callback<FlashState(std::uint32_t address, std::span<const std::uint8_t> bytes)> program;
  /// Reads bytes; false if the memory does not answer.
  Callback<bool(std::uint32_t address, std::span<std::uint8_t> bytes)> read;
  /// State of the operation that was begun last. Optional if no operation is ever busy; otherwise a
  /// chip has one user at a time, which does not read meanwhile.
  Callback<FlashState()> poll;
  /// Ensures that programmed data survives a loss of power. Optional if it always does.
  Callback<FlashState()> sync;
};

}  // namespace canvoy
