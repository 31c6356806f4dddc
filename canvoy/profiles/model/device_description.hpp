// The contents of one kind of device, selected from all that the specifications describe: "my
// device = these objects of CiA 301, this profile, and my own".
//
//     constexpr auto my_charger = describe(cia419::charger({.rpdo2 = true, .tpdo2 = true}),
//                                          cia301::identity({.vendor_id = 0x123}),
//                                          cia301::heartbeat_producer(1000),
//                                          cia301::heartbeat_consumers(2),
//                                          my_object);
//     constexpr auto layout = lay_out_device<my_charger>();  // canvoy/profiles/model/layout.hpp
//
// All work is done at compile time.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "canvoy/canopen/dictionary/dictionary_layout.hpp"
#include "canvoy/profiles/model/description.hpp"
#include "canvoy/profiles/model/mapping_value.hpp"

namespace canvoy {

/// An object of one device: whole, or with changes that the specification leaves to the device.
class Part {
 public:
  /// One thing in which a device differs from the description of an object.
  struct Change {
    /// What is changed: default, access, or whether the entry exists.
    enum class Kind : std::uint8_t { initial, access, without };
    Kind kind = Kind::initial;     ///< which of the members below counts
    std::uint8_t sub = 0;          ///< sub-index of the entry
    Access access = Access::none;  ///< if `access` is changed
    Default initial = {};          ///< if the default is changed
  };

  /// Whether storage keeps the values of the object that SDO can read and write.
  enum class Retention : std::uint8_t { by_mapping, stored, not_stored };

  constexpr Part() = default;
  /// The whole object as described, which must be static.
  constexpr Part(const ObjectInfo& object)  // NOLINT(google-explicit-constructor)
      : object_(&object), index_(object.index), count_(object.count) {}

  /// For objects of one shape: keeps only `count` of them, from `first` on (0 is the first).
  constexpr Part only(unsigned first, unsigned count = 1) const {
    Part part = *this;
    if (first + count > object_->count) detail::description_is_wrong("there are not as many");
    part.index_ = static_cast<std::uint16_t>(object_->index + first);
    part.count_ = static_cast<std::uint16_t>(count);
    return part;
  }
  /// The object moved to another block: that of the second lift, or the third battery.
  constexpr Part moved(unsigned offset) const {
    Part part = *this;
    part.index_ = static_cast<std::uint16_t>(index_ + offset);
    return part;
  }
  /// Leaves out the entries above `sub`.
  constexpr Part up_to(unsigned sub) const {
    Part part = *this;
    part.highest_sub_ = static_cast<std::uint8_t>(sub);
    return part;
  }
  /// Leaves out an optional entry.
  constexpr Part without(unsigned sub) const {
    return changed({Change::Kind::without, static_cast<std::uint8_t>(sub), Access::none, {}});
  }
  /// Keeps, of the optional entries, only those for which `keep` is true, by their sub-index. Of
  /// several entries of one shape, the first ones may stay.
  template <class Keep>
  constexpr Part keeping(Keep keep) const {
    Part part = *this;
    for (const EntryInfo& entry : object_->entries()) {
      bool is_kept = keep(unsigned{entry.sub_first});
      for (unsigned sub = entry.sub_first + 1U; is_kept && sub <= entry.last_sub(); ++sub) {
        if (keep(sub)) continue;
        part.absent_[sub / 64] |= std::uint64_t{1} << sub % 64;
        is_kept = false;
      }
      if (keep(unsigned{entry.sub_first})) continue;
      if (entry.category == Category::mandatory) {
        detail::description_is_wrong("a mandatory entry cannot be left out");
      }
      part.absent_[entry.sub_first / 64] |= std::uint64_t{1} << entry.sub_first % 64;
    }
    return part;
  }
  /// Sets another default.
  constexpr Part initial(unsigned sub, Default value) const {
    return changed({Change::Kind::initial, static_cast<std::uint8_t>(sub), Access::none, value});
  }
  /// Sets another default of a variable.
  constexpr Part initial(Default value) const { return initial(0, value); }
  /// Sets another access, where the specification leaves a choice.
  constexpr Part access(unsigned sub, Access value) const {
    return changed({Change::Kind::access, static_cast<std::uint8_t>(sub), value, {}});
  }
  /// Makes all entries read only, where the specification allows that, as for PDO parameters.
  constexpr Part constant() const {
    Part part = *this;
    part.constant_ = true;
    return part;
  }
  /// The object of a device that consumes it and does not provide it.
  constexpr Part consumed() const {
    Part part = *this;
    part.consumed_ = true;
    return part;
  }

  /// Sets this access for the entries that leave it to the virtual device.
  constexpr Part by_device(Access value) const {
    Part part = *this;
    part.device_access_ = value;
    return part;
  }
  /// Sets the number of bytes of its strings, where the specification gives no length.
  constexpr Part capacity(unsigned bytes) const {
    Part part = *this;
    part.capacity_ = static_cast<std::uint16_t>(bytes);
    return part;
  }

  /// Sets whether it is kept without power, whatever its mapping.
  constexpr Part stored(bool value = true) const {
    Part part = *this;
    part.retention_ = value ? Retention::stored : Retention::not_stored;
    return part;
  }

  /// The description of the object, or of the first one of its shape.
  constexpr const ObjectInfo& object() const { return *object_; }
  /// Index in this device, of the first of count() objects.
  constexpr std::uint16_t index() const { return index_; }
  /// Number of objects with consecutive indices.
  constexpr std::uint16_t count() const { return count_; }
  /// True if constant() made its entries read only.
  constexpr bool is_constant() const { return constant_; }
  /// True if the device consumes it and does not provide it.
  constexpr bool is_consumed() const { return consumed_; }
  /// none: as in the entries.
  constexpr Access device_access() const { return device_access_; }
  /// 0: as in the entries.
  constexpr std::uint16_t capacity() const { return capacity_; }
  /// Whether it is kept without power.
  constexpr Retention retention() const { return retention_; }
  /// True if the device has this entry of the object.
  constexpr bool has(const EntryInfo& entry) const {
    return !is_absent(entry.sub_first) && entry.sub_first <= highest_sub_ &&
           find_change(Change::Kind::without, entry.sub_first) == nullptr;
  }
  /// Last sub-index of an entry that the device has.
  constexpr std::uint8_t last_sub(const EntryInfo& entry) const {
    unsigned last = entry.sub_first;
    while (last < entry.last_sub() && last < highest_sub_ && !is_absent(last + 1)) ++last;
    return static_cast<std::uint8_t>(last);
  }
  /// Value of sub-index 00h: the highest sub-index that the device has.
  constexpr std::uint8_t highest_sub() const {
    std::uint8_t highest = 0;
    for (const EntryInfo& entry : object_->entries()) {
      if (has(entry)) highest = last_sub(entry);
    }
    return highest;
  }
  /// The change of this kind for a sub-index, or null.
  constexpr const Change* find_change(Change::Kind kind, unsigned sub) const {
    for (std::size_t i = change_count_; i-- > 0;) {
      if (changes_[i].kind == kind && changes_[i].sub == sub) return &changes_[i];
    }
    return nullptr;
  }

 private:
  static constexpr std::size_t change_capacity = 12;

  constexpr bool is_absent(unsigned sub) const { return (absent_[sub / 64] >> sub % 64 & 1) != 0; }
  constexpr Part changed(const Change& change) const {
    const EntryInfo* entry = find_entry(*object_, change.sub);
    if (entry == nullptr) {
      detail::description_is_wrong("a change of an entry that the object does not have");
    } else if (entry->sub_first != entry->last_sub()) {
      detail::description_is_wrong("a change of one of several entries of one shape");
    } else if (change.kind == Change::Kind::without && entry->category == Category::mandatory) {
      detail::description_is_wrong("a mandatory entry cannot be left out");
    }
    Part part = *this;
    if (part.change_count_ == change_capacity) detail::description_is_wrong("too many changes");
    part.changes_[part.change_count_++] = change;
    return part;
  }

  const ObjectInfo* object_ = nullptr;
  std::uint16_t index_ = 0;
  std::uint16_t count_ = 0;
  std::uint8_t highest_sub_ = 0xFF;
  std::uint16_t capacity_ = 0;
  bool consumed_ = false;
  bool constant_ = false;
  Access device_access_ = Access::none;
  Retention retention_ = Retention::by_mapping;
  std::uint8_t change_count_ = 0;
  /// A bit for each sub-index that is left out; for entries of one shape, the bit of the first.
  std::array<std::uint64_t, 4> absent_{};
  std::array<Change, change_capacity> changes_{};
};

/// A PDO mapping record with constant entries. The number of entries is then constant, too (CiA
/// 301, 7.5.2.36; CiA 419 leaves the choice, errata 11).
constexpr Part fixed_mapping(const ObjectInfo& record) {
  return Part(record).access(0, Access::ro);
}

/// A set of parts, sorted by index. Each index occurs once.
template <std::size_t capacity_>
class DeviceDescription {
 public:
  static constexpr std::size_t capacity = capacity_;  ///< parts

  constexpr DeviceDescription() = default;

  /// Adds a part. One with an index that exists already does not compile.
  constexpr void add(const Part& part) {
    std::size_t position = size_;
    for (; position > 0 && parts_[position - 1].index() > part.index(); --position) {
      parts_[position] = parts_[position - 1];
    }
    parts_[position] = part;
    ++size_;
    if (position > 0) check_order(position);
    if (position + 1 < size_) check_order(position + 1);
  }
  /// Moves each part of both once, the last first: compilers limit the number of evaluation steps.
  template <std::size_t other>
  constexpr void add(const DeviceDescription<other>& more) {
    std::size_t own = size_;
    std::size_t others = more.size();
    size_ += others;
    for (std::size_t position = size_; others > 0;) {
      const Part& part = more.begin()[others - 1];
      const bool is_next = own == 0 || parts_[own - 1].index() <= part.index();
      parts_[--position] = is_next ? part : parts_[own - 1];
      --(is_next ? others : own);
      if (position + 1 < size_) check_order(position + 1);
    }
    if (own > 0 && own < size_) check_order(own);
    for (const Profile* profile : more.profiles()) {
      if (profile != nullptr) add(*profile);
    }
  }
  /// Adds both parameters of a PDO.
  constexpr void add_pdo(const Part& parameter, const Part& mapping) {
    add(parameter);
    add(mapping);
  }
  /// Adds the objects of a profile that the PDOs of this device map by default.
  constexpr void add_mapped(const Profile& profile) {
    for (const ObjectInfo* object : profile.objects) {
      if (find(object->index) != nullptr) continue;
      for (const Part& part : *this) {
        if (!maps(part.object(), object->index)) continue;
        add(*object);
        break;
      }
    }
  }
  /// Declares conformity to this profile: its mandatory objects must exist.
  constexpr void add(const Profile& profile) {
    for (const Profile*& place : profiles_) {
      if (place == &profile) return;
      if (place == nullptr) {
        place = &profile;
        return;
      }
    }
    detail::description_is_wrong("too many profiles");
  }

  /// A copy of the device with one object replaced by `part`.
  constexpr DeviceDescription with(const Part& part) const {
    DeviceDescription made = *this;
    made.parts_[position_of(part.index())] = part;
    return made;
  }
  /// A copy of the device with another default of one entry.
  constexpr DeviceDescription initial(const ObjectInfo& object, unsigned sub, Default value) const {
    return with(parts_[position_of(object.index)].initial(sub, value));
  }
  /// A copy of the device without an optional entry.
  constexpr DeviceDescription without(const ObjectInfo& object, unsigned sub) const {
    return with(parts_[position_of(object.index)].without(sub));
  }

  /// A copy of the parts with all entries read only.
  constexpr DeviceDescription constant() const {
    DeviceDescription made = *this;
    for (std::size_t i = 0; i < size_; ++i) made.parts_[i] = parts_[i].constant();
    return made;
  }

  /// The part with this index, or null. Linear in the number of parts.
  constexpr const Part* find(unsigned index) const {
    for (const Part& part : *this) {
      if (index >= part.index() && index - part.index() < part.count()) return &part;
    }
    return nullptr;
  }
  constexpr const Part* begin() const { return parts_.data(); }
  constexpr const Part* end() const { return parts_.data() + size_; }
  constexpr std::size_t size() const { return size_; }
  /// Profiles that the device claims to conform to; null behind the last.
  constexpr const std::array<const Profile*, 4>& profiles() const { return profiles_; }

 private:
  /// Checks the order of the part at `position` and the one before it.
  constexpr void check_order(std::size_t position) const {
    const Part& last = parts_[position - 1];
    if (last.index() + last.count() > parts_[position].index()) {
      detail::description_is_wrong("an object is there twice");
    }
  }
  constexpr std::size_t position_of(unsigned index) const {
    for (std::size_t position = 0; position < size_; ++position) {
      if (parts_[position].index() == index) return position;
    }
    detail::description_is_wrong("a change of an object that is not there");
    return 0;
  }

  std::array<Part, capacity_> parts_{};
  std::size_t size_ = 0;
  std::array<const Profile*, 4> profiles_{};
};

namespace detail {
template <class Item>
inline constexpr std::size_t part_capacity = 1;
template <std::size_t capacity>
inline constexpr std::size_t part_capacity<DeviceDescription<capacity>> = capacity;
}  // namespace detail

/// Combines parts, objects, and sets of them, in any order.
template <class... Pieces>
constexpr auto describe(const Pieces&... pieces) {
  DeviceDescription<(detail::part_capacity<Pieces> + ... + 0)> device;
  (device.add(pieces), ...);
  return device;
}

}  // namespace canvoy
