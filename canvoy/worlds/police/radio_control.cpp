#include "canvoy/worlds/police/radio_control.hpp"

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
      handset_source_(network,
                      {.pdo_number = handset_pdo,
                       .lost = Callback<void()>::to<&RadioControl::handset_lost>(*this),
                       .read = Callback<void()>::to<&RadioControl::look_at_handset>(*this)}),
      key_source_(network, {.pdo_number = hands_free_pdo,
                            .lost = Callback<void()>::to<&RadioControl::key_lost>(*this),
                            .read = Callback<void()>::to<&RadioControl::look_at_key>(*this)}),
      emergency_source_(network,
                        {.pdo_number = emergency_pdo,
                         .lost = Callback<void()>::to<&RadioControl::emergency_lost>(*this),
                         .read = Callback<void()>::to<&RadioControl::look_at_emergency>(*this)}) {
  terminal_.on_number_key(Callback<void(NumberPadKey)>::to<&RadioControl::number_pressed>(*this));
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

}  // namespace canvoy::police
