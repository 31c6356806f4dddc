// A file in place of a flash memory, so that a device on Linux keeps its parameters like one on a
// microcontroller.
//
//     Result<std::unique_ptr<FileFlash>> file = FileFlash::open("charger.store", {});
//     Storage storage(node, (*file)->flash(), {.slot_size = 8192});
//
// The stored record survives a loss of power as in a real flash: each sync waits until the disk has
// it. A file of another program is never changed.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "canvoy/can/host/descriptor.hpp"
#include "canvoy/can/host/result.hpp"
#include "canvoy/canopen/storage/flash.hpp"

namespace canvoy::host {

/// A flash in a file, for one program at a time.
class FileFlash {
 public:
  /// Size of the flash, which a file keeps from its first opening on.
  struct Geometry {
    std::uint32_t sector_size = 4096;  ///< in bytes
    std::uint32_t sectors = 4;         ///< number of sectors
    friend bool operator==(const Geometry&, const Geometry&) = default;
  };
  /// Size of the head of the file: its maker and its geometry.
  static constexpr std::uint32_t head_size = 64;

  /// Opens the file, or makes it, erased, if there is none: completely or not at all. Error: it
  /// cannot be opened or made, another program has it open for the same purpose, or it is another
  /// kind of file.
  static Result<std::unique_ptr<FileFlash>> open(const std::string& path, const Geometry& geometry);
  FileFlash(const FileFlash&) = delete;
  FileFlash& operator=(const FileFlash&) = delete;

  /// The functions for Storage and others; valid as long as this object.
  const Flash& flash() const { return flash_; }

 private:
  FileFlash(Descriptor file, const Geometry& geometry);

  FlashState erase(std::uint32_t address);
  FlashState program(std::uint32_t address, std::span<const std::uint8_t> bytes);
  bool read(std::uint32_t address, std::span<std::uint8_t> bytes);
  FlashState sync();

  bool is_inside(std::uint32_t address, std::size_t size) const;

  Descriptor file_;
  Geometry geometry_;
  Flash flash_;
};

}  // namespace canvoy::host
