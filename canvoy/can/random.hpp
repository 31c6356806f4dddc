// A small random generator with the same numbers on every platform and compiler: xoshiro256** by
// Blackman and Vigna, filled from a 64-bit seed by SplitMix64.
//
//     Random random(seed);
//     if (random.happens(Probability(0.001))) ...
#pragma once

#include <bit>
#include <cstdint>

namespace canvoy {

/// A probability as a 64-bit threshold, so that a decision is one comparison of integers, the same
/// on every platform.
class Probability {
 public:
  constexpr Probability() = default;
  /// Makes a probability from 0 (or less: never) to 1 (or more: always).
  constexpr explicit Probability(double value) : threshold_(to_threshold(value)) {}
  /// Number of cases in which it happens, of 2^64 equally likely ones.
  constexpr std::uint64_t threshold() const { return threshold_; }
  /// True if it never happens, so that no random number need be drawn.
  constexpr bool is_zero() const { return threshold_ == 0; }

 private:
  static constexpr std::uint64_t to_threshold(double value) {
    if (!(value > 0.0)) return 0;
    if (value >= 1.0) return ~std::uint64_t{0};
    return static_cast<std::uint64_t>(value * 0x1p64);
  }

  std::uint64_t threshold_ = 0;
};

/// The generator. Not for secrets. Copied by value: a copy continues with the same numbers.
class Random {
 public:
  /// Seeds the generator; any number is good, 0 included.
  constexpr explicit Random(std::uint64_t seed) {
    for (std::uint64_t& word : state_) word = split_mix(seed);
  }

  /// Next 64 random bits.
  constexpr std::uint64_t next() {
    const std::uint64_t result = std::rotl(state_[1] * 5, 7) * 9;
    const std::uint64_t shifted = state_[1] << 17;
    state_[2] ^= state_[0];
    state_[3] ^= state_[1];
    state_[1] ^= state_[2];
    state_[0] ^= state_[3];
    state_[2] ^= shifted;
    state_[3] = std::rotl(state_[3], 45);
    return result;
  }

  /// Random number from 0 to `count` - 1; 0 if `count` is 0. The bias is below 2^-32.
  constexpr std::uint32_t below(std::uint32_t count) {
    return static_cast<std::uint32_t>(((next() >> 32) * count) >> 32);
  }

  /// Decides by the next random number; draws none if the probability is zero.
  constexpr bool happens(Probability probability) {
    return !probability.is_zero() && next() <= probability.threshold();
  }

 private:
  static constexpr std::uint64_t split_mix(std::uint64_t& seed) {
    seed += 0x9E37'79B9'7F4A'7C15;
    std::uint64_t mixed = seed;
    mixed = (mixed ^ (mixed >> 30)) * 0xBF58'476D'1CE4'E5B9;
    mixed = (mixed ^ (mixed >> 27)) * 0x94D0'49BB'1331'11EB;
    return mixed ^ (mixed >> 31);
  }

  std::uint64_t state_[4] = {};
};

}  // namespace canvoy
