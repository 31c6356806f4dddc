// Files that a device stores by SDO (6201h, 6202h; CiA 407, 9.2.8), one for each sub-index, or
// accepts from other devices (6720h, 6741h; 9.2.26, 9.2.27), of any size up to a limit. A file that
// does not arrive whole changes nothing. Virtual devices of one physical one share the files of an
// object: those of the shelf that was made first.
//
//     FileShelfOf<8, 8192> pictures{device, 0x6202};
//     pictures.shelf().file(1);   // the bytes of 6202h:01h
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "canvoy/devices/cia407/kit/virtual_devices.hpp"

namespace canvoy::cia407 {

class FileShelf {
 public:
  /// The memory of a shelf, for each file and for one that is arriving.
  struct Memory {
    std::span<std::uint8_t> bytes;   ///< (sizes.size() + 1) x size_max
    std::span<std::uint32_t> sizes;  ///< one for each file
    std::uint32_t size_max = 0;      ///< bytes of a file at most
    std::uint8_t first_sub = 1;      ///< of the first file; 0 for a variable
  };

  /// Attaches to an object of the device, for each file one sub-index.
  FileShelf(VirtualDevice& device, std::uint16_t index, const Memory& memory);

  /// Empty if there is none. Valid until it is written.
  std::span<const std::uint8_t> file(unsigned sub) const;
  /// Removes all files.
  void clear();

  /// Called when a whole file has arrived.
  Callback<void(const Entry&)> on_stored = {};

 private:
  FileShelf& shared(FileShelf* shelf);
  /// From 1 on: place 0 is for a file that arrives.
  unsigned place_of(unsigned sub) const { return sub - memory_.first_sub + 1; }
  bool has(unsigned sub) const {
    return sub >= memory_.first_sub && place_of(sub) <= memory_.sizes.size();
  }
  std::span<std::uint8_t> bytes_at(unsigned place) const {
    return memory_.bytes.subspan(std::size_t{memory_.size_max} * place, memory_.size_max);
  }
  Result<std::uint32_t> open_read(const Entry& entry);
  Result<std::size_t> read(const Entry& entry, std::uint32_t offset, std::span<std::uint8_t> bytes);
  AbortCode open_write(const Entry& entry, std::uint32_t size);
  AbortCode write(const Entry& entry, std::span<const std::uint8_t> bytes);
  AbortCode close_write(const Entry& entry, bool complete);

  Memory memory_;
  Domain domain_;
  Hook hook_;
  FileShelf* next_;    ///< shelf of another object, or one that shares the files of another
  FileShelf& shared_;  ///< the shelf that has the files, often this one
  std::uint32_t arrived_ = 0;
  unsigned arriving_ = 0;  ///< place of the file that is being written; 0: none
  unsigned read_ = 0;      ///< place of the file being read, unless it was written since; 0: none
};

/// A shelf with its memory.
template <std::size_t files, std::size_t size_max, std::uint8_t first_sub = 1>
class FileShelfOf {
 public:
  /// Attaches to an object of the device.
  FileShelfOf(VirtualDevice& device, std::uint16_t index)
      : shelf_(device, index,
               {.bytes = bytes_, .sizes = sizes_, .size_max = size_max, .first_sub = first_sub}) {}
  /// The shelf.
  FileShelf& shelf() { return shelf_; }

 private:
  std::array<std::uint8_t, (files + 1) * size_max> bytes_{};
  std::array<std::uint32_t, files> sizes_{};
  FileShelf shelf_;
};

}  // namespace canvoy::cia407
