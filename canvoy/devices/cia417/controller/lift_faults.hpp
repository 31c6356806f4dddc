// What a lift controller finds wrong with its lift, told as application errors FF04h, each by an
// instance (CiA 417-1, 8.4).
//
//     LiftFaults faults(node);
//     faults.change(LiftFault::door);      // FF04h, instance 3
//     faults.doors_opened(false);          // FF04h, instance 10h
#pragma once

#include <cstdint>

#include "canvoy/canopen/node.hpp"

namespace canvoy::cia417 {

/// Each is an application error FF04h with this as instance.
enum class LiftFault : std::uint8_t {
  none,
  motion,       ///< drive or position unit
  unlocked,     ///< a door is not locked while the car moves
  door,         ///< a door is not heard or tells an error
  load,         ///< the load is not known
  travel_time,  ///< the car does not arrive
  position,     ///< the car does not stand where it should: no floor, or short of its target
};

class LiftFaults {
 public:
  /// Instances of the errors that doors did not open, or not close, in time.
  static constexpr std::uint16_t opens_late = 0x10;
  static constexpr std::uint16_t closes_late = 0x11;

  explicit LiftFaults(Node& node) : node_(node) {}
  LiftFaults(const LiftFaults&) = delete;
  LiftFaults& operator=(const LiftFaults&) = delete;

  /// The node has begun anew, and its errors with it.
  void begin_anew();

  LiftFault now() const { return now_; }
  bool is_there() const { return now_ != LiftFault::none; }
  /// The fault is another one, or has gone. False: it is that already.
  bool change(LiftFault fault);
  /// A fault of a trip, which goes on until the car stands, and longer.
  void latch(LiftFault fault) { latched_ = fault; }
  LiftFault latched() const { return latched_; }

  /// Whether doors opened, or closed, in time.
  void doors_opened(bool in_time);
  void doors_closed(bool in_time);
  bool is_closing_late() const { return is_closing_late_; }

 private:
  void tell(std::uint16_t instance, bool is_present);

  Node& node_;
  LiftFault now_ = LiftFault::none;
  LiftFault latched_ = LiftFault::none;
  bool is_opening_late_ = false;
  bool is_closing_late_ = false;
};

}  // namespace canvoy::cia417
