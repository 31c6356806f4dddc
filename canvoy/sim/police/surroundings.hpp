// What is seen, heard and read of a police car, whatever its devices say: lamps as they flash, the
// sound in the air, wires of microphones and loudspeakers, the transmitter, relays, displays,
// locks.
//
//     surroundings.step(now);
//     surroundings.blue_is_seen(now);
#pragma once

#include <array>
#include <string>

#include "canvoy/can/time.hpp"
#include "canvoy/devices/cia447/roof_bar_sound/roof_bar_sound_unit.hpp"

namespace canvoy::police {

/// Lamps that flash together: on for a quarter of a second, and off for one.
template <std::size_t count>
class FlashingLamps {
 public:
  static constexpr Duration period = 500ms;

  void drive(unsigned lamp, bool is_on) {
    if (lamp < count) is_driven_[lamp] = is_on;
  }
  void burn_out(unsigned lamp, bool is_burnt = true) { is_burnt_[lamp] = is_burnt; }
  void power_off() { is_driven_.fill(false); }
  /// Who looks on sees any of them give light.
  bool is_lit(Time now) const {
    if ((now - Time{}) % period >= period / 2) return false;
    for (std::size_t i = 0; i < count; ++i) {
      if (is_driven_[i] && !is_burnt_[i]) return true;
    }
    return false;
  }
  bool is_lit(Time now, unsigned lamp) const {
    return (now - Time{}) % period < period / 2 && is_driven_[lamp] && !is_burnt_[lamp];
  }
  void step(Time now) {
    if (is_lit(now)) seen_at_ = now;
  }
  /// Flashed a moment ago.
  bool is_seen(Time now) const { return now < seen_at_ + period; }

 private:
  std::array<bool, count> is_driven_{};
  std::array<bool, count> is_burnt_{};
  Time seen_at_{-period};
};

inline constexpr unsigned beacon_count = 2;
inline constexpr unsigned flasher_count = 10;

struct Surroundings {
  FlashingLamps<beacon_count> beacons;
  FlashingLamps<flasher_count> flashers;
  cia447::RoofBarSound sound{};

  /// Wires of the audio switch, by channel.
  std::array<std::array<bool, 17>, 17> wires{};
  bool handset_is_pressed = false;
  bool led_is_lit = false;

  bool radio_has_power = false;  ///< of the power supply
  bool periphery_has_power = false;
  bool radio_is_on = false;
  bool radio_transmits = false;

  std::string title;
  std::string text_1;
  std::string text_2;

  bool is_locked = true;

  void step(Time now) {
    beacons.step(now);
    flashers.step(now);
  }
  bool all_blue_is_seen(Time now) const { return beacons.is_seen(now) && flashers.is_seen(now); }
  bool any_blue_is_seen(Time now) const { return beacons.is_seen(now) || flashers.is_seen(now); }
  bool siren_is_heard() const { return sound.sound != cia447::AdditionalSound::none; }
  /// A receiver near by hears that the channel is not free.
  bool is_on_the_air() const { return radio_has_power && radio_is_on && radio_transmits; }
};

}  // namespace canvoy::police
