#include "canvoy/tools/device/seat/seat_hands.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <utility>

#include "canvoy/profiles/cia852.hpp"
#include "canvoy/tools/device/hand/hand_rows.hpp"
#include "canvoy/tools/device/seat/seat_state.hpp"

namespace canvoy::tools {

namespace {

using hand_rows::key, hand_rows::number, hand_rows::numbered, hand_rows::whole;
using Kind = Control::Kind;

constexpr hand_rows::HandRange axis_range = {-32768, 32767};

/// Sets `control`; for a numbered hand, the element or part with that number.
auto sets(Control control, unsigned Control::*numbered_by) {
  return [control, numbered_by](SeatState& seat, const HandValue& value, const HandTarget& target) {
    Control moved = control;
    if (target.number != 0) moved.*numbered_by = target.number;
    // A button has a code, other controls a number: the other one is 0.
    seat.set(moved, value.code + std::llround(value.number));
    return true;
  };
}

DeviceHand axis(std::string name, const Control& control) {
  return number<SeatState>(std::move(name), whole(cia852::read_analogue_input_16_bit_object),
                           axis_range, sets(control, &Control::element));
}
DeviceHand button(std::string name, const Control& control,
                  unsigned Control::*numbered_by = &Control::part) {
  return key<SeatState>(std::move(name), whole(cia852::read_input_8_bit_object),
                        sets(control, numbered_by), hand_rows::two_words("released", "pressed"));
}

}  // namespace

std::vector<DeviceHand> seat_hands(const cia852::OperatorEnvironment& elements) {
  constexpr std::string_view directions = "xyz";
  constexpr unsigned buttons_of_joystick = 8;
  constexpr unsigned buttons_of_cluster = 64;
  constexpr double encoder_max = 0xFFFF'FFFF;
  std::vector<DeviceHand> hands;
  for (unsigned stick = 1; stick <= elements.joysticks; ++stick) {
    const std::string name = fmt::format("joystick{}", stick);
    for (unsigned i = 0; i < directions.size(); ++i) {
      hands.push_back(axis(fmt::format("{}.{}", name, directions[i]), {Kind::axis, stick, i + 1}));
    }
    hands.push_back(
        numbered(buttons_of_joystick, button(name + ".b", {Kind::joystick_button, stick, 1})));
    for (unsigned i = 0; i < directions.size(); ++i) {
      hands.push_back(button(fmt::format("{}.hold-{}", name, directions[i]),
                             {Kind::joystick_hold, stick, i + 1}));
    }
  }
  if (elements.foot_pedals > 0) {
    hands.push_back(numbered(elements.foot_pedals, axis("foot-pedal", {Kind::foot_pedal, 1, 1})));
  }
  for (unsigned pedal = 1; pedal <= elements.foot_pedals; ++pedal) {
    hands.push_back(
        button(fmt::format("foot-pedal{}.hold", pedal), {Kind::foot_pedal_hold, pedal, 1}));
  }
  if (elements.encoders > 0) {
    hands.push_back(numbered(
        elements.encoders,
        number<SeatState>("encoder", whole(cia852::read_input_32_bit_object), {0, encoder_max},
                          sets({Kind::encoder, 1, 1}, &Control::element))));
  }
  if (elements.wheels > 0) {
    hands.push_back(numbered(elements.wheels, axis("wheel", {Kind::wheel, 1, 1})));
  }
  for (unsigned cluster = 1; cluster <= elements.push_button_clusters; ++cluster) {
    hands.push_back(numbered(
        buttons_of_cluster,
        button(fmt::format("push-button-cluster{}.b", cluster), {Kind::push_button, cluster, 1})));
  }
  hand_rows::take_clauses(hands, cia852::profile);
  return hands;
}

}  // namespace canvoy::tools
