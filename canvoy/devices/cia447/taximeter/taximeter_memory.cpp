#include "canvoy/devices/cia447/taximeter/taximeter_memory.hpp"

#include <algorithm>

namespace canvoy::cia447 {

namespace {

constexpr Duration poll_period = 1ms;

}  // namespace

const Flash KeptImage::no_flash = {};

KeptImage::KeptImage(Node& node, const Flash* flash, const Place& place, const Room& room)
    : node_(node),
      is_kept_(flash != nullptr && place.slot_size != 0),
      pair_(is_kept_ ? *flash : no_flash,
            {.address = place.address, .slot_size = place.slot_size, .kind = place.kind}),
      room_(room),
      timer_(callback<&KeptImage::go_on>(*this)) {
  pair_.sign(place.kind, place.layout);
}

RecordState KeptImage::load(std::span<std::uint8_t> bytes) {
  if (!is_kept_) return RecordState::empty;
  const RecordState state = pair_.find();
  if (state != RecordState::valid) return state;
  return pair_.read(0, bytes) ? state : RecordState::unreadable;
}

void KeptImage::save(std::span<const std::uint8_t> bytes) {
  if (!is_kept_) return;
  if (!pair_.busy()) return begin(bytes);
  std::ranges::copy(bytes, room_.waiting.begin());
  has_waiting_ = true;
}

void KeptImage::begin(std::span<const std::uint8_t> bytes) {
  std::ranges::copy(bytes, room_.writing.begin());
  has_waiting_ = false;
  pair_.begin(
      {.rewind = callback<&KeptImage::rewind>(*this), .next = callback<&KeptImage::next>(*this)});
  node_.timers().arm(timer_, node_.now());
}

void KeptImage::save_now(std::span<const std::uint8_t> bytes) {
  if (!is_kept_) return;
  begin(bytes);
  RecordStep step = RecordStep::again;
  for (unsigned i = 0; i < steps_max && step != RecordStep::done; ++i) step = pair_.step();
  node_.timers().disarm(timer_);
}

void KeptImage::go_on(Time now) {
  RecordStep step = RecordStep::again;
  while (step == RecordStep::again) step = pair_.step();
  if (step == RecordStep::wait) {
    node_.timers().arm(timer_, now + poll_period);
  } else if (has_waiting_) {
    begin(room_.waiting);
  }
}

Result<std::size_t> KeptImage::next(std::span<std::uint8_t> bytes) {
  const std::size_t length = std::min(bytes.size(), room_.writing.size() - offset_);
  std::copy_n(room_.writing.begin() + static_cast<std::ptrdiff_t>(offset_), length, bytes.begin());
  offset_ += length;
  return length;
}

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
