// What a PDO carries: a mapping record (1600h to 17FFh, 1A00h to 1BFFh), resolved once into
// addresses in the dictionary (CiA 301, 7.5.2.36 and 7.5.2.38).
//
// Values that lie side by side in the PDO and in the dictionary become one copy. Bits and odd sizes
// are shifted in and out; what has a range or a hook is checked before anything is written.
//
//     PdoMapping mapping;
//     mapping.use(memory);
//     if (mapping.resolve(dictionary, 0x1A00, 2, PdoDirection::transmit) == AbortCode::none)
//       PdoImage image = mapping.pack();
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <utility>

#include "canvoy/canopen/dictionary.hpp"

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

/// One value of a PDO, and where in the PDO it stands. The owner of PDOs provides the memory.
struct MappedValue {
  Entry entry;                ///< without a row: a dummy entry, whose bits nobody wants
  std::uint8_t position = 0;  ///< of its first bit
  std::uint8_t bits = 0;
  bool hooked = false;  ///< a hook wants to know of the access

  bool is_dummy() const { return entry.row == nullptr; }
};

class PdoMapping {
 public:
  /// As many values as `memory` has can be mapped, 64 at most. It must outlive the mapping.
  void use(std::span<MappedValue> memory);

  /// Maps what the first `count` entries of `record` say, or nothing. Logarithmic for each entry.
  /// Aborts: value_range where `count` is too large, pdo_length where there are more than 64 bits,
  /// and those of check_mapped_entry().
  AbortCode resolve(const Dictionary& dictionary, std::uint16_t record, unsigned count,
                    PdoDirection direction);
  void clear();

  unsigned bytes() const { return (bits_ + 7U) / 8; }
  unsigned bits() const { return bits_; }
  bool empty() const { return bits_ == 0; }
  std::span<const MappedValue> values() const { return memory_.first(value_count_); }
  /// Dictionary::revision() at the time of resolve().
  std::uint32_t revision() const { return revision_; }

  /// The present values. Constant time for each copy or value.
  PdoImage pack() const;
  /// Lets the before_read hooks of mapped values refresh them.
  void refresh(Dictionary& dictionary) const;

  /// Nothing can refuse the values: write() needs no check.
  bool is_unchecked() const { return unchecked_; }
  /// Which value `data` cannot have (ranges, hooks): the first one, or null.
  const MappedValue* find_refused(const Dictionary& dictionary, const std::uint8_t* data) const;
  /// Writes all values from the bytes() at `data`, then tells the hooks.
  void write(Dictionary& dictionary, const std::uint8_t* data) const;
  /// write() is nothing but copies of one size, and so is copy().
  bool is_simple() const { return unit_ != 0 && watchers_ == 0 && unchecked_; }
  /// The same as write() where is_simple(), and faster.
  void copy(const std::uint8_t* data) const {
    switch (unit_) {
      case 8:
        return copy_units<8>(data);
      case 4:
        return copy_units<4>(data);
      case 2:
        return copy_units<2>(data);
      default:
        return copy_units<1>(data);
    }
  }

 private:
  /// Whole bytes, from the PDO to one place in the dictionary or back.
  struct Copy {
    std::uint8_t* value = nullptr;
    std::uint32_t watchers = 0;
    std::uint8_t position = 0;  ///< in bytes
    std::uint8_t size = 0;
  };

  template <unsigned unit>
  void copy_units(const std::uint8_t* data) const {
    constexpr unsigned all = pdo_bytes_max / unit;
    if (copy_count_ == all) return copy_all<unit>(data, std::make_index_sequence<all>());
    for (const Copy& copy : std::span(copies_.data(), copy_count_)) {
      std::memcpy(copy.value, data + copy.position, unit);
    }
  }
  /// Copies that fill the PDO stand in it one behind the other. Its bytes are loaded once: loads of
  /// single ones, each after a store, take twice the time.
  template <unsigned unit, std::size_t... i>
  void copy_all(const std::uint8_t* data, std::index_sequence<i...>) const {
    const auto image = load<std::uint64_t>(data);
    const auto put = [&](std::size_t place) {
      const std::uint64_t number = image >> place * unit * 8;
      std::memcpy(copies_[place].value, &number, unit);
    };
    (put(i), ...);
  }

  AbortCode append_entries(const Dictionary& dictionary, std::uint16_t record, unsigned count,
                           PdoDirection direction);
  bool plan_copies(PdoDirection direction);
  void append_copy(const MappedValue& value);
  std::uint8_t common_size() const;
  void write_values(Dictionary& dictionary, const std::uint8_t* data) const;

  std::array<Copy, pdo_bytes_max> copies_{};
  std::span<MappedValue> memory_;
  std::uint32_t revision_ = 0;
  std::uint32_t watchers_ = 0;  ///< of all copies
  std::uint8_t value_count_ = 0;
  std::uint8_t copy_count_ = 0;
  std::uint8_t bits_ = 0;
  std::uint8_t unit_ = 0;  ///< bytes of each copy, where all have 1, 2, 4 or 8
  bool copied_ = false;    ///< the copies are all that there is to do
  bool unchecked_ = false;
  bool hooked_ = false;  ///< one of the values is
};

/// Whether a mapping entry (index, sub-index, bits) names something that a PDO of this direction
/// can carry. Aborts: no_object, no_sub_index, and not_mappable where it may not be mapped or has
/// another length. Dummy entries (0001h to 0007h) are for RPDOs only.
Result<MappedValue> check_mapped_entry(const Dictionary& dictionary, std::uint32_t mapped,
                                       PdoDirection direction);

/// The PDO of which the mapping record is written.
struct PdoWrite {
  PdoDirection direction = PdoDirection::receive;
  bool valid = false;
  bool can_be_multiplexed = false;
};

/// Whether `value` may be written to `entry` of a mapping record.
/// Aborts: unsupported_access out of the order that CiA 301 prescribes (PDO invalid, sub-index 0
/// zero, entries, sub-index 0), and those of resolve() and check_mapped_entry(). `scratch` is
/// resolved anew.
AbortCode check_mapping_write(const Dictionary& dictionary, const Entry& entry,
                              std::span<const std::uint8_t> value, const PdoWrite& pdo,
                              PdoMapping& scratch);

}  // namespace canvoy
