// The two queues of a HostBus: frames that wait for the carrier, and frames in transit until they
// come back.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "canvoy/can/frame.hpp"

namespace canvoy::host {

/// A frame and the member that sent it; the sender is only compared, and may be gone.
struct SentFrame {
  Frame frame;                    ///< as it was sent
  const void* sender = nullptr;   ///< null: none, or gone
  std::uint32_t overtakings = 0;  ///< number of later frames that came back before it
};

/// A first-in-first-out queue of fixed size.
template <std::size_t capacity_>
class FrameQueue {
 public:
  static constexpr std::size_t capacity = capacity_;  ///< frames

  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  /// True if push() is not allowed.
  bool full() const { return size_ == capacity; }
  /// Removes all frames.
  void clear() { size_ = 0; }

  /// Frame at `position`, counted from the oldest.
  SentFrame& operator[](std::size_t position) { return frames_[(first_ + position) % capacity]; }
  /// Appends a frame; the queue must not be full.
  void push(const SentFrame& frame) { (*this)[size_++] = frame; }
  /// Removes the oldest frame; the queue must not be empty.
  void pop() {
    first_ = (first_ + 1) % capacity;
    --size_;
  }
  /// Removes the sender from its frames, since it is gone.
  void forget_sender(const void* sender) {
    for (std::size_t position = 0; position < size_; ++position) {
      SentFrame& sent = (*this)[position];
      if (sent.sender == sender) sent.sender = nullptr;
    }
  }

 private:
  std::array<SentFrame, capacity> frames_{};
  std::size_t first_ = 0;
  std::size_t size_ = 0;
};

/// Frames that wait until the carrier takes them.
using SendQueue = FrameQueue<256>;

/// Frames that the carrier took and that have not yet come back. An echo contains the frame without
/// its sender: among equal frames it belongs to the oldest. A controller with several mailboxes
/// sends out of order; a frame that `overtakings_max` others have overtaken was lost, and is
/// removed, as is the oldest if there are too many.
class EchoQueue {
 public:
  static constexpr std::size_t overtakings_max = 64;  ///< of one frame

  /// Appends a frame. If there are too many, the oldest was lost, and is removed.
  void push(const SentFrame& sent);
  /// Sender of a frame that came back; empty if unknown.
  std::optional<const void*> take(const Frame& frame);
  /// Removes a sender from its frames, since it is gone.
  void forget_sender(const void* sender) { queue_.forget_sender(sender); }
  std::size_t size() const { return queue_.size(); }
  /// Removes all frames.
  void clear() { queue_.clear(); }

 private:
  FrameQueue<4096> queue_;
};

}  // namespace canvoy::host
