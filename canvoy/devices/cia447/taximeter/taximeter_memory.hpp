// Keeps the record of a taximeter, and its audit log, in flash: each of them whole, old or new,
// after any loss of power (kept_image.hpp).
//
//     TaximeterMemory memory(node, flash, {.slot_size = 2048});
//     const TaximeterMemory::Found found = memory.load();
//     memory.save(record);
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "canvoy/canopen/node/node.hpp"
#include "canvoy/canopen/storage/record_pair.hpp"
#include "canvoy/devices/cia447/taximeter/audit_log.hpp"
#include "canvoy/devices/cia447/taximeter/taximeter_record.hpp"

namespace canvoy::cia447 {

/// Bytes that a taximeter keeps in flash, written step by step, so that no call waits for the
/// flash. After a loss of power, either the old or the new bytes exist
/// (canvoy/canopen/storage/record_pair.hpp).
///
///     KeptImage image(node, flash, {.address = 0, .slot_size = 512, .kind = kind, .layout = 1},
///                     {writing, waiting});
///     if (image.load(bytes) == RecordState::valid) ...
///     image.save(bytes);
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

class TaximeterMemory {
 public:
  /// Where the record is in the flash.
  struct Place {
    std::uint32_t address = 0;      ///< of the first slot; the second follows it
    std::uint32_t slot_size = 512;  ///< whole sectors, for each of two slots
  };
  /// Result of load().
  struct Found {
    std::optional<TaximeterRecord> record = {};  ///< nothing: none, or damaged
    bool is_damaged = false;                     ///< a record existed
  };

  /// Without a flash, nothing is kept. All references must outlive this.
  TaximeterMemory(Node& node, const Flash* flash, const Place& place);

  /// Reads the last kept record.
  Found load();
  /// Starts to write it. While another one is being written, the last one waits.
  void save(const TaximeterRecord& record) { image_.save(bytes_of(record)); }
  /// Writes it before it returns: for a loss of power.
  void save_now(const TaximeterRecord& record) { image_.save_now(bytes_of(record)); }
  /// True while a record is being written.
  bool is_busy() const { return image_.is_busy(); }
  /// True if the flash refused the last record.
  bool has_failed() const { return image_.has_failed(); }

 private:
  TaximeterRecordBytes writing_{};
  TaximeterRecordBytes waiting_{};
  KeptImage image_;
};
static_assert(RecordHead::size + TaximeterRecord::size <= TaximeterMemory::Place{}.slot_size);

/// A separate memory: recording never affects a total.
class AuditMemory {
 public:
  /// Location of two adjacent slots.
  struct Place {
    std::uint32_t address = 0;    ///< of the first slot
    std::uint32_t slot_size = 0;  ///< whole sectors, at least 1024 bytes; 0: not kept
  };

  /// Like TaximeterMemory.
  AuditMemory(Node& node, const Flash* flash, const Place& place);

  /// Nothing if no log can be read.
  std::optional<AuditLog> load();
  /// Starts to write it. While another one is being written, the last one waits.
  void save(const AuditLog& log);
  /// Writes it before it returns: for a loss of power.
  void save_now(const AuditLog& log);
  /// True if the flash has failed: nothing is recorded any more.
  bool has_failed() const { return image_.has_failed(); }

 private:
  static constexpr std::size_t size = record_archive::size_of<AuditLog>();
  using Bytes = std::array<std::uint8_t, size>;
  static_assert(RecordHead::size + size <= 1024);

  Bytes writing_{};
  Bytes waiting_{};
  KeptImage image_;
};

}  // namespace canvoy::cia447
