// What a PDO carries: a mapping record (1600h to 17FFh, 1A00h to 1BFFh), resolved once into places
// in the dictionary's values (CiA 301, 7.5.2.36 and 7.5.2.38).
//
// Bits and odd sizes are shifted in and out. What has a range, a hook or a watcher is special: its
// object is looked up when it is accessed, and checked before anything is written.
//
//     MappedValue values[4 * 8];   // for four PDOs of up to eight values
#pragma once

#include <array>
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

/// One value of a PDO: where it stands in the dictionary, in three bytes. The owner of PDOs
/// provides the memory.
class MappedValue {
 public:
  static constexpr unsigned offset_max = 0xFFFF;
  static constexpr unsigned bytes_max = 16;  ///< for as many bits as can be told

  void set(unsigned offset, unsigned bits, bool special) {
    offset_ = {static_cast<std::uint8_t>(offset), static_cast<std::uint8_t>(offset >> 8)};
    bits_ = static_cast<std::uint8_t>(special ? bits | special_bit : bits);
  }

  /// In bytes from the start of the dictionary's values; of no meaning where it is special.
  unsigned offset() const { return offset_[0] | unsigned{offset_[1]} << 8; }
  unsigned bits() const { return bits_ & ~special_bit; }
  /// More is to be done than to copy it.
  bool is_special() const { return bits_ > special_bit; }

 private:
  static constexpr unsigned special_bit = 0x80;

  std::array<std::uint8_t, 2> offset_{};  ///< bytes, so that three of them need no fourth
  std::uint8_t bits_ = 0;
};
static_assert(sizeof(MappedValue) == 3, "small devices have many mapped values");

}  // namespace canvoy
