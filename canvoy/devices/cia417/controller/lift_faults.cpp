#include "canvoy/devices/cia417/controller/lift_faults.hpp"

#include <utility>

#include "canvoy/profiles/cia417/errors.hpp"

namespace canvoy::cia417 {

void LiftFaults::begin_anew() {
  now_ = latched_ = LiftFault::none;
  is_opening_late_ = is_closing_late_ = false;
}

bool LiftFaults::change(LiftFault fault) {
  if (fault == now_) return false;
  if (is_there()) tell(static_cast<std::uint16_t>(now_), false);
  if (fault != LiftFault::none) tell(static_cast<std::uint16_t>(fault), true);
  now_ = fault;
  return true;
}

void LiftFaults::doors_opened(bool in_time) {
  if (std::exchange(is_opening_late_, !in_time) == in_time) tell(opens_late, !in_time);
}

void LiftFaults::doors_closed(bool in_time) {
  if (std::exchange(is_closing_late_, !in_time) == in_time) tell(closes_late, !in_time);
}

void LiftFaults::tell(std::uint16_t instance, bool is_present) {
  const Error error{.code = emergency_code::application_error,
                    .instance = instance,
                    .register_bits = error_register::generic | error_register::profile};
  if (is_present) {
    node_.raise(error);
  } else {
    node_.clear(error);
  }
}

}  // namespace canvoy::cia417
