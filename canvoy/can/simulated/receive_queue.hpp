// The frames that a CAN controller has received and its node has not fetched: a ring of fixed size.
//
//     if (!queue.push(frame)) ++overruns;
#pragma once

#include <cstddef>
#include <span>

#include "canvoy/can/frame.hpp"

namespace canvoy {

/// A ring in storage of the owner. A frame that arrives while it is full is lost; its contents
/// stay.
class ReceiveQueue {
 public:
  constexpr ReceiveQueue() = default;
  /// Makes an empty queue; the size of `storage` is its capacity.
  constexpr explicit ReceiveQueue(std::span<Frame> storage) : storage_(storage) {}

  constexpr std::size_t size() const { return size_; }

  /// Appends a frame; false if the queue is full.
  constexpr bool push(const Frame& frame) {
    if (size_ == storage_.size()) return false;
    const std::size_t index = head_ + size_++;
    storage_[index < storage_.size() ? index : index - storage_.size()] = frame;
    return true;
  }
  /// Removes the oldest frame; false if the queue is empty.
  constexpr bool pop(Frame& frame) {
    if (size_ == 0) return false;
    frame = storage_[head_];
    head_ = head_ + 1 == storage_.size() ? 0 : head_ + 1;
    --size_;
    return true;
  }
  /// Drops all frames.
  constexpr void clear() { size_ = 0; }

 private:
  std::span<Frame> storage_{};
  std::size_t head_ = 0;
  std::size_t size_ = 0;
};

}  // namespace canvoy
