// Numbers in the form of the wire: least significant byte first, in 1 to 8 bytes.
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <span>
#include <type_traits>

#include "canvoy/can/machine.hpp"

namespace canvoy {

static_assert(
    std::endian::native == std::endian::little,
    "values are kept as they travel; a big-endian target needs byte swaps in load() and store()");

/// Like load_word(), by a loop.
std::uint32_t load_word_by_bytes(const std::uint8_t* bytes, std::size_t size);
/// Loads an unsigned number of `size` bytes, of which the first four count.
inline std::uint32_t load_word(const std::uint8_t* bytes, std::size_t size) {
  if constexpr (!is_small_machine) {
    std::uint32_t number = 0;
    if (size >= sizeof number) {
      std::memcpy(&number, bytes, sizeof number);
      return number;
    }
    if (size == 1) return *bytes;
    if (size == 2) return static_cast<std::uint32_t>(bytes[0] | bytes[1] << 8);
  }
  return load_word_by_bytes(bytes, size);
}
/// Loads an unsigned number of all bytes, of which the first four count.
inline std::uint32_t load_word(std::span<const std::uint8_t> bytes) {
  return load_word(bytes.data(), bytes.size());
}

/// Loads a number of the size of `Number`; `bytes` need not be aligned.
template <class Number>
Number load(const std::uint8_t* bytes) {
  // Few processors of small machines can load unaligned words; a copy costs a call.
  if constexpr (is_small_machine && std::is_same_v<Number, std::uint16_t>) {
    return static_cast<Number>(bytes[0] | bytes[1] << 8);
  }
  if constexpr (is_small_machine && std::is_same_v<Number, std::uint32_t>) {
    return static_cast<Number>(load_word(bytes, sizeof(Number)));
  }
  Number number;
  std::memcpy(&number, bytes, sizeof number);
  return number;
}

/// Stores a number in as many bytes as `Number` has; `bytes` need not be aligned.
template <class Number>
void store(std::uint8_t* bytes, Number number) {
  if constexpr (is_small_machine && std::is_same_v<Number, std::uint16_t>) {
    bytes[0] = static_cast<std::uint8_t>(number);
    bytes[1] = static_cast<std::uint8_t>(number >> 8);
    return;
  }
  std::memcpy(bytes, &number, sizeof number);
}

/// True if the bytes are equal. Most values have one of these sizes, for which it takes a few
/// instructions.
inline bool are_equal(const std::uint8_t* one, const std::uint8_t* other, std::size_t size) {
  switch (size) {
    case 1:
      return *one == *other;
    case 2:
      return load<std::uint16_t>(one) == load<std::uint16_t>(other);
    case 4:
      return load<std::uint32_t>(one) == load<std::uint32_t>(other);
    case 8:
      return load<std::uint64_t>(one) == load<std::uint64_t>(other);
    default:
      return std::memcmp(one, other, size) == 0;
  }
}

/// Loads an unsigned number of all bytes, 8 at most.
inline std::uint64_t load_unsigned(std::span<const std::uint8_t> bytes) {
  std::uint64_t number = 0;
  std::memcpy(&number, bytes.data(), bytes.size() < 8 ? bytes.size() : 8);
  return number;
}

/// Extends `number`, of which only the lower `bits` (1 to 64) count, by its sign, the uppermost of
/// these bits.
constexpr std::int64_t sign_extend(std::uint64_t number, unsigned bits) {
  const unsigned unused = 64 - bits;
  return static_cast<std::int64_t>(number << unused) >> unused;
}

}  // namespace canvoy
