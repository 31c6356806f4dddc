#include "canvoy/devices/cia401/analogue_outputs.hpp"

#include "canvoy/devices/cia401/analogue_reals.hpp"
#include "canvoy/devices/cia401/scaling.hpp"
#include "canvoy/devices/cia401/widths.hpp"

namespace canvoy::cia401 {

namespace {

constexpr std::uint16_t output_fraction = write_analogue_output_float_object.index;

/// Null if it is no object of integers.
const Width* width_of(std::uint16_t index) {
  for (const Width& width : analogue_output_widths) {
    if (width.index == index) return &width;
  }
  return nullptr;
}

constexpr bool is_parameter(std::uint16_t index) {
  return index == output_scaling.offset_integer || index == output_scaling.scaling_integer ||
         index == output_scaling.offset_real || index == output_scaling.scaling_real;
}

}  // namespace

void AnalogueOutputs::begin(ResetScope scope) {
  if (reals_ != nullptr && scope == ResetScope::node) reals_->written_last.reset();
  for_each_channel([this](std::uint8_t channel) { drive(index_of(channel), channel); });
}

void AnalogueOutputs::written(std::uint16_t index, std::uint8_t sub) {
  if (sub == 0) return;
  if (width_of(index) != nullptr || index == output_fraction) {
    if (reals_ != nullptr) reals_->written_last[sub] = index == output_fraction;
    drive(index, sub);
  }
  if (is_parameter(index)) drive(index_of(sub), sub);
}

void AnalogueOutputs::fail() {
  for_each_channel([this](std::uint8_t channel) { fail(channel); });
}

void AnalogueOutputs::fail(std::uint8_t channel) {
  Dictionary& dictionary = node_.dictionary();
  constexpr auto takes_value = static_cast<std::uint32_t>(ErrorMode::take_error_value);
  if (dictionary.word(analogue_output_error_mode_object.index, channel) != takes_value) return;
  const std::uint16_t index = index_of(channel);
  const std::uint16_t error_value = index == output_fraction
                                        ? analogue_output_error_value_float_object.index
                                        : analogue_output_error_value_integer_object.index;
  std::uint32_t value = dictionary.word(error_value, channel);
  if (const Width* width = width_of(index); width != nullptr) {
    value = static_cast<std::uint32_t>(
        IntegerScale{}.apply(static_cast<std::int32_t>(value), width->bytes));
  }
  const Result<Entry> entry = dictionary.find(index, channel);
  if (entry) put(dictionary, *entry, value);
  drive(index, channel);
}

template <class Each>
void AnalogueOutputs::for_each_channel(Each each) {
  if (has_outputs_) {
    for_each_element(node_.dictionary(), write_analogue_output_16_bit_object.index, each);
  }
}

/// The object of floating-point numbers if that was written last; otherwise the first existing one
/// of 16 bits, 32, 8, floating-point.
std::uint16_t AnalogueOutputs::index_of(unsigned channel) const {
  if (reals_ != nullptr && reals_->written_last[channel]) return output_fraction;
  constexpr std::uint16_t order[] = {analogue_output_widths[1].index,
                                     analogue_output_widths[2].index,
                                     analogue_output_widths[0].index, output_fraction};
  for (const std::uint16_t index : order) {
    if (node_.dictionary().find(index, static_cast<std::uint8_t>(channel))) return index;
  }
  return 0;
}

void AnalogueOutputs::drive(std::uint16_t index, unsigned channel) {
  const Width* width = width_of(index);
  if (width == nullptr) {
    if (reals_ != nullptr) reals_->drive(*this, channel);
    return;
  }
  const Dictionary& dictionary = node_.dictionary();
  const std::uint32_t word = dictionary.word(index, static_cast<std::uint8_t>(channel));
  const std::int64_t value = integer_scale(dictionary, output_scaling, channel)
                                 .apply(sign_extended(word, width->bytes), width->bytes);
  const unsigned shift = 8U * (4U - width->bytes);
  const auto raw = static_cast<std::int32_t>(static_cast<std::uint32_t>(value) << shift);
  show(index, channel, static_cast<std::int32_t>(word << shift));
  if (reals_ != nullptr) reals_->show(*this, channel, raw);
  drive_(channel, raw);
}

/// Shows the value of the full width in all objects of integers except the written one.
void AnalogueOutputs::show(std::uint16_t but, unsigned channel, std::int32_t value) {
  Dictionary& dictionary = node_.dictionary();
  for (const Width& width : analogue_output_widths) {
    if (width.index == but) continue;
    const Result<Entry> entry = dictionary.find(width.index, static_cast<std::uint8_t>(channel));
    const auto shown = static_cast<std::uint32_t>(value) >> 8 * (4 - width.bytes);
    if (entry) put(dictionary, *entry, shown, true);
  }
}

}  // namespace canvoy::cia401
