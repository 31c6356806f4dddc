#include "canvoy/tools/sheet/provisions_text.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "canvoy/profiles/registry.hpp"
#include "canvoy/tools/sheet/profile_text.hpp"

namespace canvoy::tools::provisions_text_test {
namespace {

using testing::HasSubstr;
using testing::Not;

std::string said_of(std::string_view profile) {
  return profile_text(*find_profile(profile));
}

// CiA 407, 9.1, 8.1.4.1 and 8.1.4.2, 7.2, 9.2.27.
TEST(ProvisionsText, TellsWhatCia407SaysBesideItsObjects) {
  const std::string text = said_of("407");
  EXPECT_THAT(text, HasSubstr("\nindex ranges (9.1)\n"
                              "  6000h to 60FFh Physical device\n"
                              "  6100h to 618Fh Main on-board computer\n"));
  EXPECT_THAT(text, HasSubstr("\n  67FFh          Device type object\n"));
  EXPECT_THAT(text, HasSubstr("\n  minimum configuration (8.1.4.1)\n"
                              "    01h Main on-board computer\n"));
  EXPECT_THAT(text, HasSubstr("\n  typical configuration (8.1.4.2)\n"));
  EXPECT_THAT(text, HasSubstr("\nserious failures: 1029h says what they bring about (7.2)\n"
                              "  the CAN interface is bus-off\n"
                              "  a life guarding event has occurred\n"
                              "  a heartbeat event has occurred\n"));
  EXPECT_THAT(text, HasSubstr("  6741h:00h: 06090030h"));
}

// Eight applications, 0800h indices each (CiA 417-4, 4.1.1); 6020h (CiA 417-4, 4.2.6).
TEST(ProvisionsText, TellsWhoseIndicesAreOfCia417AndWhatIsRefused) {
  const std::string text = said_of("417-4");
  EXPECT_THAT(text, HasSubstr("\nindex ranges (4.1.1)\n"
                              "  6000h to 67FFh lift-control application 1\n"
                              "  6800h to 6FFFh lift-control application 2\n"));
  EXPECT_THAT(text, HasSubstr("\n  9800h to 9FFFh lift-control application 8\n"));
  EXPECT_THAT(text, HasSubstr("\nwhat is refused, and how (4.2.6)\n  6020h:00h: 06090030h: "));
  EXPECT_THAT(text, HasSubstr("\n  6020h:00h: 05040005h: "));
  EXPECT_THAT(text, HasSubstr("\n  6020h:00h: 08000000h: "));
}

// CiA 419, 4.2.2 and 5.2.
TEST(ProvisionsText, TellsTheBitRateAndTheFailuresOfACharger) {
  const std::string text = said_of("419");
  EXPECT_THAT(text, HasSubstr("\nbit rates (4.2.2)\n   125 kbit/s, mandatory\n"));
  EXPECT_THAT(text, HasSubstr("(5.2)\n  the CAN interface is bus-off\n  a heartbeat event"));
  EXPECT_THAT(text, Not(HasSubstr("life guarding event")));
}

// CiA 852, 6.2 and 5.3.
TEST(ProvisionsText, TellsBitRatesAndNumberingOfCabins) {
  const std::string text = said_of("852");
  EXPECT_THAT(text, HasSubstr("   125 kbit/s, mandatory (6.2)\n   250 kbit/s, mandatory (6.2)\n"));
  EXPECT_THAT(text, HasSubstr("  1000 kbit/s, mandatory (6.2)\n"));
  EXPECT_THAT(text, HasSubstr("    10 kbit/s, optional (6.2, CiA 301)\n"));
  EXPECT_THAT(text, HasSubstr("  numbering of sub-devices: odd numbers"));
}

// 60EAh selects how the bytes of 60EBh are read (CiA 447-3, Table 381).
TEST(ProvisionsText, TellsTheCodesOfThePrinter) {
  const std::string text = said_of("447-3");
  EXPECT_THAT(text, HasSubstr("\n  60EBh:00h where 60EAh is 00h: Text, UTF-8\n"));
  EXPECT_THAT(text, HasSubstr("\n  60EBh:00h where 60EAh is 01h to 04h: 1B04h cut paper\n"));
  EXPECT_THAT(text, HasSubstr("\n  60EBh:00h where 60EAh is 05h: 04h cut paper\n"));
}

TEST(ProvisionsText, StandsWithTheObjectThatItIsAbout) {
  const Profile& lift = *find_profile("417-4");
  EXPECT_THAT(object_details_text(lift, *find_object(lift, 0x6020)),
              HasSubstr("\n  refuses 6020h:00h: 06090030h: "));
  EXPECT_THAT(object_details_text(lift, *find_object(lift, 0x6000)), Not(HasSubstr("refuses")));
  const Profile& car = *find_profile("447-3");
  EXPECT_THAT(object_details_text(car, *find_object(car, 0x60EB)),
              HasSubstr("\n  60EBh:00h where 60EAh is 00h: Text, UTF-8 (4.2.13.10, Table 381)\n"));
}

TEST(ProvisionsText, IsEmptyWhereAProfileSaysNothingElse) {
  EXPECT_EQ(provisions_text(*find_profile("418")), "");
}

// Limits are in the unit of the load (CiA 417-4, 4.12.2); the unit of a sensor is in its parameter
// 3 (CiA 417-4, 4.13.1).
TEST(ProfileText, SaysWhereTheUnitOfAValueIsTold) {
  const Profile& lift = *find_profile("417-4");
  EXPECT_THAT(object_details_text(lift, *find_object(lift, 0x6481)),
              HasSubstr("in the unit that 6480h:02h says, kg by default\n"));
  EXPECT_THAT(object_details_text(lift, *find_object(lift, 0x6500)),
              HasSubstr("in the unit that the same sub-index of 6560h says\n"));
}

}  // namespace
}  // namespace canvoy::tools::provisions_text_test
