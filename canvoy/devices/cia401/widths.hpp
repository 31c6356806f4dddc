// The same inputs or outputs are in objects of several widths: which ones, and how their values are
// stored.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "canvoy/canopen/dictionary/dictionary.hpp"
#include "canvoy/canopen/little_endian.hpp"

namespace canvoy::cia401 {

struct Width {
  std::uint16_t index = 0;  ///< of the object with the values
  std::uint8_t bytes = 1;   ///< of an element
};
inline constexpr Width input_widths[] = {{0x6000, 1}, {0x6100, 2}, {0x6120, 4}};
inline constexpr Width output_widths[] = {{0x6200, 1}, {0x6300, 2}, {0x6320, 4}};
/// Of integers.
inline constexpr Width analogue_input_widths[] = {{0x6400, 1}, {0x6401, 2}, {0x6402, 4}};
inline constexpr Width analogue_output_widths[] = {{0x6410, 1}, {0x6411, 2}, {0x6412, 4}};

constexpr std::uint32_t in_bytes(std::uint32_t value, unsigned bytes) {
  return bytes >= 4 ? value : value & ((1U << 8 * bytes) - 1);
}

/// Calls `each` with the sub-indices of an array that are there.
template <class Each>
void for_each_element(const Dictionary& dictionary, std::uint16_t index, Each each) {
  constexpr unsigned last = 254;
  for (unsigned sub = 1; sub <= last; ++sub) {
    const auto number = static_cast<std::uint8_t>(sub);
    if (dictionary.find(index, number)) each(number);
  }
}

/// Stores a number; TPDOs learn of it where it `is_told`.
inline void put(Dictionary& dictionary, const Entry& entry, std::uint32_t value, bool is_told) {
  std::array<std::uint8_t, 4> bytes{};
  store(bytes.data(), value);
  const auto used = std::span(bytes).first(entry.row->capacity);
  if (is_told) return dictionary.set(entry, used);
  for (std::size_t i = 0; i < used.size(); ++i) entry.value[i] = used[i];
}

}  // namespace canvoy::cia401
