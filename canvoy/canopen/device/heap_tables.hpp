// Dictionary tables that can grow, for descriptions known at run time.
//
//     HeapTables tables;
//     add_object(tables, {.index = 0x1000},
//                std::to_array<EntryRow>({{.type = DataType::unsigned32}}));
//     HeapNode device(tables.tables(), port, 5);
#pragma once

#include <vector>

#include "canvoy/canopen/dictionary/dictionary_layout.hpp"

namespace canvoy {

struct HeapTables {
  std::vector<ObjectRow> objects;       ///< in the order of their indices
  std::vector<EntryShape> entries;      ///< of all objects, in the order of their sub-indices
  std::vector<std::uint32_t> defaults;  ///< of each entry: see DictionaryTables::defaults
  std::vector<std::int64_t> numbers;    ///< limits, sentinels, and defaults of more than four bytes
  std::vector<std::string_view> texts;  ///< texts that outlive this object
  std::uint32_t value_bytes = 0;        ///< size of the block of values, in bytes

  /// Tables so far; valid until an object is added.
  DictionaryTables tables() const {
    return {objects, entries, defaults, numbers, texts, value_bytes};
  }
};

}  // namespace canvoy
