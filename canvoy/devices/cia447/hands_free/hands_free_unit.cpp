#include "canvoy/devices/cia447/hands_free/hands_free_unit.hpp"

namespace canvoy::cia447 {

HandsFreeUnit::HandsFreeUnit(CarNetwork& network, const HandsFreeHardware& hardware,
                             const SwitchedSettings& settings)
    : hardware_(hardware),
      unit_(network, {.drive = callback<&HandsFreeUnit::commanded>(*this)}, settings) {}

bool HandsFreeUnit::commanded(const Commanded& wanted) {
  const bool is_on = wanted.as<Order>() == Order::on;
  const bool is_led = wanted.is_for(radio_hand_free_command_indication_led);
  bool& state = is_led ? shows_led_ : is_muted_;
  if (state == is_on) return true;
  state = is_on;
  const auto& tell = is_led ? hardware_.show_led : hardware_.mute;
  if (tell) tell(is_on);
  return true;
}

}  // namespace canvoy::cia447
