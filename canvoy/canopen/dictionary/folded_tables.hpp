// The tables of a node in the fewest bytes, for microcontrollers: they have the contents of the
// layout that they are made from, each thing once.
//
// Four PDOs have four communication records that differ in their defaults only: one shape of an
// object represents all of them, with a count of four in its row.
//
//     static constexpr auto folded = fold_tables<layout>();
//     constexpr DictionaryTables tables = folded.tables();
#pragma once

#include <algorithm>

#include "canvoy/canopen/dictionary/dictionary_layout.hpp"
#include "canvoy/canopen/dictionary/object_index.hpp"

namespace canvoy {

namespace detail {

/// Position of `sequence` in `pool`; appends it if it is absent.
template <class Pool, class Item>
constexpr std::uint16_t place_in(Pool& pool, std::span<const Item> sequence) {
  const Item* found = std::search(pool.begin(), pool.end(), sequence.begin(), sequence.end());
  const auto place = static_cast<std::uint16_t>(found - pool.begin());
  if (found == pool.end()) {
    for (const Item& item : sequence) pool.push_back(item);
  }
  return place;
}

/// True if both are PDO records of one kind, and of one shape.
constexpr bool are_like_records(const ObjectRow& row, const ObjectRow& next) {
  constexpr unsigned of_a_kind = object_index::rpdo_mapping - object_index::rpdo_parameter;
  return row.index >= object_index::rpdo_parameter &&
         next.index <= object_index::tpdo_mapping_last &&
         row.index / of_a_kind == next.index / of_a_kind && row.index + row.count == next.index &&
         row.entry_first == next.entry_first && row.entry_count == next.entry_count;
}

/// Extends `row` by `next`, if that is a similar PDO record with defaults that follow those of
/// the row or equal them. False if it cannot.
constexpr bool join(ObjectRow& row, const ObjectRow& next) {
  if (!are_like_records(row, next) || next.count != 1) return false;
  const bool has_same = row.default_pitch == 0 && next.default_first == row.default_first;
  const bool has_next = (row.count == 1 || row.default_pitch == row.entry_count) &&
                        next.default_first == row.default_first + row.count * row.entry_count;
  if (!has_same && !has_next) return false;
  if (has_next) row.default_pitch = row.entry_count;
  ++row.count;
  return true;
}

/// Folded tables, in arrays with the capacity of `layout`.
template <class Layout>
constexpr Layout fold(const Layout& layout) {
  const DictionaryTables tables = layout.tables();
  Layout folded;
  folded.value_bytes = layout.value_bytes;
  folded.index_in_tables = layout.index_in_tables;
  for (const std::string_view text : layout.texts) folded.texts.push_back(text);
  for (ObjectRow object : layout.objects) {
    Counted<EntryShape, 256> shapes;
    Counted<std::uint32_t, 256> defaults;
    const std::uint32_t* place = tables.defaults_of(object, object.index);
    for (EntryShape shape : tables.entries_of(object)) {
      if (has(shape.traits, EntryTraits::limited)) {
        const std::size_t count = has(shape.traits, EntryTraits::has_sentinel) ? 3 : 2;
        shape.limits = place_in(folded.numbers, tables.numbers.subspan(shape.limits, count));
      }
      const bool is_wide = !shape.is_text() && shape.capacity > sizeof *place;
      if (is_wide && has(shape.traits, EntryTraits::plus_node_id)) {
        description_is_wrong("a default of more than four bytes follows the node-ID");
      }
      defaults.push_back(is_wide ? place_in(folded.numbers, tables.numbers.subspan(*place, 1))
                                 : *place);
      ++place;
      shapes.push_back(shape);
    }
    object.entry_first = place_in(folded.entries, std::span<const EntryShape>(shapes));
    object.default_first = place_in(folded.defaults, std::span<const std::uint32_t>(defaults));
    ObjectRow* previous =
        folded.objects.count == 0 ? nullptr : &folded.objects.items[folded.objects.count - 1];
    if (previous == nullptr || !join(*previous, object)) folded.objects.push_back(object);
  }
  return folded;
}

}  // namespace detail

/// Folds `layout`, a DictionaryLayout of static storage. Consecutive objects of one shape become
/// one row; on a host, which keeps an ObjectState for each row, this would distinguish objects less
/// well.
template <const auto& layout>
constexpr auto fold_tables() {
  constexpr auto folded = detail::fold(layout);
  DictionaryLayout<folded.objects.count, folded.entries.count, folded.defaults.count,
                   folded.numbers.count, folded.texts.count>
      exact;
  for (const ObjectRow& object : folded.objects) exact.objects.push_back(object);
  for (const EntryShape& entry : folded.entries) exact.entries.push_back(entry);
  for (const std::uint32_t place : folded.defaults) exact.defaults.push_back(place);
  for (const std::int64_t number : folded.numbers) exact.numbers.push_back(number);
  for (const std::string_view text : folded.texts) exact.texts.push_back(text);
  exact.value_bytes = folded.value_bytes;
  exact.index_in_tables = folded.index_in_tables;
  return exact;
}

}  // namespace canvoy
