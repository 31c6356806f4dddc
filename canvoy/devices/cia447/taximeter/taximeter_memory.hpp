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

#include "canvoy/devices/cia447/taximeter/audit_log.hpp"
#include "canvoy/devices/cia447/taximeter/kept_image.hpp"
#include "canvoy/devices/cia447/taximeter/taximeter_record.hpp"

namespace canvoy::cia447 {

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
