#include "canvoy/devices/cia447/taximeter/kept_image.hpp"

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
      timer_(Callback<void(Time)>::to<&KeptImage::go_on>(*this)) {
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
  pair_.begin({.rewind = Callback<void()>::to<&KeptImage::rewind>(*this),
               .next = Callback<Result<std::size_t>(std::span<std::uint8_t>)>::to<&KeptImage::next>(
                   *this)});
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

}  // namespace canvoy::cia447
