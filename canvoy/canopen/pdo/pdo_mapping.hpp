// What a PDO carries: a mapping record (1600h to 17FFh, 1A00h to 1BFFh), resolved when it is set
// into positions in the dictionary's values and the operations on each: limits, hooks, watchers
// (CiA 301, 7.5.2.36 and 7.5.2.38).
//
// Bits and odd sizes are shifted in and out. All values of an RPDO are checked before one is
// written. If a hook or a watcher is added later, the operations are determined again; the record
// is read only when it is set. A small machine keeps no plans, and reads the record for each frame.
//
//     MappedValue values[4 * 8];   // for four PDOs of up to eight values
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <utility>

#include "canvoy/canopen/dictionary/dictionary.hpp"

namespace canvoy {

inline constexpr unsigned pdo_count_max = 512;  ///< for one direction
inline constexpr unsigned pdo_values_max = 64;  ///< mapped into one PDO
inline constexpr unsigned pdo_bytes_max = 8;    ///< data of a classical CAN frame

/// Direction as the node sees it: RPDO or TPDO.
enum class PdoDirection : std::uint8_t { receive, transmit };

/// Value of sub-index 00h of the mapping record of a multiplexed PDO.
enum class MpdoMode : std::uint8_t { none = 0, source = 0xFE, destination = 0xFF };

/// Mode for the value of sub-index 00h; none for the 0 to 64 entries of an ordinary PDO.
constexpr MpdoMode mpdo_mode(unsigned mapped_entries) {
  constexpr auto first = static_cast<unsigned>(MpdoMode::source);
  return mapped_entries - first <= 1 ? static_cast<MpdoMode>(mapped_entries) : MpdoMode::none;
}

/// Data of a PDO, as in a frame; bytes behind the last one are zero.
using PdoImage = std::array<std::uint8_t, pdo_bytes_max>;

/// Set of PDOs of one direction by position, one bit for each.
class PdoSet {
 public:
  /// Adds or removes a member; `position` is 0 to 511.
  void set(unsigned position, bool is_in) {
    const std::uint64_t bit = std::uint64_t{1} << position % 64;
    std::uint64_t& word = words_[position / 64];
    word = is_in ? word | bit : word & ~bit;
  }
  /// First member from `position` on; `count` or above if there is none below `count`.
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

/// One value of a PDO: the operations on it, resolved when the mapping is set, and its link in a
/// table that finds it by its place (see Tpdos). The owner of PDOs provides the memory; a small
/// machine needs none.
class MappedValue {
 public:
  static constexpr std::uint32_t offset_max = 0x1FF'FFFF;  ///< 32 MiB of values in a dictionary
  static constexpr unsigned bytes_max = 16;  ///< for the greatest number of bits that fits

  /// Operations beside copying: bits.
  enum Deed : std::uint8_t {
    nothing_more = 0,
    limit = 1,      ///< check of a range
    ask = 2,        ///< a service may refuse the value
    notify = 4,     ///< a service is notified of the write
    watch = 8,      ///< a TPDO maps the value
    set_text = 16,  ///< set a string, with its length
    skip = 32,      ///< skip a dummy entry
    refresh = 64,   ///< a service may refresh the value before it is sent
    /// Of an RPDO: its values are copied one by one.
    apart = 128,
  };

  /// Sets place and length. False if both were the same before.
  bool set(const EntryPlace& place, unsigned bits) {
    const std::uint32_t wanted = place.offset | bits << bits_shift;
    const bool is_same = std::exchange(offset_and_bits_, wanted) == wanted;
    object_ = place.object;
    row_ = place.row;
    index_ = place.index;
    sub_ = place.sub;
    return !is_same;
  }
  /// Place of the value in the dictionary.
  EntryPlace place() const { return {offset(), object_, row_, index_, sub_}; }
  /// Bytes from the start of the dictionary's values; 0 to offset_max.
  std::uint32_t offset() const { return offset_and_bits_ & offset_max; }
  /// Mapped length in bits; 0: nothing is mapped here.
  unsigned bits() const { return offset_and_bits_ >> bits_shift; }
  /// All deeds, as bits.
  unsigned deeds() const { return deeds_; }
  /// True if one of these deeds is needed.
  bool is(unsigned deeds) const { return (deeds_ & deeds) != 0; }
  /// Lowest and highest value, if it has a range.
  const std::int64_t* limits() const { return limits_; }

  /// Sets the deeds: bits of Deed.
  void resolve(unsigned deeds) { deeds_ = static_cast<std::uint8_t>(deeds); }
  /// For an RPDO: sets also range, and whom to ask and to notify.
  void resolve(unsigned deeds, const std::int64_t* limits, const EntryHooks& hooks) {
    resolve(deeds);
    limits_ = limits;
    context_ = hooks.context;
    ask_ = hooks.ask;
    notify_ = hooks.notify;
  }
  /// For an RPDO: a service may refuse the value.
  bool asks() const { return ask_ != nullptr; }
  /// First refusal of the services. Only if asks().
  AbortCode ask_for(const Entry& entry, std::span<const std::uint8_t> value) const {
    return ask_(context_, entry, value);
  }
  /// Notifies the services of the write. Only for the deed `notify`.
  void notify_of(const Entry& entry) const { notify_(context_, entry, Source::pdo); }

 private:
  friend class PlacesOfValues;
  static constexpr unsigned bits_shift = 25;

  // For an RPDO, see EntryHooks.
  void* context_ = nullptr;  ///< for a TPDO, the PDO
  decltype(EntryHooks::notify) notify_ = nullptr;
  decltype(EntryHooks::ask) ask_ = nullptr;
  const std::int64_t* limits_ = nullptr;
  std::uint32_t offset_and_bits_ = 0;
  std::uint16_t object_ = 0;
  std::uint16_t row_ = 0;
  std::uint16_t index_ = 0;
  std::uint8_t sub_ = 0;
  std::uint8_t deeds_ = 0;
  // For a TPDO, which is in PlacesOfValues.
  std::uint16_t next_ = 0;    ///< position from 1 of the next value with the same hash
  std::uint16_t bucket_ = 0;  ///< first value with the hash equal to this position; or 0
};
static_assert(sizeof(void*) != 8 || sizeof(MappedValue) == 48,
              "some devices have thousands of mapped values");

/// Finds mapped values by their places: a hash table in their own memory.
class PlacesOfValues {
 public:
  static constexpr unsigned nothing = UINT32_MAX;  ///< no position

  /// Makes an empty table; `count` is at most 65,534.
  PlacesOfValues(MappedValue* values, unsigned count) : values_(values), count_(count) {}

  /// Removes all values. Linear in their number.
  void clear() {
    for (unsigned i = 0; i < count_; ++i) values_[i].bucket_ = 0;
  }
  /// Adds a value that is not in the table, of the TPDO `owner`.
  void add(unsigned position, void* owner) {
    values_[position].context_ = owner;
    std::uint16_t& bucket = values_[hash(values_[position].offset())].bucket_;
    values_[position].next_ = bucket;
    bucket = static_cast<std::uint16_t>(position + 1);
  }
  /// Positions of the values at `place`, one after the other; nothing after the last one.
  unsigned first(std::uint32_t place) const { return seek(values_[hash(place)].bucket_, place); }
  /// The TPDO of add().
  void* owner(unsigned position) const { return values_[position].context_; }
  /// Position of the next value at the place of the one at `position`.
  unsigned next(unsigned position) const {
    return seek(values_[position].next_, values_[position].offset());
  }

 private:
  unsigned seek(unsigned candidate, std::uint32_t offset) const {
    while (candidate != 0 && values_[candidate - 1].offset() != offset) {
      candidate = values_[candidate - 1].next_;
    }
    return candidate == 0 ? nothing : candidate - 1;
  }
  /// Fibonacci hashing, scaled to the number of values.
  unsigned hash(std::uint32_t offset) const {
    return static_cast<unsigned>(std::uint64_t{offset * 0x9E37'79B9U} * count_ >> 32);
  }

  MappedValue* values_;
  unsigned count_;
};

}  // namespace canvoy
