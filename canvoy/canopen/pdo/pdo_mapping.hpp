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
  /// Bytes of values in a dictionary, of which the last can be mapped: 32 MiB.
  static constexpr std::uint32_t offset_max = 0x1FF'FFFF;
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

  /// Sets entry and length. False if both were the same before. A dummy entry has no row, and its
  /// value is any readable byte.
  bool set(const Entry& entry, unsigned bits) {
    const bool is_same = entry_.value == entry.value && bits_ == bits;
    // Its last bytes, which are unused, have other members.
    entry_.row = entry.row;
    entry_.state = entry.state;
    entry_.value = entry.value;
    entry_.index = entry.index;
    entry_.sub = entry.sub;
    bits_ = static_cast<std::uint8_t>(bits);
    return !is_same;
  }
  /// The mapped entry.
  const Entry& entry() const { return entry_; }
  /// Its value in the dictionary.
  std::uint8_t* value() const { return entry_.value; }
  /// Mapped length in bits; 0: nothing is mapped here.
  unsigned bits() const { return bits_; }
  /// All deeds, as bits.
  unsigned deeds() const { return deeds_; }
  /// True if one of these deeds is needed.
  bool is(unsigned deeds) const { return (deeds_ & deeds) != 0; }

  /// Sets the deeds: bits of Deed.
  void resolve(unsigned deeds) { deeds_ = static_cast<std::uint8_t>(deeds); }
  /// For an RPDO: sets also whom to ask and to notify, and the position from 1 of the only PDO of
  /// its WatchingPdos that a change concerns, or 0.
  void resolve(unsigned deeds, const EntryHooks& hooks, unsigned watcher) {
    resolve(deeds);
    context_ = hooks.context;
    ask_ = hooks.ask;
    notify_ = hooks.notify;
    next_or_watcher_ = static_cast<std::uint16_t>(watcher);
  }
  /// For an RPDO: a service may refuse the value.
  bool asks() const { return ask_ != nullptr; }
  /// First refusal of the services. Only if asks().
  AbortCode ask_for(std::span<const std::uint8_t> value) const {
    const Entry entry = entry_;
    return ask_(context_, entry, value);
  }
  /// Notifies the services of the write. Only for the deed `notify`. They may set another mapping,
  /// which changes this object; their entry stays.
  void notify_of_write() const {
    const Entry entry = entry_;
    notify_(context_, entry, Source::pdo);
  }
  /// For an RPDO: see resolve().
  unsigned watcher() const { return next_or_watcher_; }

 private:
  friend class PlacesOfValues;

  [[no_unique_address]] Entry entry_;
  std::uint8_t deeds_ = 0;
  std::uint8_t bits_ = 0;
  /// For a TPDO, which is in PlacesOfValues, position from 1 of the next value with the same hash.
  std::uint16_t next_or_watcher_ = 0;
  // For an RPDO, see EntryHooks.
  void* context_ = nullptr;  ///< for a TPDO, the PDO
  decltype(EntryHooks::notify) notify_ = nullptr;
  // NOLINTBEGIN(readability-identifier-naming): they are members of the class
  union {
    decltype(EntryHooks::ask) ask_ = nullptr;  ///< for an RPDO, see EntryHooks
    std::uintptr_t bucket_;  ///< for a TPDO, the first value with the hash equal to this position
  };
  // NOLINTEND(readability-identifier-naming)
};
static_assert(is_small_machine || sizeof(void*) != 8 || sizeof(MappedValue) == 56,
              "some devices have thousands of mapped values");

/// Finds mapped values by their places: a hash table in their own memory.
class PlacesOfValues {
 public:
  static constexpr unsigned nothing = UINT32_MAX;  ///< no position

  /// Makes an empty table for values of a dictionary, which begin at `block`; `count` is at most
  /// 65,534.
  PlacesOfValues(MappedValue* values, unsigned count, const std::uint8_t* block)
      : values_(values), block_(block), count_(count) {}

  /// Removes all values. Linear in their number.
  void clear() {
    for (unsigned i = 0; i < count_; ++i) values_[i].bucket_ = 0;
  }
  /// Adds a value that is not in the table, of the TPDO `owner`.
  void add(unsigned position, void* owner) {
    values_[position].context_ = owner;
    const auto offset = static_cast<std::uint32_t>(values_[position].value() - block_);
    std::uintptr_t& bucket = values_[hash(offset)].bucket_;
    values_[position].next_or_watcher_ = static_cast<std::uint16_t>(bucket);
    bucket = position + 1;
  }
  /// Positions of the values at `place`, in bytes from the start of all, one after the other;
  /// nothing after the last one.
  unsigned first(std::uint32_t place) const {
    return seek(static_cast<unsigned>(values_[hash(place)].bucket_), block_ + place);
  }
  /// The TPDO of add().
  void* owner(unsigned position) const { return values_[position].context_; }
  /// Position of the next value at the place of the one at `position`.
  unsigned next(unsigned position) const {
    return seek(values_[position].next_or_watcher_, values_[position].value());
  }

 private:
  unsigned seek(unsigned candidate, const std::uint8_t* place) const {
    while (candidate != 0 && values_[candidate - 1].value() != place) {
      candidate = values_[candidate - 1].next_or_watcher_;
    }
    return candidate == 0 ? nothing : candidate - 1;
  }
  /// Fibonacci hashing, scaled to the number of values.
  unsigned hash(std::uint32_t offset) const {
    return static_cast<unsigned>(std::uint64_t{offset * 0x9E37'79B9U} * count_ >> 32);
  }

  MappedValue* values_;
  const std::uint8_t* block_;
  unsigned count_;
};

}  // namespace canvoy
