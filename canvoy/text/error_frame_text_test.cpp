// Expected words are typed from linux/can/error.h; tests/strangers/error_frames compares them with
// candump and tshark.
#include "canvoy/text/error_frame_text.hpp"

#include <gtest/gtest.h>

#include "canvoy/can/frame_text.hpp"
#include "canvoy/text/frame_decoder.hpp"

namespace canvoy::text::error_frame_text_test {
namespace {

std::string text_of(std::string_view frame) {
  return error_frame_text(parse_frame(frame).frame);
}

TEST(ErrorFrameText, NamesEachClass) {
  EXPECT_EQ(text_of("20000001#0000000000000000"), "transmit time-out");
  EXPECT_EQ(text_of("20000002#0000000000000000"), "arbitration lost");
  EXPECT_EQ(text_of("20000002#0C00000000000000"), "arbitration lost in bit 12");
  EXPECT_EQ(text_of("20000004#0000000000000000"), "controller");
  EXPECT_EQ(text_of("20000008#0000000000000000"), "protocol violation");
  EXPECT_EQ(text_of("20000010#0000000000000000"), "transceiver");
  EXPECT_EQ(text_of("20000020#0000000000000000"), "no acknowledgement");
  EXPECT_EQ(text_of("20000040#0000000000000000"), "bus-off");
  EXPECT_EQ(text_of("20000080#0000000000000000"), "bus error");
  EXPECT_EQ(text_of("20000100#0000000000000000"), "controller restarted");
  EXPECT_EQ(text_of("20000200#0000000000000000"), "error counters: 0 transmit, 0 receive");
  EXPECT_EQ(text_of("20000000#0000000000000000"), "");
  EXPECT_EQ(text_of("20000400#0000000000000000"), "unknown classes 00000400h");
}

TEST(ErrorFrameText, NamesTheStatusOfTheController) {
  EXPECT_EQ(text_of("20000004#0001000000000000"), "controller: receive buffer overflow");
  EXPECT_EQ(text_of("20000004#000C000000006000"),
            "controller: error warning (reception), error warning (transmission); error counters: "
            "96 transmit, 0 receive");
  EXPECT_EQ(text_of("20000204#0020000000008000"),
            "controller: error-passive (transmission); error counters: 128 transmit, 0 receive");
  EXPECT_EQ(text_of("20000004#0040000000000000"), "controller: error-active again");
  EXPECT_EQ(text_of("20000004#0080000000000000"), "controller: unknown bits 80h");
}

TEST(ErrorFrameText, NamesTypeAndPlaceOfAViolation) {
  EXPECT_EQ(text_of("20000088#0000190000000000"),
            "protocol violation: bit error, no dominant bit could be sent, no recessive bit could "
            "be sent; bus error");
  EXPECT_EQ(text_of("20000088#0000840A00000000"),
            "protocol violation: stuff error on transmission in the data field; bus error");
  EXPECT_EQ(text_of("200000A8#0000801900000000"),
            "no acknowledgement; protocol violation: on transmission in the ACK slot; bus error");
  EXPECT_EQ(text_of("20000008#0000000800000000"), "protocol violation: in the CRC sequence");
  EXPECT_EQ(text_of("20000008#0000021A00000000"),
            "protocol violation: form error in the end of frame");
  EXPECT_EQ(text_of("20000008#0000001F00000000"), "protocol violation: unknown code 1Fh");
}

TEST(ErrorFrameText, NamesBothWiresOfTheTransceiver) {
  EXPECT_EQ(text_of("20000010#0000000004000000"), "transceiver: CANH has no wire");
  EXPECT_EQ(text_of("20000010#0000000075000000"),
            "transceiver: CANH is shorted to the battery, CANL is shorted to ground");
  EXPECT_EQ(text_of("20000010#0000000080000000"), "transceiver: CANL is shorted to CANH");
  EXPECT_EQ(text_of("20000010#0000000001000000"), "transceiver: unknown code 01h");
}

TEST(ErrorFrameText, TellsADetailWhereItsClassIsSet) {
  EXPECT_EQ(text_of("20000040#0C3F840A75000000"), "bus-off");
}

TEST(ErrorFrameText, OfAFrameWithoutAllBytesTakesThemForZero) {
  EXPECT_EQ(text_of("20000088#"), "protocol violation; bus error");
}

TEST(ErrorFrameText, IsWhatADecoderSays) {
  FrameDecoder decoder;
  const FrameWords& words = decoder.decode(parse_frame("20000040#0000000000000000").frame);
  EXPECT_EQ(words.service, "error frame");
  EXPECT_EQ(words.text, "bus-off");
  EXPECT_EQ(words.node, 0);
}

}  // namespace
}  // namespace canvoy::text::error_frame_text_test
