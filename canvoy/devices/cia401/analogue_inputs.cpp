#include "canvoy/devices/cia401/analogue_inputs.hpp"

#include <algorithm>
#include <bit>

#include "canvoy/devices/cia401/scaling.hpp"
#include "canvoy/devices/cia401/widths.hpp"

namespace canvoy::cia401 {

namespace {

constexpr std::uint16_t trigger_selection = analogue_input_interrupt_trigger_selection_object.index;
constexpr std::uint16_t interrupt_source = analogue_input_interrupt_source_object.index;
constexpr std::uint16_t first_of_integer =
    analogue_input_interrupt_upper_limit_integer_object.index;
constexpr std::uint16_t first_of_real = analogue_input_interrupt_upper_limit_float_object.index;
constexpr std::uint16_t input_fraction = read_analogue_input_float_object.index;

// Bits of 6421h.
constexpr std::uint32_t upper_limit = 1;
constexpr std::uint32_t lower_limit = 2;
constexpr std::uint32_t any_delta = 4;
constexpr std::uint32_t negative_delta = 8;
constexpr std::uint32_t positive_delta = 16;

constexpr unsigned inputs_of_source = 32;

}  // namespace

void AnalogueInputs::begin() {
  sources_.fill(0);
  for (unsigned channel = 1; channel <= states_.size(); ++channel) read(channel, false);
}

void AnalogueInputs::look() {
  const bool may_tell = are_enabled();
  for (unsigned channel = 1; channel <= states_.size(); ++channel) read(channel, may_tell);
}

bool AnalogueInputs::are_enabled() const {
  return Values(node_.dictionary())[analogue_input_global_interrupt_enable].is_set();
}

void AnalogueInputs::read(unsigned channel, bool may_tell) {
  const std::int32_t raw = sense_(channel);
  const bool is_event_of_integer = read_integers(channel, raw, may_tell);
  const bool is_event_of_real = read_real(channel, raw, may_tell);
  if (is_event_of_integer || is_event_of_real) add_source(channel);
}

/// The widest but one decides: 16 bits are what most devices have.
bool AnalogueInputs::read_integers(unsigned channel, std::int32_t raw, bool may_tell) {
  Dictionary& dictionary = node_.dictionary();
  constexpr std::size_t order[] = {1, 2, 0};  // of analogue_input_widths
  AnalogueInputState& state = states_[channel - 1];
  bool is_first = true;
  bool is_told = false;
  for (const std::size_t place : order) {
    const Width& width = analogue_input_widths[place];
    const Result<Entry> entry = dictionary.find(width.index, static_cast<std::uint8_t>(channel));
    if (!entry) continue;
    const IntegerScale scale = integer_scale(dictionary, input_scaling, channel);
    const std::int64_t now = scale.apply(narrowed(raw, width.bytes), width.bytes);
    const std::int64_t before = sign_extended(entry->word(), width.bytes);
    if (is_first) {
      const std::int64_t factor =
          settings_.limits_are_left_adjusted ? std::int64_t{1} << 8 * (4 - width.bytes) : 1;
      is_told = may_tell && is_event<std::int64_t>(channel, {before, now, state.integer}, factor,
                                                   {first_of_integer});
      if (is_told || !may_tell) state.integer = now;
    }
    is_first = false;
    if (now != before) put(dictionary, *entry, static_cast<std::uint32_t>(now), is_told);
  }
  return is_told;
}

bool AnalogueInputs::read_real(unsigned channel, std::int32_t raw, bool may_tell) {
  Dictionary& dictionary = node_.dictionary();
  const Result<Entry> entry = dictionary.find(input_fraction, static_cast<std::uint8_t>(channel));
  if (!entry) return false;
  AnalogueInputState& state = states_[channel - 1];
  const float now = real_scale(dictionary, input_scaling, channel).apply(fraction(raw));
  const auto before = std::bit_cast<float>(entry->word());
  const bool is_told =
      may_tell && is_event<double>(channel, {before, now, state.real}, 1, {first_of_real});
  if (is_told || !may_tell) state.real = now;
  if (now != before) put(dictionary, *entry, std::bit_cast<std::uint32_t>(now), is_told);
  return is_told;
}

template <class Number>
Number AnalogueInputs::limit(std::uint16_t index, unsigned channel, bool is_signed) const {
  const std::uint32_t word = node_.dictionary().word(index, static_cast<std::uint8_t>(channel));
  if constexpr (std::is_floating_point_v<Number>) {
    return std::bit_cast<float>(word);
  } else {
    return is_signed ? Number{static_cast<std::int32_t>(word)} : Number{word};
  }
}

template <class Number>
bool AnalogueInputs::is_event(unsigned channel, const Change<Number>& change, Number factor,
                              Limits limits) const {
  if (change.now == change.before && change.now == change.told) return false;
  const std::uint32_t selected =
      node_.dictionary().word(trigger_selection, static_cast<std::uint8_t>(channel));
  const Number now = change.now * factor;
  const Number rise = (change.now - change.told) * factor;
  const auto at = [&](unsigned offset, bool is_signed) {
    return limit<Number>(static_cast<std::uint16_t>(limits.upper + offset), channel, is_signed);
  };
  const bool is_out = ((selected & upper_limit) != 0 && now >= at(0, true)) ||
                      ((selected & lower_limit) != 0 && now < at(1, true));
  const bool is_far =
      ((selected & any_delta) != 0 && (rise > at(2, false) || -rise > at(2, false))) ||
      ((selected & negative_delta) != 0 && -rise > at(3, false)) ||
      ((selected & positive_delta) != 0 && rise > at(4, false));
  constexpr std::uint32_t of_limits = upper_limit | lower_limit;
  constexpr std::uint32_t of_deltas = any_delta | negative_delta | positive_delta;
  const bool has_limits = (selected & of_limits) != 0;
  const bool has_deltas = (selected & of_deltas) != 0;
  if (!has_limits && !has_deltas) return false;
  return (!has_limits || is_out) && (has_deltas ? is_far : change.now != change.before);
}

void AnalogueInputs::add_source(unsigned channel) {
  const unsigned bank = (channel - 1) / inputs_of_source;
  sources_[bank] |= 1U << (channel - 1) % inputs_of_source;
  node_.dictionary().set_number(interrupt_source, static_cast<std::uint8_t>(bank + 1),
                                sources_[bank]);
}

void AnalogueInputs::source_is_read(const Entry& entry) {
  if (entry.sub == 0 || entry.sub > sources_.size()) return;
  std::uint32_t& source = sources_[entry.sub - 1U];
  put(node_.dictionary(), entry, source, false);
  source = 0;
}

}  // namespace canvoy::cia401
