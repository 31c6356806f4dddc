// Application of the radio of a police car, beside its virtual device: it takes status messages
// from the terminal's number pad, transmits while the handset's contact is closed or hands-free,
// and connects microphones and loudspeaker for that. The emergency key sends status 0, whichever
// client has the terminal.
#pragma once

#include "canvoy/devices/cia447/kit/car_kind.hpp"
#include "canvoy/devices/cia447/kit/car_source.hpp"
#include "canvoy/devices/cia447/kit/command_keeper.hpp"
#include "canvoy/devices/cia447/radio/radio_unit.hpp"
#include "canvoy/profiles/cia447/terminal_handles.hpp"
#include "canvoy/worlds/car/application.hpp"
#include "canvoy/worlds/police/client.hpp"
#include "canvoy/worlds/police/terminal_menu.hpp"

namespace canvoy::police {

/// The radio beside it, and what it reports.
struct RadioControlHardware {
  cia447::RadioUnit* radio = nullptr;           ///< of the same device
  Acted acted = {};                             ///< called at each key that it acts on
  Callback<void(int status)> send_status = {};  ///< on the air, 0 to 9
};
/// Node-IDs of the devices that it uses.
struct RadioControlSettings {
  NodeId terminal = 0;      ///< the terminal
  NodeId audio_switch = 0;  ///< the audio switch
  NodeId hands_free = 0;    ///< the hands-free system
  NodeId handset = 0;       ///< the channel of its microphone
};

class RadioControl {
 public:
  static constexpr std::uint8_t gain = 100;  ///< of the pairs that it connects (6120h)

  /// `network` must outlive this object; it acts once the node runs.
  RadioControl(cia447::CarNetwork& network, const RadioControlHardware& hardware,
               const RadioControlSettings& settings);
  RadioControl(const RadioControl&) = delete;
  RadioControl& operator=(const RadioControl&) = delete;

  /// Presses the button at the radio.
  void press_button();

 private:
  void reset(ResetScope scope);
  void number_pressed(cia447::NumberPadKey key);
  void handset_written(const Entry& entry, Source source);
  void handset_lost();
  void look_at_handset();
  void key_written(const Entry& entry, Source source);
  void key_lost();
  void emergency_written(const Entry& entry, Source source);
  void emergency_lost() { emergency_is_pressed_ = false; }
  void look_at_emergency();
  void look_at_key();
  void talk();
  void connect(unsigned place, NodeId input, NodeId output, bool is_on);

  cia447::CarNetwork& network_;
  RadioControlHardware hardware_;
  RadioControlSettings settings_;
  cia447::TerminalClient terminal_;
  TerminalMenu menu_;
  cia447::CommandKeeper audio_;
  cia447::CommandKeeper hands_free_;
  cia447::CarSource handset_source_;
  cia447::CarSource key_source_;
  cia447::CarSource emergency_source_;
  bool handset_is_pressed_ = false;
  bool key_is_pressed_ = false;
  bool is_hands_free_ = false;
  bool emergency_is_pressed_ = false;
  static const AccessHandlers hook_calls[];
  static const ServiceHandlers service_calls;
  HandlerBinding service_{&service_calls, this};
};

/// A CarUnit beside the virtual device of the radio; it is not in the catalogue.
struct RadioControlKind
    : cia447::CarKind<RadioControl, RadioControlHardware, RadioControlSettings> {
  static constexpr DeviceInfo info = {.name = "radio-control", .title = "control of a radio"};
  static constexpr const VirtualDeviceInfo& provides = car::no_virtual_device;
  /// Keys of the terminal, and what tells when to transmit.
  static constexpr std::array<const ObjectInfo*, 14> consumes = {
      cia447::terminal_keys_objects[0],
      cia447::terminal_keys_objects[1],
      cia447::terminal_keys_objects[2],
      cia447::terminal_keys_objects[3],
      cia447::terminal_keys_objects[4],
      cia447::terminal_keys_objects[5],
      cia447::terminal_keys_objects[6],
      cia447::terminal_keys_objects[7],
      &cia447::discrete_inputs_status_object,
      &cia447::radio_hand_free_status_object,
      &cia447::steering_wheel_switch_pad_status_object,
      &cia447::steering_wheel_switch_pad_user_interaction_object,
      &cia447::emergency_key_status_object,
      &cia447::emergency_key_user_interaction_object};
};

}  // namespace canvoy::police
