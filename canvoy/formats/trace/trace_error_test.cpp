// Expected bytes are typed from linux/can/error.h, as set by the SJA1000 driver of Linux, and from
// the description of Vector's register in the headers of BLF.
#include "canvoy/formats/trace/trace_error.hpp"

#include <gtest/gtest.h>

#include <string>

#include "canvoy/can/frame_text.hpp"

namespace canvoy::formats::trace_error_test {
namespace {

std::string text_of(const TraceError& error) {
  return std::string(FrameText(trace_error_frame(error)).view());
}

TEST(TraceErrorTest, WithoutDetailsIsABusError) {
  EXPECT_EQ(text_of({}), "20000080#0000000000000000");
}

TEST(TraceErrorTest, OfAnSja1000HasKindDirectionAndPlace) {
  EXPECT_EQ(text_of(sja1000_error(0b00'1'01010)), "20000088#0000010A00000000") << "bit, received";
  EXPECT_EQ(text_of(sja1000_error(0b01'1'11010)), "20000088#0000021A00000000") << "form";
  EXPECT_EQ(text_of(sja1000_error(0b10'0'00010)), "20000088#0000840200000000") << "stuff, sent";
  EXPECT_EQ(text_of(sja1000_error(0b11'1'01000)), "20000088#0000000800000000") << "other: CRC";
}

TEST(TraceErrorTest, OfAControllerOfVectorHasKindAndDirection) {
  EXPECT_EQ(text_of(vector_core_error(0x80 | 0)), "20000088#0000010000000000") << "bit, received";
  EXPECT_EQ(text_of(vector_core_error(0xC0 | 1)), "20000088#0000820000000000") << "form, sent";
  EXPECT_EQ(text_of(vector_core_error(0x80 | 2)), "20000088#0000040000000000") << "stuff";
  EXPECT_EQ(text_of(vector_core_error(0x80 | 3)), "20000080#0000000000000000") << "other";
  EXPECT_EQ(text_of(vector_core_error(0x80 | 4)), "20000088#0000000800000000") << "CRC";
  EXPECT_EQ(text_of(vector_core_error(0x80 | 5)), "20000088#0000021B00000000") << "ACK delimiter";
  EXPECT_EQ(text_of(vector_core_error(0xC0 | 7)), "200000A8#0000801900000000") << "no ACK, sent";
  EXPECT_EQ(text_of(vector_core_error(0x40 | 3)), "200000A8#0000800000000000") << "no ACK, sent";
}

TEST(TraceErrorTest, OfVectorSaysWhoseRegisterItIs) {
  EXPECT_EQ(text_of(vector_error(1, 0xA2)), text_of(sja1000_error(0xA2)));
  EXPECT_EQ(text_of(vector_error(2, 0x82)), text_of(vector_core_error(0x82)));
  EXPECT_EQ(text_of(vector_error(0, 0x82)), text_of({}));
}

}  // namespace
}  // namespace canvoy::formats::trace_error_test
