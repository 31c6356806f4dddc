// The steps of LSS "activate bit timing": silence, the new bit rate, silence, for the time that the
// network received. For slaves and for the master (CiA 305).
//
//     BitTimingSwitch bit_timing(node,
//                                Callback<void(std::uint8_t)>::to<&Can::set_bit_timing>(can));
//     LssSlaveHooks hooks;
//     hooks.activate_bit_timing = bit_timing.hook();
#pragma once

#include <cstdint>

#include "canvoy/canopen/node/node.hpp"

namespace canvoy {

/// Switches the bit timing. In the first delay all nodes come to rest, in the second all have the
/// new bit rate before the first frame. Frames that services of the node send in either are
/// dropped; those that waited for the controller before may still leave in the first.
class BitTimingSwitch {
 public:
  /// Makes the switch. `switch_to` restarts the CAN controller with a bit timing of table selector
  /// 0.
  BitTimingSwitch(Node& node, Callback<void(std::uint8_t bit_timing)> switch_to)
      : node_(node), switch_to_(switch_to), timer_(callback<&BitTimingSwitch::expired>(*this)) {}
  BitTimingSwitch(const BitTimingSwitch&) = delete;
  BitTimingSwitch& operator=(const BitTimingSwitch&) = delete;

  /// Begins the switch: `delay` until the new bit timing, and again until the first frame. Replaces
  /// one that is under way.
  void activate(std::uint8_t bit_timing, Duration delay);
  /// Function for LssSlaveHooks::activate_bit_timing.
  Callback<void(std::uint8_t, Duration)> hook() {
    return callback<&BitTimingSwitch::activate>(*this);
  }
  /// True from activate() until frames are sent again.
  bool running() const { return timer_.armed(); }

 private:
  void expired(Time now);

  Node& node_;
  Callback<void(std::uint8_t)> switch_to_;
  Timer timer_;
  Duration delay_{};
  std::uint8_t bit_timing_ = 0;
  bool switched_ = false;
};

}  // namespace canvoy
