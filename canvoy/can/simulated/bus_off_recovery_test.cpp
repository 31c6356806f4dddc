// 128 sequences of 11 recessive bits (ISO 11898-1, fault confinement): at 125 kbit/s a bit takes
// 8 us, so that they take 11,264 us.
#include "canvoy/can/simulated/bus_off_recovery.hpp"

#include <gtest/gtest.h>

#include "canvoy/can/simulated/wire_time.hpp"

namespace canvoy::bus_off_recovery_test {
namespace {

constexpr std::int64_t bit_ns = 8'000;
constexpr std::int64_t sequence_ns = 11 * bit_ns;
constexpr std::int64_t all_ns = 11'264'000;
constexpr ControllerId node = 5;

class BusOffRecoveryTest : public testing::Test {
 protected:
  BusOffRecoveryTest() {
    members_.insert(node);
    bit_times_.set(node, 0);
  }
  std::int64_t next_ns(std::int64_t recessive_since_ns = 0) const {
    return sut_.next_ns(members_, recessive_since_ns, bit_times_);
  }
  ControllerSet take(std::int64_t now_ns) {
    return sut_.take_completed(members_, 0, now_ns, bit_times_);
  }

  BitTimes bit_times_{bit_ns};
  ControllerSet members_{};
  BusOffRecovery sut_;
};

TEST_F(BusOffRecoveryTest, TakesOneHundredAndTwentyEightTimesElevenBits) {
  EXPECT_EQ(next_ns(), never_ns);
  sut_.begin(node, 1'000);
  EXPECT_EQ(next_ns(), 1'000 + all_ns);
  EXPECT_TRUE(take(1'000 + all_ns - 1).empty());
  EXPECT_TRUE(sut_.is_under_way(node));
  EXPECT_EQ(take(1'000 + all_ns), members_);
  EXPECT_TRUE(sut_.is_empty());
}

TEST_F(BusOffRecoveryTest, BeginsWhenTheWireIsRecessive) {
  sut_.begin(node, 1'000);
  EXPECT_EQ(next_ns(50'000), 50'000 + all_ns);
}

TEST_F(BusOffRecoveryTest, LosesTheSequenceInWhichAFrameBegins) {
  sut_.begin(node, 0);
  sut_.interrupt(members_, 0, 2 * sequence_ns + 10 * bit_ns, bit_times_);
  EXPECT_EQ(next_ns(1'000'000), 1'000'000 + 126 * sequence_ns);
}

TEST_F(BusOffRecoveryTest, CountsBitsOfTheControllersOwnRate) {
  bit_times_.set(node, 250'000);
  sut_.begin(node, 0);
  EXPECT_EQ(next_ns(), all_ns / 2);
}

TEST_F(BusOffRecoveryTest, IsOfThisWireOnly) {
  sut_.begin(node, 0);
  ControllerSet others;
  others.insert(4);
  sut_.interrupt(others, 0, 3 * sequence_ns, bit_times_);
  EXPECT_EQ(sut_.next_ns(others, 0, bit_times_), never_ns);
  EXPECT_TRUE(sut_.take_completed(others, 0, never_ns, bit_times_).empty());
  EXPECT_EQ(next_ns(), all_ns);
}

TEST_F(BusOffRecoveryTest, IsForgottenWithThePower) {
  sut_.begin(node, 0);
  sut_.cancel(node);
  EXPECT_TRUE(sut_.is_empty());
  EXPECT_TRUE(take(never_ns).empty());
}

}  // namespace
}  // namespace canvoy::bus_off_recovery_test
