#include "canvoy/devices/cia417/kit/bus_warning.hpp"

#include "canvoy/canopen/protocol/error.hpp"
#include "canvoy/profiles/cia417/errors.hpp"

namespace canvoy::cia417 {

constexpr ServiceHandlers BusWarning::service_calls = {
    .reset = method<&BusWarning::reset>,
    .bus_state_changed = method<&BusWarning::bus_state_changed>};

/// It ends all communication errors: this one may still exist.
void BusWarning::reset(ResetScope) {
  bus_state_changed(node_.bus_state());
}

/// A node in bus-off cannot report, and its state stays.
void BusWarning::bus_state_changed(BusState state) {
  if (state == BusState::bus_off) return;
  node_.report(
      {.code = emergency_code::can_warning_level, .register_bits = error_register::communication},
      state != BusState::error_active);
}

}  // namespace canvoy::cia417
