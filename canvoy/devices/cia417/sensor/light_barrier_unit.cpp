#include "canvoy/devices/cia417/sensor/light_barrier_unit.hpp"

#include "canvoy/profiles/cia417/errors.hpp"

namespace canvoy::cia417 {

constexpr ServiceHandlers LightBarrierUnit::service_calls = {.reset =
                                                                 method<&LightBarrierUnit::reset>};

LightBarrierUnit::LightBarrierUnit(Node& node, const LightBarrierHardware& hardware,
                                   const LightBarrierSettings& settings)
    : node_(node),
      hardware_(hardware),
      settings_(settings),
      timer_(callback<&LightBarrierUnit::look>(*this)) {
  seen_.fill(Detection::not_available);
  node.attach(service_);
}

void LightBarrierUnit::reset(ResetScope scope) {
  // A reset of the node ends all errors.
  if (scope == ResetScope::node) seen_.fill(Detection::not_available);
  look(node_.now());
}

void LightBarrierUnit::look(Time now) {
  if (settings_.sensing_period > Duration::zero()) {
    node_.timers().arm(timer_, now + settings_.sensing_period);
  }
  for (unsigned door = 1; door <= door_count; ++door) {
    if ((settings_.doors >> (door - 1) & 1) == 0) continue;
    const Detection seen = hardware_.sense(door);
    if (seen != seen_[door - 1]) tell(door, seen);
  }
}

void LightBarrierUnit::tell(unsigned door, Detection seen) {
  const Error defect = {.code = emergency_code::light_barrier_defect,
                        .instance = static_cast<std::uint16_t>(door)};
  const bool was_defect = seen_[door - 1] == Detection::error;
  seen_[door - 1] = seen;
  Values(node_.dictionary())[in_lift(settings_.lift, light_barrier_status(door))] = seen;
  if (seen == Detection::error) {
    node_.raise(defect);
  } else if (was_defect) {
    node_.clear(defect);
  }
}

}  // namespace canvoy::cia417
