// Where the inputs, outputs or sensors of a device stand in its dictionary: groups of up to 254, up
// to 32 groups for each of 8 lifts (CiA 417-4, 4.3.1). All of them are counted from 0 on, in the
// order of their objects, so that their states can stand in one array.
//
//     const IoGroups inputs(dictionary, input_group_object.index);
//     const IoPlace place = inputs.place(3);       // 6100h:04h
//     inputs.position(place.index, place.sub);     // 3
//
// Costs nothing but a few words: everything is read from the tables of the dictionary, in a time
// that is linear in the number of groups.
#pragma once

#include <cstdint>

#include "canvoy/canopen/dictionary.hpp"
#include "canvoy/profiles/cia417/inputs.hpp"

namespace canvoy::cia417 {

/// Entry of a group: index and sub-index.
struct IoPlace {
  std::uint16_t index = 0;
  std::uint8_t sub = 0;

  constexpr bool operator==(const IoPlace&) const = default;
};

/// Position of nothing.
inline constexpr std::uint32_t io_nowhere = 0xFFFF'FFFF;

/// Whether `index` is one of 32 objects from `first` on (its index in lift 1), in any lift.
constexpr bool is_group_of(unsigned index, unsigned first) {
  if (index < 0x6000 || index >= 0x6000 + lift_count * block_pitch) return false;
  const unsigned in_lift_1 = 0x6000 + (index - 0x6000) % block_pitch;
  return in_lift_1 >= first && in_lift_1 < first + group_count;
}

constexpr std::uint32_t entries_of(const DictionaryTables& tables, const ObjectRow& object) {
  if (object.entry_count == 0) return 0;
  return tables.entries[object.entry_first + std::size_t{object.entry_count} - 1].sub_last;
}

/// How many there are: for memory that is laid out at compile time.
constexpr std::uint32_t count_in_groups(const DictionaryTables& tables, unsigned first) {
  std::uint32_t count = 0;
  for (const ObjectRow& object : tables.objects) {
    if (is_group_of(object.index, first)) count += object.count * entries_of(tables, object);
  }
  return count;
}

class IoGroups {
 public:
  /// `first` is the index of the first group of lift 1: 6100h, 6200h or 6500h. The tables must
  /// outlive this.
  constexpr IoGroups(const DictionaryTables& tables, std::uint16_t first)
      : tables_(&tables), first_(first) {}

  constexpr std::uint32_t size() const { return count_in_groups(*tables_, first_); }

  /// Of input `position`, which is below size().
  constexpr IoPlace place(std::uint32_t position) const {
    for (const ObjectRow& object : tables_->objects) {
      if (!is_group_of(object.index, first_)) continue;
      const std::uint32_t in_each = entries_of(*tables_, object);
      if (position < object.count * in_each) {
        return {static_cast<std::uint16_t>(object.index + position / in_each),
                static_cast<std::uint8_t>(position % in_each + 1)};
      }
      position -= object.count * in_each;
    }
    return {};
  }

  /// io_nowhere where no such entry is. Sub-index 0 is none.
  constexpr std::uint32_t position(IoPlace place) const {
    std::uint32_t before = 0;
    for (const ObjectRow& object : tables_->objects) {
      if (!is_group_of(object.index, first_)) continue;
      const std::uint32_t in_each = entries_of(*tables_, object);
      if (place.index >= object.index && place.index < object.index + object.count) {
        if (place.sub == 0 || place.sub > in_each) return io_nowhere;
        return before + (place.index - object.index) * in_each + place.sub - 1U;
      }
      before += object.count * in_each;
    }
    return io_nowhere;
  }

 private:
  const DictionaryTables* tables_;
  std::uint16_t first_;
};

}  // namespace canvoy::cia417
