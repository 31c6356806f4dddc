#include "canvoy/devices/cia401/analogue_reals.hpp"

#include <bit>
#include <cmath>

#include "canvoy/devices/cia401/analogue_event.hpp"
#include "canvoy/devices/cia401/scaling.hpp"

namespace canvoy::cia401 {

constexpr AnalogueReals AnalogueReals::calls = {.read = &AnalogueReals::read_real,
                                                .drive = &AnalogueReals::drive_real,
                                                .show = &AnalogueReals::show_real};

bool AnalogueReals::read_real(AnalogueInputs& inputs, AnalogueInputState& state, bool may_tell) {
  Dictionary& dictionary = inputs.node_.dictionary();
  const Result<Entry> entry =
      dictionary.find(read_analogue_input_float_object.index, state.channel);
  if (!entry) return false;
  const float now = real_scale(dictionary, input_scaling, state.channel).apply(fraction(state.raw));
  const auto before = std::bit_cast<float>(entry->word());
  const bool is_told =
      may_tell &&
      is_event<double>(dictionary, {before, now, state.real},
                       {.upper = analogue_input_interrupt_upper_limit_float_object.index,
                        .channel = state.channel});
  if (is_told || !may_tell) state.real = now;
  if (now != before) put(dictionary, *entry, std::bit_cast<std::uint32_t>(now), is_told);
  return is_told;
}

void AnalogueReals::drive_real(AnalogueOutputs& outputs, unsigned channel) {
  const Dictionary& dictionary = outputs.node_.dictionary();
  const std::uint32_t word =
      dictionary.word(write_analogue_output_float_object.index, static_cast<std::uint8_t>(channel));
  const float value =
      real_scale(dictionary, output_scaling, channel).apply(std::bit_cast<float>(word));
  const std::int32_t raw = from_fraction(std::isnan(value) ? 0 : value);
  outputs.show(write_analogue_output_float_object.index, channel, raw);
  outputs.drive_(channel, raw);
}

void AnalogueReals::show_real(AnalogueOutputs& outputs, unsigned channel, std::int32_t value) {
  Dictionary& dictionary = outputs.node_.dictionary();
  const Result<Entry> entry =
      dictionary.find(write_analogue_output_float_object.index, static_cast<std::uint8_t>(channel));
  if (entry) put(dictionary, *entry, std::bit_cast<std::uint32_t>(fraction(value)), true);
}

}  // namespace canvoy::cia401
