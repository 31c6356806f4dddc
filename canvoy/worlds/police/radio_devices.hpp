// The path of speech in a police car: the handset and the hands-free system, the audio switch that
// connects microphones and loudspeaker, and the radio with its transmitter.
//
//     RadioDevices radio(bus, options, supply, acted, events);
//     radio.lift_handset(true);
//     if (radio.carries_from_car()) ...     // what is said in the car is on the air
#pragma once

#include <array>

#include "canvoy/devices/cia447/audio_switch/audio_switch_unit.hpp"
#include "canvoy/devices/cia447/discrete_inputs/discrete_inputs_unit.hpp"
#include "canvoy/devices/cia447/hands_free/hands_free_unit.hpp"
#include "canvoy/devices/cia447/kit/car_kind.hpp"
#include "canvoy/devices/cia447/kit/car_source.hpp"
#include "canvoy/devices/cia447/kit/command_keeper.hpp"
#include "canvoy/devices/cia447/radio/radio_unit.hpp"
#include "canvoy/profiles/cia447/terminal_handles.hpp"
#include "canvoy/sim/event_log.hpp"
#include "canvoy/worlds/car/application.hpp"
#include "canvoy/worlds/car/car_bus.hpp"
#include "canvoy/worlds/police/client.hpp"
#include "canvoy/worlds/police/police_event.hpp"
#include "canvoy/worlds/police/police_options.hpp"
#include "canvoy/worlds/police/supply_device.hpp"
#include "canvoy/worlds/police/terminal_menu.hpp"

namespace canvoy::police {

// Application of the radio of a police car, beside its virtual device: it takes status messages
// from the terminal's number pad, transmits while the handset's contact is closed or hands-free,
// and connects microphones and loudspeaker for that. The emergency key sends status 0, whichever
// client has the terminal.

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

/// The application of the radio of a police car, beside its virtual devices.
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

class RadioDevices {
 public:
  /// All must outlive this object. `acted` is called for each key on which the radio has acted.
  RadioDevices(car::CarBus& bus, const Sabotage& sabotage, const SupplyDevice& supply,
               const Acted& acted, EventLog<PoliceEvent>& events)
      : bus_(bus), sabotage_(sabotage), supply_(supply), acted_(acted), events_(events) {}
  RadioDevices(const RadioDevices&) = delete;
  RadioDevices& operator=(const RadioDevices&) = delete;

  /// Puts radio, audio switch and hands-free system on the bus.
  void add_nodes();
  /// Adds the inputs of the handset.
  void add_inputs();
  /// Takes power from one of these devices; does nothing to other nodes.
  void lose_power(NodeId id);
  /// Sets the inputs of a device that gets power.
  void sense(NodeId id);

  // Actions of hands.
  /// Closes or opens the contact of the handset.
  void lift_handset(bool is_pressed);
  /// Presses the key of the hands-free system.
  void press_hands_free();
  /// Presses the button at the radio.
  void press_button();

  // Visible and audible state.
  /// True if the LED beside the key of the hands-free system is lit: the radio is active.
  bool led_is_lit() const { return led_is_lit_; }
  /// True if the radio is on.
  bool is_on() const { return is_on_; }
  /// True while the transmitter is on.
  bool transmits() const { return transmits_; }
  /// True if a receiver near by detects that the channel is in use.
  bool is_on_the_air() const { return supply_.radio_has_power() && is_on_ && transmits_; }
  /// True if speech passes from the handset's microphone, or from that of the hands-free system,
  /// through the audio switch into the radio, and on the air.
  bool carries_from_car() const;
  /// True if speech passes from the radio to the loudspeaker.
  bool carries_to_car() const;
  /// Sets the function that is called for each status message that the control room receives.
  void on_status(Callback<void(int)> heard) { status_heard_ = heard; }
  /// Number of status messages that the control room has received.
  unsigned statuses() const { return statuses_; }

 private:
  cia447::SwitchedHardware radio_hardware();
  void radio_became(const cia447::FieldPlace& status, std::uint32_t code);
  RadioControlHardware control_hardware();
  RadioControlSettings control_settings();
  void send_status(int status);
  cia447::AudioSwitchHardware audio_hardware();
  void connect(unsigned input, unsigned output, std::uint8_t gain);
  cia447::HandsFreeHardware hands_free_hardware();
  void show_led(bool is_on) { led_is_lit_ = is_on; }
  void close_contact(bool is_closed);

  car::CarBus& bus_;
  const Sabotage& sabotage_;
  const SupplyDevice& supply_;
  Acted acted_;
  EventLog<PoliceEvent>& events_;
  cia447::RadioUnit* radio_ = nullptr;
  RadioControl* control_ = nullptr;
  cia447::HandsFreeUnit* hands_free_ = nullptr;
  cia447::DiscreteInputsUnit* inputs_ = nullptr;
  /// Connections of the audio switch, by channel.
  std::array<std::array<bool, 17>, 17> wires_{};
  bool handset_is_pressed_ = false;
  bool led_is_lit_ = false;
  bool is_on_ = false;
  bool transmits_ = false;
  unsigned statuses_ = 0;
  Callback<void(int)> status_heard_;
};

}  // namespace canvoy::police
