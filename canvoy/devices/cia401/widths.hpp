// The objects of several widths that hold the same inputs or outputs, and how their values are
// stored.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "canvoy/canopen/dictionary/dictionary.hpp"
#include "canvoy/canopen/protocol/little_endian.hpp"

namespace canvoy::cia401 {

/// An object for a width.
struct Width {
  std::uint16_t index = 0;  ///< of the object with the values
  std::uint8_t bytes = 1;   ///< of an element
};
/// Digital, of 8, 16 and 32 bits.
inline constexpr Width input_widths[] = {{0x6000, 1}, {0x6100, 2}, {0x6120, 4}};
/// Digital, of 8, 16 and 32 bits.
inline constexpr Width output_widths[] = {{0x6200, 1}, {0x6300, 2}, {0x6320, 4}};
/// Objects of integers.
inline constexpr Width analogue_input_widths[] = {{0x6400, 1}, {0x6401, 2}, {0x6402, 4}};
/// Of 8, 16 and 32 bits.
inline constexpr Width analogue_output_widths[] = {{0x6410, 1}, {0x6411, 2}, {0x6412, 4}};

/// The lower `bytes` of a value.
constexpr std::uint32_t in_bytes(std::uint32_t value, unsigned bytes) {
  return bytes >= 4 ? value : value & ((1U << 8 * bytes) - 1);
}

/// Calls `each` with the existing sub-indices of an array.
template <class Each>
void for_each_element(const Dictionary& dictionary, std::uint16_t index, Each each) {
  constexpr unsigned last = 254;
  for (unsigned sub = 1; sub <= last; ++sub) {
    const auto number = static_cast<std::uint8_t>(sub);
    if (dictionary.find(index, number)) each(number);
  }
}

/// Stores the value of an output; TPDOs are notified of a change.
inline void put(Dictionary& dictionary, const Entry& entry, std::uint32_t value) {
  std::array<std::uint8_t, 4> bytes{};
  store(bytes.data(), value);
  dictionary.set(entry, bytes);
}

/// Stores the value of an input; masks and limits decide whether it is an event.
inline void put(Dictionary& dictionary, const Entry& entry, std::uint32_t value, bool is_event) {
  std::array<std::uint8_t, 4> bytes{};
  store(bytes.data(), value);
  if (is_event) return dictionary.set_with_event(entry, bytes);
  dictionary.set_without_event(entry, bytes);
}

}  // namespace canvoy::cia401
