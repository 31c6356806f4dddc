#include "canvoy/can/frame_text.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <string>

namespace canvoy::frame_text_test {
namespace {

Frame error_frame(std::uint32_t error_class, std::initializer_list<std::uint8_t> data) {
  Frame frame = Frame::data_frame(0, data);
  frame.id = error_class;
  frame.flags = FrameFlags::error;
  return frame;
}

Frame extended(Frame frame) {
  frame.flags = frame.flags | FrameFlags::extended;
  return frame;
}

std::string written(const Frame& frame) {
  return std::string(FrameText(frame).view());
}

TEST(FrameText, AnElevenBitIdentifierHasThreeDigits) {
  EXPECT_EQ(written(Frame::data_frame(0x185, {0x1E, 0x2F})), "185#1E2F");
  EXPECT_EQ(written(Frame::data_frame(0x000, {0x01, 0x00})), "000#0100");
  EXPECT_EQ(written(Frame::data_frame(0x080, {})), "080#");
}

TEST(FrameText, ATwentyNineBitIdentifierHasEightDigitsEvenWhereItIsSmall) {
  EXPECT_EQ(written(Frame::data_frame(0x1FFFFFFF, {1, 2, 3, 4, 5, 6, 7, 8})),
            "1FFFFFFF#0102030405060708");
  EXPECT_EQ(written(extended(Frame::data_frame(0x185, {0xFF}))), "00000185#FF");
}

TEST(FrameText, ARemoteFrameShowsTheLengthThatItAsksForUnlessThatIsZero) {
  EXPECT_EQ(written(Frame::remote_frame(0x185, 8)), "185#R8");
  EXPECT_EQ(written(Frame::remote_frame(0x701, 0)), "701#R");
  EXPECT_EQ(written(extended(Frame::remote_frame(0x12, 3))), "00000012#R3");
}

TEST(FrameText, AnErrorFrameShowsItsClassWithTheErrorFlagOfSocketCan) {
  EXPECT_EQ(written(error_frame(0x004, {0, 4, 0, 0, 0, 0, 0, 0})), "20000004#0004000000000000");
  EXPECT_EQ(written(error_frame(0x040, {})), "20000040#");
}

TEST(ParseFrame, ReadsWhatCanUtilsWrite) {
  EXPECT_EQ(parse_frame("123#DEADBEEF").frame, Frame::data_frame(0x123, {0xDE, 0xAD, 0xBE, 0xEF}));
  EXPECT_EQ(parse_frame("00000123#11").frame, extended(Frame::data_frame(0x123, {0x11})));
  EXPECT_EQ(parse_frame("701#R").frame, Frame::remote_frame(0x701, 0));
  EXPECT_EQ(parse_frame("1FFFFFFF#R8").frame, Frame::remote_frame(0x1FFFFFFF, 8));
  EXPECT_EQ(parse_frame("20000040#").frame, error_frame(0x40, {}));
}

TEST(ParseFrame, TakesSmallLettersAndDotsAsCansendDoes) {
  EXPECT_EQ(parse_frame("7ff#de.ad.be.ef").frame,
            Frame::data_frame(0x7FF, {0xDE, 0xAD, 0xBE, 0xEF}));
  EXPECT_EQ(parse_frame("7ff#r2").frame, Frame::remote_frame(0x7FF, 2));
}

TEST(ParseFrame, DropsTheRawDlcBehindEightBytes) {
  EXPECT_EQ(parse_frame("123#0102030405060708_E").frame,
            Frame::data_frame(0x123, {1, 2, 3, 4, 5, 6, 7, 8}));
  EXPECT_EQ(parse_frame("123#R8_9").frame, Frame::remote_frame(0x123, 8));
}

struct Refusal {
  const char* text;
  FrameTextError error;
};

class ParseFrameRefuses : public testing::TestWithParam<Refusal> {};

TEST_P(ParseFrameRefuses, WithTheReasonAndAnEmptyFrame) {
  const ParsedFrame parsed = parse_frame(GetParam().text);
  EXPECT_FALSE(parsed) << GetParam().text;
  EXPECT_EQ(parsed.error, GetParam().error) << GetParam().text;
  EXPECT_EQ(parsed.frame, Frame{});
  EXPECT_FALSE(describe(parsed.error).empty());
}

INSTANTIATE_TEST_SUITE_P(
    Texts, ParseFrameRefuses,
    testing::Values(Refusal{"", FrameTextError::identifier_length},
                    Refusal{"123", FrameTextError::identifier_length},
                    Refusal{"1234#", FrameTextError::identifier_length},
                    Refusal{"#11", FrameTextError::identifier_length},
                    Refusal{"12G#11", FrameTextError::identifier_digit},
                    Refusal{" 12#11", FrameTextError::identifier_digit},
                    Refusal{"800#11", FrameTextError::identifier_range},
                    Refusal{"40000000#11", FrameTextError::identifier_range},
                    Refusal{"80000123#11", FrameTextError::identifier_range},
                    Refusal{"123#1", FrameTextError::data_digit},
                    Refusal{"123#1X", FrameTextError::data_digit},
                    Refusal{"123#11 ", FrameTextError::data_digit},
                    Refusal{"123#.11", FrameTextError::data_digit},
                    Refusal{"123#11..22", FrameTextError::data_digit},
                    Refusal{"123#11.", FrameTextError::data_digit},
                    Refusal{"123#11_9", FrameTextError::data_digit},
                    Refusal{"123#010203040506070809", FrameTextError::data_length},
                    Refusal{"123#0102030405060708_8", FrameTextError::data_length},
                    Refusal{"123#R9", FrameTextError::remote_length},
                    Refusal{"123#R88", FrameTextError::remote_length},
                    Refusal{"123#R7_9", FrameTextError::remote_length},
                    Refusal{"20000040#R", FrameTextError::remote_error},
                    Refusal{"123##0112233", FrameTextError::fd}));

RC_GTEST_PROP(FrameText, AnyFrameIsReadBackAsItWasWritten, ()) {
  const auto extended_id = *rc::gen::arbitrary<bool>();
  const auto id = *rc::gen::inRange<std::uint32_t>(0, extended_id ? 0x2000'0000 : 0x800);
  const auto data = *rc::gen::container<std::vector<std::uint8_t>>(
      *rc::gen::inRange<std::size_t>(0, 9), rc::gen::arbitrary<std::uint8_t>());
  Frame frame = Frame::data_frame(id, data);
  if (*rc::gen::arbitrary<bool>()) frame = Frame::remote_frame(id, frame.length);
  if (extended_id) frame = extended(frame);
  RC_ASSERT(parse_frame(FrameText(frame).view()).frame == frame);
}

}  // namespace
}  // namespace canvoy::frame_text_test
