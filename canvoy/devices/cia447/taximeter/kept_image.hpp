// Bytes that a taximeter keeps in flash, step by step, so that nobody waits for it; whenever power
// fails, the old ones are there or the new ones (canvoy/canopen/storage/record_pair.hpp).
//
//     KeptImage image(node, flash, {.address = 0, .slot_size = 512, .kind = kind, .layout = 1},
//                     {writing, waiting});
//     if (image.load(bytes) == RecordState::valid) ...
//     image.save(bytes);
#pragma once

#include <cstdint>
#include <span>

#include "canvoy/canopen/node.hpp"
#include "canvoy/canopen/storage/record_pair.hpp"

namespace canvoy::cia447 {

class KeptImage {
 public:
  /// Where, and what it is.
  struct Place {
    std::uint32_t address = 0;    ///< of the first slot
    std::uint32_t slot_size = 0;  ///< whole sectors; there are two. 0: nothing is kept
    std::uint32_t kind = 0;       ///< others find nothing of theirs there
    std::uint32_t layout = 0;     ///< a reader of another one reads nothing
  };
  /// Room for the bytes that are written, and for those that are next: of one size.
  struct Room {
    std::span<std::uint8_t> writing;  ///< now
    std::span<std::uint8_t> waiting;  ///< behind them
  };

  /// Without a flash nothing is kept. What it refers to must outlive this.
  KeptImage(Node& node, const Flash* flash, const Place& place, const Room& room);
  KeptImage(const KeptImage&) = delete;
  KeptImage& operator=(const KeptImage&) = delete;

  /// Reads what is kept: valid, empty, or anything else that is damage.
  RecordState load(std::span<std::uint8_t> bytes);
  /// Begins to write as many bytes as there is room for; while others are written, the last that
  /// came are next.
  void save(std::span<const std::uint8_t> bytes);
  /// Writes them before it returns: power is failing.
  void save_now(std::span<const std::uint8_t> bytes);
  /// Bytes are being written.
  bool is_busy() const { return pair_.busy(); }
  /// The flash did not take the last ones.
  bool has_failed() const { return is_kept_ && pair_.outcome() != AbortCode::none; }

 private:
  /// Of a write of bytes of this size, each of them busy for long.
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
