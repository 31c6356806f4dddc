// The hardware on the seat of an excavator, wired to the operator environment in it: sticks with
// their contacts, pedals, wheels, a knob, push-buttons, lamps and a display. A person moves and
// reads it, the module senses and drives it, and the wires between both may break.
//
//     SeatPanel panel;
//     panel.move_stick(Stick::right_y, 0.5);   // boom up
//     OperatorDevice seat(port, 10, panel.hardware());
#pragma once

#include <array>
#include <bitset>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>

#include "canvoy/devices/cia852/operator_hardware.hpp"
#include "canvoy/sim/plants/excavator.hpp"

namespace canvoy::excavator {

/// Axes of both sticks, in the usual pattern of levers.
enum class Stick : std::uint8_t {
  left_x,   ///< slew
  left_y,   ///< stick
  right_x,  ///< bucket
  right_y,  ///< boom
};
/// Number of axes.
inline constexpr std::size_t stick_count = static_cast<std::size_t>(Stick::right_y) + 1;
inline constexpr std::size_t pedal_count = 2;  ///< number of pedals: left and right track

/// Push-buttons 1 to 5 of the cluster.
enum class Button : std::uint8_t { horn, light, beacon, travel, lock };
/// Number of push-buttons.
inline constexpr std::size_t button_count = static_cast<std::size_t>(Button::lock) + 1;

/// Indicators 1 to 8 of the cluster.
enum class Lamp : std::uint8_t { light, beacon, fast, locked, fault, low_fuel, hot, ready };
/// Number of indicators.
inline constexpr std::size_t lamp_count = static_cast<std::size_t>(Lamp::ready) + 1;
/// A bit for each Lamp.
using Lamps = std::bitset<lamp_count>;
/// True if this lamp is among the lit ones.
constexpr bool is_lit(const Lamps& lit, Lamp lamp) {
  return lit[static_cast<std::size_t>(lamp)];
}
/// Lamps that are lit when the host is lost: 6207h.
inline constexpr Lamps lamps_without_host{1U << static_cast<unsigned>(Lamp::fault)};

/// Parameters 1 to 8 of the display.
enum class Shown : std::uint8_t { fuel, oil, slew, height, rpm, reach, page, detail };
/// Number of parameters of the display.
inline constexpr std::size_t shown_parameters = static_cast<std::size_t>(Shown::detail) + 1;
inline constexpr std::int16_t no_value = INT16_MIN;  ///< nothing is shown
/// Pages of the last parameter: angles of boom, stick, bucket, and the pressure.
inline constexpr unsigned display_pages = 4;

/// Digits of a position at the end of its travel.
inline constexpr double full_scale = 32'000;
/// Reading of a broken wire: no position of a stick.
inline constexpr std::int16_t broken_wire_reads = INT16_MIN;
/// Share of the travel from which on the contact of a direction is closed.
inline constexpr double contact_closes = 0.04;

class SeatPanel {
 public:
  SeatPanel() { display_.fill(no_value); }
  SeatPanel(const SeatPanel&) = delete;
  SeatPanel& operator=(const SeatPanel&) = delete;

  // Actions of a person.

  /// `place` is -1 to 1; 0: the stick is at rest.
  void move_stick(Stick stick, double place) {
    set(sticks_[static_cast<std::size_t>(stick)], place);
  }
  /// `pedal` 0 is the left one; `place` -1 to 1.
  void move_pedal(std::size_t pedal, double place) { set(pedals_[pedal], place); }
  /// `wheel` 0 is the throttle, 1 the rotator; `place` -1 to 1.
  void turn_wheel(std::size_t wheel, double place) { set(wheels_[wheel], place); }
  /// Turns to the right, or below 0 to the left.
  void turn_knob(int clicks) { set(knob_, knob_ + static_cast<std::uint32_t>(clicks)); }
  /// Holds a push-button down, or releases it.
  void press(Button button, bool is_pressed) {
    pressed_[static_cast<std::size_t>(button)] = is_pressed;
  }
  /// Holds the button on the left joystick that asks for the command.
  void ask_for_command(bool is_pressed) { set(asks_for_command_, is_pressed); }
  /// True if all sticks are at rest.
  bool is_at_rest() const { return sticks_ == std::array<double, stick_count>{}; }
  /// Seat that has the command, by the lamps: 0 is the operator's; empty: they are dark.
  std::optional<std::size_t> commanding_seat() const;
  /// Moves the safety lever at the armrest.
  void set_lever(bool is_lowered) { set(is_lever_lowered_, is_lowered); }
  /// Loads or unloads the seat switch.
  void sit(bool is_seated) { set(is_seated_, is_seated); }
  /// Presses or pulls the emergency stop at the armrest, which stays down until it is pulled.
  void press_stop(bool is_pressed) { set(is_stop_pressed_, is_pressed); }
  /// Number of changes of these values.
  std::uint64_t hand_changes() const { return hand_changes_; }
  /// Position of the hand, -1 to 1.
  double stick(Stick stick) const { return sticks_[static_cast<std::size_t>(stick)]; }
  /// Position of the foot, -1 to 1.
  double pedal(std::size_t pedal) const { return pedals_[pedal]; }
  /// Position, -1 to 1.
  double wheel(std::size_t wheel) const { return wheels_[wheel]; }
  /// Counter of clicks; it wraps around.
  std::uint32_t knob() const { return knob_; }
  /// True while it is held down.
  bool is_pressed(Button button) const { return pressed_[static_cast<std::size_t>(button)]; }
  /// True if the safety lever permits movements.
  bool is_lever_lowered() const { return is_lever_lowered_; }
  /// True if lever, seat switch and emergency stop let the machine move.
  bool is_released() const {
    return is_lever_lowered_ && closes_seat_switch() && !is_stop_pressed_;
  }
  /// Lever, seat switch and emergency stop as bits of the armrest's inputs.
  std::uint8_t contacts() const;
  /// Lamps that give light.
  const Lamps& lit() const { return lit_; }
  /// Value on the display; no_value: nothing.
  std::int16_t shown(Shown what) const { return display_[static_cast<std::size_t>(what)]; }

  /// Movement that the hand commands: -1 to 1.
  double wanted(Movement movement) const;

  // Faults of wires.

  /// Breaks the wire of an axis, or mends it.
  void break_wire(Stick stick, bool is_broken) {
    broken_[static_cast<std::size_t>(stick)] = is_broken;
  }
  /// Keeps the first sensor at its value, whatever the hand does.
  void jam(Stick stick, bool is_jammed);
  /// The first sensor reads a quarter of the travel too much, or too little in the upper half.
  void drift(Stick stick, bool drifts) { drifting_[static_cast<std::size_t>(stick)] = drifts; }
  /// Breaks the wire of the seat switch, which then reports an empty seat.
  void break_seat_switch(bool is_broken) { is_seat_switch_broken_ = is_broken; }
  /// A lamp gives no light.
  void burn_out(Lamp lamp) { burnt_.set(static_cast<std::size_t>(lamp)); }
  /// Keeps the first parameter of the display at its first value for ever.
  void freeze_display() { is_frozen_ = true; }
  /// True if the wire of any axis is broken.
  bool has_broken_wire() const { return broken_.any(); }
  /// True if the sensor of any axis is jammed.
  bool has_jam() const { return jammed_.any(); }
  /// True while a first sensor is off.
  bool has_drift() const { return drifting_.any(); }

  // Side of the module.

  /// Hardware for the seat's module; valid as long as this object.
  cia852::OperatorHardware hardware();
  /// Digits that the module reads of an axis.
  std::int16_t sensed(Stick stick) const;
  /// The module has no power: no lamp is lit, and the display is empty.
  void go_dark();
  // Its joysticks 1 and 2, of which each axis has two sensors.

  /// Reading of the first sensor, in digits; axis 1 is x, 2 is y.
  std::int16_t joystick_axis(unsigned joystick, unsigned axis);
  /// Like joystick_axis(), of the second sensor.
  std::int16_t second_joystick_axis(unsigned joystick, unsigned axis);
  /// Contacts and buttons, as in Figure 4 of CiA 852.
  std::uint8_t joystick_buttons(unsigned joystick);

 private:
  template <class Value>
  void set(Value& value, Value to) {
    if (std::exchange(value, to) != to) ++hand_changes_;
  }
  std::uint8_t joystick_memory(unsigned) { return 0; }
  std::int16_t foot_pedal(unsigned pedal);
  bool foot_pedal_memory(unsigned) { return false; }
  std::uint32_t encoder(unsigned) { return knob_; }
  std::int16_t wheel_position(unsigned wheel);
  std::uint8_t push_buttons(unsigned cluster, unsigned group);
  void show_indicators(unsigned cluster, unsigned group, std::uint8_t lit);
  void show_parameter(unsigned display, unsigned parameter, std::int16_t value);

  std::uint64_t hand_changes_ = 0;
  std::array<double, stick_count> sticks_{};
  std::array<double, pedal_count> pedals_{};
  std::array<double, 2> wheels_{};
  std::uint32_t knob_ = 0;
  bool closes_seat_switch() const { return is_seated_ && !is_seat_switch_broken_; }

  bool is_lever_lowered_ = false;
  bool is_seated_ = false;
  bool is_stop_pressed_ = false;
  bool is_seat_switch_broken_ = false;
  std::bitset<button_count> pressed_;
  std::bitset<stick_count> broken_;
  std::bitset<stick_count> jammed_;
  std::bitset<stick_count> drifting_;
  std::array<double, stick_count> jammed_at_{};
  bool asks_for_command_ = false;
  std::uint8_t command_lamps_ = 0;
  Lamps lit_;
  Lamps burnt_;
  std::array<std::int16_t, shown_parameters> display_{};
  bool is_frozen_ = false;
};

/// First bit of a joystick's contacts among its buttons: 5 to 8 are x-, x+, y- and y+.
inline constexpr unsigned first_contact_bit = 4;
/// Button 1 of the left joystick asks for the command.
inline constexpr unsigned command_bit = 1;

}  // namespace canvoy::excavator
