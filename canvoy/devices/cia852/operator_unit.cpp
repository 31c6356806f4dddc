#include "canvoy/devices/cia852/operator_unit.hpp"

#include "canvoy/devices/cia401/digital_event.hpp"
#include "canvoy/devices/cia401/widths.hpp"
#include "canvoy/profiles/cia401/digital.hpp"
#include "canvoy/profiles/cia852/values.hpp"
#include "canvoy/profiles/model/reactions.hpp"

namespace canvoy::cia852 {

void EncoderInputs::begin() {
  for (std::size_t i = 0; i < states_.size(); ++i) {
    states_[i].position = sense_(static_cast<unsigned>(i + 1));
    store(i, false);
  }
}

void EncoderInputs::look() {
  for (std::size_t i = 0; i < states_.size(); ++i) {
    const std::uint32_t position = sense_(static_cast<unsigned>(i + 1));
    if (position == states_[i].position) continue;
    states_[i].position = position;
    const std::uint16_t enable = cia401::global_interrupt_enable_digital_object.index;
    store(i, node_.dictionary().word(enable, 0, 1) != 0);
  }
}

void EncoderInputs::show() {
  for (std::size_t i = 0; i < states_.size(); ++i) store(i, false);
}

void EncoderInputs::store(std::size_t place, bool may_tell) {
  constexpr std::uint16_t index = cia401::read_input_32_bit_object.index;
  Dictionary& dictionary = node_.dictionary();
  const auto sub =
      static_cast<std::uint8_t>(encoder_position_sub(static_cast<unsigned>(place + 1)));
  const Result<Entry> entry = dictionary.find(index, sub);
  if (!entry) return;
  const std::uint32_t before = entry->word();
  const std::uint32_t value =
      cia401::with_polarity(dictionary, index, sub, states_[place].position);
  const bool is_told =
      may_tell && cia401::events_of_change(dictionary, index, sub, before, value) != 0;
  cia401::put(dictionary, *entry, value, is_told);
}

namespace {

/// The converters of CiA 401 have 32 bits, left-adjusted.
constexpr unsigned unused_bits = 16;
constexpr std::int32_t to_left(std::int16_t value) {
  return std::int32_t{value} * (1 << unused_bits);
}

constexpr std::uint8_t directions_of_joystick = 0x07;  ///< Figure 5; the others are reserved

}  // namespace

constexpr AccessHandlers OperatorUnit::hook_calls[] = {
    after_write<&OperatorUnit::polarity_written, cia401::polarity_input_32_bit_object>};
constexpr ServiceHandlers OperatorUnit::service_calls = {.reset = method<&OperatorUnit::reset>,
                                                         .hooks = hook_calls};

OperatorUnit::OperatorUnit(Node& node, const OperatorMemory& memory,
                           const OperatorHardware& hardware, const OperatorSettings& settings)
    : node_(node),
      hardware_(hardware),
      sensing_period_(settings.sensing_period),
      io_(node, memory.io, io_hardware(),
          {.sensing_period = settings.sensing_period,
           .digital = settings.digital,
           .analogue = settings.analogue}),
      encoders_(node, memory.encoders, hardware.encoder),
      has_encoders_(!memory.encoders.empty()),
      timer_(callback<&OperatorUnit::expired>(*this)) {
  if (!has_encoders_) return;
  node.attach(service_);
}

cia401::IoHardware OperatorUnit::io_hardware() {
  return {.digital_inputs = callback<&OperatorUnit::digital_input>(*this),
          .drive_digital = callback<&OperatorUnit::show_indicators>(*this),
          .analogue_input = callback<&OperatorUnit::analogue_input>(*this),
          .drive_analogue = callback<&OperatorUnit::show_parameter>(*this)};
}

void OperatorUnit::hardware_changed() {
  io_.hardware_changed();
  if (has_encoders_) node_.timers().arm(timer_, node_.now());
}

// Inputs.

std::uint8_t OperatorUnit::digital_input(unsigned sub) {
  const DigitalInputPlace place = digital_input_place(sub);
  switch (place.kind) {
    case DigitalInputPlace::Kind::joystick_memory:
      return hardware_.joystick_memory(place.element) & directions_of_joystick;
    case DigitalInputPlace::Kind::joystick_buttons:
      return hardware_.joystick_buttons(place.element);
    case DigitalInputPlace::Kind::foot_pedal_memory:
      return hardware_.foot_pedal_memory(place.element) ? 1 : 0;
    case DigitalInputPlace::Kind::push_buttons:
      return hardware_.push_buttons(place.element, place.group);
  }
  return 0;
}

std::int32_t OperatorUnit::analogue_input(unsigned sub) {
  const AnalogueInputPlace place = analogue_input_place(sub);
  switch (place.kind) {
    case AnalogueInputPlace::Kind::joystick:
      return to_left(hardware_.joystick_axis(place.element, place.axis));
    case AnalogueInputPlace::Kind::foot_pedal:
      return to_left(hardware_.foot_pedal(place.element));
    case AnalogueInputPlace::Kind::wheel:
      return to_left(hardware_.wheel(place.element));
  }
  return 0;
}

void OperatorUnit::reset(ResetScope) {
  encoders_.begin();
  arm_from(node_.now());
}

void OperatorUnit::expired(Time now) {
  encoders_.look();
  arm_from(now);
}

void OperatorUnit::arm_from(Time now) {
  if (sensing_period_ > Duration::zero()) node_.timers().arm(timer_, now + sensing_period_);
}

// Outputs.

void OperatorUnit::show_indicators(unsigned sub, std::uint8_t lit) {
  hardware_.show_indicators((sub - 1) / groups_of_cluster + 1, (sub - 1) % groups_of_cluster + 1,
                            lit);
}

void OperatorUnit::show_parameter(unsigned sub, std::int32_t value) {
  hardware_.show_parameter((sub - 1) / display_pitch + 1, (sub - 1) % display_pitch + 1,
                           static_cast<std::int16_t>(value >> unused_bits));
}

}  // namespace canvoy::cia852
