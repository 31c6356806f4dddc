// Default values: the start of a node, resets, and restoring them by 1011h (CiA 301, 7.5.2.14).
#include <algorithm>

#include "canvoy/canopen/dictionary/dictionary.hpp"

namespace canvoy {

namespace {

/// Adds the node-ID to a default that has just been copied. Most are CAN-IDs.
[[maybe_unused]] inline void add_node_id(std::uint8_t* value, std::uint32_t size,
                                         std::uint8_t node_id) {
  if (size == sizeof(std::uint32_t)) return store(value, load<std::uint32_t>(value) + node_id);
  const std::uint64_t number = load_unsigned({value, size}) + node_id;
  std::memcpy(value, &number, size);
}

[[maybe_unused]] unsigned last_index(const ObjectRow& object) {
  return object.index + object.count - 1U;
}

}  // namespace

std::uint64_t Dictionary::default_number(const Entry& entry) const {
  const ObjectRow& object = *search_object(entry.index);
  const auto row = entry.row - (tables_.entries.data() + object.entry_first);
  return tables_.number_at(*entry.row, tables_.defaults_of(object, entry.index)[row]);
}

inline void Dictionary::restore_default(const Entry& entry, std::uint32_t place,
                                        std::uint8_t node_id) {
  const EntryShape& row = *entry.row;
  std::size_t size = row.capacity;
  const void* bytes = &place;
  std::uint64_t wide = 0;
  const bool adds_node_id = has(row.traits, EntryTraits::plus_node_id);
  if (row.is_text()) {
    bytes = tables_.texts[place].data();
    size = tables_.texts[place].size();
  } else if (size > sizeof place && !is_small_machine) {
    wide = tables_.number_at(row, place) + (adds_node_id ? node_id : 0U);
    bytes = &wide;
  } else if (size > sizeof place) {
    bytes = &tables_.numbers[place];
  } else if (adds_node_id) {
    place += node_id;
  }
  set(entry, {static_cast<const std::uint8_t*>(bytes), size});
}

/// Values are in the block in the order of the rows, without a gap.
[[gnu::always_inline]] inline void Dictionary::restore_rows(std::span<const ObjectRow> objects,
                                                            std::uint16_t first, std::uint16_t last,
                                                            std::uint8_t node_id) {
  Entry entry;
  entry.value = values_;
  for (const ObjectRow& object : objects) {
    if constexpr (!is_small_machine) {
      entry.value = values_ + object.offset;
      entry.state.value = states_.value + (&object - tables_.objects.data());
    }
    const std::span<const EntryShape> rows = tables_.entries_of(object);
    const std::uint32_t* places = tables_.defaults_of(object, object.index);
    for (unsigned index = object.index; index < unsigned{object.index} + object.count; ++index) {
      const bool is_wanted = index >= first && index <= last;
      const std::uint32_t* place = places;
      places += object.default_pitch;
      for (const EntryShape& row : rows) {
        entry.row = &row;
        for (unsigned sub = row.sub_first; sub <= row.sub_last; ++sub) {
          if (is_wanted) restore_default(entry, *place, node_id);
          entry.value += row.pitch();
        }
        ++place;
      }
    }
  }
}

/// For hosts: restoring the defaults of a row changes nothing.
inline bool Dictionary::is_as_initially(const ObjectRow& object) const {
  const bool follows_node_id = std::ranges::any_of(
      tables_.entries_of(object),
      [](const EntryShape& row) { return has(row.traits, EntryTraits::plus_node_id); });
  return !follows_node_id &&
         std::memcmp(values_ + object.offset, tables_.initial.value.bytes.data() + object.offset,
                     object.pitch * object.count) == 0;
}

/// Copies the rows from `first` up to, not including, `last` at once.
inline void Dictionary::copy_rows(std::size_t first, std::size_t last, std::uint8_t node_id) {
  if (first == last) return;
  const InitialValues& initial = tables_.initial.value;
  const ObjectRow& last_row = tables_.objects[last - 1];
  const std::uint32_t begin = tables_.objects[first].offset;
  const std::uint32_t end = last_row.offset + last_row.pitch * last_row.count;
  std::memcpy(values_ + begin, initial.bytes.data() + begin, end - begin);
  auto each =
      std::ranges::lower_bound(initial.with_node_id, begin, {}, &InitialValues::WithNodeId::offset);
  for (; each != initial.with_node_id.end() && each->offset < end; ++each) {
    add_node_id(values_ + each->offset, each->size, node_id);
  }
}

/// Copies all rows but those with a change that a TPDO is to notice. At both ends of the range, a
/// row may be in it in part.
void Dictionary::copy_defaults(std::uint16_t first, std::uint16_t last, std::uint8_t node_id) {
  if constexpr (is_small_machine) return;
  const std::span<const ObjectRow> objects = tables_.objects;
  std::size_t row = 0;
  std::size_t end = objects.size();
  const auto restore = [&](std::size_t one) {
    restore_rows(objects.subspan(one, 1), first, last, node_id);
  };
  while (row < end && last_index(objects[row]) < first) ++row;
  while (row < end && objects[end - 1].index > last) --end;
  if (row < end && objects[row].index < first) restore(row++);
  if (row < end && last_index(objects[end - 1]) > last) restore(--end);
  std::size_t copied = row;
  for (; row < end; ++row) {
    if (states_.value[row].watchers == 0 || is_as_initially(objects[row])) continue;
    copy_rows(copied, row, node_id);
    restore(row);
    copied = row + 1;
  }
  copy_rows(copied, end, node_id);
}

void Dictionary::restore_defaults(std::uint16_t first, std::uint16_t last, std::uint8_t node_id) {
  const bool is_made = !is_small_machine && !tables_.initial.value.bytes.empty();
  is_made ? copy_defaults(first, last, node_id)
          : restore_rows(tables_.objects, first, last, node_id);
}

}  // namespace canvoy
