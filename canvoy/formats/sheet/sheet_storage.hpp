// Storage that keeps the parameters of a device while the program runs: values stored with 1010h
// outlive every NMT reset (CiA 301, 7.5.2.13 and 7.5.2.14).
//
//     MemoryStorage storage(node);
#pragma once

#include <cstdint>
#include <vector>

#include "canvoy/canopen/storage/storage.hpp"

namespace canvoy::formats {

/// Size of a sector; their number is such that all parameters fit into a slot.
inline constexpr std::uint32_t storage_sector_size = 4096;
/// Size of a slot for all parameters of a dictionary: whole sectors.
std::uint32_t storage_slot_size(const Dictionary& dictionary);

/// A Storage on a flash in memory: stored values are lost with the object.
class MemoryStorage {
 public:
  /// `node` must outlive this.
  explicit MemoryStorage(Node& node);

 private:
  FlashState erase(std::uint32_t address);
  FlashState program(std::uint32_t address, std::span<const std::uint8_t> bytes);
  bool read(std::uint32_t address, std::span<std::uint8_t> bytes);
  Flash flash();

  std::vector<std::uint8_t> bytes_;
  Flash flash_;
  Storage storage_;
};

}  // namespace canvoy::formats
