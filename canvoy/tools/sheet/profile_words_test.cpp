// Frames of each profile, typed from the named clauses, and their words in the clauses.
#include <gtest/gtest.h>

#include <string>
#include <string_view>

#include "canvoy/can/frame_text.hpp"
#include "canvoy/formats/sheet/chosen_profile.hpp"
#include "canvoy/profiles/registry.hpp"
#include "canvoy/text/frame_decoder.hpp"
#include "canvoy/text/object_words.hpp"

namespace canvoy::tools::profile_words_test {
namespace {

/// A frame, the text of all its values, and violations of the profile.
struct Example {
  std::string_view clause;
  std::string_view frame;
  std::string_view text;
  std::string_view marks = "";
};

/// In a network in which all nodes have the profile.
void expect_words(std::string_view profile, std::initializer_list<Example> examples) {
  text::FrameDecoder decoder;
  decoder.network().assume_profile(*find_profile(profile));
  for (const Example& example : examples) {
    SCOPED_TRACE(example.clause);
    const text::FrameWords& words = decoder.decode(parse_frame(example.frame).frame);
    EXPECT_EQ(words.text, example.text) << example.frame;
    EXPECT_EQ(text::marks_text(words.marks), example.marks) << example.frame;
  }
}

/// Like expect_words(), but for parts of the text.
void expect_parts(std::string_view profile, std::string_view frame,
                  std::initializer_list<std::string_view> parts) {
  text::FrameDecoder decoder;
  decoder.network().assume_profile(*find_profile(profile));
  const std::string text(decoder.decode(parse_frame(frame).frame).text);
  for (const std::string_view part : parts) {
    EXPECT_NE(text.find(part), std::string::npos) << part << " in: " << text;
  }
}

TEST(ProfileWords, SayWhereAJoystickOfCia852Is) {
  // x, y and z of joystick 1, its memory function, its buttons (CiA 852, Table 12). Bits 0 to 2 of
  // the memory function are x, y and z, the others are reserved (CiA 852, Figure 6).
  expect_words(
      "852",
      {{"Table 12, Figure 6", "181#64009CFF00000100",
        "Read analogue input 16-bit, Joystick 1: x-dimension = 100; Read analogue input 16-bit, "
        "Joystick 1: y-dimension = -100; Read analogue input 16-bit, Joystick 1: z-dimension = 0; "
        "Read input 8-bit, Joystick 1: Memory function = m-x: on, m-y: off, m-z: off; Read input "
        "8-bit, Joystick 1: Up to 8 additional buttons = no bit is set"},
       {"Table 12, too short", "181#6400",
        "Read analogue input 16-bit, Joystick 1: x-dimension = 100", "wrong length"}});
  expect_parts("852", "181#0000000000000880",
               {"m-x: off", "reserved: reserved", "b8: switched-on"});
  text::FrameDecoder decoder;
  decoder.network().assume_profile(*find_profile("852"));
  EXPECT_EQ(text::marks_text(decoder.decode(parse_frame("181#0000000000000880").frame).marks),
            "reserved");
}

TEST(ProfileWords, SayWhatCia852WritesToAnOutput) {
  // RPDO 1 is eight entries of 6200h (Table 32); RPDO 2 is four of 6411h (Table 36).
  expect_parts("852", "201#0100000000000080", {"Write output 8-bit", ": switched-on"});
  expect_parts("852", "301#640000000000FFFF", {" = 100;", " = -1"});
}

TEST(ProfileWords, SayWhereACarOfCia447Is) {
  // 10^-7 degrees; north from 0 to 35A4 E900h, south from 35A4 E901h to 6B49 D200h; east from 0 to
  // 6B49 D200h, west from 6B49 D201h to D693 A400h; above is reserved, except FFFF FFFEh (failure)
  // and FFFF FFFFh (not available) (CiA 447-3, 4.2.10.1).
  constexpr std::string_view latitude = "60B0h:01h GPS current position, Position latitude = ";
  constexpr std::string_view longitude = "60B0h:02h GPS current position, Position longitude = ";
  const auto north = [&](std::string_view value) { return std::string(latitude) + value.data(); };
  const auto east = [&](std::string_view value) { return std::string(longitude) + value.data(); };
  expect_words("447-3", {{"equator", "582#43B0600100000000", north("0.0000000 °")},
                         {"52.5 degrees north", "582#43B0600140DD4A1F", north("52.5000000 °")},
                         {"north pole", "582#43B0600100E9A435", north("90.0000000 °")},
                         {"first step south", "582#43B0600101E9A435", north("-0.0000001 °")},
                         {"south pole", "582#43B0600100D2496B", north("-90.0000000 °")},
                         {"beyond", "582#43B0600101D2496B", north("Reserved"), "reserved"},
                         {"failure", "582#43B06001FEFFFFFF", north("Failure")},
                         {"not available", "582#43B06001FFFFFFFF", north("Signal not available")},
                         {"180 degrees east", "582#43B0600200D2496B", east("180.0000000 °")},
                         {"first step west", "582#43B0600201D2496B", east("-0.0000001 °")},
                         {"180 degrees west", "582#43B0600200A493D6", east("-180.0000000 °")},
                         {"beyond", "582#43B0600201A493D6", east("Reserved"), "reserved"}});
}

TEST(ProfileWords, SayTheEventsOfTheVirtualDeviceOfCia407ThatIsNamed) {
  // Flags in bits 0 to 7, with a meaning by the code in bits 24 to 31 (CiA 407, 9.2.4).
  constexpr std::string_view object = "6001h:02h events_from_virtual_devices, ";
  expect_parts(
      "407", "582#4301600205000003",
      {object, "state information: event pending", "display in test mode: event not present",
       "mapped information cannot be displayed: event pending",
       "code of virtual device: Passenger information"});
  expect_parts("407", "582#4301600242000008",
               {"driver microphone to indoor loudspeakers: event pending",
                "state information of the acoustic control manager: event pending",
                "code of virtual device: Acoustic control manager"});
  expect_parts("407", "582#4301600201341201",
               {"event flags: 01h", "manufacturer-specific information: 1234h",
                "code of virtual device: Main on-board computer"});
}

TEST(ProfileWords, SayTheMessagesOfCia407) {
  // 201h driver, 281h block, line and journey, 381h route (CiA 407, 8.1.4.3).
  expect_words("407", {{"driver", "201#2A000000", "driver: driver_ID = 42"},
                       {"block, line and journey", "281#0100000002000300",
                        "block, line and journey: block_ID = 1; line_ID = 2; journey_number = 3"},
                       {"too short", "281#0100", "block, line and journey: ", "wrong length"}});
}

TEST(ProfileWords, SayWhatAVirtualInputOfCia417Is) {
  // Basic function, sub-function by it, lift, panel, doors, function data (CiA 417-4, 4.2.3).
  expect_parts(
      "417-4", "481#020104050101",
      {"Virtual input: Virtual input mapping = Basic function: Standard hall call request, "
       "Hall call up: 1, Source lift 3: request,",
       "Source panel: 5, Dest. door 1: request,", "Call request: call request",
       "Lock: without locking function"});
  expect_parts("417-4", "481#0203FF000081",
               {"Hall call up: 1, Hall call down: 1, Source lift 1: request,",
                "Source lift 8: request", "Source panel: car", "Lock: with locking function"});
  expect_parts("417-4", "481#050704000002",
               {"Basic function: Standard car call request, Target stop: 7,", "Call request: "});
  expect_parts("417-4", "481#0A6401051100",
               {"Basic function: High priority destination call, Target stop: 100,",
                "Dest. door 1: request", "Source door 1: request"});
  expect_parts("417-4", "481#0E0901000000",
               {"Basic function: Special function, Special function: Request door open,"});
}

TEST(ProfileWords, SayALoadOfCia417InTheUnitThatTheNodeTells) {
  // Kilograms by default; the prefix is in bits 15 to 8, here milli (CiA 417-4, 4.12.1). FFFFh is
  // an unused limit in any unit (CiA 417-4, 4.12.4).
  constexpr std::string_view load = "6480h:01h Load value, Absolute load value = ";
  const auto loaded = [&](std::string_view value) { return std::string(load) + value.data(); };
  expect_words(
      "417-4",
      {{"default", "582#4B806401C2010000", loaded("450 kg")},
       {"asked", "602#4080640200000000", "read 6480h:02h Load value, SI unit"},
       {"told", "582#4B80640202FD0000", "6480h:02h Load value, SI unit = SI unit: kg, Prefix: FDh"},
       {"asked", "602#4080640100000000", "read 6480h:01h Load value, Absolute load value"},
       {"thousandths", "582#4B806401C2010000", loaded("0.450 kg")},
       {"a limit", "602#2B836404C2010000",
        "write 6483h:04h Load signaling limits, Overload limit = 0.450 kg"},
       {"none", "602#2B836404FFFF0000",
        "write 6483h:04h Load signaling limits, Overload limit = unused limit"}});
}

TEST(ProfileWords, MarkReservedCodesOfAVirtualInputOfCia417) {
  text::FrameDecoder decoder;
  decoder.network().assume_profile(*find_profile("417-4"));
  const auto marks = [&decoder](std::string_view frame) {
    return text::marks_text(decoder.decode(parse_frame(frame).frame).marks);
  };
  EXPECT_EQ(marks("481#020104050101"), "");
  EXPECT_EQ(marks("481#000104050101"), "reserved") << "basic function 00h";
  EXPECT_EQ(marks("481#120104050101"), "reserved") << "basic function 12h";
  EXPECT_EQ(marks("481#800104050101"), "") << "of the manufacturer";
  EXPECT_EQ(marks("481#050004050101"), "reserved") << "target stop 0";
  EXPECT_EQ(marks("481#05FF04050101"), "reserved") << "target stop 255";
  EXPECT_EQ(marks("481#0E1604050101"), "") << "dogging service down";
  EXPECT_EQ(marks("481#0E1704050101"), "reserved") << "special function 17h";
  EXPECT_EQ(marks("481#020104FF0101"), "reserved") << "panel 255";
  EXPECT_EQ(marks("481#0201040501"), "wrong length");
}

TEST(ProfileWords, MarkEachKindOfWhatIsAgainstCia419) {
  text::FrameDecoder decoder;
  decoder.network().assume_profile(*find_profile("419"));
  const auto marks = [&decoder](std::string_view first, std::string_view second = "") {
    const std::string said(text::marks_text(decoder.decode(parse_frame(first).frame).marks));
    if (second.empty()) return said;
    return text::marks_text(decoder.decode(parse_frame(second).frame).marks);
  };
  // Bits 1 to 7 of 6001h (7.2.2); 6080h up to 100 % (7.2.7); 6001h is read only; 8 bits.
  EXPECT_EQ(marks("582#4F01600002000000"), "reserved");
  EXPECT_EQ(marks("582#4F80600064000000"), "");
  EXPECT_EQ(marks("582#4F80600065000000"), "out of range");
  EXPECT_EQ(marks("602#2F01600001000000", "582#6001600000000000"), "wrong access");
  EXPECT_EQ(marks("602#4001600000000000", "582#4B01600001000000"), "wrong length");
  EXPECT_EQ(marks("602#2B01600001000000", "582#6001600000000000"), "wrong length, wrong access");
}

TEST(ProfileWords, AreThoseOfTheReadingThatIsChosen) {
  // 60F0h has the day in bits 27 to 20 and the month in 19 to 16, or else the month in 27 to 24 and
  // the day in 23 to 16 (errata Z02 of CiA 447-3). 14 August:
  constexpr std::string_view usual_date = "582#43F060000000E800";
  constexpr std::string_view other_date = "582#43F0600000000E08";
  const Profile& usual = *find_profile("447-3");
  const formats::ChosenProfile chosen(usual, *formats::find_reading(usual, "month-above-day"));
  const auto is_august_14 = [](const Profile& profile, std::string_view frame) {
    text::FrameDecoder decoder;
    decoder.network().assume_profile(profile);
    const std::string text(decoder.decode(parse_frame(frame).frame).text);
    return text.find("RTC date month: 8 month") != std::string::npos &&
           text.find("RTC date day: 14 d") != std::string::npos;
  };
  EXPECT_TRUE(is_august_14(usual, usual_date));
  EXPECT_FALSE(is_august_14(usual, other_date));
  EXPECT_TRUE(is_august_14(chosen.profile(), other_date));
  EXPECT_FALSE(is_august_14(chosen.profile(), usual_date));
}

}  // namespace
}  // namespace canvoy::tools::profile_words_test
