// What a PDO carries: a mapping record (1600h to 17FFh, 1A00h to 1BFFh), resolved once into places
// in the dictionary's values (CiA 301, 7.5.2.36 and 7.5.2.38).
//
// Bits and odd sizes are shifted in and out. What has a range, a hook or a watcher is special: its
// object is looked up when it is accessed, and checked before anything is written.
//
//     MappedValue values[4 * 8];   // for four PDOs of up to eight values
#pragma once

#include <array>
#include <bit>
#include <cstdint>

namespace canvoy {

inline constexpr unsigned pdo_count_max = 512;  ///< of one direction
inline constexpr unsigned pdo_values_max = 64;  ///< mapped into one PDO
inline constexpr unsigned pdo_bytes_max = 8;

enum class PdoDirection : std::uint8_t { receive, transmit };

/// Sub-index 00h of the mapping record of a multiplexed PDO.
enum class MpdoMode : std::uint8_t { none = 0, source = 0xFE, destination = 0xFF };

constexpr MpdoMode mpdo_mode(unsigned mapped_entries) {
  constexpr auto first = static_cast<unsigned>(MpdoMode::source);
  return mapped_entries - first <= 1 ? static_cast<MpdoMode>(mapped_entries) : MpdoMode::none;
}

/// The data of a PDO, as in a frame; bytes behind the last one are zero.
using PdoImage = std::array<std::uint8_t, pdo_bytes_max>;

/// PDOs of one direction by their positions, a bit for each.
class PdoSet {
 public:
  void set(unsigned position, bool is_in) {
    const std::uint64_t bit = std::uint64_t{1} << position % 64;
    std::uint64_t& word = words_[position / 64];
    word = is_in ? word | bit : word & ~bit;
  }
  /// The first one from `position` on; not below `count` where there is none below it.
  unsigned next(unsigned position, unsigned count) const {
    while (position < count) {
      const std::uint64_t left = words_[position / 64] >> position % 64;
      if (left != 0) return position + static_cast<unsigned>(std::countr_zero(left));
      position = (position / 64 + 1) * 64;
    }
    return position;
  }

 private:
  std::array<std::uint64_t, pdo_count_max / 64> words_{};
};

/// One value of a PDO: where it stands in the dictionary, in three bytes, and its part in a table
/// that finds it by its place (see Tpdos). The owner of PDOs provides the memory.
class MappedValue {
 public:
  static constexpr unsigned offset_max = 0xFFFF;
  static constexpr unsigned bytes_max = 16;  ///< for as many bits as can be told

  /// False where it was so before.
  bool set(unsigned offset, unsigned bits, bool special) {
    const auto wanted = static_cast<std::uint8_t>(special ? bits | special_bit : bits);
    if (offset_ == static_cast<std::uint16_t>(offset) && bits_ == wanted) return false;
    offset_ = static_cast<std::uint16_t>(offset);
    bits_ = wanted;
    return true;
  }

  /// In bytes from the start of the dictionary's values; of no meaning where it is special.
  unsigned offset() const { return offset_; }
  unsigned bits() const { return bits_ & ~special_bit; }
  /// More is to be done than to copy it.
  bool is_special() const { return bits_ > special_bit; }

 private:
  friend class PlacesOfValues;
  static constexpr unsigned special_bit = 0x80;

  std::uint16_t offset_ = 0;
  std::uint8_t bits_ = 0;
  std::uint16_t next_ = 0;    ///< value of which the place has the same hash: its position, from 1
  std::uint16_t bucket_ = 0;  ///< the first value of the hash that is this one's position; or 0
};
static_assert(sizeof(MappedValue) == 8, "some devices have thousands of mapped values");

/// Finds mapped values by their places: a hash table in their own memory.
class PlacesOfValues {
 public:
  static constexpr unsigned nothing = UINT32_MAX;

  PlacesOfValues(MappedValue* values, unsigned count) : values_(values), count_(count) {}

  void clear() {
    for (unsigned i = 0; i < count_; ++i) values_[i].bucket_ = 0;
  }
  /// One that is in it at most once.
  void add(unsigned position) {
    std::uint16_t& bucket = values_[hash(values_[position].offset_)].bucket_;
    values_[position].next_ = bucket;
    bucket = static_cast<std::uint16_t>(position + 1);
  }
  /// The positions of those at `place`, one after the other; nothing behind the last one.
  unsigned first(std::uint32_t place) const {
    const auto offset = static_cast<std::uint16_t>(place);
    return seek(values_[hash(offset)].bucket_, offset);
  }
  unsigned next(unsigned position) const {
    return seek(values_[position].next_, values_[position].offset_);
  }

 private:
  unsigned seek(unsigned candidate, std::uint16_t offset) const {
    while (candidate != 0 && values_[candidate - 1].offset_ != offset) {
      candidate = values_[candidate - 1].next_;
    }
    return candidate == 0 ? nothing : candidate - 1;
  }
  /// Fibonacci hashing, scaled to the number of values.
  unsigned hash(std::uint16_t offset) const {
    return static_cast<unsigned>(std::uint64_t{offset * 0x9E37'79B9U} * count_ >> 32);
  }

  MappedValue* values_;
  unsigned count_;
};

}  // namespace canvoy
