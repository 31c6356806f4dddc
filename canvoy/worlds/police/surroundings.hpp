// What is heard and read of a police car at one instant, whatever its devices report: the sound in
// the air, the transmitter, relays, displays, locks.
//
//     if (network.around().is_on_the_air()) ...
#pragma once

#include <string>

#include "canvoy/devices/cia447/roof_bar_sound/roof_bar_sound_unit.hpp"

namespace canvoy::police {

struct Surroundings {
  cia447::RoofBarSound sound{};  ///< in the air

  bool radio_has_power = false;      ///< of the power supply
  bool periphery_has_power = false;  ///< of the power supply
  bool radio_is_on = false;          ///< by its own switch
  bool radio_transmits = false;      ///< its transmitter is on

  std::string title;   ///< of display 1
  std::string text_1;  ///< first text of display 1
  std::string text_2;  ///< of display 2

  bool is_locked = true;  ///< the doors

  /// True if a receiver near by detects that the channel is in use.
  bool is_on_the_air() const { return radio_has_power && radio_is_on && radio_transmits; }
};

}  // namespace canvoy::police
