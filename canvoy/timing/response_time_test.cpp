#include "canvoy/timing/response_time.hpp"

#include <gtest/gtest.h>

namespace canvoy::timing::response_time_test {
namespace {

/// 11-bit messages with the greatest number of stuff bits, and the period as deadline.
BusMessage message(std::uint32_t id, unsigned bytes, Duration period) {
  return {.id = id, .bits = longest_frame_bits(bytes), .period = period, .deadline = period};
}

/// The example in chapter 3 of the paper: three messages of seven bytes at 125 kbit/s, which take a
/// millisecond each.
BusModel example() {
  BusModel model{.bit_rate = 125'000};
  model.messages = {message(1, 7, 2500us), message(2, 7, 3500us), message(3, 7, 3500us)};
  model.messages[1].deadline = model.messages[2].deadline = 3250us;
  return model;
}

TEST(LongestFrame, HasThePapersBits) {
  // 34 + 8 s + 13 and a stuff bit for the 5th and each fourth bit more of the first 34 + 8 s.
  EXPECT_EQ(longest_frame_bits(0), 34 + 13 + 8U);
  EXPECT_EQ(longest_frame_bits(8), 98 + 13 + 24U);
  EXPECT_EQ(longest_frame_bits(7), 125U);
  EXPECT_EQ(longest_frame_bits(8, true), 160U);
}

TEST(WireTime, IsRoundedUp) {
  EXPECT_EQ(wire_time(125, 125'000), 1ms);
  EXPECT_EQ(wire_time(1, 83'333), Nanoseconds(12'001));  // 12000.048
}

TEST(ResponseTimes, OfThePapersExampleSeeTheSecondInstanceOfTheLowest) {
  // The third message waits for one frame of each other: 3 ms for its first instance. At 3.5 ms its
  // second comes, which lets the third of the first (at 5 ms) and the second of the second (at 3.5
  // ms) go first: it begins at 6 ms, ends at 7 and took 3.5. The analysis of 1994 has 3 ms, and no
  // deadline missed.
  const std::vector<Response> responses = response_times(example());
  EXPECT_EQ(responses[0].time, 2ms);
  EXPECT_EQ(responses[1].time, 3ms);
  EXPECT_EQ(responses[2].time, 3500us);
  EXPECT_EQ(responses[2].first, 3ms);
  EXPECT_EQ(responses[2].instances, 2U);
  EXPECT_TRUE(responses[0].meets_deadline);
  EXPECT_TRUE(responses[1].meets_deadline);
  EXPECT_FALSE(responses[2].meets_deadline);
}

TEST(ResponseTimes, FollowTheIdentifiersAndNotTheListsOrder) {
  BusModel model = example();
  std::swap(model.messages[0], model.messages[2]);
  const std::vector<Response> responses = response_times(model);
  EXPECT_EQ(responses[0].time, 3500us);
  EXPECT_EQ(responses[2].time, 2ms);
}

TEST(ResponseTimes, PutAnElevenBitFrameBeforeTheOneOfTwentyNineBitsWithTheSameBits) {
  BusModel model{.bit_rate = 1'000'000};
  model.messages = {message(0x100, 0, 1s), message(0x100U << 18, 0, 1s)};
  model.messages[1].is_extended = true;
  model.messages[1].bits = longest_frame_bits(0, true);
  const std::vector<Response> responses = response_times(model);
  EXPECT_EQ(responses[0].time, responses[1].time);  // one waits for the other, in either order
  EXPECT_EQ(responses[0].blocking, 80us);           // 54 + 13 + 13 bits
  EXPECT_EQ(responses[1].blocking, 0us);
}

TEST(ResponseTimes, CountAFrameThatComesWithinABitOfTheStart) {
  // 55 bits of a microsecond each. The second frame may begin at 55 us; the next one of the first
  // comes then as well, and wins.
  BusModel model{.bit_rate = 1'000'000};
  model.messages = {message(1, 0, 55us), message(2, 0, 1s)};
  EXPECT_FALSE(response_times(model)[1].is_bounded);  // the bus is full
  model.messages[0].period = 56us;
  // It begins at 55 us, and has sent a bit of its own when the next one comes.
  EXPECT_EQ(response_times(model)[1].time, 55us + 55us);
  model.messages[0].jitter = 1us;  // the second comes at 55 us: the start is at 110 us
  EXPECT_EQ(response_times(model)[1].time, 110us + 55us);
}

TEST(ResponseTimes, GrowByTheJitterOfOthersAndByTheOwn) {
  BusModel model = example();
  model.messages[2].period = model.messages[2].deadline = 20ms;
  EXPECT_EQ(response_times(model)[2].time, 3ms);
  model.messages[2].jitter = 700us;
  EXPECT_EQ(response_times(model)[2].time, 3700us);
  model.messages[0].jitter = 600us;  // its next comes after 1.9 ms, before the 2 ms are over
  EXPECT_EQ(response_times(model)[2].time, 4700us);
}

TEST(ResponseTimes, CountABurstByItsDistance) {
  // One message with a frame each second, of which four may come at once: they are 2 ms apart.
  // Another one waits for the first, begins at 1 ms, and ends when the second comes.
  BusModel model{.bit_rate = 125'000};
  model.messages = {message(1, 7, 1s), message(2, 7, 1s)};
  model.messages[0].ahead = 3s;
  EXPECT_EQ(response_times(model)[1].time, 5ms);  // all four, and its own
  model.messages[0].distance = 2ms;
  EXPECT_EQ(response_times(model)[1].time, 2ms);
  // The last of the burst waits for those before, and for a frame of the other message.
  EXPECT_EQ(response_times(model)[0].time, 2ms);
  model.messages[0].distance = 0us;
  EXPECT_EQ(response_times(model)[0].time, 5ms);
}

TEST(ResponseTimes, CountABurstByEachOfItsRows) {
  // Of four that may come at once in the long run, at most two come within 4 ms.
  BusModel model{.bit_rate = 125'000};
  model.messages = {message(1, 7, 1s), message(2, 7, 1s)};
  model.messages[0].ahead = 3s;
  model.messages[0].bursts = {{.period = 4ms, .ahead = 4ms}};
  EXPECT_EQ(response_times(model)[1].time, 3ms);  // two, and its own
  model.messages[0].bursts[0].ahead = 3ms;  // the second comes 1 ms after the first: it counts too
  EXPECT_EQ(response_times(model)[1].time, 3ms);
  model.messages[0].bursts[0].ahead = 2ms;
  EXPECT_EQ(response_times(model)[1].time, 2ms);
}

TEST(ResponseTimes, OfFramesBehindSyncAreShorterWhereTheyKeepTheirDistance) {
  // Two messages of 10 ms, 4 ms apart behind SYNC: the second never meets the first.
  BusModel model{.bit_rate = 125'000};
  model.messages = {message(1, 7, 10ms), message(2, 7, 10ms)};
  EXPECT_EQ(response_times(model)[1].time, 2ms);
  model.messages[0].offset = 0us;
  model.messages[1].offset = 4ms;
  EXPECT_EQ(response_times(model)[1].time, 1ms);
  model.messages[0].jitter = 3500us;  // it may begin at 3.5 ms, and is in the way until 4.5
  EXPECT_EQ(response_times(model)[1].time, 1500us);
  EXPECT_EQ(response_times(model)[0].time, 5500us);  // 3.5, blocked for 1, and its own
}

TEST(ResponseTimes, OfDifferentPeriodsBehindSyncTryAllPlaces) {
  // The first comes with each SYNC of 10 ms, the second with each third, 20 ms after it: they meet.
  // 5 ms after it they do not.
  BusModel model{.bit_rate = 125'000};
  model.messages = {message(1, 7, 10ms), message(2, 7, 30ms)};
  model.messages[0].offset = 0us;
  model.messages[1].offset = 20ms;
  EXPECT_EQ(response_times(model)[1].time, 2ms);
  model.messages[1].offset = 25ms;
  EXPECT_EQ(response_times(model)[1].time, 1ms);
}

TEST(ResponseTimes, UseNoPlacesWhereTheyAreTooMany) {
  BusModel model{.bit_rate = 125'000};
  model.messages = {message(1, 7, 10007us), message(2, 7, 10009us)};
  model.messages[0].offset = 0us;
  model.messages[1].offset = 5ms;
  EXPECT_EQ(response_times(model)[1].time, 2ms);
}

TEST(ResponseTimes, GrowByErrors) {
  // One error: 31 bits and another frame of 125, 1.248 ms at 125 kbit/s.
  BusModel model{.bit_rate = 125'000};
  model.messages = {message(1, 7, 100ms), message(2, 7, 100ms)};
  model.errors.at_once = 1;
  EXPECT_EQ(response_times(model)[1].time, 2ms + 1248us);
  model.errors.at_once = 3;
  EXPECT_EQ(response_times(model)[1].time, 2ms + 3 * 1248us);
  // One, and one more after 2 ms, when the message is not over, and one at 4 ms.
  model.errors = {.at_once = 1, .each = 2ms};
  EXPECT_EQ(response_times(model)[1].time, 2ms + 3 * 1248us);
  model.errors = {.at_once = 0, .each = 10ms};  // the first may come at any time
  EXPECT_EQ(response_times(model)[1].time, 2ms + 1248us);
  model.errors = {.at_once = 1, .each = 1248us};  // they take all of the bus
  EXPECT_FALSE(response_times(model)[1].is_bounded);
}

TEST(ResponseTimes, HaveNoBoundWhereTheBusIsFull) {
  BusModel model{.bit_rate = 125'000};
  model.messages = {message(1, 7, 2ms), message(2, 7, 2ms), message(3, 7, 100ms)};
  const std::vector<Response> responses = response_times(model);
  EXPECT_TRUE(responses[0].is_bounded);
  EXPECT_FALSE(responses[1].is_bounded);
  EXPECT_FALSE(responses[1].meets_deadline);
  EXPECT_FALSE(responses[2].is_bounded);
}

TEST(ResponseTimes, OfNoMessagesAreNone) {
  EXPECT_TRUE(response_times({}).empty());
  EXPECT_EQ(utilisation({}), 0.0);
}

TEST(ResponseTimes, EndWhereNumbersAreAsLargeAsTheyCanBe) {
  BusModel model{.bit_rate = 1000};
  for (std::uint32_t id = 0; id < 50; ++id) {
    model.messages.push_back(message(id, 8, Duration{1h} * 24 * 365));
    model.messages.back().jitter = model.messages.back().ahead = Duration{1h} * 24 * 365;
  }
  model.messages.push_back(message(60, 8, 1s));
  model.messages.back().ahead = Duration{1s} * 1'000'000'000;
  EXPECT_FALSE(response_times(model).back().is_bounded);  // a burst of 10^9 frames
  EXPECT_TRUE(response_times(model).front().is_bounded);
}

TEST(Utilisation, IsTheSumOfFramesOverTheirPeriods) {
  EXPECT_NEAR(utilisation(example()), 1 / 2.5 + 2 / 3.5, 1e-12);
}

}  // namespace
}  // namespace canvoy::timing::response_time_test
