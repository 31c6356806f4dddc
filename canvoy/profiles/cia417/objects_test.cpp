// CiA 417-4: each of eight lifts has the objects of the first one.
// canvoy/profiles/clauses/417-4.txt describes them.
#include <gtest/gtest.h>

#include "canvoy/profiles/cia417.hpp"

namespace canvoy::cia417_objects_test {
namespace {

/// 4.1.1, 4.2.2: eight lifts, each 0800h above the last one (errata B18).
TEST(Cia417, EachLiftHasTheObjectsOfTheFirstOne) {
  for (unsigned lift = 1; lift <= 8; ++lift) {
    const unsigned offset = (lift - 1) * 0x800;
    for (const ObjectInfo* object : cia417::profile.objects) {
      // Of the device itself (errata B32).
      if (object->index == 0x6000 || object->index == 0x6001) continue;
      EXPECT_EQ(find_object(cia417::profile, object->index + offset), object);
    }
  }
  EXPECT_EQ(find_object(cia417::profile, 0x5FFF), nullptr);
  EXPECT_EQ(find_object(cia417::profile, 0xA100), nullptr) << "there is no ninth lift";
  EXPECT_EQ(find_object(cia417::profile, 0x6C82)->name, "Load signaling");
}

TEST(Cia417, WhatThePhysicalDeviceSaysOfItselfIsThereOnce) {
  for (const unsigned index : {0x6000U, 0x6001U}) {
    EXPECT_NE(find_object(cia417::profile, index), nullptr);
    for (unsigned lift = 2; lift <= 8; ++lift) {
      EXPECT_EQ(find_object(cia417::profile, index + (lift - 1) * 0x800), nullptr);
    }
  }
}

}  // namespace
}  // namespace canvoy::cia417_objects_test
