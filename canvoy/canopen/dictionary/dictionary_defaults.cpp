// Values as the description has them, at the start and where 1011h restores them.
#include <utility>

#include "canvoy/canopen/dictionary/dictionary.hpp"

namespace canvoy {

namespace {

/// Writes `count` numbers, and says what comes behind them. Most often it is one.
template <class Number>
std::uint8_t* fill(std::uint8_t* values, Number number, unsigned count) {
  store(values, number);
  for (; count > 1; --count) store(values += sizeof number, number);
  return values + sizeof number;
}

}  // namespace

inline std::uint64_t Dictionary::default_of(const EntryShape& row, std::uint32_t place,
                                            std::uint8_t node_id) const {
  const std::uint64_t number = tables_.number_at(row, place);
  return has(row.traits, EntryTraits::plus_node_id) ? number + node_id : number;
}

std::uint64_t Dictionary::default_number(const Entry& entry) const {
  const ObjectRow& object = *search_object(entry.index);
  const auto row = entry.row - (tables_.entries.data() + object.entry_first);
  return tables_.number_at(*entry.row, tables_.defaults_of(object, entry.index)[row]);
}

/// Values stand in the block in the order of the rows, without a gap.
void Dictionary::restore_defaults(std::uint16_t first, std::uint16_t last, std::uint8_t node_id) {
  Entry entry;
  entry.value = values_;
  for (const ObjectRow& object : tables_.objects) {
    if constexpr (!is_small_machine) {
      entry.state.value = states_.value + (&object - tables_.objects.data());
    }
    const std::span<const EntryShape> rows = tables_.entries_of(object);
    const std::uint32_t* places = tables_.defaults_of(object, object.index);
    for (unsigned index = object.index; index < unsigned{object.index} + object.count; ++index) {
      const bool is_wanted = index >= first && index <= last;
      const std::uint32_t* place = places;
      places += object.default_pitch;
      if constexpr (!is_small_machine) {
        if (!is_wanted || entry.watchers() == 0) {
          std::uint8_t* const next = entry.value + object.pitch;
          if (is_wanted) restore_unwatched(rows, entry, place, node_id);
          entry.value = next;
          continue;
        }
      }
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

/// All entries of an object of which nobody is to be told.
[[gnu::always_inline]] inline void Dictionary::restore_unwatched(std::span<const EntryShape> rows,
                                                                 Entry& entry,
                                                                 const std::uint32_t* place,
                                                                 std::uint8_t node_id) {
  std::uint8_t* value = entry.value;
  for (const EntryShape& row : rows) {
    const std::uint32_t number =
        *place + (has(row.traits, EntryTraits::plus_node_id) ? node_id : 0U);
    const unsigned count = row.sub_last - row.sub_first + 1U;
    switch (row.is_text() ? 0 : row.capacity) {
      case 1:
        value = fill(value, static_cast<std::uint8_t>(number), count);
        break;
      case 2:
        value = fill(value, static_cast<std::uint16_t>(number), count);
        break;
      case 4:
        value = fill(value, number, count);
        break;
      default:
        entry.row = &row;
        for (unsigned i = 0; i < count; ++i, value += row.pitch()) {
          entry.value = value;
          restore_default(entry, *place, node_id);
        }
    }
    ++place;
  }
}

inline void Dictionary::restore_default(const Entry& entry, std::uint32_t place,
                                        std::uint8_t node_id) {
  const EntryShape& row = *entry.row;
  std::size_t size = row.capacity;
  const void* bytes = &place;
  std::uint64_t wide = 0;
  if (row.is_text()) {
    bytes = tables_.texts[place].data();
    size = tables_.texts[place].size();
  } else if (size > sizeof place && !is_small_machine) {
    wide = default_of(row, place, node_id);
    bytes = &wide;
  } else if (size > sizeof place) {
    bytes = &tables_.numbers[place];
  } else if (has(row.traits, EntryTraits::plus_node_id)) {
    place += node_id;
  }
  set(entry, {static_cast<const std::uint8_t*>(bytes), size});
}

}  // namespace canvoy
