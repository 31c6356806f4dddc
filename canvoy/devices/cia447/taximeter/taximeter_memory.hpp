// Keeps the record of a taximeter, and its audit log, in flash: each of them whole, old or new,
// whenever power fails (kept_image.hpp).
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
  struct Place {
    std::uint32_t address = 0;
    std::uint32_t slot_size = 512;  ///< whole sectors; there are two
  };
  /// What load() finds.
  struct Found {
    std::optional<TaximeterRecord> record = {};
    bool is_damaged = false;  ///< there was one
  };

  /// Without a flash nothing is kept. What it refers to must outlive this.
  TaximeterMemory(Node& node, const Flash* flash, const Place& place);

  /// Reads what was kept last.
  Found load();
  /// Begins to write it; while another one is written, the last that came is next.
  void save(const TaximeterRecord& record) { image_.save(bytes_of(record)); }
  /// Writes it before it returns: power is failing.
  void save_now(const TaximeterRecord& record) { image_.save_now(bytes_of(record)); }
  /// A record is being written.
  bool is_busy() const { return image_.is_busy(); }
  /// The flash did not take the last record.
  bool has_failed() const { return image_.has_failed(); }

 private:
  TaximeterRecordBytes writing_{};
  TaximeterRecordBytes waiting_{};
  KeptImage image_;
};
static_assert(RecordHead::size + TaximeterRecord::size <= TaximeterMemory::Place{}.slot_size);

/// In a place of its own: what is recorded, and how often, touches no total.
class AuditMemory {
 public:
  /// Of two slots, one behind the other.
  struct Place {
    std::uint32_t address = 0;    ///< of the first one
    std::uint32_t slot_size = 0;  ///< whole sectors, of 1024 bytes at least; 0: it is not kept
  };

  /// As TaximeterMemory has it.
  AuditMemory(Node& node, const Flash* flash, const Place& place);

  /// Nothing where there is none that can be read.
  std::optional<AuditLog> load();
  /// Begins to write it; while another one is written, the last that came is next.
  void save(const AuditLog& log);
  /// Writes it before it returns: power is failing.
  void save_now(const AuditLog& log);
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
