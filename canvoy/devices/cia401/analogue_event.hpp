// Decides whether a change of an analogue input of CiA 401 is an event (6421h, 6424h to 642Dh).
#pragma once

#include <bit>
#include <cstdint>
#include <type_traits>

#include "canvoy/canopen/dictionary/dictionary.hpp"
#include "canvoy/profiles/cia401/analogue.hpp"

namespace canvoy::cia401 {

/// Bits of 6421h.
namespace trigger {
inline constexpr std::uint32_t upper_limit = 1;      ///< at or above 6424h
inline constexpr std::uint32_t lower_limit = 2;      ///< below 6425h
inline constexpr std::uint32_t any_delta = 4;        ///< by more than 6426h
inline constexpr std::uint32_t negative_delta = 8;   ///< down by more than 6427h
inline constexpr std::uint32_t positive_delta = 16;  ///< up by more than 6428h
/// Triggers that compare with a value.
inline constexpr std::uint32_t limits = upper_limit | lower_limit;
/// Triggers that compare with the last event.
inline constexpr std::uint32_t deltas = any_delta | negative_delta | positive_delta;
}  // namespace trigger

/// A value, and the values with which its change is compared.
template <class Number>
struct AnalogueChange {
  Number before = 0;  ///< in the object
  Number now = 0;     ///< sensed
  Number told = 0;    ///< at the last event
};

/// Location of limits and deltas: the upper limit, and in the objects behind it the lower limit,
/// delta, negative and positive delta.
struct AnalogueLimits {
  std::uint16_t upper = 0;   ///< index of the object with the upper limits
  std::uint8_t channel = 0;  ///< sub-index
  std::uint8_t shift = 0;    ///< from a whole number to the unit of its limits
};

namespace detail {

template <class Number>
Number analogue_limit(const Dictionary& dictionary, const AnalogueLimits& of, unsigned offset,
                      bool is_signed) {
  const std::uint32_t word =
      dictionary.word(static_cast<std::uint16_t>(of.upper + offset), of.channel);
  if constexpr (std::is_floating_point_v<Number>) {
    return std::bit_cast<float>(word);
  } else {
    return is_signed ? Number{static_cast<std::int32_t>(word)} : Number{word};
  }
}

template <class Number>
Number in_units_of(const AnalogueLimits& limits, Number value) {
  if constexpr (std::is_floating_point_v<Number>) {
    return value;
  } else {
    return static_cast<Number>(value << limits.shift);
  }
}

}  // namespace detail

/// Devices without 6421h have no limits, so that each change is an event.
template <class Number>
bool is_event(const Dictionary& dictionary, const AnalogueChange<Number>& change,
              const AnalogueLimits& limits) {
  if (change.now == change.before && change.now == change.told) return false;
  constexpr std::uint32_t absent = ~0U;
  const std::uint32_t selected = dictionary.word(
      analogue_input_interrupt_trigger_selection_object.index, limits.channel, absent);
  if (selected == absent) return true;
  const Number now = detail::in_units_of(limits, change.now);
  const Number rise = detail::in_units_of(limits, static_cast<Number>(change.now - change.told));
  const auto is_selected = [selected](std::uint32_t bit) { return (selected & bit) != 0; };
  const auto at = [&](unsigned offset, bool is_signed) {
    return detail::analogue_limit<Number>(dictionary, limits, offset, is_signed);
  };
  const bool is_out = (is_selected(trigger::upper_limit) && now >= at(0, true)) ||
                      (is_selected(trigger::lower_limit) && now < at(1, true));
  const bool is_far =
      (is_selected(trigger::any_delta) && (rise > at(2, false) || -rise > at(2, false))) ||
      (is_selected(trigger::negative_delta) && -rise > at(3, false)) ||
      (is_selected(trigger::positive_delta) && rise > at(4, false));
  const bool has_limits = is_selected(trigger::limits);
  const bool has_deltas = is_selected(trigger::deltas);
  if (!has_limits && !has_deltas) return false;
  return (!has_limits || is_out) && (has_deltas ? is_far : change.now != change.before);
}

}  // namespace canvoy::cia401
