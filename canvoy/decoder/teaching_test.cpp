#include "canvoy/decoder/teaching.hpp"

#include <gtest/gtest.h>

#include <random>

#include "canvoy/decoder/decoder.hpp"
#include "canvoy/profiles/registry.hpp"

namespace canvoy::decoder::teaching_test {
namespace {

TEST(Teaching, IsOfSdoWithObjectsThatSayWhatOthersMeanAndOfLss) {
  const auto read = [](std::uint8_t low, std::uint8_t high, std::uint8_t sub) {
    return may_teach(Frame::data_frame(0x60A, {0x40, low, high, sub, 0, 0, 0, 0}));
  };
  EXPECT_TRUE(read(0x00, 0x10, 0));   // 1000h
  EXPECT_TRUE(read(0x18, 0x10, 4));   // 1018h
  EXPECT_TRUE(read(0x01, 0x12, 1));   // 1201h
  EXPECT_TRUE(read(0x03, 0x1A, 0));   // 1A03h
  EXPECT_FALSE(read(0x01, 0x10, 0));  // 1001h
  EXPECT_FALSE(read(0x10, 0x60, 0));  // 6010h
  EXPECT_TRUE(may_teach(Frame::data_frame(0x58A, {0x43, 0x00, 0x10, 0, 0xA2, 0x01, 0, 0})));
  EXPECT_TRUE(may_teach(Frame::data_frame(0x7E4, {0x44, 5, 0, 0, 0, 0, 0, 0})));
  EXPECT_FALSE(may_teach(Frame::data_frame(0x18A, {0x43, 0x00, 0x10, 0, 0xA2, 0x01, 0, 0})));
  EXPECT_FALSE(may_teach(Frame::data_frame(0x60A, {0x40, 0x00, 0x10})));
}

/// Requests and answers about any objects, most of them of those that teach.
Frame any_frame(std::mt19937& random) {
  const auto below = [&random](unsigned end) { return static_cast<std::uint8_t>(random() % end); };
  constexpr std::array<std::uint16_t, 8> indices = {0x1000, 0x1018, 0x1201, 0x1400,
                                                    0x1800, 0x1A00, 0x6480, 0x6010};
  const std::uint16_t index = indices[below(indices.size())];
  const bool is_request = below(2) == 0;
  constexpr std::array<std::uint8_t, 4> requests = {0x40, 0x23, 0x2F, 0x60};
  constexpr std::array<std::uint8_t, 4> answers = {0x43, 0x60, 0x4F, 0x41};
  return Frame::data_frame(
      (is_request ? 0x600U : 0x580U) + 1 + below(3),
      {is_request ? requests[below(4)] : answers[below(4)], static_cast<std::uint8_t>(index),
       static_cast<std::uint8_t>(index >> 8), below(4), below(255), below(3), below(8), 0});
}

TEST(Teaching, IsInAllFramesThatAListenerLearnsFrom) {
  std::mt19937 random(7);
  Decoder decoder;
  unsigned learned = 0;
  for (int i = 0; i < 200'000; ++i) {
    const Frame frame = any_frame(random);
    const std::uint32_t before = decoder.network().generation();
    decoder.decode(frame);
    if (decoder.network().generation() == before) continue;
    ++learned;
    ASSERT_TRUE(may_teach(frame)) << std::hex << frame.id << " " << unsigned{frame.data[2]};
  }
  EXPECT_GT(learned, 1000U);
}

}  // namespace
}  // namespace canvoy::decoder::teaching_test
