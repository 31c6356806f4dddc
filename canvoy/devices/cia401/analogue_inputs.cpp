#include "canvoy/devices/cia401/analogue_inputs.hpp"

#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/devices/cia401/analogue_event.hpp"
#include "canvoy/devices/cia401/analogue_reals.hpp"
#include "canvoy/devices/cia401/scaling.hpp"

namespace canvoy::cia401 {

namespace {

constexpr std::uint16_t interrupt_source = analogue_input_interrupt_source_object.index;
constexpr unsigned inputs_of_source = 32;

bool is_enabled(const Dictionary& dictionary) {
  return dictionary.word(analogue_input_global_interrupt_enable_object.index) != 0;
}
constexpr bool is_analogue_input(MappingValue mapped) {
  constexpr std::uint16_t manufacturer_specific = 0x6404;
  return mapped.index >= read_analogue_input_8_bit_object.index &&
         mapped.index <= manufacturer_specific;
}

}  // namespace

bool tpdo_may_begin(const Dictionary& dictionary, std::uint16_t number) {
  if (is_enabled(dictionary)) return true;
  const auto record = static_cast<std::uint16_t>(object_index::tpdo_mapping + number - 1);
  const std::uint32_t count = dictionary.word(record);
  for (std::uint32_t sub = 1; sub <= count; ++sub) {
    const MappingValue mapped(dictionary.word(record, static_cast<std::uint8_t>(sub)));
    if (!is_analogue_input(mapped)) return true;
  }
  return count == 0;
}

AnalogueInputs::AnalogueInputs(Node& node, std::span<AnalogueInputState> states, Sense sense,
                               const AnalogueInputSettings& settings, const AnalogueReals* reals)
    : node_(node), states_(states), sense_(sense), settings_(settings), reals_(reals) {
  std::size_t next = 0;
  for_each_element(node.dictionary(), read_analogue_input_16_bit_object.index,
                   [&](std::uint8_t sub) {
                     if (next < states_.size()) states_[next++].channel = sub;
                   });
  states_ = states_.first(next);
}

void AnalogueInputs::begin() {
  sources_.fill(0);
  for (AnalogueInputState& state : states_) {
    state.raw = sense_(state.channel);
    read(state, false);
  }
}

void AnalogueInputs::rescale(unsigned channel) {
  for (AnalogueInputState& state : states_) {
    if (state.channel == channel) read(state, false);
  }
}

/// Without a change, no object is looked up.
void AnalogueInputs::look() {
  for (AnalogueInputState& state : states_) {
    const std::int32_t raw = sense_(state.channel);
    if (raw == state.raw) continue;
    state.raw = raw;
    read(state, are_enabled());
  }
}

bool AnalogueInputs::are_enabled() const {
  return is_enabled(node_.dictionary());
}

void AnalogueInputs::read(AnalogueInputState& state, bool may_tell) {
  const bool is_event_of_integer = read_integers(state, may_tell);
  const bool is_event_of_real = reals_ != nullptr && reals_->read(*this, state, may_tell);
  if (is_event_of_integer || is_event_of_real) add_source(state.channel);
}

/// The widest but one decides: most devices have 16 bits.
bool AnalogueInputs::read_integers(AnalogueInputState& state, bool may_tell) {
  constexpr std::size_t order[] = {1, 2, 0};  // of analogue_input_widths
  const Dictionary& dictionary = node_.dictionary();
  const IntegerScale scale = integer_scale(dictionary, input_scaling, state.channel);
  bool is_first = true;
  bool is_told = false;
  for (const std::size_t place : order) {
    const Width& width = analogue_input_widths[place];
    const Result<Entry> entry = dictionary.find(width.index, state.channel);
    if (!entry) continue;
    const std::int64_t now = scale.apply(narrowed(state.raw, width.bytes), width.bytes);
    const std::int64_t before = sign_extended(entry->word(), width.bytes);
    if (is_first) {
      is_told = may_tell && is_event_of_width(state, width, before, now);
      if (is_told || !may_tell) state.integer = static_cast<std::int32_t>(now);
    }
    is_first = false;
    if (now != before) put(node_.dictionary(), *entry, static_cast<std::uint32_t>(now), is_told);
  }
  return is_told;
}

bool AnalogueInputs::is_event_of_width(const AnalogueInputState& state, const Width& width,
                                       std::int64_t before, std::int64_t now) const {
  const unsigned shift = settings_.limits_are_left_adjusted ? 8U * (4U - width.bytes) : 0;
  return is_event<std::int64_t>(node_.dictionary(), {before, now, state.integer},
                                {.upper = analogue_input_interrupt_upper_limit_integer_object.index,
                                 .channel = state.channel,
                                 .shift = static_cast<std::uint8_t>(shift)});
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
