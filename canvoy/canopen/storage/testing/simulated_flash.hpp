// A flash memory for tests: it loses power at any byte, tears words, wears, fails, and takes time.
//
//     SimulatedFlash memory({.sector_size = 128, .sectors = 2, .unit = 8});
//     Storage storage(node, memory.flash, {.slot_size = 128});
//     memory.cut_after(57);  // bytes that are erased or programmed before power fails
//
// For tests only.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "canvoy/canopen/storage/flash.hpp"

namespace canvoy {

/// State of the byte being programmed or erased after a power failure.
enum class Tear : std::uint8_t { nothing, some_bits };

class SimulatedFlash {
 public:
  struct Geometry {
    std::uint32_t sector_size = 128;
    std::uint32_t sectors = 2;
    std::uint32_t unit = 8;
  };
  using Bytes = std::vector<std::uint8_t>;
  static constexpr std::uint64_t no_limit = std::numeric_limits<std::uint64_t>::max();

  explicit SimulatedFlash(const Geometry& geometry) : SimulatedFlash(geometry, {}) {}
  /// Makes a flash with the content of another one after a power failure.
  SimulatedFlash(const Geometry& geometry, Bytes content)
      : bytes(std::move(content)), geometry_(geometry) {
    bytes.resize(std::size_t{geometry.sector_size} * geometry.sectors, 0xFF);
    flash.sector_size = geometry.sector_size;
    flash.unit = geometry.unit;
    flash.erase = decltype(Flash::erase)::to<&SimulatedFlash::erase>(*this);
    flash.program = decltype(Flash::program)::to<&SimulatedFlash::program>(*this);
    flash.read = decltype(Flash::read)::to<&SimulatedFlash::read>(*this);
    flash.poll = decltype(Flash::poll)::to<&SimulatedFlash::poll>(*this);
    flash.sync = decltype(Flash::sync)::to<&SimulatedFlash::sync>(*this);
  }
  SimulatedFlash(const SimulatedFlash&) = delete;
  SimulatedFlash& operator=(const SimulatedFlash&) = delete;

  void cut_after(std::uint64_t steps, Tear tear = Tear::nothing) {
    cut_at_ = steps_ + steps;
    tear_ = tear;
  }
  bool is_dead() const { return steps_ >= cut_at_; }
  /// Makes the current operation end at the next poll.
  void end_operation() { polls_ = polls_ == 0 ? 0 : 1; }
  /// Number of bytes erased or programmed so far.
  std::uint64_t steps() const { return steps_; }

  Flash flash;
  Bytes bytes;
  unsigned busy_polls = 0;    ///< number of polls that each operation is busy
  unsigned erasures = 0;      ///< number begun
  unsigned programmings = 0;  ///< number begun
  unsigned syncs = 0;
  unsigned violations = 0;  ///< of the rules for users in flash.hpp
  bool fail_erase = false;
  unsigned fail_program = 0;  ///< the n-th programming from here on fails; 0: none
  unsigned fail_sync = 0;     ///< the n-th sync from here on fails; 0: none
  bool fail_read = false;
  unsigned fail_read_at = 0;  ///< the n-th read from here on fails; 0: none
  bool stuck_bit = false;     ///< bit 0 of each byte stays set when programmed

 private:
  /// Counts a step; false if power has failed.
  bool has_power(std::uint8_t& place, std::uint8_t wanted) {
    if (steps_ == cut_at_) return false;
    if (++steps_ < cut_at_) {
      place = wanted;
    } else if (tear_ == Tear::some_bits) {
      place = static_cast<std::uint8_t>((place & 0x5A) | (wanted & 0xA5));
    }
    return true;
  }
  FlashState begin(bool failed) {
    if (polls_ != 0) ++violations;
    polls_ = busy_polls;
    failed_ = failed;
    return polls_ != 0 ? FlashState::busy : poll();
  }
  FlashState poll() {
    if (polls_ != 0 && --polls_ != 0) return FlashState::busy;
    return failed_ ? FlashState::failed : FlashState::done;
  }
  FlashState erase(std::uint32_t address) {
    ++erasures;
    if (address % geometry_.sector_size != 0 || address >= bytes.size()) ++violations;
    if (fail_erase) return begin(true);
    for (std::uint32_t i = 0; i < geometry_.sector_size; ++i) {
      if (!has_power(bytes.at(address + i), 0xFF)) break;
    }
    return begin(false);
  }
  FlashState program(std::uint32_t address, std::span<const std::uint8_t> data) {
    ++programmings;
    if (address % geometry_.unit != 0 || data.size() % geometry_.unit != 0) ++violations;
    if (fail_program != 0 && --fail_program == 0) return begin(true);
    for (std::size_t i = 0; i < data.size(); ++i) {
      std::uint8_t& place = bytes.at(address + i);
      if (place != 0xFF && !is_dead()) ++violations;
      const auto programmed = static_cast<std::uint8_t>(place & (data[i] | (stuck_bit ? 1U : 0U)));
      if (!has_power(place, programmed)) break;
    }
    return begin(false);
  }
  bool read(std::uint32_t address, std::span<std::uint8_t> data) {
    if (polls_ != 0) ++violations;
    if (fail_read || polls_ != 0) return false;
    if (fail_read_at != 0 && --fail_read_at == 0) return false;
    for (std::size_t i = 0; i < data.size(); ++i) data[i] = bytes.at(address + i);
    return true;
  }
  FlashState sync() {
    ++syncs;
    return begin(fail_sync != 0 && --fail_sync == 0);
  }

  Geometry geometry_;
  std::uint64_t steps_ = 0;
  std::uint64_t cut_at_ = no_limit;
  Tear tear_ = Tear::nothing;
  unsigned polls_ = 0;
  bool failed_ = false;
};

}  // namespace canvoy
