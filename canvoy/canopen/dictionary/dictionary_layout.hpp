// Turns rows that say what there is into tables that say where it stands, at compile time.
//
//     constexpr auto layout = lay_out(std::to_array<ObjectRow>({{.index = 0x1000, .entry_count =
//     1}}),
//                                     std::to_array<EntryRow>({{.type = DataType::unsigned32}}));
//     constexpr DictionaryTables tables = layout.tables();
#pragma once

#include <array>
#include <cstddef>

#include "canvoy/canopen/dictionary/dictionary.hpp"

namespace canvoy {

/// The tables of one kind of node; constexpr, or static.
template <std::size_t object_rows, std::size_t entry_rows>
struct DictionaryLayout {
  std::array<ObjectRow, object_rows> objects{};
  std::array<EntryRow, entry_rows> entries{};
  std::uint32_t value_bytes = 0;
  /// See DictionaryTables.
  std::uint16_t (*index_in_tables)(const Dictionary&, std::uint16_t index) = nullptr;

  constexpr DictionaryTables tables() const {
    DictionaryTables tables{objects, entries, value_bytes, index_in_tables};
    if (!needs_check()) tables.check_number = nullptr;
    return tables;
  }

 private:
  /// An entry has limits, or bits of its last byte that are not used.
  constexpr bool needs_check() const {
    for (const EntryRow& entry : entries) {
      const bool is_odd = entry.bits % 8 != 0 && entry.type != DataType::boolean;
      if (is_odd || has(entry.traits, EntryTraits::limited)) return true;
    }
    return false;
  }
};

/// What follows from the type of an entry, so that nobody has to ask for it at run time: bits,
/// traits, pitch, and the capacity of all but strings.
constexpr void fill_in_type(EntryRow& entry) {
  unsigned traits = static_cast<unsigned>(entry.traits);
  if (is_string(entry.type)) {
    traits |= static_cast<unsigned>(EntryTraits::text);
  } else {
    entry.capacity = static_cast<std::uint16_t>(byte_length(entry.type));
  }
  entry.bits = static_cast<std::uint8_t>(bit_length(entry.type));
  if (is_signed(entry.type)) traits |= static_cast<unsigned>(EntryTraits::has_sign);
  if (!is_integer(entry.type)) traits &= ~static_cast<unsigned>(EntryTraits::limited);
  entry.traits = static_cast<EntryTraits>(traits);
  entry.pitch = static_cast<std::uint16_t>(entry.capacity + (entry.is_text() ? 2 : 0));
}

namespace detail {

/// Not constexpr: to reach it in a constant expression is a compile error that names the reason.
inline void description_is_wrong(const char* /*reason*/) {}

constexpr std::uint32_t lay_out_object(ObjectRow& object, std::span<EntryRow> entries) {
  std::uint32_t bytes = 0;
  int previous_sub = -1;
  for (EntryRow& entry : entries) {
    if (entry.sub_first <= previous_sub || entry.sub_last < entry.sub_first) {
      description_is_wrong("sub-indices of an object are not in order");
    }
    previous_sub = entry.sub_last;
    fill_in_type(entry);
    entry.offset = bytes;
    bytes += entry.pitch * (entry.sub_last - entry.sub_first + 1U);
  }
  object.pitch = bytes;
  return bytes * object.count;
}

}  // namespace detail

/// Fills in where entries and values stand, and the lengths of all types that have one length. The
/// entries of the first object come first, in the order of their sub-indices, then those of the
/// second. Of a string the capacity is kept.
template <std::size_t object_rows, std::size_t entry_rows>
constexpr DictionaryLayout<object_rows, entry_rows> lay_out(
    std::array<ObjectRow, object_rows> objects, std::array<EntryRow, entry_rows> entries) {
  DictionaryLayout<object_rows, entry_rows> layout{objects, entries};
  std::size_t entry_first = 0;
  int previous_index = -1;
  for (ObjectRow& object : layout.objects) {
    if (object.index <= previous_index || object.count == 0) {
      detail::description_is_wrong("objects are not in order");
    }
    previous_index = object.index + object.count - 1;
    object.entry_first = static_cast<std::uint16_t>(entry_first);
    object.offset = layout.value_bytes;
    layout.value_bytes += detail::lay_out_object(
        object, std::span(layout.entries).subspan(entry_first, object.entry_count));
    entry_first += object.entry_count;
  }
  if (entry_first != entry_rows) detail::description_is_wrong("entries without an object");
  return layout;
}

}  // namespace canvoy
