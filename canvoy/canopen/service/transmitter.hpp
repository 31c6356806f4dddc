// The way out of a node: directly into the controller, or into a bounded backlog while the
// controller is full.
#pragma once

#include <cstdint>
#include <span>
#include <utility>

#include "canvoy/can/frame.hpp"
#include "canvoy/can/machine.hpp"
#include "canvoy/can/port.hpp"

namespace canvoy {

/// Sends in order, and waits where the controller is full.
class Transmitter {
 public:
  /// Makes a transmitter. `backlog`, of 65,535 frames at most, and `port` must outlive it.
  constexpr Transmitter(const Port& port, std::span<Frame> backlog)
      : port_(port), backlog_(backlog) {}

  /// Sends a frame; frames leave in the order of the calls. False if the backlog is full too: the
  /// frame is lost, and counted.
  bool send(const Frame& frame) { return (!is_small_machine && pass_on(frame)) || keep(frame); }
  /// Like send(const Frame&), but for a data frame of 8 bytes at most.
  bool send(std::uint16_t can_id, std::span<const std::uint8_t> bytes);
  /// Mutes the transmitter: frames sent while it is muted are dropped; frames that wait are kept.
  void mute(bool on) { muted_ = on; }
  /// True while frames are dropped: see mute().
  bool muted() const { return muted_; }
  /// Drops waiting frames with this CAN-ID, if it is one of a PDO. They keep their room until their
  /// turn.
  void drop(std::uint16_t can_id) {
    if (is_small_machine || taken() != 0) drop_from_backlog(can_id);
  }
  /// Drops waiting frames that NMT state stopped forbids.
  void drop_what_stopped_forbids();
  /// Tries again to send the frames that the controller did not take.
  void flush();
  /// Drops all waiting frames.
  void clear() {
    size_ = 0;
    leaving_ = false;
  }

  /// For hosts: true if a frame has waited, or was lost, since the last call that found none
  /// waiting. Otherwise no service was refused, and so none waits for room.
  bool is_awaited() { return std::exchange(awaited_.value, awaited_.value && size_ != 0); }

  /// True if no frame waits.
  bool idle() const { return size_ == 0; }
  /// True if the next frame would be lost.
  bool full() const { return taken() != 0 && taken() >= backlog_.size(); }
  /// True if there is no room for process data: the other half is for answers, error control and
  /// SYNC.
  bool crowded() const { return size_ != 0 && 2U * size_ >= backlog_.size(); }
  /// Number of frames that found neither the controller nor the backlog with room.
  std::uint32_t lost() const { return lost_; }

 private:
  static constexpr std::uint32_t dropped = UINT32_MAX;  ///< in place of a CAN-ID

  /// Hands a frame to the controller, without overtaking waiting frames.
  bool pass_on(const Frame& frame) {
    return size_ == 0 && !muted_ && !leaving_ && port_.send(port_.context, frame);
  }
  bool keep(const Frame& frame);
  void drop_from_backlog(std::uint16_t can_id);
  /// Number of places taken in the backlog, including that of the frame being sent.
  std::size_t taken() const { return size_ + std::size_t{leaving_}; }
  /// Position in the ring; a comparison is cheaper than a division.
  std::size_t place(std::size_t position) const {
    return position < backlog_.size() ? position : position - backlog_.size();
  }

  const Port& port_;
  std::span<Frame> backlog_;
  std::uint16_t first_ = 0;
  std::uint16_t size_ = 0;
  std::uint32_t lost_ = 0;
  bool muted_ = false;
  [[no_unique_address]] HostOnly<bool> awaited_;
  bool leaving_ = false;  ///< a frame of the backlog is being sent; its place is reserved
};

}  // namespace canvoy
