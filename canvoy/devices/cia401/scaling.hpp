// Offset and scaling of analogue inputs and outputs (642Eh to 6432h, 6441h to 6447h). The process
// value is that of the converter times the scaling, plus the offset, within its type.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "canvoy/canopen/dictionary/dictionary.hpp"
#include "canvoy/profiles/cia401/analogue.hpp"

namespace canvoy::cia401 {

/// The scaling objects of inputs or outputs.
struct Scaling {
  std::uint16_t offset_integer = 0;   ///< index; sub-index is the channel
  std::uint16_t scaling_integer = 0;  ///< index
  std::uint16_t offset_real = 0;      ///< index
  std::uint16_t scaling_real = 0;     ///< index
};
/// 6431h, 6432h, 642Eh and 642Fh.
inline constexpr Scaling input_scaling = {
    .offset_integer = analogue_input_offset_integer_object.index,
    .scaling_integer = analogue_input_scaling_integer_object.index,
    .offset_real = analogue_input_offset_float_object.index,
    .scaling_real = analogue_input_scaling_float_object.index};
/// Of 6411h and 6413h.
inline constexpr Scaling output_scaling = {
    .offset_integer = analogue_output_offset_integer_object.index,
    .scaling_integer = analogue_output_scaling_integer_object.index,
    .offset_real = analogue_output_offset_float_object.index,
    .scaling_real = analogue_output_scaling_float_object.index};

/// The upper bits of a left-adjusted value of 32 bits.
constexpr std::int64_t narrowed(std::int32_t raw, unsigned bytes) {
  return raw >> 8 * (4 - bytes);
}
/// The number in the lower `bytes` (1 to 4) of a word, extended by its sign.
constexpr std::int64_t sign_extended(std::uint32_t word, unsigned bytes) {
  const unsigned unused = 8 * (4 - bytes);
  return static_cast<std::int32_t>(word << unused) >> unused;
}
/// Full scale is 1.
constexpr float fraction(std::int32_t raw) {
  return static_cast<float>(static_cast<double>(raw) / 2147483648.0);
}
/// Converter value of a fraction of full scale; clamped to -1 to just below 1.
constexpr std::int32_t from_fraction(double value) {
  constexpr double full = 2147483648.0;
  return static_cast<std::int32_t>(std::clamp(value * full, -full, full - 1));
}

/// Offset and scaling of integers.
struct IntegerScale {
  std::int64_t scaling = 1;  ///< factor
  std::int64_t offset = 0;   ///< added after it

  /// Applies it within a type of so many bytes.
  constexpr std::int64_t apply(std::int64_t value, unsigned bytes) const {
    const std::int64_t high = (std::int64_t{1} << (8 * bytes - 1)) - 1;
    return std::clamp(value * scaling + offset, -high - 1, high);
  }
};
/// Scale of a channel; without the objects, the value stays as it is.
inline IntegerScale integer_scale(const Dictionary& dictionary, const Scaling& of,
                                  unsigned channel) {
  const auto sub = static_cast<std::uint8_t>(channel);
  return {static_cast<std::int32_t>(dictionary.word(of.scaling_integer, sub, 1)),
          static_cast<std::int32_t>(dictionary.word(of.offset_integer, sub, 0))};
}

/// Offset and scaling of floating-point numbers.
struct RealScale {
  float scaling = 1;  ///< factor
  float offset = 0;   ///< added after it

  /// The scaled value.
  constexpr float apply(float value) const { return value * scaling + offset; }
};
/// Scale of a channel; without the objects, the value stays as it is.
inline RealScale real_scale(const Dictionary& dictionary, const Scaling& of, unsigned channel) {
  constexpr auto one = std::bit_cast<std::uint32_t>(1.0F);
  const auto sub = static_cast<std::uint8_t>(channel);
  return {std::bit_cast<float>(dictionary.word(of.scaling_real, sub, one)),
          std::bit_cast<float>(dictionary.word(of.offset_real, sub, 0))};
}

}  // namespace canvoy::cia401
