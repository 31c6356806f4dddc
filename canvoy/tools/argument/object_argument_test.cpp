#include "canvoy/tools/argument/object_argument.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "canvoy/decoder/sheet_profile.hpp"
#include "canvoy/formats/eds/eds_reader.hpp"
#include "canvoy/tools/cli/failure.hpp"

namespace canvoy::tools::object_argument_test {
namespace {

using testing::HasSubstr;

/// `6020:02`
std::string place_of(std::string_view text, unsigned profile) {
  const ObjectAddress address = parse_object(text, profile);
  char made[16];
  std::snprintf(made, sizeof made, "%04X:%02X", unsigned{address.index}, unsigned{address.sub});
  return made;
}

std::string complaint_of(std::string_view text, unsigned profile) {
  try {
    parse_object(text, profile);
  } catch (const UsageError& error) {
    return error.what();
  }
  return "none";
}

TEST(ObjectArgument, WhatIsPrintedIsAccepted) {  // CiA 418, 6020h and 6010h
  for (const char* text : {"6020:2", "6020h:02h", "0x6020:02", "battery_parameters:ah_capacity",
                           "battery_parameters, ah_capacity", "Battery Parameters: Ah-Capacity"}) {
    EXPECT_EQ(place_of(text, 418), "6020:02") << text;
  }
  for (const char* text : {"6010", "6010h", "6010h:00h", "temperature", "temperature (6010h:00h)",
                           "6010h:00h temperature", "6010h:00h  anything"}) {
    EXPECT_EQ(place_of(text, 418), "6010:00") << text;
  }
  EXPECT_EQ(place_of("Identity object, Vendor-ID", 418), "1018:01");
}

TEST(ObjectArgument, APartOfANameIsEnoughWhereOnlyOneHasIt) {
  EXPECT_EQ(place_of("water_level", 418), "6090:00");
  EXPECT_EQ(place_of("ah_cap", 418), "6020:02");
}

TEST(ObjectArgument, WhatMayBeMeantIsListedWhereSeveralHaveThePart) {
  const std::string complaint = complaint_of("state_of_charge", 418);
  EXPECT_THAT(complaint, HasSubstr("charger_state_of_charge (6080h:00h)"));
  EXPECT_THAT(complaint, HasSubstr("battery_state_of_charge (6081h:00h)"));
  EXPECT_THAT(complaint, HasSubstr("say which"));
}

TEST(ObjectArgument, WhatTheNodeDoesNotHaveIsNotMeant) {  // CiA 418, 6080h and 6081h
  const auto has_its_own = [](std::uint16_t index, std::uint8_t) { return index == 0x6081; };
  EXPECT_EQ(parse_object("state_of_charge", 418, has_its_own).index, 0x6081);
  const auto has_nothing = [](std::uint16_t, std::uint8_t) { return false; };
  EXPECT_THROW(parse_object("state_of_charge", 418, has_nothing), UsageError);
}

TEST(ObjectArgument, ThePartnersNameStandsForTheSameValue) {  // CiA 419, 6010h; CiA 418, 6010h
  EXPECT_EQ(place_of("battery_temperature", 418), "6010:00");
  EXPECT_EQ(place_of("temperature", 419), "6010:00");
  EXPECT_THAT(complaint_of("water_level_status", 419), HasSubstr("CiA 419"))
      << "the charger has no such value";
}

TEST(ObjectArgument, ADataSheetHasNamesOfItsOwn) {
  formats::Findings findings;
  const decoder::SheetProfile sheet(
      formats::read_eds("[2000]\nParameterName=Pump speed\nDataType=6\nAccessType=rw\n"
                        "[2010]\nParameterName=Motor\nObjectType=9\nSubNumber=2\n"
                        "[2010sub0]\nParameterName=Entries\nDataType=5\nAccessType=ro\n"
                        "[2010sub1]\nParameterName=Current\nDataType=3\nAccessType=ro\n",
                        findings));
  const ProfileChoice known(sheet.profile());
  const ObjectAddress speed = parse_object("pump_speed", known);
  EXPECT_EQ(speed.index, 0x2000);
  ASSERT_NE(speed.entry, nullptr);
  EXPECT_EQ(speed.entry->type, DataType::unsigned16);  // 0006h (CiA 301, 7.4.1)
  const ObjectAddress current = parse_object("Motor:Current", known);
  EXPECT_EQ(current.index, 0x2010);
  EXPECT_EQ(current.sub, 1);
  EXPECT_EQ(parse_object("1017", known).index, 0x1017) << "what a sheet does not have, CiA 301 has";
  EXPECT_THROW(check_object("pump_sped", known), UsageError);
  EXPECT_NO_THROW(check_object("speed", known)) << "a part of a name";
}

TEST(ObjectArgument, AMisspeltNameIsAnsweredWithAKnownOne) {
  EXPECT_THAT(complaint_of("tempersture", 418), HasSubstr("did you mean 'temperature'?"));
  EXPECT_THROW(check_object("tempersture"), UsageError);
  EXPECT_NO_THROW(check_object("charge")) << "which one, the node's profile decides";
}

}  // namespace
}  // namespace canvoy::tools::object_argument_test
