// A set of floors 1 to 254 of CiA 417: 32 bytes, with a search for the next floor in a few steps.
//
//     FloorSet calls;
//     calls.insert(7);
//     calls.next_up(3)  // 7
#pragma once

#include <array>
#include <bit>
#include <cstdint>

namespace canvoy::cia417 {

/// Floor 0 is no floor: it is in no set, and is the result if there is none.
class FloorSet {
 public:
  static constexpr unsigned floor_max = 254;  ///< floors of a building in CiA 417
  /// True for 1 to 254.
  static constexpr bool is_floor(unsigned floor) { return floor >= 1 && floor <= floor_max; }

  /// Floors that do not exist are ignored.
  constexpr void insert(unsigned floor) {
    if (is_floor(floor)) words_[floor / 32] |= bit(floor);
  }
  /// Removes a floor.
  constexpr void erase(unsigned floor) {
    if (is_floor(floor)) words_[floor / 32] &= ~bit(floor);
  }
  /// Removes all floors.
  constexpr void clear() { words_ = {}; }

  /// True if a floor is in the set; false for 0.
  constexpr bool contains(unsigned floor) const {
    return is_floor(floor) && (words_[floor / 32] & bit(floor)) != 0;
  }
  constexpr bool empty() const { return words_ == std::array<std::uint32_t, 8>{}; }
  constexpr unsigned size() const {
    unsigned count = 0;
    for (const std::uint32_t word : words_) count += static_cast<unsigned>(std::popcount(word));
    return count;
  }

  /// The lowest floor from `floor` on, or 0.
  constexpr std::uint8_t next_up(unsigned floor) const {
    if (floor > floor_max) return 0;
    std::uint32_t word = words_[floor / 32] & (~std::uint32_t{0} << floor % 32);
    for (unsigned i = floor / 32;; word = words_[i]) {
      if (word != 0) return to_floor(i, static_cast<unsigned>(std::countr_zero(word)));
      if (++i == words_.size()) return 0;
    }
  }
  /// The highest floor up to `floor`, or 0.
  constexpr std::uint8_t next_down(unsigned floor) const {
    if (floor > floor_max) floor = floor_max;
    std::uint32_t word = words_[floor / 32] & (~std::uint32_t{0} >> (31 - floor % 32));
    for (unsigned i = floor / 32;; word = words_[i]) {
      if (word != 0) return to_floor(i, 31U - static_cast<unsigned>(std::countl_zero(word)));
      if (i-- == 0) return 0;
    }
  }
  /// The lowest floor; 0 if the set is empty.
  constexpr std::uint8_t lowest() const { return next_up(1); }
  /// The highest floor; 0 if the set is empty.
  constexpr std::uint8_t highest() const { return next_down(floor_max); }

  constexpr FloorSet& operator|=(const FloorSet& other) {
    for (std::size_t i = 0; i < words_.size(); ++i) words_[i] |= other.words_[i];
    return *this;
  }
  constexpr FloorSet& operator&=(const FloorSet& other) {
    for (std::size_t i = 0; i < words_.size(); ++i) words_[i] &= other.words_[i];
    return *this;
  }
  constexpr FloorSet& operator^=(const FloorSet& other) {
    for (std::size_t i = 0; i < words_.size(); ++i) words_[i] ^= other.words_[i];
    return *this;
  }
  friend constexpr FloorSet operator^(FloorSet a, const FloorSet& b) { return a ^= b; }
  friend constexpr FloorSet operator|(FloorSet a, const FloorSet& b) { return a |= b; }
  friend constexpr FloorSet operator&(FloorSet a, const FloorSet& b) { return a &= b; }
  friend constexpr bool operator==(const FloorSet&, const FloorSet&) = default;

  /// The floors from `first` to `last`; none if `first` is above `last`.
  static constexpr FloorSet between(unsigned first, unsigned last) {
    FloorSet made;
    for (unsigned i = 0; i < made.words_.size(); ++i) {
      made.words_[i] = from(first, 32 * i) & ~from(last + 1, 32 * i);
    }
    made.words_[0] &= ~std::uint32_t{1};
    made.words_[7] &= ~bit(255);
    return made;
  }

 private:
  static constexpr std::uint32_t bit(unsigned floor) { return std::uint32_t{1} << floor % 32; }
  static constexpr std::uint8_t to_floor(unsigned word, unsigned position) {
    return static_cast<std::uint8_t>(32 * word + position);
  }
  /// Bits of the floors from `floor` on, in a word that starts with floor `begin`.
  static constexpr std::uint32_t from(unsigned floor, unsigned begin) {
    if (floor <= begin) return ~std::uint32_t{0};
    return floor - begin >= 32 ? 0 : ~std::uint32_t{0} << (floor - begin);
  }

  std::array<std::uint32_t, 8> words_{};
};

}  // namespace canvoy::cia417
