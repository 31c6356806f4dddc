#include "canvoy/worlds/police/radio_devices.hpp"

#include <string>

#include "canvoy/profiles/cia447/radio_handles.hpp"
#include "canvoy/profiles/model/reactions.hpp"

namespace canvoy::police {

namespace {

using namespace cia447;

constexpr unsigned handset_pdo = 79;
constexpr unsigned hands_free_pdo = 65;
constexpr unsigned emergency_pdo = 82;

/// Indices of the settings of the audio switch.
constexpr unsigned listening = 0;
constexpr unsigned speaking = 1;
constexpr unsigned conversing = 2;

}  // namespace

constexpr AccessHandlers RadioControl::hook_calls[] = {
    after_write<&RadioControl::handset_written, discrete_inputs_status_object>,
    after_write<&RadioControl::key_written, radio_hand_free_status_object>,
    after_write<&RadioControl::emergency_written, emergency_key_user_interaction_object>};
constexpr ServiceHandlers RadioControl::service_calls = {.reset = method<&RadioControl::reset>,
                                                         .hooks = hook_calls};

RadioControl::RadioControl(CarNetwork& network, const RadioControlHardware& hardware,
                           const RadioControlSettings& settings)
    : network_(network),
      hardware_(hardware),
      settings_(settings),
      terminal_(network, {.terminal = settings.terminal}),
      menu_(network, terminal_, title_of(Client::radio)),
      audio_(network, {.server = settings.audio_switch}),
      hands_free_(network, {.server = settings.hands_free}),
      handset_source_(network, {.pdo_number = handset_pdo,
                                .lost = callback<&RadioControl::handset_lost>(*this),
                                .read = callback<&RadioControl::look_at_handset>(*this)}),
      key_source_(network, {.pdo_number = hands_free_pdo,
                            .lost = callback<&RadioControl::key_lost>(*this),
                            .read = callback<&RadioControl::look_at_key>(*this)}),
      emergency_source_(network, {.pdo_number = emergency_pdo,
                                  .lost = callback<&RadioControl::emergency_lost>(*this),
                                  .read = callback<&RadioControl::look_at_emergency>(*this)}) {
  terminal_.on_number_key(callback<&RadioControl::number_pressed>(*this));
  network.node().attach(service_);
}

void RadioControl::reset(ResetScope) {
  menu_.close();
  handset_is_pressed_ = key_is_pressed_ = is_hands_free_ = emergency_is_pressed_ = false;
  if (hardware_.radio != nullptr) {
    hardware_.radio->switching().command(radio_device_command_power, Order::on);
  }
  talk();
}

void RadioControl::press_button() {
  if (!menu_.is_open()) menu_.open("status?");
}

void RadioControl::number_pressed(NumberPadKey key) {
  const int digit = digit_of(key);
  if (hardware_.acted) {
    hardware_.acted({.client = Client::radio, .key = static_cast<std::uint8_t>(key)});
  }
  if (!menu_.is_open() || digit < 0) return;
  if (hardware_.send_status) hardware_.send_status(digit);
  menu_.finish("status " + std::to_string(digit), 2s);
}

void RadioControl::handset_written(const Entry&, Source source) {
  handset_source_.came(source);
  look_at_handset();
}
void RadioControl::look_at_handset() {
  const Values inputs(network_.node().dictionary());
  handset_is_pressed_ = inputs[discrete_inputs_status_ptt_di].is(Signal::on);
  talk();
}
/// The state of the contact is unknown: a transmitter that stays on would block the channel.
void RadioControl::handset_lost() {
  handset_is_pressed_ = false;
  talk();
}

/// Each press begins a conversation, or ends it.
void RadioControl::key_written(const Entry&, Source source) {
  key_source_.came(source);
  look_at_key();
}
void RadioControl::look_at_key() {
  const Values values(network_.node().dictionary());
  const bool is_pressed = values[radio_hand_free_status_key].is(Signal::yes);
  if (is_pressed && !key_is_pressed_) is_hands_free_ = !is_hands_free_;
  key_is_pressed_ = is_pressed;
  talk();
}
void RadioControl::key_lost() {
  key_is_pressed_ = is_hands_free_ = false;
  talk();
}

/// Each press is an emergency, and does not wait for a menu.
void RadioControl::emergency_written(const Entry&, Source source) {
  emergency_source_.came(source);
  look_at_emergency();
}
void RadioControl::look_at_emergency() {
  const Values values(network_.node().dictionary());
  const bool is_pressed = values[emergency_key_user_interaction].is(Signal::yes);
  constexpr int emergency = 0;
  const bool begins = is_pressed && !emergency_is_pressed_;
  emergency_is_pressed_ = is_pressed;
  if (begins && hardware_.send_status) hardware_.send_status(emergency);
}

void RadioControl::talk() {
  const NodeId radio = network_.node().id();
  connect(listening, radio, settings_.hands_free, true);
  connect(speaking, settings_.handset, radio, handset_is_pressed_);
  connect(conversing, settings_.hands_free, radio, is_hands_free_);
  const Order led = is_hands_free_ ? Order::on : Order::off;
  const auto both = static_cast<unsigned>(led);
  constexpr unsigned others = 0xF0;
  hands_free_.want(0, {radio_hand_free_command_object.index, 0, others | both << 2 | both, 1});
  if (hardware_.radio == nullptr) return;
  const bool talks = handset_is_pressed_ || is_hands_free_;
  hardware_.radio->switching().command(radio_device_command_push_to_talk,
                                       talks ? Order::on : Order::off);
}

void RadioControl::connect(unsigned place, NodeId input, NodeId output, bool is_on) {
  const std::uint32_t wanted = is_on ? gain : 0;
  audio_.want(place, {audio_switch_command_object.index, 0,
                      wanted << 16 | static_cast<std::uint32_t>(output) << 8 | input, 3});
}

namespace {

constexpr Duration hands_free_key_time = 200ms;

}  // namespace

void RadioDevices::add_nodes() {
  using namespace cia447;
  Environment& radio = bus_.add_site();
  radio.provide(callback<&RadioDevices::radio_hardware>(*this));
  radio.watch(radio_);
  radio.provide(callback<&RadioDevices::control_hardware>(*this));
  radio.provide(callback<&RadioDevices::control_settings>(*this));
  radio.watch(control_);
  bus_.add(car::units_of<RadioKind, RadioControlKind>, radio);
  Environment& audio = bus_.add_site();
  audio.provide(callback<&RadioDevices::audio_hardware>(*this));
  bus_.add(car::units_of<AudioSwitchKind>, audio);
  Environment& hands_free = bus_.add_site();
  hands_free.provide(callback<&RadioDevices::hands_free_hardware>(*this));
  hands_free.watch(hands_free_);
  bus_.add(car::units_of<HandsFreeKind>, hands_free);
}

void RadioDevices::add_inputs() {
  using namespace cia447;
  Environment& environment = bus_.add_site();
  environment.watch(inputs_);
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
  return {.became = callback<&RadioDevices::radio_became>(*this)};
}
void RadioDevices::radio_became(const cia447::FieldPlace& status, std::uint32_t code) {
  const bool is_on = code == static_cast<std::uint32_t>(cia447::Signal::on);
  if (status == place_of(cia447::radio_device_status_power)) is_on_ = is_on;
  if (status != place_of(cia447::radio_device_status_transmit_push_to_talk)) return;
  transmits_ = is_on || (transmits_ && sabotage_.sticking_relay);
}

RadioControlHardware RadioDevices::control_hardware() {
  return {
      .radio = radio_, .acted = acted_, .send_status = callback<&RadioDevices::send_status>(*this)};
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
  return {.connect = callback<&RadioDevices::connect>(*this)};
}
void RadioDevices::connect(unsigned input, unsigned output, std::uint8_t gain) {
  wires_.at(input).at(output) = gain != 0;
}

cia447::HandsFreeHardware RadioDevices::hands_free_hardware() {
  return {.show_led = callback<&RadioDevices::show_led>(*this), .mute = {}};
}

}  // namespace canvoy::police
