// The sound of a roof bar: country-specific and additional sounds, and their volume (6138h to
// 613Bh; CiA 447-3, 4.2.21).
//
//     RoofBarSoundUnit bar(network, {.play = ...}, {.step_per_kmh = 0.2});
//     bar.output().volume;   // what is heard: step 1 to 62
//
// At night, a setting limits the volume. With velocity dependent adjustment, the volume increases
// with the speed of the car, by the wheel rpm from the gateway (6053h); without that value, it is
// the set volume.
#pragma once

#include "canvoy/devices/cia447/kit/car_kind.hpp"
#include "canvoy/devices/cia447/kit/car_source.hpp"
#include "canvoy/devices/cia447/kit/switching.hpp"
#include "canvoy/profiles/cia447/car_handles.hpp"
#include "canvoy/profiles/cia447/devices.hpp"
#include "canvoy/profiles/cia447/roof_bar_handles.hpp"

namespace canvoy::cia447 {

/// State of the loudspeakers.
struct RoofBarSound {
  AdditionalSound sound = AdditionalSound::none;  ///< none: silence
  CountrySound country = CountrySound::none;      ///< for a `sound` of country_specific
  bool is_fast = false;                           ///< double speed
  bool is_city = false;                           ///< variant of the sound for cities
  bool is_test = false;                           ///< acoustic test operation
  unsigned volume = 1;                            ///< step 1 to 62

  bool operator==(const RoofBarSound&) const = default;
};

/// The loudspeakers.
struct RoofBarSoundHardware {
  /// Called on each change.
  Callback<void(const RoofBarSound&)> play = {};
  SwitchedHardware switched = {};  ///< what commands drive
};
/// Sets it to the member functions of a plain class that have these names: see PlainHardware.
template <class Plain>
constexpr void set_by_names(RoofBarSoundHardware& hardware, Plain& plain) {
  static_assert(
      requires { &Plain::play; } || requires { &Plain::drive; } || requires { &Plain::became; },
      "the class has no member function of RoofBarSoundHardware: play, drive or became");
  if constexpr (requires { &Plain::play; }) hardware.play = callback<&Plain::play>(plain);
  if constexpr (requires { &Plain::drive; })
    hardware.switched.drive = callback<&Plain::drive>(plain);
  if constexpr (requires { &Plain::became; })
    hardware.switched.became = callback<&Plain::became>(plain);
}

/// Volume at night and at speed.
struct RoofBarSoundSettings {
  unsigned night_volume_max = 31;      ///< step 1 to 62
  double step_per_kmh = 0.2;           ///< louder with the speed of the car
  double wheel_circumference_m = 2.0;  ///< of the car, for its speed
  SwitchedSettings switched = {};      ///< of the functions that are switched
};

inline constexpr const ObjectInfo* roof_bar_sound_commands[] = {
    &country_specific_sound_command_object, &sound_command_roof_bar_object};
inline constexpr Mirror roof_bar_sound_mirrors[] = {
    {&country_specific_sound_command_object, &country_specific_sound_status_object, 0ms},
    {&sound_command_roof_bar_object, &sound_status_roof_bar_object, 50ms}};
inline constexpr Effect roof_bar_sound_effects[] = {
    effect(sound_command_roof_bar_audio_active, Order::off, sound_status_roof_bar_audio_active,
           Signal::off, 50ms),
    effect(sound_command_roof_bar_audio_active, Order::on, sound_status_roof_bar_audio_active,
           Signal::on, 50ms)};
inline constexpr Rest roof_bar_sound_rests[] = {
    rest(sound_status_roof_bar_speaker, Speaker::ok),
    rest(sound_status_roof_bar_local_voltage, LocalVoltage::ok),
    rest(sound_status_roof_bar_volume, std::uint32_t{30})};
inline constexpr SwitchedTable roof_bar_sound_table = {.commands = roof_bar_sound_commands,
                                                       .mirrors = roof_bar_sound_mirrors,
                                                       .effects = roof_bar_sound_effects,
                                                       .rests = roof_bar_sound_rests};

class RoofBarSoundUnit {
 public:
  static constexpr unsigned volume_max = 62;  ///< greatest step

  /// Everything to which `hardware` and `settings` refer must outlive this.
  RoofBarSoundUnit(CarNetwork& network, const RoofBarSoundHardware& hardware,
                   const RoofBarSoundSettings& settings);

  /// What the loudspeakers give at present.
  const RoofBarSound& output() const { return output_; }
  /// The machine of commands and states.
  Switching& switching() { return unit_.switching(); }

 private:
  void became(const FieldPlace& status, std::uint32_t code);
  void speed_written(Source source);
  void speed_lost();
  void play();
  unsigned volume() const;

  CarNetwork& network_;
  RoofBarSoundHardware hardware_;
  RoofBarSoundSettings settings_;
  RoofBarSound output_{.volume = 31};
  SwitchedUnit<roof_bar_sound_table> unit_;
  CarSource speed_;
  static const AccessHandlers hook_calls[];
  static const ServiceHandlers service_calls;
  HandlerBinding service_{&service_calls, this};
};

/// Catalogue row of the sound of a roof bar (4.2.21); car_unit makes it a part of a device.
struct RoofBarSoundKind : CarKind<RoofBarSoundUnit, RoofBarSoundHardware, RoofBarSoundSettings> {
  static constexpr DeviceInfo info = {.name = "roof-bar-sound",
                                      .title = "sound of a roof bar",
                                      .product = "Canvoy CiA 447 roof bar sound",
                                      .product_code = 44718,
                                      .node_id = 14,
                                      .hardware = "loudspeakers: sound, volume; voltage"};
  static constexpr const VirtualDeviceInfo& provides = roof_bar_sound_device;
  /// All objects of the PDO with the wheel rpm.
  static constexpr std::array<const ObjectInfo*, 3> consumes = {
      &actual_engine_revolutions_object, &wheel_rpm_object, &wheel_pulse_counter_object};
};

}  // namespace canvoy::cia447
