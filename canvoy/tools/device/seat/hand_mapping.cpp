#include "canvoy/tools/device/seat/hand_mapping.hpp"

#include <fmt/format.h>
#include <libevdev/libevdev.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include "canvoy/tools/cli/failure.hpp"

namespace canvoy::tools {

namespace {

using SixteenBits = std::numeric_limits<std::int16_t>;

/// Values of evdev have 32 bits.
constexpr Range<double> axis_values = {-2147483648.0, 2147483647.0};

bool is_moved(Control::Kind kind) {
  using Kind = Control::Kind;
  return kind == Kind::axis || kind == Kind::foot_pedal || kind == Kind::wheel ||
         kind == Kind::encoder;
}

/// The code of one of `types`, by its Linux name.
HandCode take_code(TomlTable& table, std::initializer_list<unsigned> types, const char* example) {
  std::string name;
  table.take("code", name);
  for (const unsigned type : types) {
    const int code = libevdev_event_code_from_name(type, name.c_str());
    if (code >= 0) return {type, static_cast<unsigned>(code)};
  }
  table.refuse("code",
               fmt::format("'{}' is none that Linux has here: write it as {}", name, example));
}

/// The control of `key`; errors give its line.
Control take_control(TomlTable& table, const char* key,
                     const cia852::OperatorEnvironment& elements) {
  std::string text;
  table.take(key, text);
  try {
    return parse_control(text, elements);
  } catch (const UsageError& error) {
    table.refuse(key, error.what());
  }
}

void take_value(TomlTable& table, const char* key, std::optional<double>& to) {
  if (!table.has(key)) return;
  double value = 0;
  table.take(key, value, axis_values);
  to = value;
}

HandAxis take_absolute(TomlTable& table, HandAxis axis) {
  AxisCalibration& calibration = axis.calibration;
  take_value(table, "least", calibration.least);
  take_value(table, "centre", calibration.centre);
  take_value(table, "most", calibration.most);
  table.take("dead-band", calibration.dead_band, {0, axis_values.most});
  table.take("inverted", calibration.is_inverted);
  return axis;
}
HandAxis take_relative(TomlTable& table, HandAxis axis) {
  using Kind = Control::Kind;
  if (axis.control.kind != Kind::wheel && axis.control.kind != Kind::encoder) {
    table.refuse("moves", "a relative axis turns an encoder or a wheel");
  }
  double step = axis.step;
  table.take("step", step, {-32'768, 32'767});
  if (step == 0 || step != std::trunc(step)) table.refuse("step", "write a whole number, not 0");
  axis.step = static_cast<std::int32_t>(step);
  return axis;
}

HandAxis take_axis(TomlTable& table, const cia852::OperatorEnvironment& elements) {
  HandAxis axis;
  axis.code = take_code(table, {EV_ABS, EV_REL}, "ABS_X or REL_WHEEL");
  axis.control = take_control(table, "moves", elements);
  if (!is_moved(axis.control.kind))
    table.refuse("moves", "this is pressed: map it as a [[button]]");
  axis = axis.code.type == EV_REL ? take_relative(table, axis) : take_absolute(table, axis);
  table.finish();
  return axis;
}

HandButton take_button(TomlTable& table, const cia852::OperatorEnvironment& elements) {
  HandButton button;
  button.code = take_code(table, {EV_KEY}, "BTN_TRIGGER or KEY_A");
  button.control = take_control(table, "presses", elements);
  if (is_moved(button.control.kind))
    table.refuse("presses", "this is moved: map it as an [[axis]]");
  table.finish();
  return button;
}

/// `indicator-cluster1.i3`.
HandLight take_light(TomlTable& table, const cia852::OperatorEnvironment& elements) {
  HandLight light;
  light.code = take_code(table, {EV_LED}, "LED_MUTE");
  std::string text;
  table.take("shows", text);
  constexpr std::string_view name = "indicator-cluster";
  constexpr std::string_view part = ".i";
  const std::string_view all = text;
  const std::size_t dot = all.find(part);
  const auto number = [](std::string_view digits, unsigned most) {
    unsigned value = 0;
    const char* const end = digits.data() + digits.size();
    const auto [stop, error] = std::from_chars(digits.data(), end, value);
    return error == std::errc{} && stop == end && value <= most ? value : 0U;
  };
  constexpr unsigned indicators = 64;
  if (all.starts_with(name) && dot != std::string_view::npos) {
    light.cluster = number(all.substr(name.size(), dot - name.size()), elements.indicator_clusters);
    light.indicator = number(all.substr(dot + part.size()), indicators);
  }
  if (dot == std::string_view::npos || light.cluster == 0 || light.indicator == 0 ||
      !all.starts_with(name)) {
    table.refuse("shows", fmt::format("'{}' is no indicator of this device: write it as "
                                      "indicator-cluster1.i1",
                                      text));
  }
  table.finish();
  return light;
}

/// No axis, button or light of the device is used twice.
template <class Item>
void check_once(TomlTable& table, const std::vector<Item>& before, const Item& item) {
  const bool is_there =
      std::ranges::any_of(before, [&item](const Item& other) { return other.code == item.code; });
  if (is_there) table.refuse("code", fmt::format("{} is given twice", code_text(item.code)));
}

}  // namespace

AxisCalibration AxisCalibration::completed(double least_of_device, double most_of_device,
                                           bool is_pedal) const {
  AxisCalibration whole = *this;
  if (!whole.least) whole.least = least_of_device;
  if (!whole.most) whole.most = most_of_device;
  const double rest = whole.is_inverted ? *whole.most : *whole.least;
  if (!whole.centre) whole.centre = is_pedal ? rest : (*whole.least + *whole.most) / 2;
  return whole;
}

std::string AxisCalibration::complaint() const {
  const double low = least.value_or(0);
  const double middle = centre.value_or(0);
  const double high = most.value_or(0);
  if (low >= high) return fmt::format("least {} is not below most {}", low, high);
  if (middle < low || middle > high) {
    return fmt::format("centre {} is not from {} to {}", middle, low, high);
  }
  const double below = middle - low;
  const double above = high - middle;
  const bool leaves_some = (below == 0 || dead_band < below) && (above == 0 || dead_band < above);
  return leaves_some ? "" : fmt::format("dead-band {} leaves nothing to move", dead_band);
}

std::int16_t AxisCalibration::position(double value) const {
  const double sign = is_inverted ? -1 : 1;
  const double middle = centre.value_or(0);
  const double off = (value - middle) * sign;
  const bool is_above = off > 0;
  const double beyond = std::abs(off) - dead_band;
  if (beyond <= 0) return 0;
  const bool goes_up = is_above != is_inverted;
  const double room =
      (goes_up ? most.value_or(0) - middle : middle - least.value_or(0)) - dead_band;
  const double full = is_above ? SixteenBits::max() : -double{SixteenBits::min()};
  const double part = room <= 0 ? 0 : std::min(beyond / room, 1.0);
  return static_cast<std::int16_t>(std::lround((is_above ? full : -full) * part));
}

std::string code_text(HandCode code) {
  const char* const name = libevdev_event_code_get_name(code.type, code.code);
  return name == nullptr ? fmt::format("code {} of type {}", code.code, code.type) : name;
}

HandMapping read_hand_mapping(TomlFile& file, const cia852::OperatorEnvironment& elements) {
  HandMapping mapping;
  TomlTable& root = file.table();
  root.take("device", mapping.device);
  if (mapping.device.empty()) root.refuse("device: write which, as \"/dev/input/event5\"");
  for (TomlTable& table : root.tables("axis")) {
    const HandAxis axis = take_axis(table, elements);
    check_once(table, mapping.axes, axis);
    mapping.axes.push_back(axis);
  }
  for (TomlTable& table : root.tables("button")) {
    const HandButton button = take_button(table, elements);
    check_once(table, mapping.buttons, button);
    mapping.buttons.push_back(button);
  }
  for (TomlTable& table : root.tables("light")) {
    const HandLight light = take_light(table, elements);
    check_once(table, mapping.lights, light);
    mapping.lights.push_back(light);
  }
  root.finish();
  if (mapping.axes.empty() && mapping.buttons.empty() && mapping.lights.empty()) {
    root.refuse("there is nothing in it: write an [[axis]], a [[button]] or a [[light]]");
  }
  return mapping;
}

void check_hand_mappings(const std::vector<HandMapping>& mappings) {
  std::vector<Control> moved;
  std::vector<std::string> devices;
  const auto take = [&moved](const Control& control, HandCode code, const std::string& device) {
    if (std::ranges::find(moved, control) != moved.end()) {
      throw UsageError(
          fmt::format("--joystick: {} of {} moves what another one does", code_text(code), device));
    }
    moved.push_back(control);
  };
  for (const HandMapping& mapping : mappings) {
    if (std::ranges::find(devices, mapping.device) != devices.end()) {
      throw UsageError(fmt::format("--joystick: {} is given twice", mapping.device));
    }
    devices.push_back(mapping.device);
    for (const HandAxis& axis : mapping.axes) take(axis.control, axis.code, mapping.device);
    for (const HandButton& button : mapping.buttons) {
      take(button.control, button.code, mapping.device);
    }
  }
}

}  // namespace canvoy::tools
