#include "canvoy/can/simulated/arbitration.hpp"

#include <gtest/gtest.h>

namespace canvoy::arbitration_test {
namespace {

bool wins(const Frame& frame, const Frame& against) {
  return arbitration_key(frame) < arbitration_key(against);
}

Frame extended(std::uint32_t id, bool is_remote = false) {
  Frame frame = is_remote ? Frame::remote_frame(id, 0) : Frame::data_frame(id, {});
  frame.flags = frame.flags | FrameFlags::extended;
  return frame;
}

TEST(Arbitration, IsWonByTheLowerIdentifierWhateverTheData) {
  EXPECT_TRUE(wins(Frame::data_frame(0x080, {0xFF}), Frame::data_frame(0x081, {})));
  EXPECT_TRUE(wins(Frame::data_frame(0x000, {}), Frame::data_frame(0x7FF, {})));
  EXPECT_TRUE(wins(extended(0x100), extended(0x101)));
}

TEST(Arbitration, OfADataFrameAndARemoteFrameWithOneIdentifierIsWonByTheDataFrame) {
  EXPECT_TRUE(wins(Frame::data_frame(0x185, {}), Frame::remote_frame(0x185, 8)));
  EXPECT_TRUE(wins(extended(0x1234567), extended(0x1234567, true)));
  EXPECT_TRUE(wins(Frame::remote_frame(0x184, 8), Frame::data_frame(0x185, {})));
}

TEST(Arbitration, BetweenElevenAndTwentyNineBitsIsDecidedByTheFirstElevenThenForTheEleven) {
  const std::uint32_t same_base = 0x185U << 18;
  EXPECT_TRUE(wins(Frame::data_frame(0x185, {}), extended(same_base)));
  EXPECT_TRUE(wins(Frame::remote_frame(0x185, 0), extended(same_base)));
  EXPECT_TRUE(wins(extended((0x184U << 18) | 0x3FFFF, true), Frame::data_frame(0x185, {})));
  // A 29-bit identifier of the same value begins with zeros.
  EXPECT_TRUE(wins(extended(0x185), Frame::data_frame(0x185, {})));
}

TEST(Arbitration, IsNotDecidedBetweenFramesWithTheSameIdentifier) {
  EXPECT_EQ(arbitration_key(Frame::data_frame(0x705, {4})),
            arbitration_key(Frame::data_frame(0x705, {5})));
}

}  // namespace
}  // namespace canvoy::arbitration_test
