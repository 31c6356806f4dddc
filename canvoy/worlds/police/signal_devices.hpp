// Blue light and siren of a police car: roof bar, flashers and their control, with the lamps and
// the loudspeaker that they drive; what people at the road see and hear.
//
//     SignalDevices signals(bus, sabotage, acted);
//     signals.step(now);                    // each 100 ms
//     signals.any_blue_is_seen(now)
#pragma once

#include <array>
#include <cstddef>

#include "canvoy/can/time.hpp"
#include "canvoy/devices/cia447/blue_light/blue_light_unit.hpp"
#include "canvoy/devices/cia447/roof_bar_light/roof_bar_light_unit.hpp"
#include "canvoy/devices/cia447/roof_bar_sound/roof_bar_sound_unit.hpp"
#include "canvoy/worlds/car/car_bus.hpp"
#include "canvoy/worlds/police/client.hpp"
#include "canvoy/worlds/police/police_options.hpp"
#include "canvoy/worlds/police/signal_control.hpp"

namespace canvoy::police {

// Lamps that flash together, like those of a blue light: an observer sees them flash, although each
// of them is dark half of the time.
//
//     FlashingLamps<2> beacons;
//     beacons.drive(0, true);
//     beacons.step(now);            // each step
//     if (beacons.is_seen(now)) ...

/// Lamps that flash together: on for a quarter of a second, and off for one.
template <std::size_t count>
class FlashingLamps {
 public:
  static constexpr Duration period = 500ms;  ///< of the flashing: half of it dark

  /// The output of a lamp, from 0; others are ignored.
  void drive(unsigned lamp, bool is_on) {
    if (lamp < count) is_driven_[lamp] = is_on;
  }
  /// Breaks or replaces a lamp.
  void burn_out(unsigned lamp, bool is_burnt = true) { is_burnt_[lamp] = is_burnt; }
  /// The device has no power: all outputs are off.
  void power_off() { is_driven_.fill(false); }
  /// True if any of them gives visible light.
  bool is_lit(Time now) const {
    if ((now - Time{}) % period >= period / 2) return false;
    for (std::size_t i = 0; i < count; ++i) {
      if (is_driven_[i] && !is_burnt_[i]) return true;
    }
    return false;
  }
  /// True if this lamp gives light at this instant.
  bool is_lit(Time now, unsigned lamp) const {
    return (now - Time{}) % period < period / 2 && is_driven_[lamp] && !is_burnt_[lamp];
  }
  /// People look: call it in each step.
  void step(Time now) {
    if (is_lit(now)) seen_at_ = now;
  }
  /// True if they flashed a moment ago.
  bool is_seen(Time now) const { return now < seen_at_ + period; }

 private:
  std::array<bool, count> is_driven_{};
  std::array<bool, count> is_burnt_{};
  Time seen_at_{-period};
};

inline constexpr unsigned beacon_count = 2;    ///< beacons of the roof bar
inline constexpr unsigned flasher_count = 10;  ///< blue light flashers

class SignalDevices {
 public:
  /// All must outlive this object. `acted` is called for each key on which the control has acted.
  SignalDevices(car::CarBus& bus, const Sabotage& sabotage, const Acted& acted)
      : bus_(bus), sabotage_(sabotage), acted_(acted) {}
  SignalDevices(const SignalDevices&) = delete;
  SignalDevices& operator=(const SignalDevices&) = delete;

  /// Puts its three devices on the bus.
  void add_nodes();
  /// Takes power from one of these devices; does nothing to other nodes.
  void lose_power(NodeId id);
  /// Sets the inputs of a device that gets power.
  void sense(NodeId id);
  /// Breaks the front left flasher. The module detects that no current flows.
  void burn_lamp(bool is_burnt);
  /// Lamps follow their outputs; call it in each step.
  void step(Time now);

  /// True if all groups of blue lamps flash.
  bool all_blue_is_seen(Time now) const { return beacons_.is_seen(now) && flashers_.is_seen(now); }
  /// True if any blue lamp flashes.
  bool any_blue_is_seen(Time now) const { return beacons_.is_seen(now) || flashers_.is_seen(now); }
  /// True if search lamp and both alley lights are lit.
  bool work_light_is_seen() const { return work_lights_ == all_work_lights; }
  /// True if any of them is lit.
  bool any_work_light_is_seen() const { return work_lights_ != 0; }
  /// True if the loudspeaker plays a siren.
  bool siren_is_heard() const { return sound_.sound != cia447::AdditionalSound::none; }
  /// What the loudspeaker plays.
  const cia447::RoofBarSound& sound() const { return sound_; }
  /// True while burn_lamp() has broken it.
  bool has_burnt_lamp() const { return lamp_is_burnt_; }
  /// Lamps of the roof bar.
  const FlashingLamps<beacon_count>& beacons() const { return beacons_; }
  /// Lamps of the flashers.
  const FlashingLamps<flasher_count>& flashers() const { return flashers_; }

 private:
  cia447::SwitchedHardware roof_light_hardware();
  void drive_blue(Callback<void(unsigned, bool)> lamps, unsigned lamp, bool is_on);
  void drive_beacon(unsigned lamp, bool is_on) { beacons_.drive(lamp, is_on); }
  void drive_flasher(unsigned lamp, bool is_on) { flashers_.drive(lamp, is_on); }
  void roof_light_became(const cia447::FieldPlace& status, std::uint32_t code);
  cia447::RoofBarSoundHardware sound_hardware();
  void play(const cia447::RoofBarSound& sound);
  SignalControlHardware control_hardware();
  SignalControlSettings control_settings();
  cia447::SwitchedHardware blue_light_hardware();
  void blue_light_became(const cia447::FieldPlace& status, std::uint32_t code);

  car::CarBus& bus_;
  const Sabotage& sabotage_;
  Acted acted_;
  cia447::BlueLightUnit* blue_light_ = nullptr;
  cia447::RoofBarSoundUnit* sound_unit_ = nullptr;
  FlashingLamps<beacon_count> beacons_;
  FlashingLamps<flasher_count> flashers_;
  cia447::RoofBarSound sound_{};
  bool lamp_is_burnt_ = false;
  static constexpr unsigned all_work_lights = 7;
  unsigned work_lights_ = 0;  ///< one bit for each: search lamp, alley lights right and left
};

}  // namespace canvoy::police
