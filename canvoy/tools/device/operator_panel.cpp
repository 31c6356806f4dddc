#include "canvoy/tools/device/operator_panel.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <limits>

#include "canvoy/tools/device/operator_elements.hpp"
#include "canvoy/tools/duration_argument.hpp"
#include "canvoy/tools/failure.hpp"

namespace canvoy::tools {

namespace {

using Kind = Control::Kind;

constexpr std::string_view directions = "xyz";

/// `name1`, with a number from 1 to `most`; 0 where it is another name.
unsigned numbered(std::string_view text, std::string_view name, unsigned most) {
  if (!text.starts_with(name)) return 0;
  text.remove_prefix(name.size());
  unsigned number = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  return error == std::errc{} && stop == end && number <= most ? number : 0;
}

/// 1 to 3 for `x`, `y`, `z` behind a prefix; 0 where it is none.
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

constexpr unsigned of_group = 8;

void set_bit(std::uint8_t& byte, unsigned place, bool is_on) {
  const auto bit = static_cast<std::uint8_t>(1U << place);
  byte = static_cast<std::uint8_t>(is_on ? byte | bit : byte & ~bit);
}

std::int16_t position(std::int64_t value) {
  using Limits = std::numeric_limits<std::int16_t>;
  return static_cast<std::int16_t>(std::clamp<std::int64_t>(value, Limits::min(), Limits::max()));
}

}  // namespace

void add_operator_panel_options(CLI::App& command, OperatorPanelOptions& options) {
  command.add_option("--elements", options.elements, operator_elements_help);
  command
      .add_option("--move", options.moves,
                  "what is moved or pressed of an operator environment, and when: "
                  "joystick1.x=12000@2s, joystick1.b3=1@2s, joystick1.hold-x=1@2s, foot-pedal1=, "
                  "foot-pedal1.hold=, encoder1=, wheel1=, push-button-cluster1.b13=1@3s")
      ->allow_extra_args(false);
}

Control parse_control(const std::string& text, const cia852::OperatorEnvironment& elements) {
  if (const auto control = find_control(text, elements)) return *control;
  throw UsageError(fmt::format(
      "'{}' is nothing to move on this device: joystick1.x, joystick1.b1, joystick1.hold-x, "
      "foot-pedal1, foot-pedal1.hold, encoder1, wheel1, push-button-cluster1.b1",
      text));
}

// What is moved.

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
      const unsigned group = (control.part - 1) / of_group + 1;
      return set_bit(push_buttons_[cia852::indicators_sub(control.element, group) - 1],
                     (control.part - 1) % of_group, is_on);
    }
  }
}

cia852::OperatorHardware SeatState::inputs() {
  using Byte = std::uint8_t;
  return {.joystick_axis = Callback<std::int16_t(unsigned, unsigned)>::to<&SeatState::axis>(*this),
          .joystick_buttons = Callback<Byte(unsigned)>::to<&SeatState::buttons>(*this),
          .joystick_memory = Callback<Byte(unsigned)>::to<&SeatState::holds>(*this),
          .foot_pedal = Callback<std::int16_t(unsigned)>::to<&SeatState::foot_pedal>(*this),
          .foot_pedal_memory = Callback<bool(unsigned)>::to<&SeatState::foot_pedal_holds>(*this),
          .encoder = Callback<std::uint32_t(unsigned)>::to<&SeatState::encoder>(*this),
          .wheel = Callback<std::int16_t(unsigned)>::to<&SeatState::wheel>(*this),
          .push_buttons = Callback<Byte(unsigned, unsigned)>::to<&SeatState::push_buttons>(*this)};
}

// The panel.

OperatorPanel::OperatorPanel(const OperatorPanelOptions& options, Site& site,
                             const DeviceOutput& output)
    : output_(output), elements_(parse_operator_elements(options.elements)) {
  for (const std::string& text : options.moves) moves_.push_back(parse_move(text));
  std::ranges::stable_sort(moves_, {}, &Move::at);
  site.offer(Callback<cia852::OperatorEnvironment()>::to<&OperatorPanel::elements>(*this));
  site.offer(Callback<cia852::OperatorHardware()>::to<&OperatorPanel::hardware>(*this));
}

OperatorPanel::Move OperatorPanel::parse_move(const std::string& text) const {
  const std::size_t equals = text.find('=');
  const std::size_t at = text.find('@');
  Move move;
  const char* const first = text.data() + std::min(equals, text.size() - 1) + 1;
  const char* const end = text.data() + std::min(at, text.size());
  const bool has_both = equals != std::string::npos && at != std::string::npos && equals < at;
  const auto [stop, error] = std::from_chars(first, std::max(first, end), move.value);
  if (!has_both || error != std::errc{} || stop != end) {
    throw UsageError(fmt::format(
        "--move: '{}' is nothing with a value and a time: write joystick1.x=12000@2s", text));
  }
  move.control = parse_control(text.substr(0, equals), elements_);
  move.at = parse_duration_argument(text.substr(at + 1));
  return move;
}

void OperatorPanel::step(Time now) {
  if (!begin_) begin_ = now;
  for (; done_ < moves_.size() && now - *begin_ >= moves_[done_].at; ++done_) {
    seat_.set(moves_[done_].control, moves_[done_].value);
  }
}

cia852::OperatorHardware OperatorPanel::hardware() {
  cia852::OperatorHardware made = seat_.inputs();
  made.show_indicators =
      Callback<void(unsigned, unsigned, std::uint8_t)>::to<&OperatorPanel::show_indicators>(*this);
  made.show_parameter =
      Callback<void(unsigned, unsigned, std::int16_t)>::to<&OperatorPanel::show_parameter>(*this);
  return made;
}

void OperatorPanel::show_indicators(unsigned cluster, unsigned group, std::uint8_t lit) {
  std::uint8_t& before = lit_[cia852::indicators_sub(cluster, group) - 1];
  const unsigned changed = lit ^ unsigned { before };
  before = lit;
  for (unsigned i = 0; i < of_group; ++i) {
    if ((changed >> i & 1) == 0) continue;
    output_.say("operator",
                fmt::format("indicator {} of cluster {} {}", (group - 1) * of_group + i + 1,
                            cluster, (lit >> i & 1) != 0 ? "on" : "off"));
  }
}

void OperatorPanel::show_parameter(unsigned display, unsigned parameter, std::int16_t value) {
  std::int16_t& before = shown_[cia852::display_sub(display, parameter) - 1];
  if (before == value) return;
  before = value;
  output_.say("operator", fmt::format("display {} parameter {}: {}", display, parameter, value));
}

}  // namespace canvoy::tools
