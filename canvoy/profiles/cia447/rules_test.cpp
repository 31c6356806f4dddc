// CiA 447-3: rules for all of its objects, codes and fields, and its other readings.
// canvoy/profiles/clauses/447-3.txt describes each of them.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "canvoy/profiles/cia447.hpp"
#include "canvoy/profiles/model/number_rules.hpp"
#include "canvoy/profiles/registry.hpp"

namespace canvoy::cia447_rules_test {
namespace {

constexpr auto invalid = Meaning::invalid, failure = Meaning::failure;
constexpr auto not_implemented = Meaning::not_implemented, do_not_care = Meaning::do_not_care;
constexpr const char* not_available = "Signal not available";
constexpr const char* take_no_action = "Don't care, take no action";

TEST(Cia447Objects, HaveADescriptionEach) {
  for (const ObjectInfo* object : cia447::profile.objects) {
    EXPECT_FALSE(object->description.empty()) << object->name;
  }
}

TEST(Cia447Objects, AreFoundByTheNumberOfTheProfile) {
  EXPECT_EQ(find_profile(0x0000'01BF), &cia447::profile);
  EXPECT_EQ(find_description(cia447::profile, 0x600D), &cia447::door_status_object);
  EXPECT_EQ(find_object(cia447::profile, 0x6008), nullptr)
      << "there is none between 6007h and 6009h";
  EXPECT_EQ(find_object(cia447::profile, 0x609F), nullptr) << "display 2 has no title (errata C11)";
}

TEST(Cia447Entries, TextsHoldAsManyCharactersAsTheSpecificationSays) {
  EXPECT_EQ(cia447::vin_data_object.entry.capacity, 17);
  EXPECT_GE(cia447::rtc_time_zone_object.entry.capacity, 6);
  EXPECT_GE(cia447::display_1_text_object.entry.capacity, 254);
}

TEST(Cia447Numbers, DatesBeginWithTheFirst) {
  for (const FieldInfo& field : find_object(cia447::profile, 0x60F0)->entry.fields) {
    if (field.name == "r") continue;
    const NumberRules rules(field.value, bits_of(field));
    EXPECT_FALSE(rules.is_value(0)) << field.name;
    EXPECT_TRUE(rules.is_value(1)) << field.name;
  }
}

/// Each value of the profile that is coded in bits: a whole entry, or a field that is not reserved.
template <class Visit>
void for_each_value(Visit visit) {
  for (const ObjectInfo* object : cia447::profile.objects) {
    for (const EntryInfo& entry : object->entries()) {
      if (entry.sub_first == 0 && !object->subs.empty()) continue;
      if (bit_length(entry.type) == 0 || object->index == 0x60F9) continue;
      SCOPED_TRACE(testing::Message() << std::hex << object->index << "h:" << +entry.sub_first);
      if (entry.fields.empty()) visit(*object, entry, "", entry.value, bits_of(entry));
      for (const FieldInfo& field : entry.fields) {
        if (field.name != "r") visit(*object, entry, field.name, field.value, bits_of(field));
      }
    }
  }
}

bool is_command(const EntryInfo& entry) {
  return entry.access == Access::rw;
}

TEST(Cia447Codes, EveryCodeIsANumberOrHasAName) {
  for_each_value([](const ObjectInfo&, const EntryInfo&, std::string_view field,
                    const ValueInfo& value, const BitRange& bits) {
    const std::int64_t last = (std::int64_t{1} << bits.bits) - 1;
    for (std::int64_t code = 0; code <= last;) {
      const NamedValue* named = find_name(value, code, bits.bits, false);
      const bool is_number = value.limits.kind != Limits::Kind::none && code >= value.limits.low;
      if (named != nullptr) {
        code = named->last + 1;
      } else if (is_number && code <= value.limits.high) {
        // Names may be within a range, but only at its beginning.
        code = value.limits.high + 1;
      } else if (value.limits.kind == Limits::Kind::minimum && code < last - 1) {
        code = last - 1;
      } else {
        ADD_FAILURE() << field << ": code " << code << " means nothing";
        return;
      }
    }
  });
}

TEST(Cia447Codes, TheHighestCodeSaysThatThereIsNoValue) {
  for_each_value([](const ObjectInfo& object, const EntryInfo& entry, std::string_view field,
                    const ValueInfo& value, const BitRange& bits) {
    if (object.index == 0x6055 && field == "wheel pulse counter") return;  // C5
    if (object.index == 0x6056 && field == "wheel pulse counter overrun value") return;
    const std::int64_t highest = (std::int64_t{1} << bits.bits) - 1;
    const NamedValue* named = find_name(value, highest, bits.bits, false);
    ASSERT_NE(named, nullptr) << field;
    EXPECT_EQ(named->meaning, is_command(entry) ? do_not_care : invalid) << field;
    EXPECT_EQ(named->name, is_command(entry) ? take_no_action : not_available) << field;
    if (!is_command(entry)) {
      EXPECT_EQ(find_invalid(value), named) << "the first one is what a handle writes";
    }
  });
}

TEST(Cia447Codes, TheSecondHighestCodeSaysWhyButWhereNoneIsLeft) {
  using Exception = std::pair<unsigned, std::string_view>;
  const std::set<Exception> exceptions = {{0x6055, "wheel pulse counter"},
                                          {0x6056, "wheel pulse counter overrun value"},  // C5
                                          {0x6011, "ct"},
                                          {0x6011, "bd"},
                                          {0x6025, "temp"},
                                          {0x6098, "display 1 command"},  // A7, A8
                                          {0x60C1, ""},
                                          {0x60C3, ""},
                                          {0x60C4, "rcp"},
                                          {0x60E5, "uccs"},  // Z35
                                          {0x60F1, "RTC date year"},
                                          {0x60F1, "RTC date month"},
                                          {0x60F1, "RTC date day"},
                                          {0x60F3, "RTC hour"},
                                          {0x60F3, "RTC minute"},
                                          {0x60F3, "RTC second"},
                                          {0x6109, "configure"},
                                          {0x6121, "audio input channel"},
                                          {0x6121, "audio output channel"},
                                          {0x6130, "sslrl"},
                                          {0x6130, "sslud"},
                                          {0x6130, "slp"},
                                          {0x6131, "sslrl"},
                                          {0x6131, "sslud"},
                                          {0x6131, "slp"},
                                          {0x6131, "rbllv"},
                                          {0x613B, "rbslv"}};
  std::set<Exception> met;
  for_each_value([&](const ObjectInfo& object, const EntryInfo& entry, std::string_view field,
                     const ValueInfo& value, const BitRange& bits) {
    const std::int64_t code = (std::int64_t{1} << bits.bits) - 2;
    const NamedValue* named = find_name(value, code, bits.bits, false);
    const Meaning expected = is_command(entry) ? not_implemented : failure;
    if (named != nullptr && named->meaning == expected) return;
    met.insert({object.index, field});
  });
  EXPECT_EQ(met, exceptions);
}

TEST(Cia447Codes, AStatusSendsTheSecondHighestCodeWhereSeveralSayFailure) {  // A9, Z11
  for (const unsigned index : {0x6019U, 0x60A7U, 0x60ABU}) {
    for (const FieldInfo& field : find_object(cia447::profile, index)->subs[1].fields) {
      for (const NamedValue& named : field.value.names) {
        if (named.meaning != failure) continue;
        EXPECT_EQ(named.first, (1 << field.bits) - 2) << index << " " << field.name;
        EXPECT_EQ(named.last, named.first);
        break;
      }
    }
  }
}

TEST(Cia447Figures, ReservedBitsAreSentAsOnes) {
  for (const ObjectInfo* object : cia447::profile.objects) {
    for (const EntryInfo& entry : object->entries()) {
      for (const FieldInfo& field : entry.fields) {
        if (field.name != "r") continue;
        ASSERT_EQ(field.value.names.size(), 1U) << object->name;
        EXPECT_EQ(field.value.names[0].first, (1 << field.bits) - 1) << object->name;
        EXPECT_EQ(field.value.names[0].meaning, Meaning::padding) << object->name;
      }
    }
  }
}

/// With its number in place of `#`.
std::string full_name(const FieldInfo& field) {
  std::string name(field.name);
  const std::size_t at = name.find('#');
  if (at != std::string::npos) name.replace(at, 1, std::to_string(field.number));
  return name;
}
std::vector<FieldInfo> from_the_left(const Items<FieldInfo>& fields) {
  std::vector<FieldInfo> sorted(fields.begin(), fields.end());
  std::ranges::sort(sorted, std::ranges::greater{}, &FieldInfo::first_bit);
  return sorted;
}
std::string positions_of(const Items<FieldInfo>& fields) {
  std::string text;
  for (const FieldInfo& field : from_the_left(fields)) {
    if (!text.empty()) text += ' ';
    if (field.bits > 1) text += std::to_string(field.first_bit + field.bits - 1) + " ";
    text += std::to_string(field.first_bit);
  }
  return text;
}
std::string names_of(const Items<FieldInfo>& fields) {
  std::string text;
  for (const FieldInfo& field : from_the_left(fields)) {
    text += (text.empty() ? "" : " ") + full_name(field);
  }
  return text;
}

TEST(Cia447Readings, TheMonthMayStandAboveTheDay) {  // errata Z02, reading B
  const ReadingInfo& reading = cia447::profile.readings[0];
  EXPECT_EQ(reading.name, "month-above-day");
  ASSERT_EQ(reading.objects.size(), 2U);
  for (const ObjectInfo* object : reading.objects) {
    EXPECT_EQ(positions_of(object->entry.fields), "31 28 27 24 23 16 15 0");
    EXPECT_EQ(names_of(object->entry.fields), "r RTC date month RTC date day RTC date year");
  }
}

TEST(Cia447Readings, TheWarningsMayBeginAtBit1) {  // errata Z01, reading B
  const ReadingInfo& reading = cia447::profile.readings[1];
  EXPECT_EQ(reading.name, "warnings-from-bit-1");
  ASSERT_EQ(reading.objects.size(), 1U);
  EXPECT_EQ(reading.objects[0]->index, 0x60A1);
  EXPECT_EQ(positions_of(reading.objects[0]->entry.fields),
            "31 15 14 13 12 11 10 9 8 7 6 5 4 3 2 1 0");
  EXPECT_EQ(names_of(reading.objects[0]->entry.fields),
            "r fasi fasa fasce fesf feso fesa fesce bit 0");
}

}  // namespace
}  // namespace canvoy::cia447_rules_test
