#include "canvoy/timing/breakdown.hpp"

#include <gtest/gtest.h>

namespace canvoy::timing::breakdown_test {
namespace {

BusMessage message(std::uint32_t id, Duration period, Duration deadline) {
  return {.id = id, .bits = 125, .period = period, .deadline = deadline};
}

TEST(Breakdown, OfOneMessageIsAFullBus) {
  // A frame of a millisecond each 10: ten times as many fit.
  const BusModel model{.bit_rate = 125'000, .messages = {message(1, 10ms, 10ms)}};
  const auto at = breakdown(model);
  ASSERT_TRUE(at);
  EXPECT_NEAR(at->scale, 0.1, 0.0002);
  EXPECT_NEAR(at->utilisation, 1.0, 0.002);
}

TEST(Breakdown, OfTwoIsWhereTheFirstWaitsForTheSecond) {
  // The first needs 2 ms, blocked by the second: its period and deadline are not below 2 ms.
  BusModel model{.bit_rate = 125'000};
  model.messages = {message(1, 10ms, 10ms), message(2, 40ms, 40ms)};
  const auto at = breakdown(model);
  ASSERT_TRUE(at);
  EXPECT_NEAR(at->scale, 0.2, 0.0004);
  EXPECT_NEAR(at->utilisation, 1 / 2.0 + 1 / 8.0, 0.002);
}

TEST(Breakdown, OfABusThatIsLateIsBelowItsLoad) {
  // The first needs 2 ms for each of its frames, and has one in 1.6.
  BusModel model{.bit_rate = 125'000};
  model.messages = {message(1, 1600us, 1600us), message(2, 40ms, 40ms)};
  const auto at = breakdown(model);
  ASSERT_TRUE(at);
  EXPECT_NEAR(at->scale, 1.25, 0.002);
  EXPECT_LT(at->utilisation, utilisation(model));
}

TEST(Breakdown, IsNoneWhereADeadlineIsBelowWhatItTakes) {
  const BusModel model{.bit_rate = 125'000, .messages = {message(1, 10ms, 900us)}};
  EXPECT_FALSE(breakdown(model));
  EXPECT_FALSE(breakdown({}));
}

TEST(Scaled, KeepsMultiplesOfSyncAndDeadlinesThatAreNoPeriods) {
  BusModel model;
  model.messages = {message(1, 10ms, 10ms), message(2, 30ms, 5ms)};
  model.messages[0].offset = 0us;
  model.messages[1].offset = 7ms;
  const BusModel made = scaled(model, 1.0 / 3);
  EXPECT_EQ(made.messages[0].period, 3333us);
  EXPECT_EQ(made.messages[0].deadline, 3333us);
  EXPECT_EQ(made.messages[1].period, 9999us);
  EXPECT_EQ(made.messages[1].deadline, 5ms);
  EXPECT_EQ(made.messages[1].offset, 2333us);
}

}  // namespace
}  // namespace canvoy::timing::breakdown_test
