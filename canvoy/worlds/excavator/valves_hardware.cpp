#include "canvoy/worlds/excavator/valves_hardware.hpp"

#include <algorithm>
#include <cmath>

#include "canvoy/canopen/protocol/little_endian.hpp"
#include "canvoy/worlds/excavator/host_objects.hpp"

namespace canvoy::excavator {

namespace {

constexpr unsigned unused_bits = 16;  ///< values of converters are left-aligned

}  // namespace

cia401::IoHardware ValvesHardware::hardware() {
  using Self = ValvesHardware;
  return {.digital_inputs = callback<&Self::sense_digital>(*this),
          .drive_digital = callback<&Self::drive_digital>(*this),
          .analogue_input = callback<&Self::sense_analogue>(*this),
          .drive_analogue = callback<&Self::drive_analogue>(*this)};
}

std::int32_t ValvesHardware::sense_analogue(unsigned channel) {
  if (channel > sensors) return 0;
  const auto sensor = static_cast<Sensor>(channel);
  return static_cast<std::int32_t>(std::lround(value_of(sensor) * digits_of(sensor))) *
         (1 << unused_bits);
}

double ValvesHardware::value_of(Sensor sensor) const {
  switch (sensor) {
    case Sensor::boom:
      return machine_.angle(Movement::boom);
    case Sensor::stick:
      return machine_.angle(Movement::stick);
    case Sensor::bucket:
      return machine_.angle(Movement::bucket);
    case Sensor::slew:
      return machine_.angle(Movement::slew);
    case Sensor::fuel:
      return machine_.litres() / Excavator::tank_litres * 100;
    case Sensor::oil:
      return machine_.oil_celsius();
    case Sensor::rpm:
      return machine_.rpm();
    case Sensor::pressure:
      return machine_.pressure_bar();
  }
  return 0;
}

void ValvesHardware::drive_digital(unsigned group, std::uint8_t outputs) {
  if (group == 1) switch_outputs(outputs);
}

void ValvesHardware::switch_outputs(unsigned outputs) {
  const unsigned changed = outputs ^ outputs_;
  outputs_ = outputs;
  machine_.set_fast_travel(is_on(Switched::fast_travel));
  machine_.set_pilot_pressure(is_on(Switched::pilot_pressure));
  for (std::size_t i = 0; i < button_count; ++i) {
    const unsigned bit = 1U << i;
    if ((changed & bit) != 0) switched_(static_cast<Button>(i), (outputs & bit) != 0);
  }
}

void ValvesHardware::drive_analogue(unsigned channel, std::int32_t value) {
  set_valve(channel, (value >> unused_bits) / valve_digits);
}

void ValvesHardware::set_valve(unsigned channel, double share) {
  const double limited = std::clamp(share, -1.0, 1.0);
  if (channel == throttle_output) machine_.set_throttle(std::max(limited, 0.0));
  if (channel <= movements) machine_.command(static_cast<Movement>(channel - 1), limited);
}

void ValvesHardware::release() {
  switch_outputs(0);
  for (unsigned channel = 1; channel <= throttle_output; ++channel) set_valve(channel, 0);
}

void ValvesHardware::follow(const Frame& frame) {
  if (!frame.is_plain() || frame.length != Frame::length_max) return;
  if (frame.id == switches_id) return switch_outputs(frame.data[0]);
  const bool is_first = frame.id == valve_id;
  if (!is_first && frame.id != more_valves_id) return;
  for (unsigned i = 0; i < 4; ++i) {
    const auto value =
        static_cast<std::int16_t>(load<std::uint16_t>(&frame.data[2 * std::size_t{i}]));
    set_valve((is_first ? 1 : 5) + i, value / valve_digits);
  }
}

}  // namespace canvoy::excavator
