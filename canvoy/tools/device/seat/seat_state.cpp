#include "canvoy/tools/device/seat/seat_state.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <limits>
#include <optional>

#include "canvoy/tools/cli/failure.hpp"

namespace canvoy::tools {

namespace {

using Kind = Control::Kind;

constexpr std::string_view directions = "xyz";

/// `name1`, with a number from 1 to `most`; 0 for another name.
unsigned numbered(std::string_view text, std::string_view name, unsigned most) {
  if (!text.starts_with(name)) return 0;
  text.remove_prefix(name.size());
  unsigned number = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  return error == std::errc{} && stop == end && number <= most ? number : 0;
}

/// 1 to 3 for `x`, `y`, `z` after a prefix; 0 if there is none.
unsigned direction(std::string_view text, std::string_view prefix) {
  if (text.size() != prefix.size() + 1 || !text.starts_with(prefix)) return 0;
  const std::size_t place = directions.find(text.back());
  return place == std::string_view::npos ? 0 : static_cast<unsigned>(place + 1);
}

std::optional<Control> control_of_joystick(unsigned joystick, std::string_view part) {
  if (const unsigned axis = direction(part, "")) return Control{Kind::axis, joystick, axis};
  if (const unsigned axis = direction(part, "hold-")) {
    return Control{Kind::joystick_hold, joystick, axis};
  }
  constexpr unsigned buttons = 8;
  if (const unsigned button = numbered(part, "b", buttons)) {
    return Control{Kind::joystick_button, joystick, button};
  }
  return std::nullopt;
}

std::optional<Control> find_control(std::string_view text, const cia852::OperatorEnvironment& has) {
  const std::size_t dot = text.find('.');
  const std::string_view element = text.substr(0, dot);
  const bool is_whole = dot == std::string_view::npos;
  const std::string_view part = is_whole ? std::string_view() : text.substr(dot + 1);
  if (const unsigned joystick = numbered(element, "joystick", has.joysticks)) {
    return control_of_joystick(joystick, part);
  }
  if (const unsigned pedal = numbered(element, "foot-pedal", has.foot_pedals)) {
    if (is_whole) return Control{Kind::foot_pedal, pedal, 1};
    if (part == "hold") return Control{Kind::foot_pedal_hold, pedal, 1};
  }
  if (const unsigned encoder = numbered(element, "encoder", has.encoders); is_whole && encoder) {
    return Control{Kind::encoder, encoder, 1};
  }
  if (const unsigned wheel = numbered(element, "wheel", has.wheels); is_whole && wheel) {
    return Control{Kind::wheel, wheel, 1};
  }
  constexpr unsigned buttons = 64;
  const unsigned cluster = numbered(element, "push-button-cluster", has.push_button_clusters);
  if (const unsigned button = numbered(part, "b", buttons); cluster != 0 && button != 0) {
    return Control{Kind::push_button, cluster, button};
  }
  return std::nullopt;
}

void set_bit(std::uint8_t& byte, unsigned place, bool is_on) {
  const auto bit = static_cast<std::uint8_t>(1U << place);
  byte = static_cast<std::uint8_t>(is_on ? byte | bit : byte & ~bit);
}

std::int16_t position(std::int64_t value) {
  using Limits = std::numeric_limits<std::int16_t>;
  return static_cast<std::int16_t>(std::clamp<std::int64_t>(value, Limits::min(), Limits::max()));
}

}  // namespace

Control parse_control(const std::string& text, const cia852::OperatorEnvironment& elements) {
  if (const auto control = find_control(text, elements)) return *control;
  throw UsageError(fmt::format(
      "'{}' is nothing to move on this device: joystick1.x, joystick1.b1, joystick1.hold-x, "
      "foot-pedal1, foot-pedal1.hold, encoder1, wheel1, push-button-cluster1.b1",
      text));
}

// Controls that are moved.

void SeatState::set(const Control& control, std::int64_t value) {
  const bool is_on = value != 0;
  const unsigned place = control.element - 1;
  switch (control.kind) {
    case Kind::axis:
      axes_[cia852::joystick_axis_sub(control.element, control.part) - 1] = position(value);
      return;
    case Kind::joystick_button:
      return set_bit(buttons_[place], control.part - 1, is_on);
    case Kind::joystick_hold:
      return set_bit(holds_[place], control.part - 1, is_on);
    case Kind::foot_pedal:
      foot_pedals_[place] = position(value);
      return;
    case Kind::foot_pedal_hold:
      foot_pedal_holds_[place] = is_on;
      return;
    case Kind::encoder:
      encoders_[place] = static_cast<std::uint32_t>(value);
      return;
    case Kind::wheel:
      wheels_[place] = position(value);
      return;
    case Kind::push_button: {
      const unsigned group = (control.part - 1) / switches_of_group + 1;
      return set_bit(push_buttons_[cia852::indicators_sub(control.element, group) - 1],
                     (control.part - 1) % switches_of_group, is_on);
    }
  }
}

void SeatState::turn(const Control& control, std::int64_t steps) {
  const bool is_wheel = control.kind == Kind::wheel;
  const std::int64_t before = is_wheel ? std::int64_t{wheels_[control.element - 1]}
                                       : std::int64_t{encoders_[control.element - 1]};
  set(control, before + steps);
}

cia852::OperatorHardware SeatState::inputs() {
  return {.joystick_axis = callback<&SeatState::axis>(*this),
          .joystick_buttons = callback<&SeatState::buttons>(*this),
          .joystick_memory = callback<&SeatState::holds>(*this),
          .foot_pedal = callback<&SeatState::foot_pedal>(*this),
          .foot_pedal_memory = callback<&SeatState::foot_pedal_holds>(*this),
          .encoder = callback<&SeatState::encoder>(*this),
          .wheel = callback<&SeatState::wheel>(*this),
          .push_buttons = callback<&SeatState::push_buttons>(*this)};
}

}  // namespace canvoy::tools
