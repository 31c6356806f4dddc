#include "canvoy/devices/cia417/special_functions.hpp"

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
    function.on = !function.on;
  } else {
    function.on = requested;
  }
  function.wants_answer = true;
  function.floor = input.floor;
  function.doors = input.doors;
  return true;
}

void SpecialFunctions::set(SpecialFunction function, bool on) {
  at(function).on = on;
}

void SpecialFunctions::clear() {
  for (Function& function : functions_) function.on = function.told = function.wants_answer = false;
}

void SpecialFunctions::tell_again() {
  for (Function& function : functions_) function.told = function.told && !function.on;
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
