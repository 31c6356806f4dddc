#include "canvoy/tools/page/frame_index.hpp"

#include "canvoy/decoder/teaching.hpp"

namespace canvoy::tools {

void FrameIndex::add(std::size_t bus, const Frame& frame) {
  if (!is_open_) blocks_.push_back({.first_key = keys_.size()});
  is_open_ = true;
  Block& block = blocks_.back();
  const std::uint32_t of_bus = std::uint32_t{1} << bus;
  if (frame.is_error()) {
    block.errors |= of_bus;
  } else if (frame.is_extended()) {
    block.extended |= of_bus;
  } else {
    block.teaches = block.teaches || decoder::may_teach(frame);
    const std::size_t key = bus * can_ids + frame.id;
    if (here_[key]) return;
    here_.set(key);
    all_.set(key);
    block.is_kept = block.is_kept && keys_.size() < keys_kept_max;
    if (block.is_kept) keys_.push_back(static_cast<Key>(key));
  }
}

void FrameIndex::end_block() {
  here_.reset();
  is_open_ = false;
}

std::span<const FrameIndex::Key> FrameIndex::keys(std::size_t block) const {
  const std::size_t end = block + 1 < blocks_.size() ? blocks_[block + 1].first_key : keys_.size();
  return std::span(keys_).subspan(blocks_[block].first_key, end - blocks_[block].first_key);
}

}  // namespace canvoy::tools
