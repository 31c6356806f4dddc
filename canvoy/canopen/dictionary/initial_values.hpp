// The block of values as it is after power-on, for the tables of a node on a host: a reset copies
// it, where it would go through all rows.
//
//     static constexpr DictionaryTables tables = tables_with_initial_values<layout>();
#pragma once

#include <array>

#include "canvoy/canopen/dictionary/dictionary_layout.hpp"

namespace canvoy {

namespace detail {

/// True if a default is not zero, node-ID included.
constexpr bool is_given(const DictionaryTables& tables, const EntryShape& row,
                        std::uint32_t place) {
  if (row.is_text()) return !tables.texts[place].empty();
  return has(row.traits, EntryTraits::plus_node_id) || tables.number_at(row, place) != 0;
}

/// Writes a default to its place, which is zero.
constexpr void write_default(const DictionaryTables& tables, const EntryShape& row,
                             std::uint32_t place, std::uint8_t* to) {
  if (!row.is_text()) {
    std::uint64_t number = tables.number_at(row, place);
    for (unsigned i = 0; i < row.capacity && number != 0; ++i, number >>= 8) {
      to[i] = static_cast<std::uint8_t>(number);
    }
    return;
  }
  const std::string_view text = tables.texts[place].substr(0, row.capacity);
  *to++ = static_cast<std::uint8_t>(text.size());
  *to++ = static_cast<std::uint8_t>(text.size() >> 8);
  for (const char character : text) *to++ = static_cast<std::uint8_t>(character);
}

}  // namespace detail

/// Writes the defaults of all entries to `bytes`: DictionaryTables::value_bytes, which are zero.
/// Calls each(InitialValues::WithNodeId) for each to which the node-ID is to be added, in order.
template <class Each>
constexpr void write_defaults(const DictionaryTables& tables, std::span<std::uint8_t> bytes,
                              Each each) {
  std::uint32_t offset = 0;
  const auto write = [&](const EntryShape& row, std::uint32_t place) {
    std::uint32_t at = offset;
    const unsigned count = row.sub_last - row.sub_first + 1U;
    offset += count * row.pitch();
    if (!detail::is_given(tables, row, place)) return;
    for (; at != offset; at += row.pitch()) {
      detail::write_default(tables, row, place, bytes.data() + at);
      if (has(row.traits, EntryTraits::plus_node_id)) each({at, row.capacity});
    }
  };
  for (const ObjectRow& object : tables.objects) {
    for (unsigned index = object.index; index < unsigned{object.index} + object.count; ++index) {
      const std::uint32_t* place = tables.defaults_of(object, index);
      for (const EntryShape& row : tables.entries_of(object)) write(row, *place++);
    }
  }
}

namespace detail {

constexpr std::size_t count_with_node_id(const DictionaryTables& tables) {
  std::size_t count = 0;
  for (const ObjectRow& object : tables.objects) {
    for (const EntryShape& row : tables.entries_of(object)) {
      if (!has(row.traits, EntryTraits::plus_node_id)) continue;
      count += object.count * (row.sub_last - row.sub_first + 1U);
    }
  }
  return count;
}

template <const auto& layout>
struct InitialBlock {
  static constexpr DictionaryTables tables = layout.tables();

  constexpr InitialBlock() {
    std::size_t count = 0;
    write_defaults(tables, bytes,
                   [&](const InitialValues::WithNodeId& each) { with_node_id[count++] = each; });
  }

  std::array<std::uint8_t, tables.value_bytes> bytes{};
  std::array<InitialValues::WithNodeId, count_with_node_id(tables)> with_node_id{};
};
template <const auto& layout>
inline constexpr InitialBlock<layout> initial_block{};

}  // namespace detail

/// Size up to which the block of defaults is made: a compiler allows its evaluation so many steps,
/// and the block stands in the program a second time.
inline constexpr std::uint32_t initial_bytes_max = 16 * 1024;

/// Tables of a layout, a DictionaryLayout of static storage, with the block of its defaults; of
/// more than `initial_bytes_max`, without one: a reset goes through their rows.
template <const auto& layout>
constexpr DictionaryTables tables_with_initial_values() {
  DictionaryTables tables = layout.tables();
  if constexpr (layout.tables().value_bytes <= initial_bytes_max) {
    const detail::InitialBlock<layout>& block = detail::initial_block<layout>;
    tables.initial.value = {.bytes = block.bytes, .with_node_id = block.with_node_id};
  }
  return tables;
}

}  // namespace canvoy
