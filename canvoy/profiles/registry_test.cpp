#include "canvoy/profiles/registry.hpp"

#include <gtest/gtest.h>

#include <ostream>
#include <set>
#include <utility>

#include "canvoy/profiles/cia301.hpp"
#include "canvoy/profiles/cia401.hpp"
#include "canvoy/profiles/cia418.hpp"
#include "canvoy/profiles/cia419.hpp"
#include "canvoy/profiles/model/number_rules.hpp"

namespace canvoy::registry_test {
namespace {

TEST(Registry, ADeviceTypeNamesItsProfileInTheLowWord) {
  EXPECT_EQ(find_profile(0x0000'01A3), &cia419::profile);
  EXPECT_EQ(find_profile(0x0000'01A2), &cia418::profile);
  EXPECT_EQ(find_profile(0x00FF'01A3), &cia419::profile) << "additional information does not count";
  EXPECT_EQ(find_profile(0), nullptr);
  EXPECT_EQ(find_profile(0x01A3'0000), nullptr);
  EXPECT_EQ(find_profile(301), nullptr) << "CiA 301 is not a device profile";
}

TEST(Registry, ProfilesAreInTheOrderOfTheirNumbers) {
  const auto profiles = all_profiles();
  ASSERT_GE(profiles.size(), 3U);
  EXPECT_EQ(profiles[0], &base_profile());
  for (std::size_t i = 1; i < profiles.size(); ++i) {
    EXPECT_LT(profiles[i - 1]->number, profiles[i]->number);
  }
}

TEST(Registry, AProfilesOwnDescriptionComesBeforeThatOfCia301) {
  EXPECT_EQ(find_description(cia419::profile, 0x1400), &cia419::rpdo1_parameter_object);
  EXPECT_EQ(find_description(cia419::profile, 0x1403), &cia301::rpdo_parameter_object);
  EXPECT_EQ(find_description(cia419::profile, 0x1017), &cia419::producer_heartbeat_object);
  EXPECT_EQ(find_description(cia401::profile, 0x1017), &cia301::producer_heartbeat_object);
  EXPECT_EQ(find_description(cia418::profile, 0x1017), &cia418::producer_heartbeat_object);
  EXPECT_EQ(find_description(cia419::profile, 0x12FF), &cia301::sdo_client_object);
  EXPECT_EQ(find_description(cia419::profile, 0x6061), nullptr);
}

struct Address {
  const char* text;
  unsigned index;
  unsigned sub;
};
std::ostream& operator<<(std::ostream& out, const Address& address) {
  return out << address.text;
}
class Addresses : public testing::TestWithParam<Address> {};

TEST_P(Addresses, AreUnderstood) {
  const auto& [text, index, sub] = GetParam();
  const ObjectAddress address = find_address(cia418::profile, text).value_or(ObjectAddress{});
  EXPECT_EQ(address.index, index);
  EXPECT_EQ(address.sub, sub);
  EXPECT_NE(address.object, nullptr);
  EXPECT_NE(address.entry, nullptr);
}

INSTANTIATE_TEST_SUITE_P(
    Registry, Addresses,
    testing::Values(
        Address{"6010", 0x6010, 0}, Address{"6010h", 0x6010, 0}, Address{"0x6010", 0x6010, 0},
        Address{"6020:1", 0x6020, 1}, Address{"6020h:04h", 0x6020, 4},
        Address{"0x6020 2", 0x6020, 2}, Address{" 6020 : 2 ", 0x6020, 2},
        Address{"1a00:01", 0x1A00, 1}, Address{"1A00H", 0x1A00, 0},
        Address{"1003:FE", 0x1003, 0xFE}, Address{"temperature", 0x6010, 0},
        Address{"Temperature", 0x6010, 0}, Address{"battery_status", 0x6000, 0},
        Address{"Battery status", 0x6000, 0}, Address{"battery-status", 0x6000, 0},
        Address{"BatteryStatus", 0x6000, 0}, Address{"battery_parameters", 0x6020, 0},
        Address{"battery_parameters:2", 0x6020, 2},
        Address{"Battery Parameters: AH-capacity", 0x6020, 2}, Address{"ah capacity", 0x6020, 2},
        Address{"number of cells", 0x6020, 4}, Address{"producer heartbeat time", 0x1017, 0},
        Address{"Identity object:Serial number", 0x1018, 4}, Address{"serial number", 0x1018, 4},
        Address{"device type", 0x1000, 0}, Address{"6810", 0x6810, 0},
        Address{"1018sub4", 0x1018, 4}, Address{"1018h sub 04h", 0x1018, 4},
        Address{"0x1018/4", 0x1018, 4}, Address{"1018.4", 0x1018, 4},
        Address{"0x1018,0x04", 0x1018, 4}, Address{"0x1018[4]", 0x1018, 4},
        Address{"0x1018:0x04", 0x1018, 4}, Address{"Identity object.Serial number", 0x1018, 4}));

TEST(Registry, AnUnknownIndexIsAnAddressWithoutADescription) {
  const ObjectAddress unknown = find_address(cia419::profile, "2001:3").value_or(ObjectAddress{});
  EXPECT_EQ(unknown.index, 0x2001);
  EXPECT_EQ(unknown.sub, 3);
  EXPECT_EQ(unknown.object, nullptr);
  EXPECT_EQ(unknown.entry, nullptr);
  const ObjectAddress beyond = find_address(cia419::profile, "6010:1").value_or(ObjectAddress{});
  EXPECT_EQ(beyond.index, 0x6010);
  EXPECT_NE(beyond.object, nullptr);
  EXPECT_EQ(beyond.entry, nullptr);
}

class NoAddresses : public testing::TestWithParam<const char*> {};
TEST_P(NoAddresses, AreRefused) {
  EXPECT_FALSE(find_address(cia418::profile, GetParam()));
}

INSTANTIATE_TEST_SUITE_P(Registry, NoAddresses,
                         testing::Values("", " ", ":", "nonsense", "601", "60100", "0x60101",
                                         "6010:", "6010:100", "6010:x", "x:1", "each", "each:1",
                                         "battery_parameters:nonsense",
                                         "battery_parameters:", "temperature:nonsense",
                                         "characters", "_", "-", "highest sub-index supported",
                                         "6010.", "1018[", "1018]4", "1018subx", "sub4"));

/// 6864h is the position of the second axis of a drive.
TEST(Registry, SeveralLogicalDevicesInANodeAre800hApart) {
  const struct {
    const char* profile;
    unsigned index;
    unsigned same_as;
  } blocks[] = {{"401", 0x6800, 0x6000},   {"401", 0x9C11, 0x6411}, {"402", 0x6864, 0x6064},
                {"402", 0x98FF, 0x60FF},   {"406", 0x7004, 0x6004}, {"418", 0x6860, 0x6060},
                {"417-4", 0x6B83, 0x6383}, {"852", 0x6C01, 0x6401}};
  for (const auto& block : blocks) {
    const Profile& profile = *find_profile(block.profile);
    const ObjectInfo* object = find_description(profile, block.index);
    ASSERT_NE(object, nullptr) << block.profile << ' ' << std::hex << block.index;
    EXPECT_EQ(object, find_description(profile, block.same_as));
  }
}

TEST(Registry, NamesAreTheSameButForCaseAndFillers) {
  EXPECT_TRUE(same_name("battery_status", "Battery Status"));
  EXPECT_TRUE(same_name("a-b c_d", "ABCD"));
  EXPECT_TRUE(same_name(" ab ", "ab"));
  EXPECT_FALSE(same_name("ab", "abc"));
  EXPECT_FALSE(same_name("abc", "ab"));
  EXPECT_FALSE(same_name("ab", "ac"));
  EXPECT_FALSE(same_name("", ""));
  EXPECT_FALSE(same_name("", "a"));
}

// Rules for every description.

template <class Check>
void for_each_object(Check check) {
  for (const Profile* profile : all_profiles()) {
    for (const ObjectInfo* object : profile->objects) {
      SCOPED_TRACE(testing::Message() << profile->name << " " << std::hex << object->index << "h");
      check(*profile, *object);
    }
  }
}

TEST(Descriptions, ObjectsAreSortedAndNamed) {
  for (const Profile* profile : all_profiles()) {
    EXPECT_FALSE(profile->name.empty());
    EXPECT_FALSE(profile->title.empty());
    unsigned next = 0;
    for (const ObjectInfo* object : profile->objects) {
      EXPECT_GE(object->index, next);
      EXPECT_FALSE(object->name.empty());
      next = object->index + object->count;
    }
  }
}

TEST(Descriptions, ConditionalObjectsSayTheirCondition) {
  for_each_object([](const Profile&, const ObjectInfo& object) {
    EXPECT_EQ(object.category == Category::conditional, !object.condition.empty());
  });
}

TEST(Descriptions, ApplicationObjectsHaveUniqueNames) {
  for (const Profile* profile : all_profiles()) {
    std::set<std::pair<std::string_view, unsigned>> names;
    for (const ObjectInfo* object : profile->objects) {
      if (object->index >= 0x6000) {
        EXPECT_TRUE(names.emplace(object->name, object->first_number).second)
            << profile->name << " " << object->name;
      }
    }
  }
}

TEST(Descriptions, EntriesOfArraysAndRecordsHaveNamesAndFieldsFitIn) {
  for_each_object([](const Profile&, const ObjectInfo& object) {
    for (const EntryInfo& entry : object.entries()) {
      EXPECT_EQ(object.subs.empty(), entry.name.empty());
      // consistency.hpp checks that fields overlap only where they are variants.
      for (const FieldInfo& field : entry.fields) {
        EXPECT_LE(unsigned{field.first_bit} + field.bits, bit_length(entry.type));
        EXPECT_FALSE(field.name.empty());
      }
    }
  });
}

TEST(Descriptions, NamedValuesFitIntoTheirBits) {
  const auto check = [](const ValueInfo& value, const BitRange& bits) {
    EXPECT_NE(value.scale.numerator, 0);
    EXPECT_GT(value.scale.denominator, 0);
    for (const NamedValue& named : value.names) {
      const NumberRange range = range_of(named, bits);
      EXPECT_LE(range.low, range.high) << named.name;
      const auto is_within = [&](std::int64_t number) {
        return range_of_type(bits.bits, false).contains(number) ||
               range_of_type(bits.bits, true).contains(number);
      };
      EXPECT_TRUE(is_within(named.first) && is_within(named.last)) << named.name;
    }
  };
  for_each_object([&](const Profile&, const ObjectInfo& object) {
    for (const EntryInfo& entry : object.entries()) {
      if (is_integer(entry.type)) check(entry.value, bits_of(entry));
      for (const FieldInfo& field : entry.fields) check(field.value, bits_of(field));
    }
  });
}

}  // namespace
}  // namespace canvoy::registry_test
