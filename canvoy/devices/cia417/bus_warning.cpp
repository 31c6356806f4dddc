#include "canvoy/devices/cia417/bus_warning.hpp"

#include "canvoy/canopen/emergency/error.hpp"
#include "canvoy/profiles/cia417/errors.hpp"

namespace canvoy::cia417 {

constexpr ServiceCalls BusWarning::service_calls = {
    .reset = method<&BusWarning::reset>,
    .bus_state_changed = method<&BusWarning::bus_state_changed>};

/// It ends all errors of communication: this one may be there still.
void BusWarning::reset(ResetScope) {
  bus_state_changed(node_.bus_state());
}

/// Who is bus-off cannot tell, and stays as he was.
void BusWarning::bus_state_changed(BusState state) {
  if (state == BusState::bus_off) return;
  node_.report(
      {.code = emergency_code::can_warning_level, .register_bits = error_register::communication},
      state != BusState::error_active);
}

}  // namespace canvoy::cia417
