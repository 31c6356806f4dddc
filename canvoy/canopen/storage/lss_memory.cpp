#include "canvoy/canopen/storage/lss_memory.hpp"

#include <algorithm>

namespace canvoy {

namespace {

constexpr std::uint32_t lss_record = 0x534C'4F43;  ///< "COLS"

}  // namespace

LssMemory::LssMemory(const Flash& flash, const Place& place)
    : record_(flash, {place.address, place.slot_size, lss_record}) {}

LssMemory::~LssMemory() {
  if (node_ != nullptr) node_->timers().disarm(timer_);
}

LssMemory::Content LssMemory::find() {
  state_ = record_.find();
  std::array<std::uint8_t, 2> bytes;
  if (state_ != RecordState::valid) return {};
  const bool is_whole = record_.length() == bytes.size() && record_.read(0, bytes);
  if (!is_whole || !(is_node_id(bytes[0]) || bytes[0] == node_id_unconfigured)) {
    state_ = RecordState::damaged;
    return {};
  }
  return {.node_id = bytes[0], .bit_timing = bytes[1]};
}

void LssMemory::serve(Node& node, LssSlave& slave) {
  node_ = &node;
  slave_ = &slave;
}

void LssMemory::store(NodeId node_id, std::uint8_t bit_timing) {
  content_ = {node_id, bit_timing};
  record_.begin(
      {.rewind = Callback<void()>::to<&LssMemory::rewind>(*this),
       .next =
           Callback<Result<std::size_t>(std::span<std::uint8_t>)>::to<&LssMemory::next>(*this)});
  end_ = node_->now() + time_out;
  node_->timers().arm(timer_, node_->now());
}

Result<std::size_t> LssMemory::next(std::span<std::uint8_t> bytes) {
  const std::size_t size = std::min(bytes.size(), content_.size() - given_);
  std::copy_n(content_.begin() + static_cast<std::ptrdiff_t>(given_), size, bytes.begin());
  given_ += size;
  return size;
}

void LssMemory::step(Time now) {
  switch (record_.step()) {
    case RecordStep::again:
      return node_->timers().arm(timer_, now);
    case RecordStep::wait:
      if (now >= end_) return finish(AbortCode::hardware);
      return node_->timers().arm(timer_, now + poll_interval);
    case RecordStep::done:
      return finish(record_.outcome());
  }
}

void LssMemory::finish(AbortCode outcome) {
  record_.cancel();
  if (outcome == AbortCode::none) state_ = RecordState::valid;
  slave_->stored({.code = outcome == AbortCode::none ? LssError::none : LssError::store_failed});
}

}  // namespace canvoy
