// The two readings of errata 5 of CiA 852: twelve parameters for each display without gaps, or
// blocks of 24.
#include "canvoy/formats/sheet/chosen_profile.hpp"

#include <gtest/gtest.h>

#include "canvoy/profiles/cia852.hpp"
#include "canvoy/profiles/registry.hpp"

namespace canvoy::formats::chosen_profile_test {
namespace {

std::string_view entry_at(const Profile& profile, unsigned sub) {
  const ObjectInfo* object = find_object(profile, 0x6411);
  const EntryInfo* entry = object == nullptr ? nullptr : find_entry(*object, sub);
  return entry == nullptr ? "" : entry->name;
}

TEST(ChosenProfile, HasTheObjectsOfTheReadingInPlaceOfTheUsualOnes) {
  const ReadingInfo* wide = find_reading(cia852::profile, "wide-displays");
  ASSERT_NE(wide, nullptr);
  const ChosenProfile chosen(cia852::profile, *wide);
  EXPECT_EQ(chosen.profile().objects.size(), cia852::profile.objects.size());
  EXPECT_NE(find_object(chosen.profile(), 0x6411), find_object(cia852::profile, 0x6411));
  EXPECT_EQ(find_object(chosen.profile(), 0x6000), find_object(cia852::profile, 0x6000));
  EXPECT_NE(entry_at(cia852::profile, 13), "") << "parameter 1 of display 2: 12 + 1";
  EXPECT_EQ(entry_at(chosen.profile(), 13), "") << "it is at 24 + 1";
  EXPECT_NE(entry_at(chosen.profile(), 25), "");
}

TEST(ChosenProfile, KeepsTheOrderThatLookUpNeeds) {
  for (const Profile* profile : all_profiles()) {
    for (const ReadingInfo& reading : profile->readings) {
      const ChosenProfile chosen(*profile, reading);
      for (const ObjectInfo* object : chosen.profile().objects) {
        EXPECT_EQ(find_object(chosen.profile(), object->index), object) << reading.name;
      }
      for (const std::uint16_t index : reading.without) {
        EXPECT_EQ(find_object(chosen.profile(), index), nullptr) << reading.name;
      }
    }
  }
}

TEST(ChosenProfile, AReadingThatIsNotThereIsNone) {
  EXPECT_EQ(find_reading(cia852::profile, "mine"), nullptr);
}

}  // namespace
}  // namespace canvoy::formats::chosen_profile_test
