#include "canvoy/tools/device/device_wires.hpp"

#include <fmt/format.h>

#include <cmath>

#include "canvoy/profiles/cia417.hpp"
#include "canvoy/tools/device/wired_hands.hpp"

namespace canvoy::tools {

namespace {

/// `Standard hall call acknowledgement 1`: the word of the profile, and the sub-function.
std::string name_of(cia417::BasicFunction function, std::uint8_t sub_function) {
  constexpr ValueInfo functions = {.names = cia417::output_function_names};
  const NamedValue* name = find_name(functions, static_cast<std::int64_t>(function), 8, false);
  const std::string_view word = name == nullptr ? "" : name->name;
  if (function == cia417::BasicFunction::special_function) {
    constexpr ValueInfo specials = {.names = cia417::special_acknowledgement_names};
    if (const NamedValue* special = find_name(specials, sub_function, 8, false)) {
      return std::string(special->name);
    }
  }
  return fmt::format("{} {}", word, sub_function);
}

}  // namespace

DeviceWires::DeviceWires(std::string_view device, DeviceHardware& hardware,
                         Environment& environment, const DeviceOutput& output)
    : device_(device),
      hardware_(hardware),
      output_(output),
      hands_(wired_hands(device, environment)),
      io_(output),
      sensors_(cia417::sensors_at(environment.lift, static_cast<std::uint8_t>(environment.floor))),
      orders_({{device_, hands_}}) {
  using cia417::InputPanelUnit, cia417::OutputPanelUnit, cia417::SensorUnit;
  io_.join(environment);
  environment.provide(callback<&DeviceWires::lamps>(*this));
  environment.provide(callback<&DeviceWires::sensors>(*this));
  environment.watch(inputs_);
  environment.watch(outputs_);
  environment.watch(sensor_unit_);
}

void DeviceWires::step(Node& node, Time now) {
  orders_.step(node, now, [this, now](const HandOrder& order) { act(order, now); });
}

void DeviceWires::act(const HandOrder& order, Time now) {
  if (order.hand->act({.unit = static_cast<WiredThings*>(this), .number = order.number, .now = now},
                      order.value))
    return;
  output_.say(device_, fmt::format("{}: not here", order.hand->name));
}

bool DeviceWires::press(cia417::BasicFunction function, std::uint8_t sub_function,
                        const HandValue& value, Time now) {
  bool is_there = false;
  for (std::uint32_t i = 0; inputs_ != nullptr && i < inputs_->size(); ++i) {
    const cia417::VirtualInput record = inputs_->input(i);
    if (record.function != function || record.sub_function != sub_function) continue;
    is_there = true;
    if (const auto condition = wired_condition<cia417::CallRequest>(value)) {
      inputs_->report(i, *condition, now);
    } else {
      inputs_->set_level(i, value.code != 0, now);
    }
  }
  return is_there;
}

bool DeviceWires::set_sensor(cia417::SensorFunction sensor, const HandValue& value, Time now) {
  if (sensor_unit_ == nullptr) return false;
  const auto number = static_cast<std::uint32_t>(cia417::sensor_number(sensor));
  if (const auto condition = wired_condition<cia417::SensorSignal>(value)) {
    sensor_unit_->report(number, *condition, now);
  } else if (cia417::is_measured(sensor)) {
    sensor_unit_->set_value(number, static_cast<std::int16_t>(std::lround(value.number)), now);
  } else {
    sensor_unit_->set_level(number, value.code != 0, now);
  }
  return true;
}

bool DeviceWires::set_input(unsigned number, bool is_on) {
  io_.set_input(number, is_on);
  return true;
}

bool DeviceWires::set_analogue_input(unsigned number, std::int16_t value) {
  io_.set_analogue_input(number, value);
  return true;
}

/// True if the sensors of the lift units have changed.
bool DeviceWires::look() {
  hardware_.lift_units().look();
  return true;
}

bool DeviceWires::set_door_fault(bool lift::DoorFaults::*fault, bool is_there, Time now) {
  lift::DoorPlant& door = hardware_.lift_units().door();
  lift::DoorFaults faults = door.faults();
  faults.*fault = is_there;
  door.set_faults(now, faults);
  return look();
}

bool DeviceWires::put_in_door(bool is_there, Time now) {
  hardware_.lift_units().door().stand_in_way(now, is_there);
  return look();
}

bool DeviceWires::approach_door(bool is_near) {
  hardware_.lift_units().door().approach(is_near);
  return look();
}

bool DeviceWires::touch_door(bool is_touched) {
  hardware_.lift_units().door().touch_edge(is_touched);
  return look();
}

bool DeviceWires::set_load(double kilograms) {
  hardware_.lift_units().cell().set_load(kilograms);
  return look();
}

bool DeviceWires::break_rope_sensor(bool is_broken) {
  hardware_.lift_units().cell().break_sensor(is_broken ? 1 : 0);
  return look();
}

bool DeviceWires::open_safety_chain(bool is_open) {
  car()->cut(is_open);
  return true;
}

bool DeviceWires::catch_safety_gear(bool is_caught) {
  is_caught ? car()->arrest() : car()->release_gear();
  return true;
}

cia417::OutputHardware DeviceWires::lamps() {
  return {.show = callback<&DeviceWires::show>(*this)};
}

void DeviceWires::show(std::uint32_t number, const cia417::OutputView& view) {
  if (views_.size() <= number) views_.resize(number + 1);
  if (views_[number] == view) return;
  const bool was_on = views_[number].on;
  views_[number] = view;
  if ((!view.on && !was_on) || outputs_ == nullptr) return;
  const cia417::VirtualOutput record = outputs_->output(number);
  output_.say(device_,
              fmt::format("{}: {}{}", name_of(record.function, view.sub_function),
                          view.on ? "on" : "off", view.flash_millihertz != 0 ? ", flashing" : ""));
}

}  // namespace canvoy::tools
