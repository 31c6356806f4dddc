#include "canvoy/tools/device/io_wires.hpp"

#include <fmt/format.h>

#include <utility>

namespace canvoy::tools {

void IoWires::join(Environment& environment) {
  environment.provide(callback<&IoWires::hardware>(*this));
  environment.watch(unit_);
}

cia401::IoHardware IoWires::hardware() {
  return {.digital_inputs = cia401::DigitalInputs::Sense::to<&IoWires::sense>(*this),
          .drive_digital = cia401::DigitalOutputs::Drive::to<&IoWires::drive>(*this),
          .analogue_input = cia401::AnalogueInputs::Sense::to<&IoWires::measure>(*this),
          .drive_analogue = cia401::AnalogueOutputs::Drive::to<&IoWires::drive_analogue>(*this)};
}

void IoWires::set_input(unsigned number, bool is_on) {
  const unsigned place = number - 1;
  std::uint8_t& group = inputs_.at(place / inputs_of_group);
  const unsigned bit = 1U << place % inputs_of_group;
  group = static_cast<std::uint8_t>(is_on ? group | bit : group & ~bit);
  look();
}

void IoWires::set_analogue_input(unsigned number, std::int16_t value) {
  analogue_inputs_.at(number - 1) = value;
  look();
}

void IoWires::look() const {
  if (unit_ != nullptr) unit_->hardware_changed();
}

void IoWires::drive(unsigned group, std::uint8_t outputs) {
  const unsigned changed = std::exchange(outputs_.at(group), outputs) ^ outputs;
  for (unsigned bit = 0; bit < inputs_of_group; ++bit) {
    if ((changed >> bit & 1U) == 0) continue;
    output_.say("io-401", fmt::format("output {} {}", (group - 1) * inputs_of_group + bit + 1,
                                      (outputs >> bit & 1U) != 0 ? "on" : "off"));
  }
}

void IoWires::drive_analogue(unsigned channel, std::int32_t value) {
  const std::int32_t upper = value >> 16;
  if (std::exchange(analogue_outputs_.at(channel), upper) == upper) return;
  output_.say("io-401", fmt::format("analogue output {}: {}", channel, upper));
}

}  // namespace canvoy::tools
