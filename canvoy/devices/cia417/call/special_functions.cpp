#include "canvoy/devices/cia417/call/special_functions.hpp"

#include <algorithm>

namespace canvoy::cia417 {

namespace {

bool toggles(SpecialFunction function) {
  return function == SpecialFunction::fan_1 || function == SpecialFunction::fan_2 ||
         function == SpecialFunction::load_time_1 || function == SpecialFunction::load_time_2;
}
bool stays_when_defective(SpecialFunction function) {
  return function == SpecialFunction::fire_service_enable ||
         function == SpecialFunction::fire_service || function == SpecialFunction::out_of_order;
}

}  // namespace

bool SpecialFunctions::take(const VirtualInput& input) {
  if (input.sub_function == 0 || input.sub_function >= count) return false;
  const auto number = static_cast<SpecialFunction>(input.sub_function);
  Function& function = at(number);
  const bool requested = input.request() == CallRequest::request;
  const bool works = requested || input.request() == CallRequest::none;
  if (!works && stays_when_defective(number)) return false;
  if (toggles(number) && !input.locks()) {
    if (!requested) return false;
    set(number, !function.on);
  } else {
    request({input.sub_function, input.floor, input.doors}, requested);
  }
  function.wants_answer = true;
  function.floor = input.floor;
  function.doors = input.doors;
  return true;
}

bool SpecialFunctions::take_reading(const VirtualInput& input) {
  if (input.sub_function == 0 || input.sub_function >= count) return false;
  const auto number = static_cast<SpecialFunction>(input.sub_function);
  if (toggles(number) && !input.locks()) return false;
  const Input read{input.sub_function, input.floor, input.doors};
  const bool is_known = std::ranges::find(inputs_, read) != inputs_.end();
  const bool requested = input.request() == CallRequest::request;
  return requested != is_known && take(input);
}

/// An end by an input that is not remembered ends the function if no other input requests it.
void SpecialFunctions::request(const Input& input, bool on) {
  Function& function = functions_[input.function];
  const auto known = std::ranges::find(inputs_, input);
  if (on && known == inputs_.end()) {
    const auto room = std::ranges::find(inputs_, Input{});
    if (room != inputs_.end()) {
      *room = input;
    } else {
      function.is_set = true;
    }
  } else if (!on && known != inputs_.end()) {
    *known = {};
  } else if (!on) {
    function.is_set = false;
  }
  function.on = function.is_set || is_requested(input.function);
  function.was_on = function.was_on || function.on;
}

bool SpecialFunctions::is_requested(std::uint8_t function) const {
  return std::ranges::find(inputs_, function, &Input::function) != inputs_.end();
}

bool SpecialFunctions::is_on_wherever(SpecialFunction key, SpecialFunction button) const {
  const auto number = static_cast<std::uint8_t>(key);
  if (std::ranges::count(inputs_, number, &Input::function) <= 1) return is_on(button);
  return std::ranges::all_of(inputs_, [&](const Input& place) {
    const Input there{static_cast<std::uint8_t>(button), place.floor, place.doors};
    return place.function != number || std::ranges::find(inputs_, there) != inputs_.end();
  });
}

void SpecialFunctions::set(SpecialFunction number, bool on) {
  Function& function = at(number);
  function.is_set = on;
  function.on = on || is_requested(static_cast<std::uint8_t>(number));
  function.was_on = function.was_on || function.on;
}

void SpecialFunctions::clear() {
  functions_ = {};
  inputs_ = {};
}

void SpecialFunctions::report_again() {
  for (Function& function : functions_) {
    function.wants_answer = function.wants_answer || function.was_on;
  }
}

bool SpecialFunctions::waits() const {
  for (const Function& function : functions_) {
    if (function.wants_answer || function.on != function.told) return true;
  }
  return false;
}

VirtualOutput SpecialFunctions::next(std::uint8_t lifts) {
  VirtualOutput output{.function = BasicFunction::special_function, .lifts = lifts};
  for (std::size_t i = 1; i < functions_.size(); ++i) {
    Function& function = functions_[i];
    if (!function.wants_answer && function.on == function.told) continue;
    function.wants_answer = false;
    function.told = function.on;
    output.sub_function = static_cast<std::uint8_t>(i);
    output.floor = function.floor;
    output.doors = function.doors;
    output.data = output_data(function.on, Property::standard, 0, function.on);
    return output;
  }
  return output;
}

}  // namespace canvoy::cia417
