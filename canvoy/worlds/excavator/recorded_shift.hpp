// A recorded shift of an excavator: what hands moved, turned and pressed at the seat, and when.
// ExcavatorOperator plays it again, against a network that may be another one.
//
//     ShiftRecorder recorder;
//     recorder.look(now, panel);                     // each time that hands moved
//     options.shift.recorded = recorder.shift();
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <utility>
#include <vector>

#include "canvoy/can/time.hpp"
#include "canvoy/worlds/excavator/seat_panel.hpp"

namespace canvoy::excavator {

/// What a hand moves, and the unit of its value.
enum class HandInput : std::uint8_t {
  // Position: -1 to 1.
  left_x,
  left_y,
  right_x,
  right_y,
  left_pedal,
  right_pedal,
  throttle,
  rotator,
  knob,   ///< clicks from this position, below 0 to the left
  lever,  ///< 1: down, 0: up
  // Time for which it is held, in s.
  horn,
  light,
  beacon,
  travel,
  lock,
  activity,  ///< Activity that the operator begins
};
/// Number of inputs.
inline constexpr std::size_t hand_inputs = static_cast<std::size_t>(HandInput::activity) + 1;
/// True for the five push-buttons: the value is a time.
constexpr bool is_button(HandInput input) {
  return input >= HandInput::horn && input <= HandInput::lock;
}
/// True for sticks, pedals and wheels: the value is a position.
constexpr bool is_place(HandInput input) {
  return input <= HandInput::rotator;
}
/// The button of an input for which is_button() is true.
constexpr Button button_of(HandInput input) {
  return static_cast<Button>(static_cast<unsigned>(input) - static_cast<unsigned>(HandInput::horn));
}

/// An action of a hand.
struct HandMove {
  Time at{};                            ///< since the start of the shift
  HandInput input = HandInput::left_x;  ///< what is moved
  double value = 0;                     ///< in the unit of the input

  friend bool operator==(const HandMove&, const HandMove&) = default;
};
/// In the order of their times; of one instant in any order.
using RecordedShift = std::vector<HandMove>;

/// Moves, turns or sets the element; does nothing for buttons and activities.
void move_hand(SeatPanel& panel, const HandMove& move);

/// Records a shift while an operator works.
class ShiftRecorder {
 public:
  /// Records what has changed since the last look.
  void look(Time now, const SeatPanel& panel);
  /// A button is held for `down`.
  void pressed(Time now, Button button, Duration down);
  /// The operator begins an Activity, by its number.
  void began(Time now, std::uint8_t activity);

  /// What was recorded so far.
  const RecordedShift& shift() const { return shift_; }

 private:
  static constexpr std::size_t places = static_cast<std::size_t>(HandInput::lever) + 1;

  RecordedShift shift_;
  std::array<double, places> told_{};
  std::uint32_t knob_ = 0;
};

}  // namespace canvoy::excavator
