// Dictionary tables that can grow, for descriptions known at run time.
//
//     HeapTables tables;
//     add_object(tables, {.index = 0x1000}, std::to_array<EntryRow>({{.type =
//     DataType::unsigned32}})); HeapNode device(tables.tables(), port, 5);
#pragma once

#include <vector>

#include "canvoy/canopen/dictionary/dictionary_layout.hpp"

namespace canvoy {

struct HeapTables {
  std::vector<ObjectRow> objects;
  std::vector<EntryShape> entries;
  std::vector<std::uint32_t> defaults;
  std::vector<std::int64_t> numbers;
  std::vector<std::string_view> texts;  ///< texts that outlive this object
  std::uint32_t value_bytes = 0;

  /// Tables so far; valid until an object is added.
  DictionaryTables tables() const {
    return {objects, entries, defaults, numbers, texts, value_bytes};
  }
};

}  // namespace canvoy
