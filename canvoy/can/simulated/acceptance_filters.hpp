// The acceptance filters of all controllers of a bus, by identifier, so that the bus finds the
// receivers of a frame in one step.
//
//     AcceptanceFilters filters;
//     filters.accept(node, 0x181, true);
//     (receivers & filters.accepting(frame)).for_each(hand_over);
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "canvoy/can/frame.hpp"
#include "canvoy/can/simulated/controller_set.hpp"

namespace canvoy {

/// The filters, all closed at first. Allocates in the constructor only.
class AcceptanceFilters {
 public:
  AcceptanceFilters() : by_identifier_(Frame::id_max + std::size_t{1}) {}

  /// Sets the filter for frames with this 11-bit identifier, also remote ones; greater identifiers
  /// are ignored.
  void accept(ControllerId id, std::uint16_t can_id, bool wanted) {
    if (can_id < by_identifier_.size()) by_identifier_[can_id].assign(id, wanted);
  }
  /// Sets the filter for all frames with 29-bit identifiers.
  void accept_extended(ControllerId id, bool wanted) { extended_.assign(id, wanted); }
  /// Opens the filter of a controller for all frames.
  void accept_all(ControllerId id) {
    for (ControllerSet& accepting : by_identifier_) accepting.insert(id);
    extended_.insert(id);
  }

  /// Controllers that let the frame pass. The identifier must be within its 11 or 29 bits.
  const ControllerSet& accepting(const Frame& frame) const {
    return frame.is_extended() ? extended_ : by_identifier_[frame.id];
  }

 private:
  std::vector<ControllerSet> by_identifier_;
  ControllerSet extended_{};
};

}  // namespace canvoy
