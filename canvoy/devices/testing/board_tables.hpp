// Compares the tables of a board's dictionary, which are made at compile time, with those that the
// catalogue's device of the same kind composes at run time: shapes, defaults, limits and texts, in
// their order. A file of its own, since the boards of each profile are compared.
//
//     expect_same_tables(DeviceNode<car_layout<Kind>>::tables, composed.tables());
#pragma once

#include <gtest/gtest.h>

#include <algorithm>

#include "canvoy/canopen/dictionary/dictionary_tables.hpp"

namespace canvoy {

inline void expect_same_tables(const DictionaryTables& tables, const DictionaryTables& expected) {
  ASSERT_EQ(tables.objects.size(), expected.objects.size());
  for (std::size_t i = 0; i < tables.objects.size(); ++i) {
    EXPECT_EQ(tables.objects[i].index, expected.objects[i].index);
    EXPECT_EQ(tables.objects[i].count, expected.objects[i].count);
    EXPECT_EQ(tables.objects[i].entry_count, expected.objects[i].entry_count);
  }
  ASSERT_EQ(tables.entries.size(), expected.entries.size());
  EXPECT_TRUE(std::ranges::equal(tables.entries, expected.entries));
  EXPECT_TRUE(std::ranges::equal(tables.defaults, expected.defaults));
  EXPECT_TRUE(std::ranges::equal(tables.numbers, expected.numbers));
  EXPECT_TRUE(std::ranges::equal(tables.texts, expected.texts));
}

}  // namespace canvoy
