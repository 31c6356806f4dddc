// CiA 852: handles for application code. Elements, push-buttons and indicators are numbered from 1
// (5.3). The number of a button or indicator has to be known at compile time.
//
//     Values seat(node.dictionary());
//     seat[cia852::joystick_x(1)] = -12000;
//     seat[cia852::push_button<13>(2)] = Switch::on;  // of cluster 2
//     if (seat[cia852::indicator<1>(1)].is(cia852::Switch::on)) ...
#pragma once

#include "canvoy/profiles/cia852/inputs.hpp"
#include "canvoy/profiles/cia852/outputs.hpp"
#include "canvoy/profiles/model/handle.hpp"

namespace canvoy::cia852 {

/// Location among the 64 of a cluster: the group of eight, and the number in it.
inline constexpr unsigned bits_of_group = 8;
/// Group, from 1, of an element of a cluster.
constexpr unsigned group_of(unsigned number) {
  return (number - 1) / bits_of_group + 1;
}
/// Number, 1 to 8, of an element in its group.
constexpr unsigned place_of(unsigned number) {
  return (number - 1) % bits_of_group + 1;
}
/// A number that a cluster can have: 1 to 64.
template <unsigned number>
concept InCluster = number >= 1 && number <= groups_of_cluster * bits_of_group;

// Joysticks (9.2).

/// Deflection along x of a joystick, from 1 on.
constexpr auto joystick_x(unsigned joystick) {
  return Number<read_analogue_input_16_bit_object, "Joystick #: x-dimension">{}[joystick_axis_sub(
      joystick, 1)];
}
/// Deflection along y of a joystick, from 1 on.
constexpr auto joystick_y(unsigned joystick) {
  return Number<read_analogue_input_16_bit_object, "Joystick #: y-dimension">{}[joystick_axis_sub(
      joystick, 2)];
}
/// Deflection along z of a joystick, from 1 on.
constexpr auto joystick_z(unsigned joystick) {
  return Number<read_analogue_input_16_bit_object, "Joystick #: z-dimension">{}[joystick_axis_sub(
      joystick, 3)];
}
/// Whether a joystick holds its position along x.
constexpr auto joystick_memory_x(unsigned joystick) {
  return State<Switch, read_input_8_bit_object, "Joystick #: Memory function",
               "m-x">{}[joystick_memory_sub(joystick)];
}
/// Whether a joystick holds its position along y.
constexpr auto joystick_memory_y(unsigned joystick) {
  return State<Switch, read_input_8_bit_object, "Joystick #: Memory function",
               "m-y">{}[joystick_memory_sub(joystick)];
}
/// Whether a joystick holds its position along z.
constexpr auto joystick_memory_z(unsigned joystick) {
  return State<Switch, read_input_8_bit_object, "Joystick #: Memory function",
               "m-z">{}[joystick_memory_sub(joystick)];
}
/// All buttons of a joystick, one bit each.
constexpr auto joystick_buttons(unsigned joystick) {
  return Number<read_input_8_bit_object,
                "Joystick #: Up to 8 additional buttons">{}[joystick_buttons_sub(joystick)];
}
/// One of buttons 1 to 8 of a joystick.
template <unsigned button>
  requires(button >= 1 && button <= bits_of_group)
constexpr auto joystick_button(unsigned joystick) {
  return State<Switch, read_input_8_bit_object, "Joystick #: Up to 8 additional buttons",
               numbered("b", button)>{}[joystick_buttons_sub(joystick)];
}

// Foot pedals, encoders and wheels (9.3 to 9.5).

/// Position of a foot pedal, from 1 on.
constexpr auto foot_pedal_position(unsigned pedal) {
  return Number<read_analogue_input_16_bit_object,
                "Foot pedal #: Position">{}[foot_pedal_position_sub(pedal)];
}
/// Whether a foot pedal holds its position.
constexpr auto foot_pedal_memory(unsigned pedal) {
  return State<Switch, read_input_8_bit_object, "Foot pedal #: Memory function",
               "m-x">{}[foot_pedal_memory_sub(pedal)];
}
/// Position of an encoder, from 1 on.
constexpr auto encoder_position(unsigned encoder) {
  return Number<read_input_32_bit_object, "Encoder #: Position">{}[encoder_position_sub(encoder)];
}
/// Position of a wheel, from 1 on.
constexpr auto wheel_position(unsigned wheel) {
  return Number<read_analogue_input_16_bit_object, "Wheel #: Position">{}[wheel_position_sub(
      wheel)];
}
/// True if TPDOs are sent when an analogue input changes.
inline constexpr Flag<analogue_input_global_interrupt_enable_object> analogue_events_enabled;

// Push-buttons (9.6). All groups of a cluster have the shape of the first.

/// Eight push-buttons of a cluster; both count from 1.
constexpr auto push_buttons(unsigned cluster, unsigned group) {
  return Number<read_input_8_bit_object, "Push-button cluster #: Switch 1-to-8">{}[push_buttons_sub(
      cluster, group)];
}
/// One of push-buttons 1 to 64 of a cluster, from 1 on.
template <unsigned button>
  requires InCluster<button>
constexpr auto push_button(unsigned cluster) {
  return State<Switch, read_input_8_bit_object, "Push-button cluster #: Switch 1-to-8",
               numbered("pb", place_of(button))>{}[push_buttons_sub(cluster, group_of(button))];
}

// Indicators (9.7).

/// Eight indicators of a cluster; both count from 1.
constexpr auto indicators(unsigned cluster, unsigned group) {
  return Number<write_output_8_bit_object,
                "Indicator cluster #: Indicator 1-to-8">{}[indicators_sub(cluster, group)];
}
/// One of indicators 1 to 64 of a cluster, from 1 on.
template <unsigned number>
  requires InCluster<number>
constexpr auto indicator(unsigned cluster) {
  return State<Switch, write_output_8_bit_object, "Indicator cluster #: Indicator 1-to-8",
               numbered("i", place_of(number))>{}[indicators_sub(cluster, group_of(number))];
}
/// What an indicator does when the host is lost (6206h): keeps its state, or takes that of 6207h.
template <unsigned number>
  requires InCluster<number>
constexpr auto indicator_error_mode(unsigned cluster) {
  return State<cia401::ErrorMode, error_mode_output_8_bit_object,
               "Indicator cluster #: Error mode 1-to-8",
               numbered("i", place_of(number))>{}[indicators_sub(cluster, group_of(number))];
}
/// State of an indicator without a host (6207h).
template <unsigned number>
  requires InCluster<number>
constexpr auto indicator_error_value(unsigned cluster) {
  return State<Switch, error_value_output_8_bit_object, "Indicator cluster #: Error value 1-to-8",
               numbered("i", place_of(number))>{}[indicators_sub(cluster, group_of(number))];
}

// Displays (9.8).

/// Parameter of a display, as an integer; both count from 1.
constexpr auto display_value(unsigned display, unsigned parameter) {
  return Number<write_analogue_output_16_bit_object, "Display #: parameter 1">{}[display_sub(
      display, parameter)];
}
/// Parameter of a display, as a floating-point number; both count from 1.
constexpr auto display_float(unsigned display, unsigned parameter) {
  return Quantity<write_analogue_output_float_object, "Display #: parameter 1">{}[display_sub(
      display, parameter)];
}
/// Whether a parameter of a display takes its error value.
constexpr auto display_error_mode(unsigned display, unsigned parameter) {
  return State<cia401::ErrorMode, analogue_output_error_mode_object,
               "Error mode display #: parameter 1">{}[display_sub(display, parameter)];
}
/// Error value of a parameter of a display, as an integer.
constexpr auto display_error_value(unsigned display, unsigned parameter) {
  return Number<analogue_output_error_value_integer_object,
                "Error value display #: parameter 1">{}[display_sub(display, parameter)];
}
/// Error value of a parameter of a display, as a floating-point number.
constexpr auto display_error_float(unsigned display, unsigned parameter) {
  return Quantity<analogue_output_error_value_float_object,
                  "Error value display #: parameter 1">{}[display_sub(display, parameter)];
}

}  // namespace canvoy::cia852
