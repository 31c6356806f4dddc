#include "canvoy/devices/cia447/taximeter/taximeter_memory.hpp"

namespace canvoy::cia447 {

namespace {

constexpr std::uint32_t record_kind = 0x4D58'4154;  // "TAXM"
constexpr std::uint32_t audit_kind = 0x4158'4154;   // "TAXA"
constexpr std::uint32_t record_layout =
    TaximeterRecord::present_version << 16 | static_cast<std::uint32_t>(TaximeterRecord::size);

}  // namespace

TaximeterMemory::TaximeterMemory(Node& node, const Flash* flash, const Place& place)
    : image_(node, flash,
             {.address = place.address,
              .slot_size = place.slot_size,
              .kind = record_kind,
              .layout = record_layout},
             {writing_, waiting_}) {}

TaximeterMemory::Found TaximeterMemory::load() {
  TaximeterRecordBytes bytes{};
  const RecordState state = image_.load(bytes);
  if (state == RecordState::empty) return {};
  const bool is_read =
      state == RecordState::valid ||
      (state == RecordState::outdated &&
       image_.read_outdated(std::span(bytes).first(TaximeterRecord::size_of_version_1)));
  const auto record = is_read ? taximeter_record(bytes) : std::nullopt;
  return {.record = record, .is_damaged = !record.has_value()};
}

AuditMemory::AuditMemory(Node& node, const Flash* flash, const Place& place)
    : image_(node, flash,
             {.address = place.address,
              .slot_size = place.slot_size,
              .kind = audit_kind,
              .layout = static_cast<std::uint32_t>(size)},
             {writing_, waiting_}) {}

std::optional<AuditLog> AuditMemory::load() {
  Bytes bytes;
  if (image_.load(bytes) != RecordState::valid) return std::nullopt;
  AuditLog log;
  record_archive::ReadingArchive archive{bytes.data()};
  log.visit(archive);
  if (!log.is_sound()) return std::nullopt;
  return log;
}

void AuditMemory::save(const AuditLog& log) {
  image_.save(record_archive::bytes_of<size>(log));
}
void AuditMemory::save_now(const AuditLog& log) {
  image_.save_now(record_archive::bytes_of<size>(log));
}

}  // namespace canvoy::cia447
