// Bytes that a taximeter keeps in flash, written step by step, so that no call waits for the flash.
// After a loss of power, either the old or the new bytes exist
// (canvoy/canopen/storage/record_pair.hpp).
//
//     KeptImage image(node, flash, {.address = 0, .slot_size = 512, .kind = kind, .layout = 1},
//                     {writing, waiting});
//     if (image.load(bytes) == RecordState::valid) ...
//     image.save(bytes);
#pragma once

#include <cstdint>
#include <span>

#include "canvoy/canopen/node/node.hpp"
#include "canvoy/canopen/storage/record_pair.hpp"

namespace canvoy::cia447 {

class KeptImage {
 public:
  /// Location and kind of the bytes.
  struct Place {
    std::uint32_t address = 0;    ///< of the first slot
    std::uint32_t slot_size = 0;  ///< whole sectors, for each of two slots. 0: nothing is kept
    std::uint32_t kind = 0;       ///< distinguishes these bytes from those of others
    std::uint32_t layout = 0;     ///< another layout is not read
  };
  /// Room for the bytes that are being written, and for the next ones: of one size.
  struct Room {
    std::span<std::uint8_t> writing;  ///< being written
    std::span<std::uint8_t> waiting;  ///< waiting
  };

  /// Without a flash, nothing is kept. All references must outlive this.
  KeptImage(Node& node, const Flash* flash, const Place& place, const Room& room);
  KeptImage(const KeptImage&) = delete;
  KeptImage& operator=(const KeptImage&) = delete;

  /// Reads the kept bytes: valid, empty, or any other state for damage.
  RecordState load(std::span<std::uint8_t> bytes);
  /// After a load() that found a record of another layout: reads it if it has this size.
  bool read_outdated(std::span<std::uint8_t> bytes) const {
    return pair_.length() == bytes.size() && pair_.read(0, bytes);
  }
  /// Starts to write all bytes. While others are being written, the last ones wait.
  void save(std::span<const std::uint8_t> bytes);
  /// Writes them before it returns: for a loss of power.
  void save_now(std::span<const std::uint8_t> bytes);
  /// True while bytes are being written.
  bool is_busy() const { return pair_.busy(); }
  /// True if the flash refused the last ones.
  bool has_failed() const { return is_kept_ && pair_.outcome() != AbortCode::none; }

 private:
  /// Maximum number of steps of a write of this size, with each of them busy for long.
  static constexpr unsigned steps_max = 10'000'000;

  void begin(std::span<const std::uint8_t> bytes);
  void go_on(Time now);
  void rewind() { offset_ = 0; }
  Result<std::size_t> next(std::span<std::uint8_t> bytes);

  static const Flash no_flash;

  Node& node_;
  bool is_kept_;
  RecordPair pair_;
  Room room_;
  bool has_waiting_ = false;
  std::size_t offset_ = 0;
  Timer timer_;
};

}  // namespace canvoy::cia447
