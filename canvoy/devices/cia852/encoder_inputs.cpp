#include "canvoy/devices/cia852/encoder_inputs.hpp"

#include "canvoy/devices/cia401/digital_event.hpp"
#include "canvoy/devices/cia401/widths.hpp"
#include "canvoy/profiles/cia401/digital.hpp"
#include "canvoy/profiles/cia852/values.hpp"

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

}  // namespace canvoy::cia852
