#include "canvoy/worlds/excavator/seat_panel.hpp"

#include <bit>
#include <cmath>

#include "canvoy/worlds/excavator/armrest_watch.hpp"

namespace canvoy::excavator {

namespace {

std::int16_t in_digits(double place) {
  return static_cast<std::int16_t>(std::lround(place * full_scale));
}

}  // namespace

double SeatPanel::wanted(Movement movement) const {
  switch (movement) {
    case Movement::slew:
      return stick(Stick::left_x);
    case Movement::stick:
      return stick(Stick::left_y);
    case Movement::bucket:
      return stick(Stick::right_x);
    case Movement::boom:
      return stick(Stick::right_y);
    case Movement::left_track:
      return pedals_[0];
    case Movement::right_track:
      return pedals_[1];
    case Movement::rotator:
      return wheels_[1];
  }
  return 0;
}

void SeatPanel::jam(Stick stick, bool is_jammed) {
  const auto place = static_cast<std::size_t>(stick);
  if (is_jammed && !jammed_[place]) jammed_at_[place] = sticks_[place];
  jammed_[place] = is_jammed;
}

cia852::OperatorHardware SeatPanel::hardware() {
  return {.joystick_axis = callback<&SeatPanel::joystick_axis>(*this),
          .joystick_buttons = callback<&SeatPanel::joystick_buttons>(*this),
          .joystick_memory = callback<&SeatPanel::joystick_memory>(*this),
          .foot_pedal = callback<&SeatPanel::foot_pedal>(*this),
          .foot_pedal_memory = callback<&SeatPanel::foot_pedal_memory>(*this),
          .encoder = callback<&SeatPanel::encoder>(*this),
          .wheel = callback<&SeatPanel::wheel_position>(*this),
          .push_buttons = callback<&SeatPanel::push_buttons>(*this),
          .show_indicators = callback<&SeatPanel::show_indicators>(*this),
          .show_parameter = callback<&SeatPanel::show_parameter>(*this)};
}

std::int16_t SeatPanel::sensed(Stick stick) const {
  const auto place = static_cast<std::size_t>(stick);
  constexpr double drift = 0.25;
  if (broken_[place]) return broken_wire_reads;
  const double sensed = jammed_[place] ? jammed_at_[place] : sticks_[place];
  if (!drifting_[place]) return in_digits(sensed);
  return in_digits(sensed > 0.5 ? sensed - drift : sensed + drift);
}

std::int16_t SeatPanel::second_joystick_axis(unsigned joystick, unsigned axis) {
  if (axis > 2) return 0;
  return in_digits(sticks_.at(2 * (joystick - 1) + axis - 1));
}

std::int16_t SeatPanel::joystick_axis(unsigned joystick, unsigned axis) {
  if (axis > 2) return 0;
  return sensed(static_cast<Stick>(2 * (joystick - 1) + axis - 1));
}

/// Contacts that are separate from the sensor of the position.
std::uint8_t SeatPanel::joystick_buttons(unsigned joystick) {
  unsigned bits = joystick == 1 && asks_for_command_ ? command_bit : 0U;
  for (unsigned axis = 0; axis < 2; ++axis) {
    const double place = sticks_[2 * (joystick - std::size_t{1}) + axis];
    if (place < -contact_closes) bits |= 1U << (first_contact_bit + 2 * axis);
    if (place > contact_closes) bits |= 2U << (first_contact_bit + 2 * axis);
  }
  return static_cast<std::uint8_t>(bits);
}

std::int16_t SeatPanel::foot_pedal(unsigned pedal) {
  return in_digits(pedals_.at(pedal - 1));
}

std::int16_t SeatPanel::wheel_position(unsigned wheel) {
  return in_digits(wheels_.at(wheel - 1));
}

std::uint8_t SeatPanel::push_buttons(unsigned cluster, unsigned group) {
  if (cluster != 1 || group != 1) return 0;
  return static_cast<std::uint8_t>(pressed_.to_ulong());
}

void SeatPanel::show_indicators(unsigned cluster, unsigned group, std::uint8_t lit) {
  if (cluster == 1 && group == 1) lit_ = Lamps(lit) & ~burnt_;
  if (cluster == 1 && group == 2) command_lamps_ = lit;
}

void SeatPanel::show_parameter(unsigned display, unsigned parameter, std::int16_t value) {
  if (display != 1 || parameter > display_.size()) return;
  const bool is_first = parameter == 1;
  if (is_first && is_frozen_ && display_[0] != no_value && value != no_value) return;
  display_[parameter - 1] = value;
}

void SeatPanel::go_dark() {
  lit_.reset();
  command_lamps_ = 0;
  display_.fill(no_value);
}

std::optional<std::size_t> SeatPanel::commanding_seat() const {
  if (!std::has_single_bit(command_lamps_)) return std::nullopt;
  return static_cast<std::size_t>(std::countr_zero(command_lamps_));
}

std::uint8_t SeatPanel::contacts() const {
  const unsigned closed = (is_lever_lowered_ ? lever_bit : 0U) |
                          (closes_seat_switch() ? seat_bit : 0U) |
                          (is_stop_pressed_ ? 0U : stop_bit);
  return static_cast<std::uint8_t>(closed);
}

}  // namespace canvoy::excavator
