#include "canvoy/canopen/storage/parameter.hpp"

#include <algorithm>

#include "canvoy/canopen/dictionary/action_objects.hpp"
#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/canopen/storage/crc32.hpp"

namespace canvoy {

namespace {

using detail::IndexRange;

constexpr IndexRange all_objects{0x0000, 0xFFFF};
constexpr IndexRange communication{object_index::device_type, object_index::communication_last};
constexpr IndexRange application{0x6000, 0x9FFF};

}  // namespace

bool is_in_group(std::uint16_t index, std::uint8_t sub, std::span<const ParameterGroup> groups) {
  if (sub == 1) return all_objects.contains(index);
  if (sub == 2) return communication.contains(index);
  if (sub == 3) return application.contains(index);
  return std::ranges::any_of(groups, [&](const ParameterGroup& group) {
    return group.sub == sub && index >= group.first && index <= group.last;
  });
}

bool is_parameter(std::uint16_t index, const EntryShape& row) {
  if (!allows(row.access, Access::rw) || allows(row.access, Access::constant)) return false;
  const bool has_value = is_string(row.type) || byte_length(row.type) != 0;
  if (!has_value || has(row.traits, EntryTraits::not_stored)) return false;
  return !is_action_or_state(index);
}

bool ParameterWalk::next(Entry& entry) {
  const DictionaryTables& tables = dictionary_->tables();
  while (object_ < tables.objects.size()) {
    const ObjectRow& object = tables.objects[object_];
    if (number_ == object.count) {
      number_ = 0;
      ++object_;
    } else if (row_ == object.entry_count) {
      row_ = 0;
      ++number_;
    } else {
      const EntryShape& row = tables.entries[object.entry_first + std::size_t{row_}];
      const auto index = static_cast<std::uint16_t>(object.index + number_);
      const unsigned sub = row.sub_first + unsigned{place_};
      if (sub <= row.sub_last && is_parameter(index, row)) {
        ++place_;
        entry = *dictionary_->find(index, static_cast<std::uint8_t>(sub));
        return true;
      }
      place_ = 0;
      ++row_;
    }
  }
  return false;
}

std::uint32_t parameter_signature(const Dictionary& dictionary) {
  Crc32 crc;
  Entry entry;
  for (ParameterWalk walk(dictionary); walk.next(entry);) {
    const std::uint8_t shape[] = {
        static_cast<std::uint8_t>(entry.index),
        static_cast<std::uint8_t>(entry.index >> 8),
        entry.sub,
        static_cast<std::uint8_t>(entry.row->type),
        static_cast<std::uint8_t>(entry.row->capacity),
        static_cast<std::uint8_t>(entry.row->capacity >> 8),
    };
    crc.add(shape);
  }
  return crc.value();
}

}  // namespace canvoy
