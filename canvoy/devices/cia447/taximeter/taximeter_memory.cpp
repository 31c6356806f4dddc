#include "canvoy/devices/cia447/taximeter/taximeter_memory.hpp"

#include <algorithm>

namespace canvoy::cia447 {

namespace {

constexpr std::uint32_t record_kind = 0x4D58'4154;  // "TAXM"
constexpr Duration poll_period = 1ms;
/// A reader of another version reads nothing.
constexpr std::uint32_t record_layout =
    TaximeterRecord::present_version << 16 | static_cast<std::uint32_t>(TaximeterRecord::size);

}  // namespace

const Flash TaximeterMemory::no_flash = {};

TaximeterMemory::TaximeterMemory(Node& node, const Flash* flash, const Place& place)
    : node_(node),
      has_flash_(flash != nullptr),
      pair_(has_flash_ ? *flash : no_flash,
            {.address = place.address, .slot_size = place.slot_size, .kind = record_kind}),
      timer_(Callback<void(Time)>::to<&TaximeterMemory::go_on>(*this)) {
  pair_.sign(record_kind, record_layout);
}

TaximeterMemory::Found TaximeterMemory::load() {
  if (!has_flash_) return {};
  const RecordState state = pair_.find();
  if (state == RecordState::empty) return {};
  TaximeterRecordBytes bytes;
  const bool is_read = state == RecordState::valid && pair_.read(0, bytes);
  const auto record = is_read ? taximeter_record(bytes) : std::nullopt;
  return {.record = record, .is_damaged = !record.has_value()};
}

void TaximeterMemory::save(const TaximeterRecord& record) {
  if (!has_flash_) return;
  if (pair_.busy()) {
    waiting_ = bytes_of(record);
    has_waiting_ = true;
    return;
  }
  begin(bytes_of(record));
}

void TaximeterMemory::begin(const TaximeterRecordBytes& bytes) {
  writing_ = bytes;
  has_waiting_ = false;
  pair_.begin(
      {.rewind = Callback<void()>::to<&TaximeterMemory::rewind>(*this),
       .next = Callback<Result<std::size_t>(std::span<std::uint8_t>)>::to<&TaximeterMemory::next>(
           *this)});
  node_.timers().arm(timer_, node_.now());
}

void TaximeterMemory::save_now(const TaximeterRecord& record) {
  if (!has_flash_) return;
  begin(bytes_of(record));
  RecordStep step = RecordStep::again;
  for (unsigned i = 0; i < steps_max && step != RecordStep::done; ++i) step = pair_.step();
  node_.timers().disarm(timer_);
}

void TaximeterMemory::go_on(Time now) {
  RecordStep step = RecordStep::again;
  while (step == RecordStep::again) step = pair_.step();
  if (step == RecordStep::wait) {
    node_.timers().arm(timer_, now + poll_period);
  } else if (has_waiting_) {
    begin(TaximeterRecordBytes(waiting_));
  }
}

Result<std::size_t> TaximeterMemory::next(std::span<std::uint8_t> bytes) {
  const std::size_t length = std::min(bytes.size(), writing_.size() - offset_);
  std::copy_n(writing_.begin() + static_cast<std::ptrdiff_t>(offset_), length, bytes.begin());
  offset_ += length;
  return length;
}

}  // namespace canvoy::cia447
