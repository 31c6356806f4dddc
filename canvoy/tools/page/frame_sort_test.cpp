#include "canvoy/tools/page/frame_sort.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace canvoy::tools::frame_sort_test {
namespace {

/// Each frame is told apart by its CAN-ID and bytes.
StoredFrame frame_at(std::uint64_t number, Time time) {
  const std::array<std::uint8_t, 4> bytes = {
      static_cast<std::uint8_t>(number), static_cast<std::uint8_t>(number >> 8),
      static_cast<std::uint8_t>(number >> 16), static_cast<std::uint8_t>(number >> 24)};
  return {time, Frame::data_frame(0x181, bytes), static_cast<std::uint8_t>(number % 32)};
}

/// `part` frames are sorted in memory: a hundred parts are merged in two steps.
void expect_sorted(std::vector<StoredFrame> frames, std::uint64_t part) {
  FrameStore store;
  for (const StoredFrame& each : frames) store.add(each);
  sort_by_time(store, part);
  std::ranges::stable_sort(frames, {}, &StoredFrame::time);
  ASSERT_EQ(store.size(), frames.size());
  FrameCursor cursor(store);
  for (std::uint64_t i = 0; i < frames.size(); ++i) {
    ASSERT_EQ(cursor.at(i).time, frames[i].time) << i;
    ASSERT_EQ(cursor.at(i).frame, frames[i].frame) << i;
  }
}

TEST(FrameSort, KeepsTheOrderOfFramesOfOneTime) {
  std::mt19937 random(3);
  std::vector<StoredFrame> frames;
  for (std::uint64_t i = 0; i < 30'000; ++i) {
    frames.push_back(frame_at(i, Time(Duration(random() % 1000))));
  }
  expect_sorted(frames, 100'000);
  expect_sorted(frames, 7001);
  expect_sorted(frames, 300);
}

TEST(FrameSort, OfALogWhoseTimeJumpsBackOncePutsTheSecondHalfFirst) {
  std::vector<StoredFrame> frames;
  for (std::uint64_t i = 0; i < 20'000; ++i) {
    frames.push_back(frame_at(i, Time(Duration(1ms) * static_cast<int>((i + 10'000) % 20'000))));
  }
  expect_sorted(frames, 3000);
}

TEST(FrameSort, TakesAStoreOfNoFrames) {
  expect_sorted({}, 1000);
}

}  // namespace
}  // namespace canvoy::tools::frame_sort_test
