#include "canvoy/devices/cia852/two_channel_axes.hpp"

#include <algorithm>
#include <cstdlib>

namespace canvoy::cia852 {

namespace {

/// Table 37.
constexpr std::uint16_t hardware_error = 0x5000;

}  // namespace

void TwoChannelAxes::connect(Node& node, OperatorUnit& unit) {
  node_ = &node;
  unit_ = &unit;
}

std::int16_t TwoChannelAxes::look(unsigned joystick, unsigned axis) {
  const std::int16_t first = first_(joystick, axis);
  const std::int16_t second = second_(joystick, axis);
  const bool is_broken = first == no_position || second == no_position;
  const bool is_odd = is_broken || std::abs(first - second) > settings_.deviation_most;
  const std::size_t place = place_of(joystick, axis);
  watch(place, is_odd);
  if (is_broken || states_[place].is_invalid) return no_position;
  if (is_odd && (first < 0) != (second < 0)) return 0;
  return std::abs(first) <= std::abs(second) ? first : second;
}

void TwoChannelAxes::watch(std::size_t place, bool is_odd) {
  State& state = states_[place];
  const Time now = node_ == nullptr ? Time{} : node_->now();
  if (state.is_odd != is_odd) state = {now, is_odd, state.is_invalid};
  if (is_odd == state.is_invalid) return;
  const Time ends = state.since + settings_.deviates_most;
  if (node_ == nullptr) {
    state.is_invalid = is_odd;
  } else if (now < ends) {
    if (!timer_.armed() || ends < timer_.at()) node_->timers().arm(timer_, ends);
  } else {
    state.is_invalid = is_odd;
    const Error error{.code = hardware_error, .instance = static_cast<std::uint16_t>(place + 1)};
    is_odd ? node_->raise(error) : node_->clear(error);
  }
}

}  // namespace canvoy::cia852
