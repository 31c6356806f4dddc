#include "canvoy/canopen/lss/lss_store.hpp"

#include <algorithm>

namespace canvoy {

namespace {

constexpr std::uint32_t record_kind = 0x3153'534C;  // "LSS1"
constexpr Duration poll_interval = 1ms;
constexpr Duration time_out = 10s;

}  // namespace

LssStore::LssStore(Node& node, const Flash& flash, const Place& place)
    : node_(node),
      record_(flash, {.address = place.address, .slot_size = place.slot_size, .kind = record_kind}),
      timer_(callback<&LssStore::step>(*this)),
      state_(record_.find()) {
  std::array<std::uint8_t, 2> found{};
  if (state_ != RecordState::valid) return;
  const bool whole = record_.length() == found.size() && record_.read(0, found);
  if (!whole || !(is_node_id(found[0]) || found[0] == node_id_unconfigured)) {
    state_ = RecordState::damaged;
    return;
  }
  content_ = found;
  node_.set_power_on_id(content_[0]);
}

void LssStore::store(NodeId id, std::uint8_t bit_timing) {
  content_ = {id, bit_timing};
  record_.begin({.rewind = {}, .next = callback<&LssStore::next>(*this)});
  end_ = node_.now() + time_out;
  node_.timers().arm(timer_, node_.now());
}

/// All content fits into the first piece, which is then the last one.
Result<std::size_t> LssStore::next(std::span<std::uint8_t> bytes) {
  static_assert(std::tuple_size_v<decltype(content_)> < RecordHead::size);
  std::ranges::copy(content_, bytes.begin());
  return content_.size();
}

void LssStore::step(Time now) {
  const RecordStep step = record_.step();
  if (step != RecordStep::done && now < end_) {
    return node_.timers().arm(timer_, step == RecordStep::again ? now : now + poll_interval);
  }
  const bool good = step == RecordStep::done && record_.outcome() == AbortCode::none;
  record_.cancel();
  stored_({.code = good ? LssError::none : LssError::store_failed});
}

}  // namespace canvoy
