#include "canvoy/devices/cia852/encoder_inputs.hpp"

#include "canvoy/devices/cia401/widths.hpp"
#include "canvoy/profiles/cia401_digital.hpp"
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

void EncoderInputs::store(std::size_t place, bool is_told) {
  const auto sub =
      static_cast<std::uint8_t>(encoder_position_sub(static_cast<unsigned>(place + 1)));
  const Result<Entry> entry = node_.dictionary().find(cia401::read_input_32_bit_object.index, sub);
  if (entry) cia401::put(node_.dictionary(), *entry, states_[place].position, is_told);
}

}  // namespace canvoy::cia852
