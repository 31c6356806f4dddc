// Faults that a lift controller detects in its lift, reported as application errors FF04h, each
// with a separate instance (CiA 417-1, 8.4).
//
//     LiftFaults faults(node);
//     faults.change(LiftFault::door);      // FF04h, instance 3
//     faults.doors_opened(false);          // FF04h, instance 10h
#pragma once

#include <cstdint>

#include "canvoy/canopen/node/node.hpp"

namespace canvoy::cia417 {

/// Each is an application error FF04h with this as instance.
enum class LiftFault : std::uint8_t {
  none,
  motion,       ///< drive or position unit
  unlocked,     ///< a door is not locked while the car moves
  door,         ///< a door is not received or reports an error
  load,         ///< the load is not known
  travel_time,  ///< the car does not arrive
  position,     ///< the car is not where it should be: at no floor, or short of its target
};

class LiftFaults {
 public:
  /// Instances of the errors that doors did not open or close in time.
  static constexpr std::uint16_t opens_late = 0x10;
  static constexpr std::uint16_t closes_late = 0x11;  ///< instance

  /// Makes a state without faults; `node` must outlive it, and reports them.
  explicit LiftFaults(Node& node) : node_(node) {}
  LiftFaults(const LiftFaults&) = delete;
  LiftFaults& operator=(const LiftFaults&) = delete;

  /// Clears all faults: the node has started, without errors.
  void begin_anew();

  /// The fault that holds; none if there is none.
  LiftFault now() const { return now_; }
  /// True if a fault holds.
  bool is_there() const { return now_ != LiftFault::none; }
  /// Sets another fault, or none. False if it is unchanged.
  bool change(LiftFault fault);
  /// A fault of a trip, which lasts until the car stands, or longer.
  void latch(LiftFault fault) { latched_ = fault; }
  /// Fault of the present or last trip.
  LiftFault latched() const { return latched_; }

  /// Reports whether doors opened or closed in time.
  void doors_opened(bool in_time);
  /// Reports whether doors closed in time.
  void doors_closed(bool in_time);
  /// True from doors_closed(false) to doors_closed(true).
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
