#include "canvoy/worlds/police/radio_devices.hpp"

#include "canvoy/profiles/cia447/radio_handles.hpp"

namespace canvoy::police {

namespace {

constexpr Duration hands_free_key_time = 200ms;

}  // namespace

void RadioDevices::add_nodes() {
  using namespace cia447;
  Environment& radio = bus_.add_site();
  radio.provide(Callback<SwitchedHardware()>::to<&RadioDevices::radio_hardware>(*this));
  radio.watch(Callback<void(RadioUnit&, Node&)>::to<&RadioDevices::is_radio>(*this));
  radio.provide(Callback<RadioControlHardware()>::to<&RadioDevices::control_hardware>(*this));
  radio.provide(Callback<RadioControlSettings()>::to<&RadioDevices::control_settings>(*this));
  radio.watch(Callback<void(RadioControl&, Node&)>::to<&RadioDevices::is_control>(*this));
  bus_.add(car::units_of<RadioKind, RadioControlKind>, radio);
  Environment& audio = bus_.add_site();
  audio.provide(Callback<AudioSwitchHardware()>::to<&RadioDevices::audio_hardware>(*this));
  bus_.add(car::units_of<AudioSwitchKind>, audio);
  Environment& hands_free = bus_.add_site();
  hands_free.provide(Callback<HandsFreeHardware()>::to<&RadioDevices::hands_free_hardware>(*this));
  hands_free.watch(Callback<void(HandsFreeUnit&, Node&)>::to<&RadioDevices::is_hands_free>(*this));
  bus_.add(car::units_of<HandsFreeKind>, hands_free);
}

void RadioDevices::add_inputs() {
  using namespace cia447;
  Environment& environment = bus_.add_site();
  environment.watch(
      Callback<void(DiscreteInputsUnit&, Node&)>::to<&RadioDevices::is_inputs>(*this));
  bus_.add(car::units_of<DiscreteInputsKind>, environment);
}

void RadioDevices::lose_power(NodeId id) {
  if (id == radio_id) is_on_ = transmits_ = false;
  if (id == audio_switch_id) wires_ = {};
  if (id == hands_free_id) led_is_lit_ = false;
}

void RadioDevices::sense(NodeId id) {
  if (id == inputs_id && handset_is_pressed_) close_contact(true);
}

void RadioDevices::lift_handset(bool is_pressed) {
  handset_is_pressed_ = is_pressed;
  const Duration late = sabotage_.slow_handset && is_pressed ? 4s : 0s;
  World& world = bus_.world();
  world.at(world.now() + late, [this](Time) { close_contact(handset_is_pressed_); });
}

void RadioDevices::close_contact(bool is_closed) {
  if (!bus_.has_power(inputs_id)) return;
  inputs_->switching().report(cia447::discrete_inputs_status_ptt_di,
                              is_closed ? cia447::Signal::on : cia447::Signal::off);
  bus_.touched(inputs_id);
}

void RadioDevices::press_hands_free() {
  if (!bus_.has_power(hands_free_id)) return;
  hands_free_->press_key(true);
  bus_.touched(hands_free_id);
  World& world = bus_.world();
  world.at(world.now() + hands_free_key_time, [this](Time) {
    hands_free_->press_key(false);
    bus_.touched(hands_free_id);
  });
}

void RadioDevices::press_button() {
  if (bus_.has_power(radio_id)) control_->press_button();
  bus_.touched(radio_id);
}

bool RadioDevices::carries_from_car() const {
  const bool is_connected =
      wires_[hands_free_id][radio_id] || (handset_is_pressed_ && wires_[inputs_id][radio_id]);
  return is_on_the_air() && is_connected;
}

bool RadioDevices::carries_to_car() const {
  return supply_.radio_has_power() && is_on_ && !transmits_ && wires_[radio_id][hands_free_id];
}

cia447::SwitchedHardware RadioDevices::radio_hardware() {
  return {
      .became =
          Callback<void(const cia447::FieldPlace&, std::uint32_t)>::to<&RadioDevices::radio_became>(
              *this)};
}
void RadioDevices::radio_became(const cia447::FieldPlace& status, std::uint32_t code) {
  const bool is_on = code == static_cast<std::uint32_t>(cia447::Signal::on);
  if (status == place_of(cia447::radio_device_status_power)) is_on_ = is_on;
  if (status != place_of(cia447::radio_device_status_transmit_push_to_talk)) return;
  transmits_ = is_on || (transmits_ && sabotage_.sticking_relay);
}

RadioControlHardware RadioDevices::control_hardware() {
  return {.radio = radio_,
          .acted = acted_,
          .send_status = Callback<void(int)>::to<&RadioDevices::send_status>(*this)};
}
RadioControlSettings RadioDevices::control_settings() {
  return {.terminal = terminal_id,
          .audio_switch = audio_switch_id,
          .hands_free = hands_free_id,
          .handset = inputs_id};
}
void RadioDevices::send_status(int status) {
  if (!supply_.radio_has_power() || !is_on_) return;
  ++statuses_;
  events_.note(bus_.world().now(), StatusSent{status});
  status_heard_(status);
}

cia447::AudioSwitchHardware RadioDevices::audio_hardware() {
  return {.connect =
              Callback<void(unsigned, unsigned, std::uint8_t)>::to<&RadioDevices::connect>(*this)};
}
void RadioDevices::connect(unsigned input, unsigned output, std::uint8_t gain) {
  wires_.at(input).at(output) = gain != 0;
}

cia447::HandsFreeHardware RadioDevices::hands_free_hardware() {
  return {.show_led = Callback<void(bool)>::to<&RadioDevices::show_led>(*this), .mute = {}};
}

}  // namespace canvoy::police
