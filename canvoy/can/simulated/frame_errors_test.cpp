// Errors of one frame, decided at its start. 080# has 48 bits, its acknowledgement slot is bit 40
// (ISO 11898-1: delimiter and end of frame follow, eight bits); a bit takes 8 us.
#include "canvoy/can/simulated/frame_errors.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace canvoy::frame_errors_test {
namespace {

constexpr std::int64_t bit_ns = 8000;
constexpr unsigned bits = 48;
constexpr unsigned no_bit = 49;

ControllerSet set_of(const std::vector<ControllerId>& ids) {
  ControllerSet set;
  for (const ControllerId id : ids) set.insert(id);
  return set;
}

/// Two or more controllers, of which number 0 sends 080#.
struct FrameErrorsTest : testing::Test {
  FrameErrorsTest() {
    add(0);
    add(1);
  }
  void add(ControllerId id, std::uint32_t bit_rate = 0, bool is_listen_only = false) {
    controllers.emplace_back(id, ControllerOptions{.listen_only = is_listen_only},
                             std::span<PendingFrame>(), std::span<Frame>());
    who.update(controllers.back());
    bit_times.set(id, bit_rate);
    members.insert(id);
  }
  /// 16 receive errors of 8 and 1 make it error-passive (ISO 11898-1).
  void make_passive(ControllerId id) {
    for (SimulatedController& each : controllers) {
      for (int i = 0; each.id() == id && i < 16; ++i) each.count_receive_error(true);
      who.update(each);
    }
  }
  void begin(SimulatedWire& on) {
    on.connect(members);
    on.begin({.frame = Frame::data_frame(0x080, {}), .bits = bits}, bit_ns, 0, set_of({0}),
             who.hearing());
  }
  /// Plans a frame from its start on; returns the controllers without a part in it.
  ControllerSet plan(FrameErrors& errors) {
    begin(wire);
    return errors.plan(wire, who, bit_times);
  }
  /// Number of the bit, counted from 1, at the end of which it fails.
  static unsigned failed_bit(const SimulatedWire& on) {
    unsigned bit = 0;
    while (bit <= bits && !on.has_failed(on.bit_end_ns(bit))) ++bit;
    return bit;
  }
  unsigned failed_bit() const { return failed_bit(wire); }
  std::vector<SimulatedController> controllers;
  Participants who;
  BitTimes bit_times{bit_ns};
  ControllerSet members;
  SimulatedWire wire{bit_ns, bit_ns, 0};
};

TEST_F(FrameErrorsTest, OfADisturbanceBeyondTheFrameHitItsLastBitAndOfBit0ItsFirst) {
  FrameErrors sut(1, {});
  sut.disturb(1, 1000);
  plan(sut);
  EXPECT_EQ(failed_bit(), bits);
  sut.disturb(1, 0);
  plan(sut);
  EXPECT_EQ(failed_bit(), 1U);
}

TEST_F(FrameErrorsTest, OfOneDisturbanceHitOneOfTwoPiecesOfTheCable) {
  SimulatedWire other(bit_ns, bit_ns, 0);
  begin(wire);
  begin(other);
  FrameErrors sut(1, {});
  sut.disturb(1, 20);
  sut.plan(wire, who, bit_times);
  sut.plan(other, who, bit_times);
  EXPECT_EQ(failed_bit(wire), 20U);
  EXPECT_EQ(failed_bit(other), no_bit);
}

// Six equal bits, of the slower of sender and reader, are a stuff error.
TEST_F(FrameErrorsTest, OfTwoForeignBitRatesAreTheEarlierAndADisturbanceBeforeItGoesFirst) {
  add(2, 50'000);
  add(3, 250'000);
  add(4, 500'000);
  FrameErrors sut(1, {});
  plan(sut);
  EXPECT_EQ(failed_bit(), 6U);
  EXPECT_EQ(wire.failure_kind(), BusErrorKind::stuff);
  EXPECT_EQ(wire.detectors(), set_of({3, 4})) << "that of 50 kbit/s sees it in bit 15";
  EXPECT_EQ(wire.receivers(), set_of({1}));
  sut.disturb(1, 5);
  plan(sut);
  EXPECT_EQ(failed_bit(), 5U);
  EXPECT_EQ(wire.failure_kind(), BusErrorKind::bit);
  EXPECT_TRUE(wire.detectors().empty()) << "all see it";
}

// A controller that is error-passive or only listens cannot destroy a frame (ISO 11898-1, error
// flags).
TEST_F(FrameErrorsTest, OfWhoMisreadsAreThoseOfAllWhereItsFlagIsSeenAndElseItsOwn) {
  add(70);
  add(80);
  add(90, 0, true);
  make_passive(80);
  FrameErrors sut(1, {});
  sut.set_misreading(80, Probability(1.0));
  sut.set_misreading(90, Probability(1.0));
  EXPECT_EQ(plan(sut), set_of({80})) << "the counters of who listens stand still";
  EXPECT_EQ(failed_bit(), no_bit);
  EXPECT_EQ(wire.receivers(), set_of({1, 70}));
  sut.set_misreading(70, Probability(1.0));
  plan(sut);
  EXPECT_LT(failed_bit(), no_bit);
  EXPECT_EQ(wire.detectors(), set_of({70}));
  for (const ControllerId id : {ControllerId{70}, ControllerId{80}, ControllerId{90}}) {
    sut.set_misreading(id, Probability(0.0));
  }
  EXPECT_EQ(plan(sut), ControllerSet{}) << "they read again";
  EXPECT_EQ(failed_bit(), no_bit);
  EXPECT_EQ(wire.receivers(), set_of({1, 70, 80, 90}));
}

TEST_F(FrameErrorsTest, OfTheOnlyReceiverThatMisreadsLeaveNobodyToAcknowledge) {
  make_passive(1);
  FrameErrors sut(1, {});
  sut.set_misreading(1, Probability(1.0));
  EXPECT_EQ(plan(sut), set_of({1}));
  EXPECT_EQ(failed_bit(), 40U);
  EXPECT_EQ(wire.failure_kind(), BusErrorKind::acknowledgement);
}

TEST_F(FrameErrorsTest, OfEachBitAreInTheFirstOneOfEachFrame) {
  FrameErrors sut(1, {.bit_error_rate = 1.0});
  for (int i = 0; i < 100; ++i) {
    plan(sut);
    EXPECT_EQ(failed_bit(), 1U);
  }
}

}  // namespace
}  // namespace canvoy::frame_errors_test
