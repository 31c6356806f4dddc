// Keeps the record of a taximeter in flash, step by step, so that nobody waits for it; whenever
// power fails, the old record is there or the new one (canvoy/canopen/storage/record_pair.hpp).
//
//     TaximeterMemory memory(node, flash, {.slot_size = 2048});
//     const TaximeterMemory::Found found = memory.load();
//     memory.save(record);
#pragma once

#include <cstdint>
#include <optional>

#include "canvoy/canopen/node.hpp"
#include "canvoy/canopen/storage/record_pair.hpp"
#include "canvoy/devices/cia447/taximeter/taximeter_record.hpp"

namespace canvoy::cia447 {

class TaximeterMemory {
 public:
  struct Place {
    std::uint32_t address = 0;
    std::uint32_t slot_size = 512;  ///< whole sectors; there are two
  };
  struct Found {
    std::optional<TaximeterRecord> record = {};
    bool is_damaged = false;  ///< there was one
  };

  /// Without a flash nothing is kept. What it refers to must outlive this.
  TaximeterMemory(Node& node, const Flash* flash, const Place& place);
  TaximeterMemory(const TaximeterMemory&) = delete;
  TaximeterMemory& operator=(const TaximeterMemory&) = delete;

  Found load();
  /// Begins to write it; while another one is written, the last that came is next.
  void save(const TaximeterRecord& record);
  /// Writes it before it returns: power is failing.
  void save_now(const TaximeterRecord& record);
  bool is_busy() const { return pair_.busy(); }
  /// The flash did not take the last record.
  bool has_failed() const { return has_flash_ && pair_.outcome() != AbortCode::none; }

 private:
  /// Of a write of a record of this size, each of them busy for long.
  static constexpr unsigned steps_max = 10'000'000;

  void begin(const TaximeterRecordBytes& bytes);
  void go_on(Time now);
  void rewind() { offset_ = 0; }
  Result<std::size_t> next(std::span<std::uint8_t> bytes);

  static const Flash no_flash;

  Node& node_;
  bool has_flash_;
  RecordPair pair_;
  TaximeterRecordBytes writing_{};
  TaximeterRecordBytes waiting_{};
  bool has_waiting_ = false;
  std::size_t offset_ = 0;
  Timer timer_;
};
static_assert(RecordHead::size + TaximeterRecord::size <= TaximeterMemory::Place{}.slot_size);

}  // namespace canvoy::cia447
