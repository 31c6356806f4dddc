// Expectations of described objects, typed as "index, type, default", for profiles of which the
// text is not at hand.
//
//     expect_described(cia402::profile, {{0x6040, u16}, {0x605A, i16, 2}});
//
// For tests only.
#pragma once

#include <gtest/gtest.h>

#include <initializer_list>

#include "canvoy/profiles/model/description.hpp"

namespace canvoy {

struct Described {
  unsigned index = 0;
  DataType type = DataType::unsigned8;
  std::int64_t initial = -1;  ///< -1: not specified
};

/// For arrays and records, the type and default of sub-index 01h.
inline void expect_described(const Profile& profile, std::initializer_list<Described> expected) {
  for (const auto& [index, type, initial] : expected) {
    SCOPED_TRACE(testing::Message() << std::hex << index << "h");
    const ObjectInfo* object = find_object(profile, index);
    ASSERT_NE(object, nullptr);
    const EntryInfo& entry = object->subs.empty() ? object->entry : object->subs[1];
    EXPECT_EQ(entry.type, type);
    if (initial < 0) continue;
    EXPECT_TRUE(static_cast<bool>(entry.initial));
    EXPECT_EQ(entry.initial.number, initial);
  }
}

}  // namespace canvoy
