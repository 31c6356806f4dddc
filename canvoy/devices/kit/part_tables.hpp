// The dictionary tables of a device with parts that are known at run time, like lay_out_device()
// for parts that are known at compile time.
//
//     PartTables tables(parts);
//     HeapNode device(tables.tables(), port, 5);
#pragma once

#include <span>

#include "canvoy/canopen/device/heap_tables.hpp"
#include "canvoy/profiles/model/device_description.hpp"

namespace canvoy {

class PartTables {
 public:
  /// `parts` are sorted by index, each index once. Everything to which they refer must outlive
  /// this. Their consistency is checked at compile time where a description is made of the same
  /// parts.
  explicit PartTables(std::span<const Part> parts);

  /// Tables; they refer to this object.
  DictionaryTables tables() const { return tables_.tables(); }

 private:
  void add(const Part& part);

  HeapTables tables_;
};

}  // namespace canvoy
