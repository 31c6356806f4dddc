#include "canvoy/canopen/lss/bit_timing_switch.hpp"

namespace canvoy {

void BitTimingSwitch::activate(std::uint8_t bit_timing, Duration delay) {
  bit_timing_ = bit_timing;
  delay_ = delay;
  switched_ = false;
  node_.transmitter().mute(true);
  node_.timers().arm(timer_, node_.now() + delay);
}

void BitTimingSwitch::expired(Time now) {
  if (switched_) return node_.transmitter().mute(false);
  switched_ = true;
  node_.transmitter().clear();
  switch_to_(bit_timing_);
  node_.timers().arm(timer_, now + delay_);
}

}  // namespace canvoy
