// A file that stands in for a flash memory, so that a device on Linux keeps its parameters as one
// on a microcontroller does.
//
//     Result<std::unique_ptr<FileFlash>> file = FileFlash::open("charger.store", {});
//     Storage storage(node, (*file)->flash(), {.slot_size = 8192});
//
// The record of what is stored is safe against a loss of power as in a real flash: each sync waits
// until the disk has it. A file that somebody else made is never changed.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "canvoy/can/host/descriptor.hpp"
#include "canvoy/can/host/result.hpp"
#include "canvoy/canopen/storage/flash.hpp"

namespace canvoy::host {

class FileFlash {
 public:
  struct Geometry {
    std::uint32_t sector_size = 4096;
    std::uint32_t sectors = 4;
    friend bool operator==(const Geometry&, const Geometry&) = default;
  };
  /// What comes first in the file: who made it, and of which geometry it is.
  static constexpr std::uint32_t head_size = 64;

  /// Makes the file, erased, where there is none: whole, or not at all. Error: it cannot be opened
  /// or made, another program has it open for the same purpose, or it is something else.
  static Result<std::unique_ptr<FileFlash>> open(const std::string& path, const Geometry& geometry);
  FileFlash(const FileFlash&) = delete;
  FileFlash& operator=(const FileFlash&) = delete;

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
