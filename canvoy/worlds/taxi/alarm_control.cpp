#include "canvoy/worlds/taxi/alarm_control.hpp"

#include "canvoy/devices/cia447/kit/commands.hpp"
#include "canvoy/profiles/cia447/radio_handles.hpp"

namespace canvoy::taxi {

namespace {

using cia447::Lamp;

/// Value of 6106h; Fh leaves each of the other lamps unchanged.
constexpr std::uint32_t emergency_light(Lamp lamp) {
  constexpr auto place = cia447::place_of(cia447::tariff_display_lamps_command_1_emcy_light);
  constexpr std::uint32_t mask = ((1U << place.bits) - 1) << place.first_bit;
  return ~mask | static_cast<std::uint32_t>(lamp) << place.first_bit;
}

}  // namespace

AlarmControl::AlarmControl(cia447::CarNetwork& network, const AlarmControlHardware& hardware,
                           const AlarmControlSettings& settings)
    : network_(network),
      hardware_(hardware),
      settings_(settings),
      sign_(network, {.server = settings.sign}),
      call_(callback<&AlarmControl::called>(*this)) {
  alarm(false);
}

void AlarmControl::alarm(bool is_on) {
  constexpr std::uint16_t index = cia447::tariff_display_lamps_command_1_object.index;
  sign_.want(0, {index, 0, emergency_light(is_on ? Lamp::blinking : Lamp::off), 4});
  if (is_on && !is_on_) {
    network_.node().timers().arm(call_, network_.node().now() + settings_.call_takes);
  } else if (!is_on) {
    network_.node().timers().disarm(call_);
  }
  is_on_ = is_on;
}

void AlarmControl::called(Time /*now*/) {
  hardware_.has_called();
}

}  // namespace canvoy::taxi
