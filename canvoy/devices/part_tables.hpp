// The dictionary tables of a device of which the parts are known when the program runs: what
// lay_out_device() is for parts that are known to the compiler.
//
//     PartTables tables(parts);
//     HeapNode device(tables.tables(), port, 5);
#pragma once

#include <span>

#include "canvoy/canopen/heap_tables.hpp"
#include "canvoy/profiles/device_description.hpp"

namespace canvoy {

class PartTables {
 public:
  /// `parts` are sorted by index, each index once. What they refer to must outlive this. That they
  /// do not contradict themselves is for the compiler to say, where a description is made of the
  /// same ones.
  explicit PartTables(std::span<const Part> parts);

  DictionaryTables tables() const { return tables_.tables(); }

 private:
  void add(const Part& part);

  HeapTables tables_;
};

}  // namespace canvoy
