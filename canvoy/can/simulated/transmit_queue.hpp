// The transmit queue of a CAN controller: of fixed size, in one of the two orders of real
// controllers.
//
//     TransmitQueue queue(storage, TransmitOrder::by_identifier);
//     queue.push(frame);  send(queue.front().frame);  queue.pop();
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "canvoy/can/frame.hpp"
#include "canvoy/can/simulated/arbitration.hpp"

namespace canvoy {

/// Order in which a controller sends the frames of its queue.
enum class TransmitOrder : std::uint8_t {
  as_queued,  ///< first in, first out
  /// The frame that would win arbitration goes first; equal ones in the order in which they were
  /// queued.
  by_identifier,
};

/// A waiting frame, with properties that the bus needs repeatedly.
struct PendingFrame {
  Frame frame{};           ///< as it is sent
  std::uint32_t key = 0;   ///< arbitration_key()
  std::uint32_t bits = 0;  ///< frame_bits()
};

/// A ring in storage of the owner. A frame that is on the wire is locked at the front until pop()
/// or unlock().
class TransmitQueue {
 public:
  constexpr TransmitQueue() = default;
  /// Makes an empty queue; the size of `storage` is its capacity.
  constexpr TransmitQueue(std::span<PendingFrame> storage, TransmitOrder order)
      : storage_(storage), order_(order) {}

  constexpr bool empty() const { return size_ == 0; }
  /// True if push() would refuse.
  constexpr bool full() const { return size_ == storage_.size(); }
  constexpr std::size_t size() const { return size_; }

  /// Appends a frame; false if the queue is full. Constant, or for by_identifier linear in the
  /// frames that it overtakes.
  constexpr bool push(const PendingFrame& pending) {
    if (full()) return false;
    std::size_t place = size_++;
    if (order_ == TransmitOrder::by_identifier) {
      const std::size_t first_free = locked_ ? 1 : 0;
      for (; place > first_free && pending.key < at(place - 1).key; --place) {
        at(place) = at(place - 1);
      }
    }
    at(place) = pending;
    return true;
  }

  /// Next frame to send; the queue must not be empty.
  constexpr const PendingFrame& front() const { return storage_[head_]; }
  /// Removes the front, and unlocks the queue; it must not be empty.
  constexpr void pop() {
    head_ = head_ + 1 == storage_.size() ? 0 : head_ + 1;
    --size_;
    locked_ = false;
  }

  /// Locks the front, which is on the wire: no frame overtakes it.
  constexpr void lock() { locked_ = true; }
  /// Unlocks the front, which must be sent again: more urgent frames that came meanwhile go first.
  constexpr void unlock() {
    locked_ = false;
    if (order_ != TransmitOrder::by_identifier) return;
    for (std::size_t place = 1; place < size_ && at(place).key < at(place - 1).key; ++place) {
      const PendingFrame urgent = at(place);
      at(place) = at(place - 1);
      at(place - 1) = urgent;
    }
  }

  /// Drops all frames except one that is on the wire.
  constexpr void clear() { size_ = locked_ ? 1 : 0; }

 private:
  constexpr PendingFrame& at(std::size_t place) {
    const std::size_t index = head_ + place;
    return storage_[index < storage_.size() ? index : index - storage_.size()];
  }

  std::span<PendingFrame> storage_{};
  std::size_t head_ = 0;
  std::size_t size_ = 0;
  TransmitOrder order_ = TransmitOrder::as_queued;
  bool locked_ = false;
};

}  // namespace canvoy
