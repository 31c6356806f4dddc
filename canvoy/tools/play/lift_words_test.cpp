// Virtual outputs of CiA 417-4 (4.2.4, 4.4.1), typed from the clause, and their words: basic
// function, sub-function by it, lifts, panel, buttons and doors, function data.
#include <gtest/gtest.h>

#include <string>
#include <string_view>

#include "canvoy/can/frame_text.hpp"
#include "canvoy/profiles/registry.hpp"
#include "canvoy/text/frame_decoder.hpp"
#include "canvoy/text/object_words.hpp"

namespace canvoy::tools::lift_words_test {
namespace {

/// The text of a frame, and its marks.
struct Said {
  std::string text;
  std::string marks;
};

Said say(std::string_view frame) {
  text::FrameDecoder decoder;
  decoder.network().assume_profile(*find_profile("417-4"));
  const text::FrameWords& words = decoder.decode(parse_frame(frame).frame);
  return {std::string(words.text), text::marks_text(words.marks)};
}

/// A frame on 400h with a significant second byte, or last byte; its text begins with this.
struct Example {
  std::string_view frame;
  std::string_view part;
  std::string_view marks = "";
};

void expect(std::initializer_list<Example> examples) {
  for (const Example& example : examples) {
    const Said said = say(example.frame);
    EXPECT_NE(said.text.find(example.part), std::string::npos)
        << example.frame << ": " << said.text;
    EXPECT_EQ(said.marks, example.marks) << example.frame;
  }
}

TEST(LiftWords, SayTheWholeOfAVirtualOutput) {
  const Said said = say("400#020105FF2181");
  EXPECT_EQ(said.text,
            "Virtual output: Virtual output mapping = Basic function: Standard hall call "
            "acknowledgement, Hall call up: 1, Destination lift 1: 1, Destination lift 3: 1, "
            "Destination panel: all floors, Dest. button 1: 1, Dest. door 2: 1, Status: data "
            "indicated, Property: Default, Predicate: acknowledgement is affirmed");
  EXPECT_EQ(said.marks, "");
  EXPECT_EQ(say("400#024105FF2181").marks, "reserved") << "bit 6 of the sub-function";
}

TEST(LiftWords, NameEachBasicFunctionOfAnOutput) {
  expect({
      {"400#000001000000", "Basic function: reserved, ", "reserved"},
      {"400#010001000000", "Basic function: Generic output, Destination lift 1: 1"},
      {"400#020201000000", "Standard hall call acknowledgement, Hall call down: 1"},
      {"400#030101000000", "Low priority hall call acknowledgement, Hall call up: 1"},
      {"400#040101000000", "High priority hall call acknowledgement, Hall call up: 1"},
      {"400#050701000000", "Standard car call acknowledgement, Target stop acknowledgement: 7,"},
      {"400#06FE01000000",
       "Low priority car call acknowledgement, Target stop acknowledgement: 254"},
      {"400#07FF01000000",
       "High priority car call acknowledgement, Target stop acknowledgement: "
       "all target stop buttons,"},
      {"400#080001000000",
       "Standard destination call acknowledgement, Target stop "
       "acknowledgement: reserved",
       "reserved"},
      {"400#090101000000", "Low priority destination call acknowledgement, Target stop "},
      {"400#0A0101000000", "High priority destination call acknowledgement, Target stop "},
      {"400#0B0101000000", "Standard call to destination floor acknowledgement, Target stop "},
      {"400#0C0101000000", "Low priority call to destination floor acknowledgement, Target stop "},
      {"400#0D0101000000", "High priority call to destination floor acknowledgement, Target stop "},
      {"400#0E0901000000",
       "Special function acknowledgement, Special function acknowledgement: "
       "Request door open acknowledgement,"},
      {"400#0F0001000000", "Access code upload acknowledgement, Destination lift 1: 1"},
      {"400#100001000000", "Speech connection acknowledgement, Destination lift 1: 1"},
      {"400#110001000000", "Area monitoring connection acknowledgement, Destination lift 1: 1"},
      {"400#120001000000", "Basic function: reserved, ", "reserved"},
      {"400#3F0001000000", "Basic function: reserved, ", "reserved"},
      {"400#450001000000", "Operation data, Destination lift 1: 1"},
      {"400#460001000000", "Publicity indication, Destination lift 1: 1"},
      {"400#470001000000", "Basic function: reserved, ", "reserved"},
      {"400#7F0001000000", "Basic function: reserved, ", "reserved"},
      {"400#800001000000", "Basic function: manufacturer-specific, Sub-function: manufacturer-"},
      {"400#FF1201000000", "Basic function: manufacturer-specific, Sub-function: manufacturer-"},
  });
}

TEST(LiftWords, SayWhatAnIndicationShows) {
  expect({
      {"400#400C01000001", "Position indicator, Floor data: 12, Destination lift 1: 1"},
      {"400#400001000001", "Position indicator, Floor data: clear the display,"},
      {"400#40FF01000001", "Position indicator, Floor data: reserved,", "reserved"},
      {"400#410101000001", "Hall lantern, Up: 1, Moving: the car stands"},
      {"400#421201000001", "Direction indication, Down: 1, Moving: the car moves"},
      {"400#420C01000001", "Direction indication, Right: 1, Left: 1, "},
      {"400#422101000001", "Direction indication, Up: 1", "reserved"},
      {"400#430001000001", "Special indication, Special indication: all displays off"},
      {"400#430301000001", "Special indication, Special indication: Over load"},
      {"400#430601000001", "Special indication, Special indication: Help is coming"},
      // 09h and 0Ah have meanings (errata A4).
      {"400#430901000001", "Special indication, Special indication: Occupied"},
      {"400#430A01000001", "Special indication, Special indication: Out of order"},
      {"400#430B01000001", "Special indication, Special indication: reserved", "reserved"},
      {"400#440101000001", "Arrival indication, Up: 1, Destination lift 1: 1"},
      {"400#440401000001", "Arrival indication, ", "reserved"},
  });
}

TEST(LiftWords, NameEachAcknowledgementOfASpecialFunction) {
  expect({
      {"400#0E0001000000", "Special function acknowledgement: reserved", "reserved"},
      {"400#0E0101000000", "Special function acknowledgement: Request fan 1 acknowledgement"},
      {"400#0E0501000000", "Special function acknowledgement: Request key lock 1 acknowledgement"},
      {"400#0E0B01000000", "Special function acknowledgement: Fire service enable acknowledgement"},
      {"400#0E1001000000", "Special function acknowledgement: Out of order acknowledgement"},
      {"400#0E1601000000",
       "Special function acknowledgement: Dogging service down acknowledgement"},
      {"400#0E1701000000", "Special function acknowledgement: reserved", "reserved"},
  });
}

TEST(LiftWords, SayHowAnOutputWorks) {
  // Status in bit 0, property in bits 1 to 3, its parameter in bits 4 to 6, predicate in bit 7.
  expect({
      {"400#400C01000000",
       "Status: no data indicated, Property: Default, Predicate: "
       "acknowledgement is not affirmed"},
      {"400#400C01000083",
       "Status: data indicated, Property: continuous, Predicate: "
       "acknowledgement is affirmed"},
      {"400#400C01000005", "Property: impulse, Impulse: 0.5 s, "},
      {"400#400C01000075", "Property: impulse, Impulse: 15 s, "},
      {"400#400C01000007", "Property: flashing, Flashing: 10 Hz, "},
      {"400#400C01000057", "Property: flashing, Flashing: 1 Hz, "},
      {"400#400C01000077", "Property: flashing, Flashing: 0.25 Hz, "},
      {"400#400C01000009", "Property: color, Color: white, "},
      {"400#400C01000059", "Property: color, Color: red, "},
      {"400#400C01000029", "Property: color, Color: reserved, ", "reserved"},
      {"400#400C0100000B", "Property: volume, Volume: min., "},
      {"400#400C0100007B", "Property: volume, Volume: max., "},
      {"400#400C0100000D", "Property: scroll rate, Scroll rate: automatic, "},
      {"400#400C0100003D", "Property: scroll rate, Scroll rate: 3 lines/s, "},
      {"400#400C0100000F", "Property: reserved, ", "reserved"},
  });
}

TEST(LiftWords, MarkReservedBitsOfInputs) {
  // Bits 2 to 6 of the function data, bits 2 to 7 of the sub-function of a hall call (CiA 417-4,
  // 4.3.1).
  expect({
      {"481#020104050181", "Call request: call request, Lock: with locking function"},
      {"481#020104050105", "Call request: call request, ", "reserved"},
      {"481#020104050141", "Call request: call request, ", "reserved"},
      {"481#020504050101", "Hall call up: 1, ", "reserved"},
      {"481#028104050101", "Hall call up: 1, ", "reserved"},
      {"481#051C04050101", "Target stop: 28, "},
  });
}

TEST(LiftWords, SayASubIndexOfAnOutputGroupAsIts48Bits) {
  // Segments of an upload of 6200h:05h of node 1, 6 bytes: the position indicator shows floor 3.
  text::FrameDecoder decoder;
  decoder.network().assume_profile(*find_profile("417-4"));
  for (const std::string_view frame :
       {"601#4000620500000000", "581#4100620506000000", "601#6000000000000000"}) {
    decoder.decode(parse_frame(frame).frame);
  }
  const text::FrameWords& words = decoder.decode(parse_frame("581#0340030105010100").frame);
  EXPECT_NE(
      words.text.find("Output group 1, Virtual output 5 = Basic function: Position indicator, "
                      "Floor data: 3, Destination lift 1: 1,"),
      std::string::npos)
      << words.text;
  EXPECT_TRUE(words.marks.empty());
}

}  // namespace
}  // namespace canvoy::tools::lift_words_test
