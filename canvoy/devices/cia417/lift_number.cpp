#include "canvoy/devices/cia417/lift_number.hpp"

#include <bit>

namespace canvoy::cia417 {

constexpr HookCalls LiftNumber::hook_calls[] = {{.first = lift_number_object.index,
                                                 .last = lift_number_object.index,
                                                 .before_write = method<&LiftNumber::before_write>,
                                                 .after_write = method<&LiftNumber::written>}};

LiftNumber::LiftNumber(Node& node, const LiftNumberSettings& settings)
    : node_(node), settings_(settings) {
  node.dictionary().attach(hooks_);
}

std::uint8_t LiftNumber::lifts() const {
  return static_cast<std::uint8_t>(node_.dictionary().number(lift_number_object.index, 0));
}

AbortCode LiftNumber::before_write(const Entry&, std::span<const std::uint8_t> value) {
  const std::uint8_t lifts = value[0];
  const bool is_one = std::has_single_bit(lifts);
  if (lifts == 0 || (!is_one && !settings_.several)) return AbortCode::value_range;
  const bool has_objects = (lifts & ~lifts_of(node_.dictionary().tables())) == 0;
  return has_objects || settings_.changed ? AbortCode::none : AbortCode::value_range;
}

void LiftNumber::written(const Entry&, Source) {
  if (settings_.changed) settings_.changed(lifts());
}

}  // namespace canvoy::cia417
