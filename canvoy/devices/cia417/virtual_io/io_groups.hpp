// Location of the inputs, outputs or sensors of a device in its dictionary: groups of up to 254, up
// to 32 groups for each of 8 lifts (CiA 417-4, 4.3.1). They are counted from 0, in the order of
// their objects, so that one array can hold their states.
//
//     const IoGroups inputs(dictionary, input_group_object.index);
//     const IoPlace place = inputs.place(3);       // 6100h:04h
//     inputs.position(place);                      // 3
//
// Takes only a few words of memory: everything is read from the tables of the dictionary, in time
// linear in the number of groups. Construction is linear in the number of objects.
#pragma once

#include <cstdint>
#include <span>

#include "canvoy/canopen/dictionary/dictionary.hpp"
#include "canvoy/canopen/protocol/error.hpp"
#include "canvoy/profiles/cia417/errors.hpp"
#include "canvoy/profiles/cia417/inputs.hpp"

namespace canvoy::cia417 {

/// Entry of a group: index and sub-index.
struct IoPlace {
  std::uint16_t index = 0;  ///< of the group
  std::uint8_t sub = 0;     ///< of the input, output or sensor

  constexpr bool operator==(const IoPlace&) const = default;
};

// Bytes and bits of the parameters of inputs, outputs and sensors.
inline constexpr unsigned enable_byte = 0;      ///< of parameter 1
inline constexpr unsigned error_code_byte = 1;  ///< of parameter 1
inline constexpr unsigned debounce_byte = 0;    ///< of parameter 3
inline constexpr unsigned edge_byte = 1;        ///< of parameter 3
inline constexpr unsigned rising_bit = 0x01;    ///< of the edges
inline constexpr unsigned falling_bit = 0x02;   ///< of the edges
inline constexpr unsigned polarity_bit = 0x80;  ///< of the edge byte

inline constexpr std::uint32_t one_second = 1'000'000;  ///< in ticks, see low_ticks()

/// Compares two ticks less than 35 min apart: true if `now` is not before `at`.
constexpr bool is_over(std::uint32_t at, std::uint32_t now) {
  return static_cast<std::int32_t>(now - at) >= 0;
}

/// Position if there is none.
inline constexpr std::uint32_t io_nowhere = 0xFFFF'FFFF;

/// Error of a defective input or sensor: FF04h, with its number counted from 1 (CiA 417-1, 8.4).
constexpr Error defect_of(std::uint32_t number) {
  return {.code = emergency_code::application_error,
          .instance = static_cast<std::uint16_t>(number + 1),
          .register_bits = error_register::profile};
}

/// True if `index` is one of 32 objects from `first` on (its index in lift 1), in any lift.
constexpr bool is_group_of(unsigned index, unsigned first) {
  if (index < 0x6000 || index >= 0x6000 + lift_count * block_pitch) return false;
  const unsigned in_lift_1 = 0x6000 + (index - 0x6000) % block_pitch;
  return in_lift_1 >= first && in_lift_1 < first + group_count;
}

/// Entries of a group, without sub-index 00h.
constexpr std::uint32_t entries_of(const DictionaryTables& tables, const ObjectRow& object) {
  if (object.entry_count == 0) return 0;
  return tables.entries_of(object).back().sub_last;
}

/// Their number, for memory that is laid out at compile time.
constexpr std::uint32_t count_in_groups(const DictionaryTables& tables, unsigned first) {
  std::uint32_t count = 0;
  for (const ObjectRow& object : tables.objects) {
    if (is_group_of(object.index, first)) count += object.count * entries_of(tables, object);
  }
  return count;
}

// Parameters: 20h, 40h ... above the groups, at the same sub-indices (4.3.2, 4.5.1).

inline constexpr std::uint16_t parameter_pitch = 0x20;  ///< distance of the objects of parameters
/// A byte of a parameter that is not used or does not exist.
inline constexpr std::uint8_t parameter_not_used = 0xFF;

/// The byte `byte` of parameter `number` (from 1) of the entry at `place`.
inline std::uint8_t parameter_byte(const Dictionary& dictionary, IoPlace place, unsigned number,
                                   unsigned byte) {
  const auto index = static_cast<std::uint16_t>(place.index + number * parameter_pitch);
  const Result<Entry> entry = dictionary.find(index, place.sub);
  return entry && byte < entry->row->capacity ? entry->value[byte] : parameter_not_used;
}
/// Sets one byte of parameter `number`, where the dictionary has it.
inline void set_parameter_byte(Dictionary& dictionary, IoPlace place, unsigned number,
                               unsigned byte, std::uint8_t value) {
  const auto index = static_cast<std::uint16_t>(place.index + number * parameter_pitch);
  const std::uint64_t written = dictionary.number(index, place.sub);
  const std::uint64_t others = ~(std::uint64_t{0xFF} << (8 * byte));
  dictionary.set_number(index, place.sub, (written & others) | std::uint64_t{value} << (8 * byte));
}
/// The entry to which a parameter belongs, or the group's own entry; `first` is the index of the
/// first group in lift 1.
constexpr IoPlace place_of_parameter(IoPlace entry, std::uint16_t first) {
  const unsigned offset = (unsigned{entry.index} - first) % block_pitch;
  return {static_cast<std::uint16_t>(entry.index - offset / parameter_pitch * parameter_pitch),
          entry.sub};
}

// Bytes of parameter 2 that count events in a second (4.3.3, 4.5.2 and 4.13.3).
inline constexpr unsigned limitation_byte = 1;   ///< greatest number of events
inline constexpr unsigned start_event_byte = 2;  ///< sending event, reception event

/// Refuses event counts of 00h, which is reserved; `parameter_2` is the index of that parameter in
/// the first group of lift 1.
constexpr AbortCode check_event_counts(const Entry& entry, std::span<const std::uint8_t> value,
                                       std::uint16_t parameter_2) {
  if (!is_group_of(entry.index, parameter_2) || entry.sub == 0) return AbortCode::none;
  const bool is_reserved = value[limitation_byte] == 0 || value[start_event_byte] == 0;
  return is_reserved ? AbortCode::value_range : AbortCode::none;
}

/// Before any record was sent, the PDO that is sent at the start carries this one.
inline void begin_mapping(Dictionary& dictionary, std::uint16_t mapping, std::uint64_t record) {
  if (dictionary.number(mapping, 0) == 0) dictionary.set_number(mapping, 0, record);
}

/// `hook` for lift `lift`.
constexpr AccessHandlers in_lift(unsigned lift, AccessHandlers hook) {
  hook.first = static_cast<std::uint16_t>(hook.first + block_shift(lift));
  hook.last = static_cast<std::uint16_t>(hook.last + block_shift(lift));
  return hook;
}

class IoGroups {
 public:
  /// `first` is the index of the first group of lift 1: 6100h, 6200h or 6500h. The tables must
  /// outlive this.
  constexpr IoGroups(const DictionaryTables& tables, std::uint16_t first)
      : tables_(&tables), first_(first) {
    while (!rows_.empty() && !is_group_of(rows_.front().index, first)) rows_ = rows_.subspan(1);
    while (!rows_.empty() && !is_group_of(rows_.back().index, first)) {
      rows_ = rows_.first(rows_.size() - 1);
    }
  }

  constexpr std::uint32_t size() const { return count_in_groups(*tables_, first_); }

  /// Location of input `position`, which is below size().
  constexpr IoPlace place(std::uint32_t position) const {
    for (const ObjectRow& object : rows_) {
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

  /// Calls visit(position, place) for each, in their order.
  template <class Visit>
  constexpr void for_each(Visit visit) const {
    for_each_group([&visit](std::uint32_t position, std::uint16_t index, unsigned count) {
      for (unsigned sub = 1; sub <= count; ++sub) {
        visit(position++, IoPlace{index, static_cast<std::uint8_t>(sub)});
      }
    });
  }

  /// Calls visit(position, index, count) for each group, in order: it has `count` inputs from
  /// sub-index 1 on, of which the first has this position.
  template <class Visit>
  constexpr void for_each_group(Visit visit) const {
    std::uint32_t position = 0;
    for (const ObjectRow& object : rows_) {
      if (!is_group_of(object.index, first_)) continue;
      const std::uint32_t in_each = entries_of(*tables_, object);
      for (unsigned group = 0; group < object.count; ++group) {
        visit(position, static_cast<std::uint16_t>(object.index + group), in_each);
        position += in_each;
      }
    }
  }

  /// io_nowhere if there is no such entry. Sub-index 0 is none.
  constexpr std::uint32_t position(IoPlace place) const {
    std::uint32_t before = 0;
    for (const ObjectRow& object : rows_) {
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
  /// From the first group to the last, with the objects of other lifts between them.
  std::span<const ObjectRow> rows_ = tables_->objects;
  std::uint16_t first_;
};

}  // namespace canvoy::cia417
