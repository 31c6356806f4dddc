#include "canvoy/tools/page/frame_store.hpp"

#include <gtest/gtest.h>

namespace canvoy::tools::frame_store_test {
namespace {

constexpr std::uint64_t in_memory = FrameStore::memory_blocks * FrameStore::block_frames;

StoredFrame numbered(std::uint64_t number) {
  const std::array<std::uint8_t, 4> bytes = {
      static_cast<std::uint8_t>(number), static_cast<std::uint8_t>(number >> 8),
      static_cast<std::uint8_t>(number >> 16), static_cast<std::uint8_t>(number >> 24)};
  return {Time(Duration(static_cast<Duration::rep>(number / 2 * 10))),
          Frame::data_frame(0x181, bytes), static_cast<std::uint8_t>(number % 32)};
}

TEST(FrameStore, GivesEachFrameBackFromMemoryFromTheFileAndFromTheLastBlock) {
  FrameStore store;
  const std::uint64_t count = in_memory + 2 * FrameStore::block_frames + 7;
  for (std::uint64_t i = 0; i < count; ++i) store.add(numbered(i));
  ASSERT_EQ(store.size(), count);
  FrameCursor cursor(store);
  for (const std::uint64_t i :
       {std::uint64_t{0}, in_memory - 1, in_memory, in_memory + FrameStore::block_frames,
        in_memory + 1, count - 8, count - 7, count - 1, std::uint64_t{4095}}) {
    const StoredFrame& frame = cursor.at(i);
    EXPECT_EQ(frame.plain(), numbered(i).plain()) << i;
    EXPECT_EQ(frame.time, numbered(i).time) << i;
    EXPECT_EQ(frame.bus(), i % 32) << i;
  }
}

TEST(FrameStore, FindsTheFirstFrameLaterThanATime) {
  FrameStore store;
  const std::uint64_t count = 3 * FrameStore::block_frames;
  for (std::uint64_t i = 0; i < count; ++i) store.add(numbered(i));
  EXPECT_EQ(store.first_after(Time(-1us)), 0U);
  EXPECT_EQ(store.first_after(Time(0us)), 2U);
  EXPECT_EQ(store.first_after(Time(9us)), 2U);
  EXPECT_EQ(store.first_after(Time(10us)), 4U);
  // Two frames with one time, the second of which begins a block.
  EXPECT_EQ(store.first_after(Time(Duration(4096 / 2 * 10))), 4098U);
  EXPECT_EQ(store.first_after(Time(1h)), count);
}

TEST(FrameStore, OfNoFramesFindsNone) {
  EXPECT_EQ(FrameStore().first_after(Time(1h)), 0U);
}

}  // namespace
}  // namespace canvoy::tools::frame_store_test
