// Changes of digital inputs of CiA 401: polarity, and which bits are events (6002h, 6006h to 6008h,
// and the corresponding objects of 16 and 32 bits). All are behind the object with the values, at
// its sub-index.
//
//     const std::uint32_t value = with_polarity(dictionary, 0x6120, 0x81, position);
//     put(dictionary, entry, value, events_of_change(dictionary, 0x6120, 0x81, before, value) !=
//     0);
#pragma once

#include <cstdint>

#include "canvoy/canopen/dictionary/dictionary.hpp"

namespace canvoy::cia401 {

// Distance from the object with the values.
inline constexpr std::uint16_t to_input_polarity = 2;  ///< 6002h of 6000h
inline constexpr std::uint16_t to_any_change = 6;      ///< 6006h of 6000h
inline constexpr std::uint16_t to_low_to_high = 7;     ///< 6007h of 6000h
inline constexpr std::uint16_t to_high_to_low = 8;     ///< 6008h of 6000h

/// Inverts an element of the object `index` by its polarity; without polarity, nothing.
inline std::uint32_t with_polarity(const Dictionary& dictionary, std::uint16_t index,
                                   std::uint8_t sub, std::uint32_t value) {
  return value ^ dictionary.word(static_cast<std::uint16_t>(index + to_input_polarity), sub);
}

/// Bits with a change that is an event. Without masks, each change is one.
inline std::uint32_t events_of_change(const Dictionary& dictionary, std::uint16_t index,
                                      std::uint8_t sub, std::uint32_t before, std::uint32_t value) {
  const auto mask_at = [&](std::uint16_t offset, std::uint32_t absent) {
    return dictionary.word(static_cast<std::uint16_t>(index + offset), sub, absent);
  };
  return (before ^ value) & (mask_at(to_any_change, ~0U) | (value & mask_at(to_low_to_high, 0)) |
                             (~value & mask_at(to_high_to_low, 0)));
}

}  // namespace canvoy::cia401
