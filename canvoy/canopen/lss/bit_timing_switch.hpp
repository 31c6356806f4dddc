// The steps of LSS "activate bit timing": silence, the new bit rate, silence, as long as the
// network was told (CiA 305). For slaves and for the master alike.
//
//     BitTimingSwitch bit_timing(node,
//     Callback<void(std::uint8_t)>::to<&Can::set_bit_timing>(can)); LssSlaveHooks hooks;
//     hooks.activate_bit_timing = bit_timing.hook();
#pragma once

#include <cstdint>

#include "canvoy/canopen/node.hpp"

namespace canvoy {

/// In the first delay all nodes come to rest, in the second all have the new bit rate before the
/// first frame. Frames that services of the node send in either are dropped; those that waited for
/// the controller already may still go out in the first.
class BitTimingSwitch {
 public:
  /// `switch_to` restarts the CAN controller with a bit timing of table selector 0.
  BitTimingSwitch(Node& node, Callback<void(std::uint8_t bit_timing)> switch_to)
      : node_(node),
        switch_to_(switch_to),
        timer_(Callback<void(Time)>::to<&BitTimingSwitch::expired>(*this)) {}
  BitTimingSwitch(const BitTimingSwitch&) = delete;
  BitTimingSwitch& operator=(const BitTimingSwitch&) = delete;

  /// `delay` from now to the switch, and from there to the first frame. One that is under way is
  /// replaced.
  void activate(std::uint8_t bit_timing, Duration delay);
  Callback<void(std::uint8_t, Duration)> hook() {
    return Callback<void(std::uint8_t, Duration)>::to<&BitTimingSwitch::activate>(*this);
  }
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
