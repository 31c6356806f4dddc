#include "canvoy/tools/page/frame_index.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace canvoy::tools::frame_index_test {
namespace {

using ::testing::UnorderedElementsAre;

TEST(FrameIndex, HasEachBusAndCanIdOfABlockOnce) {
  FrameIndex index;
  index.add(0, Frame::data_frame(0x705, {0x05}));
  index.add(0, Frame::data_frame(0x705, {0x7F}));
  index.add(31, Frame::remote_frame(0x7FF, 1));
  index.end_block();
  index.add(0, Frame::data_frame(0x000, {0x01, 0x05}));
  EXPECT_THAT(index.keys(0), UnorderedElementsAre(0x705, 31 * 2048 + 0x7FF));
  EXPECT_THAT(index.keys(1), UnorderedElementsAre(0x000));
  EXPECT_EQ(FrameIndex::bus(index.keys(0)[1]), 31U);
  EXPECT_EQ(FrameIndex::can_id(index.keys(0)[1]), 0x7FFU);
  EXPECT_EQ(index.all_keys().count(), 3U);
}

TEST(FrameIndex, TellsBusesOfFramesWithoutACanIdOf11Bits) {
  FrameIndex index;
  Frame error;
  error.flags = FrameFlags::error;
  index.add(2, error);
  index.add(3, Frame::data_frame(0x1234567, {}));
  EXPECT_EQ(index.errors(0), 1U << 2);
  EXPECT_EQ(index.extended(0), 1U << 3);
  EXPECT_TRUE(index.keys(0).empty());
}

TEST(FrameIndex, TellsABlockThatTeachesAndTheNextOne) {
  FrameIndex index;
  for (int block = 0; block < 4; ++block) {
    index.add(0, Frame::data_frame(0x60A, {0x40, 0x10, 0x60, 0, 0, 0, 0, 0}));  // 6010h
    if (block == 1) index.add(0, Frame::data_frame(0x60A, {0x40, 0x18, 0x10, 1, 0, 0, 0, 0}));
    index.end_block();
  }
  EXPECT_FALSE(index.teaches(0));
  EXPECT_TRUE(index.teaches(1));
  EXPECT_TRUE(index.teaches(2));
  EXPECT_FALSE(index.teaches(3));
}

}  // namespace
}  // namespace canvoy::tools::frame_index_test
