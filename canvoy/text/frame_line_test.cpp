// The head of a line is that of candump, `(seconds.microseconds) bus frame`; the text for the frame
// is typed from the named clauses.
#include "canvoy/text/frame_line.hpp"

#include <gtest/gtest.h>

#include "canvoy/can/frame_text.hpp"
#include "canvoy/profiles/registry.hpp"

namespace canvoy::text::frame_line_test {
namespace {

using namespace std::chrono_literals;

class FrameLineTest : public testing::Test {
 protected:
  FrameLineTest() { decoder.network().set_profile(10, *find_profile("418")); }

  std::string line(std::string_view frame, Duration time = 1'700'000'000'000'125us) {
    const FrameWords& words = decoder.decode(parse_frame(frame).frame);
    std::string made;
    append_frame_line(made, {time, "can0", frame}, words, words.text);
    return made;
  }

  std::string narrow(std::string_view frame, std::size_t width, std::string_view bus = "") {
    const FrameWords& words = decoder.decode(parse_frame(frame).frame);
    std::string made;
    append_narrow_line(made, {12'345'678us, bus, frame}, words, words.text, width);
    return made;
  }

  FrameDecoder decoder;
};

TEST_F(FrameLineTest, OnFewColumnsTheLineGoesOnBelow) {
  EXPECT_EQ(narrow("18A#A00001", 80),
            "  12.345 18A#A00001           TPDO1 10: temperature = 20.000 \u00B0C; "
            "battery_status\n      = ready");
  EXPECT_EQ(narrow("18A#A00001", 100),
            "  12.345 18A#A00001           TPDO1 10: temperature = 20.000 \u00B0C; "
            "battery_status = ready");
  EXPECT_EQ(narrow("000#0100", 80, "can1"),
            "  12.345 can1 000#0100             NMT start all nodes");
  for (std::size_t width = 1; width < 120; ++width) {
    const std::string text = narrow("18A#A000", width);
    EXPECT_NE(text.find("[!]"), std::string::npos) << "nothing is left out";
  }
}

TEST_F(FrameLineTest, HasItsColumnsOneBelowTheOther) {
  // 6010h has 0.125 °C per step; ready is bit 0 of 6000h (CiA 418). Start all (CiA 301, 7.2.8.3.1).
  EXPECT_EQ(line("18A#A00001"),
            "(1700000000.000125) can0 18A#A00001            TPDO1            node 10 (0Ah): "
            "temperature = 20.000 °C; battery_status = ready");
  EXPECT_EQ(line("000#0100"),
            "(1700000000.000125) can0 000#0100              NMT              start all nodes");
}

TEST_F(FrameLineTest, AMarkStandsBehindTheMeaning) {
  // TPDO1 has three bytes (CiA 418).
  EXPECT_TRUE(line("18A#A000").ends_with("temperature = 20.000 °C [!] wrong length"));
}

TEST_F(FrameLineTest, TimesHaveSixPlacesAndASign) {
  EXPECT_TRUE(line("000#0100", 0us).starts_with("(0.000000) can0 "));
  EXPECT_TRUE(line("000#0100", 1'000'001us).starts_with("(1.000001) can0 "));
  EXPECT_TRUE(line("000#0100", -500us).starts_with("(-0.000500) can0 "));
}

}  // namespace
}  // namespace canvoy::text::frame_line_test
