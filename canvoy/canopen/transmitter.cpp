#include "canvoy/canopen/transmitter.hpp"

#include <cstring>

namespace canvoy {

bool Transmitter::send(std::uint16_t can_id, std::span<const std::uint8_t> bytes) {
  Frame frame;
  frame.id = can_id;
  frame.length = static_cast<std::uint8_t>(bytes.size());
  std::memcpy(frame.data.data(), bytes.data(), bytes.size());
  return send(frame);
}

bool Transmitter::keep(const Frame& frame) {
  if (is_small_machine && pass_on(frame)) return true;
  if (muted_) return true;
  if (taken() >= backlog_.size()) {
    ++lost_;
    return false;
  }
  backlog_[place(std::size_t{first_} + size_)] = frame;
  ++size_;
  return true;
}

void Transmitter::flush() {
  while (size_ > 0 && !leaving_) {
    // It is taken out before it leaves: what answers it may come at once, and clear the backlog. A
    // controller that refuses it may also tell of its state, and so have others sent or all
    // cleared.
    const std::uint16_t first = first_;
    const Frame frame = backlog_[first];
    first_ = static_cast<std::uint16_t>(place(first + 1U));
    --size_;
    leaving_ = true;
    const bool sent = port_.send(port_.context, frame);
    const bool cleared = !leaving_;
    leaving_ = false;
    if (sent) continue;
    if (cleared) return;
    first_ = first;
    ++size_;
    return;
  }
}

}  // namespace canvoy
