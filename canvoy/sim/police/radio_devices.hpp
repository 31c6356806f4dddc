// The way of a spoken word in a police car: the handset and the hands-free system, the audio switch
// that connects microphones and loudspeaker, and the radio with its transmitter.
//
//     RadioDevices radio(bus, options, supply, acted, events);
//     radio.lift_handset(true);
//     if (radio.carries_from_car()) ...     // what is said in the car is on the air
#pragma once

#include <array>

#include "canvoy/devices/cia447/audio_switch/audio_switch_unit.hpp"
#include "canvoy/devices/cia447/discrete_inputs/discrete_inputs_unit.hpp"
#include "canvoy/devices/cia447/hands_free/hands_free_unit.hpp"
#include "canvoy/sim/car/car_bus.hpp"
#include "canvoy/sim/event_log.hpp"
#include "canvoy/sim/police/police_event.hpp"
#include "canvoy/sim/police/police_options.hpp"
#include "canvoy/sim/police/radio_control.hpp"
#include "canvoy/sim/police/supply_device.hpp"

namespace canvoy::police {

class RadioDevices {
 public:
  /// All must outlive this. `acted` is told of each key that the radio has acted on.
  RadioDevices(car::CarBus& bus, const Sabotage& sabotage, const SupplyDevice& supply,
               const Acted& acted, EventLog<PoliceEvent>& events)
      : bus_(bus), sabotage_(sabotage), supply_(supply), acted_(acted), events_(events) {}
  RadioDevices(const RadioDevices&) = delete;
  RadioDevices& operator=(const RadioDevices&) = delete;

  /// Puts radio, audio switch and hands-free system on the bus.
  void add_nodes();
  /// The inputs at which the handset is.
  void add_inputs();
  /// What they do without power; of other nodes nothing happens.
  void lose_power(NodeId id);
  /// What they sense when they get it.
  void sense(NodeId id);

  // Hands.
  void lift_handset(bool is_pressed);
  /// The key of the hands-free system.
  void press_hands_free();
  /// The button at the radio.
  void press_button();

  // What is seen and heard.
  /// Beside the key of the hands-free system: the radio is active.
  bool led_is_lit() const { return led_is_lit_; }
  bool is_on() const { return is_on_; }
  bool transmits() const { return transmits_; }
  /// A receiver near by hears that the channel is not free.
  bool is_on_the_air() const { return supply_.radio_has_power() && is_on_ && transmits_; }
  /// From the handset's microphone, or from that of the hands-free system, through the audio switch
  /// into the radio, and on the air.
  bool carries_from_car() const;
  /// From the radio to the loudspeaker.
  bool carries_to_car() const;
  /// Status messages that the control room got.
  unsigned statuses() const { return statuses_; }

 private:
  cia447::SwitchedHardware radio_hardware();
  void radio_became(const cia447::FieldPlace& status, std::uint32_t code);
  void is_radio(cia447::RadioUnit& unit, Node& /*node*/) { radio_ = &unit; }
  RadioControlHardware control_hardware();
  RadioControlSettings control_settings();
  void is_control(RadioControl& control, Node& /*node*/) { control_ = &control; }
  void send_status(int status);
  cia447::AudioSwitchHardware audio_hardware();
  void connect(unsigned input, unsigned output, std::uint8_t gain);
  cia447::HandsFreeHardware hands_free_hardware();
  void show_led(bool is_on) { led_is_lit_ = is_on; }
  void is_hands_free(cia447::HandsFreeUnit& unit, Node& /*node*/) { hands_free_ = &unit; }
  void is_inputs(cia447::DiscreteInputsUnit& unit, Node& /*node*/) { inputs_ = &unit; }
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
  /// Of the audio switch, by channel.
  std::array<std::array<bool, 17>, 17> wires_{};
  bool handset_is_pressed_ = false;
  bool led_is_lit_ = false;
  bool is_on_ = false;
  bool transmits_ = false;
  unsigned statuses_ = 0;
};

}  // namespace canvoy::police
