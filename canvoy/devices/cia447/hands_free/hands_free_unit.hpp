// Hand-free conversation by radio: a key for the driver, an LED that shows that the radio is
// active, and the muting of other audio (6150h, 6151h; CiA 447-3, 4.2.23).
//
//     HandsFreeUnit hands_free(network, {.show_led = ..., .mute = ...}, {});
//     hands_free.press_key(true);
#pragma once

#include "canvoy/devices/cia447/kit/car_kind.hpp"
#include "canvoy/devices/cia447/kit/switching.hpp"
#include "canvoy/profiles/cia447/devices.hpp"
#include "canvoy/profiles/cia447/radio_handles.hpp"

namespace canvoy::cia447 {

/// The LED and the loudspeakers.
struct HandsFreeHardware {
  // Called when LED and mute are switched on or off.
  Callback<void(bool is_on)> show_led = {};  ///< LED that shows the active radio
  Callback<void(bool is_muted)> mute = {};   ///< of other audio
};
/// Sets it to the member functions of a plain class that have these names: see PlainHardware.
template <class Plain>
constexpr void set_by_names(HandsFreeHardware& hardware, Plain& plain) {
  static_assert(
      requires { &Plain::show_led; } || requires { &Plain::mute; },
      "the class has no member function of HandsFreeHardware: show_led or mute");
  if constexpr (requires { &Plain::show_led; })
    hardware.show_led = callback<&Plain::show_led>(plain);
  if constexpr (requires { &Plain::mute; }) hardware.mute = callback<&Plain::mute>(plain);
}

inline constexpr const ObjectInfo* hands_free_commands[] = {&radio_hand_free_command_object};
inline constexpr Rest hands_free_rests[] = {rest(radio_hand_free_status_key, Signal::no)};
inline constexpr SwitchedTable hands_free_table = {.commands = hands_free_commands,
                                                   .rests = hands_free_rests};

class HandsFreeUnit {
 public:
  /// Everything to which `hardware` and `settings` refer must outlive this.
  HandsFreeUnit(CarNetwork& network, const HandsFreeHardware& hardware,
                const SwitchedSettings& settings);

  /// Reports the driver's key.
  void press_key(bool is_pressed) {
    switching().report(radio_hand_free_status_key, is_pressed ? Signal::yes : Signal::no);
  }
  /// True while the LED is on.
  bool shows_led() const { return shows_led_; }
  /// True while other audio is muted.
  bool is_muted() const { return is_muted_; }
  /// To report a failed key.
  Switching& switching() { return unit_.switching(); }

 private:
  bool commanded(const Commanded& wanted);

  HandsFreeHardware hardware_;
  bool shows_led_ = false;
  bool is_muted_ = false;
  SwitchedUnit<hands_free_table> unit_;
};

/// Catalogue row of the hand-free conversation by radio (4.2.23);
/// car_unit makes it a part of a device.
struct HandsFreeKind : CarKind<HandsFreeUnit, HandsFreeHardware, SwitchedSettings> {
  static constexpr DeviceInfo info = {.name = "hands-free",
                                      .title = "hand-free conversation by radio",
                                      .product = "Canvoy CiA 447 hands-free",
                                      .product_code = 44720,
                                      .node_id = 6,
                                      .hardware = "key, LED, mute"};
  static constexpr const VirtualDeviceInfo& provides = radio_hand_free_conversation_device;
};

}  // namespace canvoy::cia447
