// Application of the control of blue light and siren, beside the sound of the roof bar, which it
// drives: it takes commands from the function keys of the terminal, and the choice of the sound
// from the number pad; it drives the roof bar's light and the blue light flashers, locks the car,
// and shows on display 2 what is on.
//
//     key 1: blue light; 2: with siren; 3: all off; 4: search lamp and alley lights, on and off; 5:
//     lock; 6: unlock; 7: choose the sound
//
// The siren sounds only when a device has taken the command for blue light, so that people in the
// way see where the sound comes from.
#pragma once

#include <string>

#include "canvoy/devices/cia447/kit/car_kind.hpp"
#include "canvoy/devices/cia447/kit/command_keeper.hpp"
#include "canvoy/devices/cia447/roof_bar_sound/roof_bar_sound_unit.hpp"
#include "canvoy/worlds/car/application.hpp"
#include "canvoy/worlds/police/client.hpp"
#include "canvoy/worlds/police/terminal_menu.hpp"

namespace canvoy::police {

/// The sound beside it, and what it reports.
struct SignalControlHardware {
  cia447::RoofBarSoundUnit* sound = nullptr;  ///< of the same device
  Acted acted = {};                           ///< called at each key that it acts on
};
/// Node-IDs of the devices that it uses.
struct SignalControlSettings {
  NodeId terminal = 0;    ///< the terminal
  NodeId roof_light = 0;  ///< the light of the roof bar
  NodeId blue_light = 0;  ///< the blue light flashers
  NodeId gateway = 0;     ///< the IVN gateway, for the locks
  /// Never gives the number pad back: for tests that this is detected.
  bool hogs_terminal = false;
};

class SignalControl {
 public:
  static constexpr auto blue_key = cia447::FunctionKey::key_1;    ///< without siren
  static constexpr auto siren_key = cia447::FunctionKey::key_2;   ///< with blue light
  static constexpr auto off_key = cia447::FunctionKey::key_3;     ///< of both
  static constexpr auto work_key = cia447::FunctionKey::key_4;    ///< on and off
  static constexpr auto lock_key = cia447::FunctionKey::key_5;    ///< from outside
  static constexpr auto unlock_key = cia447::FunctionKey::key_6;  ///< of the doors
  static constexpr auto sound_key = cia447::FunctionKey::key_7;   ///< choice of the sound

  /// `network` must outlive this object; it acts once the node runs.
  SignalControl(cia447::CarNetwork& network, const SignalControlHardware& hardware,
                const SignalControlSettings& settings);
  SignalControl(const SignalControl&) = delete;
  SignalControl& operator=(const SignalControl&) = delete;

 private:
  void reset(ResetScope scope);
  void function_pressed(cia447::FunctionKey key);
  void number_pressed(cia447::NumberPadKey key);
  void lamps_written(const Entry& entry);
  void drive();
  void sound_siren(Time now);
  void lock(cia447::Locking wanted);
  void show();

  cia447::CarNetwork& network_;
  SignalControlHardware hardware_;
  SignalControlSettings settings_;
  cia447::TerminalClient terminal_;
  TerminalMenu menu_;
  cia447::CommandKeeper roof_light_;
  cia447::CommandKeeper blue_light_;
  cia447::CommandKeeper gateway_;
  bool is_blue_ = false;
  bool has_siren_ = false;
  bool has_work_light_ = false;
  bool siren_sounds_ = false;
  bool has_broken_lamp_ = false;
  cia447::AdditionalSound sound_ = cia447::AdditionalSound::country_specific;
  static const AccessHandlers hook_calls[];
  static const ServiceHandlers service_calls;
  HandlerBinding service_{&service_calls, this};
  Timer siren_;
};

/// A CarUnit beside the virtual device of the sound; it is not in the catalogue.
struct SignalControlKind
    : cia447::CarKind<SignalControl, SignalControlHardware, SignalControlSettings> {
  static constexpr DeviceInfo info = {.name = "signal-control", .title = "control of blue light"};
  static constexpr const VirtualDeviceInfo& provides = car::no_virtual_device;
  /// Keys of the terminal, and states that it shows.
  static constexpr std::array<const ObjectInfo*, 9> consumes = {
      cia447::terminal_keys_objects[0],         cia447::terminal_keys_objects[1],
      cia447::terminal_keys_objects[2],         cia447::terminal_keys_objects[3],
      cia447::terminal_keys_objects[4],         cia447::terminal_keys_objects[5],
      cia447::terminal_keys_objects[6],         cia447::terminal_keys_objects[7],
      &cia447::blue_light_flasher_status_object};
};

}  // namespace canvoy::police
