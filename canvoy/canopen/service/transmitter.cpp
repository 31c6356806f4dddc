#include "canvoy/canopen/service/transmitter.hpp"

#include <cstring>

#include "canvoy/can/check_invariant.hpp"
#include "canvoy/canopen/protocol/cob_id.hpp"

namespace canvoy {

bool Transmitter::send(std::uint16_t can_id, std::span<const std::uint8_t> bytes) {
  check_invariant(bytes.size() <= Frame::length_max);
  Frame frame;
  frame.id = can_id;
  frame.length = static_cast<std::uint8_t>(bytes.size());
  std::memcpy(frame.data.data(), bytes.data(), bytes.size());
  return send(frame);
}

bool Transmitter::keep(const Frame& frame) {
  if (is_small_machine && pass_on(frame)) return true;
  if (muted_) return true;
  if constexpr (!is_small_machine) awaited_.value = true;
  if (taken() >= backlog_.size()) {
    ++lost_;
    return false;
  }
  backlog_[place(std::size_t{first_} + size_)] = frame;
  ++size_;
  check_invariant(size_ <= backlog_.size());
  return true;
}

/// Marks frames, waiting or sent: flush() skips them. 0 is not a PDO, but NMT.
void Transmitter::drop_from_backlog(std::uint16_t can_id) {
  for (Frame& frame : backlog_) {
    if (frame.id == can_id && can_id != 0) frame.id = dropped;
  }
}

/// Drops SYNC, TIME, PDO and SDO. Emergencies stay: their producer counts them as sent (CiA 301,
/// 7.3.2.2.4).
void Transmitter::drop_what_stopped_forbids() {
  for (Frame& frame : backlog_) {
    const bool is_forbidden =
        frame.id == can_id::sync || (frame.id >= can_id::time && frame.id < can_id::error_control);
    if (is_forbidden) frame.id = dropped;
  }
}

void Transmitter::flush() {
  while (size_ > 0 && !leaving_) {
    // Removed before it leaves: an answer may come at once, and clear the backlog. A controller
    // that refuses it may also report its state, and so cause other frames to be sent or all to be
    // cleared.
    const std::uint16_t first = first_;
    const Frame frame = backlog_[first];
    first_ = static_cast<std::uint16_t>(place(first + 1U));
    --size_;
    leaving_ = true;
    const bool sent = frame.id == dropped || port_.send(port_.context, frame);
    const bool cleared = !leaving_;
    leaving_ = false;
    if (sent) continue;
    if (cleared) return;
    check_invariant(size_ < backlog_.size());
    first_ = first;
    ++size_;
    return;
  }
}

}  // namespace canvoy
