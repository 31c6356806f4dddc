#include "canvoy/worlds/excavator/recorded_shift.hpp"

namespace canvoy::excavator {

namespace {

/// Position of an input that has one.
double place_of(const SeatPanel& panel, HandInput input) {
  switch (input) {
    case HandInput::left_x:
    case HandInput::left_y:
    case HandInput::right_x:
    case HandInput::right_y:
      return panel.stick(static_cast<Stick>(input));
    case HandInput::left_pedal:
      return panel.pedal(0);
    case HandInput::right_pedal:
      return panel.pedal(1);
    case HandInput::throttle:
      return panel.wheel(0);
    case HandInput::rotator:
      return panel.wheel(1);
    default:
      return panel.is_lever_lowered() ? 1 : 0;
  }
}

}  // namespace

void move_hand(SeatPanel& panel, const HandMove& move) {
  switch (move.input) {
    case HandInput::left_x:
    case HandInput::left_y:
    case HandInput::right_x:
    case HandInput::right_y:
      return panel.move_stick(static_cast<Stick>(move.input), move.value);
    case HandInput::left_pedal:
      return panel.move_pedal(0, move.value);
    case HandInput::right_pedal:
      return panel.move_pedal(1, move.value);
    case HandInput::throttle:
      return panel.turn_wheel(0, move.value);
    case HandInput::rotator:
      return panel.turn_wheel(1, move.value);
    case HandInput::knob:
      return panel.turn_knob(static_cast<int>(move.value));
    case HandInput::lever:
      panel.sit(move.value != 0);
      return panel.set_lever(move.value != 0);
    default:
      return;
  }
}

void ShiftRecorder::look(Time now, const SeatPanel& panel) {
  for (std::size_t i = 0; i < places; ++i) {
    const auto input = static_cast<HandInput>(i);
    if (input == HandInput::knob) continue;
    const double place = place_of(panel, input);
    if (std::exchange(told_[i], place) != place) shift_.push_back({now, input, place});
  }
  const auto clicks = static_cast<std::int32_t>(panel.knob() - std::exchange(knob_, panel.knob()));
  if (clicks != 0) shift_.push_back({now, HandInput::knob, static_cast<double>(clicks)});
}

void ShiftRecorder::pressed(Time now, Button button, Duration down) {
  const auto input = static_cast<HandInput>(static_cast<unsigned>(HandInput::horn) +
                                            static_cast<unsigned>(button));
  shift_.push_back({now, input, std::chrono::duration<double>(down).count()});
}

void ShiftRecorder::began(Time now, std::uint8_t activity) {
  shift_.push_back({now, HandInput::activity, static_cast<double>(activity)});
}

}  // namespace canvoy::excavator
