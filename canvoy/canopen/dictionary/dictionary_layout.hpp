// Turns rows that describe entries into tables with their positions, at compile time.
//
//     constexpr auto layout = lay_out(std::to_array<ObjectRow>({{.index = 0x1000, .entry_count =
//     1}}),
//                                     std::to_array<EntryRow>({{.type = DataType::unsigned32}}));
//     constexpr DictionaryTables tables = layout.tables();
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <utility>

#include "canvoy/canopen/dictionary/dictionary.hpp"

namespace canvoy {

/// Description of entries of one shape: sub-indices first to last of an object, all of one type,
/// access, range and default.
struct EntryRow {
  std::uint8_t sub_first = 0;              ///< the first sub-index
  std::uint8_t sub_last = 0;               ///< the last one, included
  DataType type = DataType::unsigned8;     ///< of each value
  Access access = Access::ro;              ///< rights of clients, and PDOs that may map it
  EntryTraits traits = EntryTraits::none;  ///< what the numbers below mean
  std::uint16_t capacity = 0;              ///< length limit of a string, in bytes
  std::int64_t low = 0;                    ///< smallest value, if EntryTraits::limited
  std::int64_t high = 0;                   ///< largest value, if EntryTraits::limited
  std::int64_t sentinel = 0;           ///< allowed beyond the limits, if EntryTraits::has_sentinel
  std::int64_t initial = 0;            ///< the default: a number, or the bits of a real
  std::string_view initial_text = {};  ///< the default of a string
};

namespace detail {

/// Up to `most` items, filled by the compiler, which determines their number at the end only.
template <class Item, std::size_t most>
struct Counted {
  std::array<Item, most> items{};
  std::size_t count = 0;

  constexpr std::size_t size() const { return count; }
  constexpr void push_back(const Item& item) { items[count++] = item; }
  constexpr const Item* begin() const { return items.data(); }
  constexpr const Item* end() const { return items.data() + count; }
  constexpr const Item& operator[](std::size_t i) const { return items[i]; }
};

}  // namespace detail

/// The tables of one kind of node; constexpr, or static.
template <std::size_t object_rows, std::size_t entry_rows, std::size_t defaults_max = entry_rows,
          std::size_t numbers_max = 4 * entry_rows, std::size_t texts_max = entry_rows>
struct DictionaryLayout {
  detail::Counted<ObjectRow, object_rows> objects{};        ///< sorted by index
  detail::Counted<EntryShape, entry_rows> entries{};        ///< of each object, sorted by sub-index
  detail::Counted<std::uint32_t, defaults_max> defaults{};  ///< of each entry
  detail::Counted<std::int64_t, numbers_max> numbers{};  ///< limits, sentinels, and long defaults
  detail::Counted<std::string_view, texts_max> texts{};  ///< defaults of strings
  std::uint32_t value_bytes = 0;                         ///< size of the block of values, in bytes
  /// See DictionaryTables.
  std::uint16_t (*index_in_tables)(const Dictionary&, std::uint16_t index) = nullptr;

  /// Tables for nodes of this kind. They refer to this object, which must outlive them.
  constexpr DictionaryTables tables() const {
    DictionaryTables tables{objects, entries,     defaults,       numbers,
                            texts,   value_bytes, index_in_tables};
    if (!needs_check()) tables.check_number = nullptr;
    return tables;
  }

 private:
  /// True if an entry has limits, or unused bits in its last byte.
  constexpr bool needs_check() const {
    for (const EntryShape& entry : entries) {
      if (entry.bits % 8 != 0 || has(entry.traits, EntryTraits::limited)) return true;
    }
    return false;
  }
};

namespace detail {

/// Not constexpr: a call in a constant expression is a compile error that names the reason.
inline void description_is_wrong(const char* /*reason*/) {}

/// Shape that follows from the type of an entry, so that run time needs no test of the type: bits,
/// traits, and the capacity of all types but strings.
constexpr EntryShape shape_of(const EntryRow& entry) {
  unsigned traits = static_cast<unsigned>(entry.traits);
  if (is_string(entry.type)) traits |= static_cast<unsigned>(EntryTraits::text);
  if (is_signed(entry.type)) traits |= static_cast<unsigned>(EntryTraits::has_sign);
  if (!is_integer(entry.type)) traits &= ~static_cast<unsigned>(EntryTraits::limited);
  return {.sub_first = entry.sub_first,
          .sub_last = entry.sub_last,
          .type = entry.type,
          .access = entry.access,
          .traits = static_cast<EntryTraits>(traits),
          .bits = static_cast<std::uint8_t>(bit_length(entry.type)),
          .capacity = is_string(entry.type) ? entry.capacity
                                            : static_cast<std::uint16_t>(byte_length(entry.type))};
}

constexpr BlockOffset block_offset(std::uint32_t bytes) {
  if (bytes > std::numeric_limits<BlockOffset>::max()) {
    description_is_wrong("more values than a small machine has memory for");
  }
  return static_cast<BlockOffset>(bytes);
}

/// Adds limits to the tables, and returns their position.
template <class Tables>
constexpr std::uint16_t add_limits(Tables& tables, const EntryRow& entry) {
  const std::size_t place = tables.numbers.size();
  tables.numbers.push_back(entry.low);
  tables.numbers.push_back(entry.high);
  if (has(entry.traits, EntryTraits::has_sentinel)) tables.numbers.push_back(entry.sentinel);
  return static_cast<std::uint16_t>(place);
}

/// Number that represents a default in DictionaryTables::defaults.
template <class Tables>
constexpr std::uint32_t add_default(Tables& tables, const EntryRow& entry,
                                    const EntryShape& shape) {
  if (shape.is_text()) {
    tables.texts.push_back(entry.initial_text);
    return static_cast<std::uint32_t>(tables.texts.size() - 1);
  }
  if (shape.capacity <= sizeof(std::uint32_t)) return static_cast<std::uint32_t>(entry.initial);
  tables.numbers.push_back(entry.initial);
  return static_cast<std::uint32_t>(tables.numbers.size() - 1);
}

}  // namespace detail

/// Appends an object and its entries, in the order of their sub-indices. `tables` are a
/// DictionaryLayout or HeapTables.
template <class Tables>
constexpr void add_object(Tables& tables, ObjectRow object, std::span<const EntryRow> entries) {
  object.entry_count = static_cast<std::uint16_t>(entries.size());
  object.entry_first = static_cast<std::uint16_t>(tables.entries.size());
  object.default_first = static_cast<std::uint16_t>(tables.defaults.size());
  object.offset = detail::block_offset(tables.value_bytes);
  std::uint32_t bytes = 0;
  int previous_sub = -1;
  for (const EntryRow& entry : entries) {
    if (entry.sub_first <= previous_sub || entry.sub_last < entry.sub_first) {
      detail::description_is_wrong("sub-indices of an object are not in order");
    }
    previous_sub = entry.sub_last;
    EntryShape shape = detail::shape_of(entry);
    shape.offset = detail::block_offset(bytes);
    bytes += shape.pitch() * (entry.sub_last - entry.sub_first + 1U);
    if (has(shape.traits, EntryTraits::limited)) shape.limits = detail::add_limits(tables, entry);
    tables.defaults.push_back(detail::add_default(tables, entry, shape));
    tables.entries.push_back(shape);
  }
  object.pitch = detail::block_offset(bytes);
  tables.value_bytes += bytes * object.count;
  tables.objects.push_back(object);
}

/// Fills in the positions of entries and values, and the lengths of all types of fixed length. The
/// entries of the first object come first, in the order of their sub-indices, then those of the
/// second. The capacity of a string is kept.
template <std::size_t object_rows, std::size_t entry_rows>
constexpr DictionaryLayout<object_rows, entry_rows> lay_out(
    const std::array<ObjectRow, object_rows>& objects,
    const std::array<EntryRow, entry_rows>& entries) {
  DictionaryLayout<object_rows, entry_rows> layout;
  std::size_t entry_first = 0;
  int previous_index = -1;
  for (const ObjectRow& object : objects) {
    if (object.index <= previous_index || object.count == 0) {
      detail::description_is_wrong("objects are not in order");
    }
    previous_index = object.index + object.count - 1;
    add_object(layout, object, std::span(entries).subspan(entry_first, object.entry_count));
    entry_first += object.entry_count;
  }
  if (entry_first != entry_rows) detail::description_is_wrong("entries without an object");
  return layout;
}

/// Tables of a part of a device, for a test of a single service: a DeviceNode does not check
/// whether it is a whole device (mandatory_objects.hpp).
template <class Layout>
struct PartialLayout : Layout {
  static constexpr bool is_partial = true;  ///< DeviceNode looks for it
};
/// Marks a layout as that of a part of a device.
template <class Layout>
constexpr PartialLayout<Layout> partial(Layout layout) {
  return {std::move(layout)};
}

}  // namespace canvoy
