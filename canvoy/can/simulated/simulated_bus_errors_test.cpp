// Errors on the bus, with times and counters calculated by hand.
//
// 080# has 48 bits, 705#05 56, 705#04 55; at 125 kbit/s a bit takes 8 us. A destroyed frame ends
// with an error flag of 6 bits, 6 more of controllers that saw the error only in the flag, and 8 of
// delimiter; 3 of intermission follow. An error-passive transmitter waits 8 more. An error that all
// see in bit 20 thus takes 20 + 6 + 6 + 8 + 3 = 43 bits.
#include <gtest/gtest.h>

#include <vector>

#include "canvoy/can/simulated/simulated_bus.hpp"
#include "canvoy/can/simulated/simulated_bus_test.hpp"

namespace canvoy::simulated_bus_errors_test {
namespace {

using Frames = std::vector<TimedFrame>;
using States = std::vector<TimedState>;

const Frame sync = Frame::data_frame(0x080, {});
const Frame heartbeat = Frame::data_frame(0x705, {5});
const Frame stopped = Frame::data_frame(0x705, {4});

constexpr Duration bits(std::int64_t count) {
  return Duration(count * 8);
}

/// Errors that a tap received.
struct ErrorLog {
  explicit ErrorLog(SimulatedBus& bus) {
    bus.observe({.context = this, .on_error = [](void* context, Time now, const BusError& error) {
                   static_cast<ErrorLog*>(context)->times.push_back(now.time_since_epoch());
                   static_cast<ErrorLog*>(context)->errors.push_back(error);
                 }});
  }
  std::vector<Duration> times;
  std::vector<BusError> errors;
};

TEST(Acknowledgement, IsMissingForANodeAloneWhichRepeatsAndGoesErrorPassiveButNeverBusOff) {
  SimulatedBus bus;
  BusTestNode alone(bus);
  ErrorLog log(bus);
  alone.send(sync);
  // The slot is bit 40 of 48. The flag has no echo: 40 + 6 + 8 + 3 = 57 bits for each attempt, 8
  // counts each.
  bus.advance(Time(bits(40)));
  EXPECT_EQ(alone.tec(), 8);
  ASSERT_EQ(log.errors.size(), 1U);
  EXPECT_EQ(log.errors[0].kind, BusErrorKind::acknowledgement);
  EXPECT_EQ(log.errors[0].sender, alone.id);
  EXPECT_EQ(log.errors[0].bit, 40U);
  EXPECT_EQ(log.errors[0].frame, sync);
  bus.advance(Time(60s));
  EXPECT_EQ(log.times[1], bits(57 + 40));
  EXPECT_EQ(alone.states, (States{{bits(11 * 57 + 40), BusState::error_warning},
                                  {bits(15 * 57 + 40), BusState::error_passive}}));
  // Error-passive, it waits eight bits more.
  EXPECT_EQ(log.times[16], bits(16 * 57 + 8 + 40));
  EXPECT_EQ(log.times[17], bits(16 * 57 + 8 + 65 + 40));
  EXPECT_EQ(alone.tec(), 128);
  EXPECT_TRUE(alone.sent.empty());
}

TEST(Acknowledgement, ComesFromTheFirstNodeThatIsSwitchedOn) {
  SimulatedBus bus;
  BusTestNode alone(bus);
  BusTestNode second(bus);
  bus.power(second.id, false);
  alone.send(sync);
  bus.advance(Time(1s));
  bus.power(second.id, true);
  bus.advance(Time(2s));
  // Attempt n from the 17th on begins at bit 16 * 57 + 8 + (n - 17) * 65; the first after bit
  // 125'000 at 125'005.
  EXPECT_EQ(second.received, (Frames{{bits(125'005 + 47), sync}}));
  EXPECT_EQ(alone.tec(), 127);
  EXPECT_EQ(alone.states.back(), (TimedState{bits(125'005 + 48), BusState::error_warning}));
}

TEST(Acknowledgement, IsNotGivenByANodeThatOnlyListens) {
  SimulatedBus bus;
  BusTestNode sender(bus);
  BusTestNode listener(bus, {.listen_only = true});
  sender.send(sync);
  bus.advance(Time(1s));
  EXPECT_TRUE(sender.sent.empty());
  EXPECT_EQ(listener.rec(), 0);
}

TEST(Disturbance, IsSeenByAllAndTheFrameIsSentAgain) {
  SimulatedBus bus;
  BusTestNode sender(bus);
  BusTestNode receiver(bus);
  ErrorLog log(bus);
  bus.disturb(1, 20);
  sender.send(sync);
  bus.advance(Time(bits(20)));
  EXPECT_EQ(sender.tec(), 8);
  EXPECT_EQ(receiver.rec(), 1);
  ASSERT_EQ(log.errors.size(), 1U);
  EXPECT_EQ(log.errors[0].kind, BusErrorKind::bit);
  EXPECT_EQ(log.errors[0].bit, 20U);
  bus.advance(Time(1s));
  EXPECT_EQ(receiver.received, (Frames{{bits(43 + 47), sync}}));
  EXPECT_EQ(sender.tec(), 7);
  EXPECT_EQ(receiver.rec(), 0);
  EXPECT_EQ(bus.statistics(sender.id).transmit_errors, 1U);
  EXPECT_EQ(bus.statistics().error_frames, 1U);
  EXPECT_EQ(bus.statistics().frames, 1U);
}

TEST(Disturbance, InTheLastBitMakesReceiversGetTheFrameTwice) {
  SimulatedBus bus;
  BusTestNode sender(bus);
  BusTestNode receiver(bus);
  bus.disturb(1, 48);
  sender.send(sync);
  bus.advance(Time(bits(48)));
  EXPECT_EQ(sender.tec(), 8);
  EXPECT_EQ(receiver.rec(), 0);  // for receivers it was an overload, no error
  bus.advance(Time(1s));
  EXPECT_EQ(receiver.received, (Frames{{bits(47), sync}, {bits(48 + 23 + 47), sync}}));
  EXPECT_EQ(sender.sent, (Frames{{bits(48 + 23 + 48), sync}}));
  EXPECT_EQ(sender.tec(), 7);
  EXPECT_EQ(receiver.rec(), 0);
}

TEST(Disturbance, InTheBitBeforeThatMakesThemGetItOnce) {
  SimulatedBus bus;
  BusTestNode sender(bus);
  BusTestNode receiver(bus);
  bus.disturb(1, 47);
  sender.send(sync);
  bus.advance(Time(1s));
  EXPECT_EQ(receiver.received, (Frames{{bits(47 + 23 + 47), sync}}));
}

TEST(Disturbance, CountsInTheBusLoadWithItsErrorFrame) {
  SimulatedBus bus;
  BusTestNode sender(bus);
  BusTestNode receiver(bus);
  bus.disturb(1, 20);
  sender.send(sync);
  bus.advance(Time(bits(200)));
  EXPECT_DOUBLE_EQ(bus.load_total(), (43 + 48 + 3) / 200.0);
}

TEST(FaultConfinement, TakesATransmitterToErrorPassiveAfterSixteenErrorsAndToBusOffAfterThirtyTwo) {
  SimulatedBus bus;
  BusTestNode sender(bus);
  BusTestNode receiver(bus);
  bus.disturb(32, 20);
  sender.send(sync);
  bus.advance(Time(bits(31 * 43 + 15 * 8 + 8 + 20)));
  // The 17th attempt and all after it wait eight bits more.
  const Duration warning = bits(11 * 43 + 20);
  const Duration passive = bits(15 * 43 + 20);
  const Duration off = bits(31 * 43 + 16 * 8 + 20);
  EXPECT_EQ(sender.states, (States{{warning, BusState::error_warning},
                                   {passive, BusState::error_passive},
                                   {off, BusState::bus_off}}));
  EXPECT_EQ(sender.tec(), 256);
  EXPECT_EQ(receiver.rec(), 32);
  EXPECT_EQ(receiver.state(), BusState::error_active);
}

TEST(FaultConfinement, LetsOthersGoBeforeAnErrorPassiveTransmitter) {
  SimulatedBus bus;
  BusTestNode passive(bus);
  BusTestNode other(bus);
  bus.disturb(16, 20);
  passive.send(sync);
  bus.advance(Time(bits(15 * 43 + 20)));
  ASSERT_EQ(passive.state(), BusState::error_passive);
  other.send(heartbeat);
  bus.advance(Time(1s));
  // 080h would win, but may start only eight bits later.
  EXPECT_EQ(passive.received, (Frames{{bits(16 * 43 + 55), heartbeat}}));
  EXPECT_EQ(other.received, (Frames{{bits(16 * 43 + 59 + 47), sync}}));
}

TEST(FaultConfinement, BringsAnErrorPassiveTransmitterBackWithEachFrameThatGoesWell) {
  SimulatedBus bus;
  BusTestNode sender(bus);
  BusTestNode receiver(bus);
  bus.disturb(16, 20);
  sender.send(sync);
  bus.advance(Time(1s));
  EXPECT_EQ(sender.tec(), 127);
  EXPECT_EQ(sender.states.back(), (TimedState{bits(16 * 43 + 8 + 48), BusState::error_warning}));
}

TEST(FaultConfinement, LetsOthersGoBeforeAnErrorPassiveTransmitterAlsoAfterAFrameThatWentWell) {
  SimulatedBus bus;
  BusTestNode sender(bus);
  BusTestNode receiver(bus);
  bus.disturb(17, 20);
  sender.send(sync);
  sender.send(heartbeat);
  bus.advance(Time(1s));
  const std::int64_t begin = 17 * 43 + 2 * 8;  // of the eighteenth attempt
  EXPECT_EQ(receiver.received,
            (Frames{{bits(begin + 47), sync}, {bits(begin + 51 + 8 + 55), heartbeat}}));
  EXPECT_EQ(sender.tec(), 17 * 8 - 2);
}

TEST(BusOff, EndsByItselfAfterOneHundredAndTwentyEightTimesElevenRecessiveBits) {
  SimulatedBus bus;
  BusTestNode sender(bus);
  BusTestNode receiver(bus);
  bus.disturb(32, 20);
  sender.send(sync);
  bus.advance(Time(10s));
  const std::int64_t off = 31 * 43 + 16 * 8 + 20;
  const std::int64_t back = off + 12 + 128 * 11;  // after the error flags
  EXPECT_EQ(sender.states.back(), (TimedState{bits(back), BusState::error_active}));
  EXPECT_EQ(receiver.received, (Frames{{bits(back + 47), sync}}));
  EXPECT_EQ(sender.tec(), 0);
}

TEST(BusOff, LastsUntilRecoveryIsAskedForWhereItIsNotAutomatic) {
  SimulatedBus bus;
  BusTestNode sender(bus, {.recover_automatically = false});
  BusTestNode receiver(bus);
  bus.disturb(32, 20);
  sender.send(sync);
  bus.advance(Time(10s));
  EXPECT_EQ(sender.state(), BusState::bus_off);
  EXPECT_TRUE(sender.send(heartbeat));
  EXPECT_EQ(bus.next_event(), never);
  bus.recover(sender.id);
  EXPECT_EQ(bus.next_event(), Time(10s + bits(128 * 11)));
  bus.advance(Time(11s));
  EXPECT_EQ(sender.states.back(), (TimedState{10s + bits(128 * 11), BusState::error_active}));
  EXPECT_EQ(receiver.received, (Frames{{10s + bits(128 * 11 + 47), sync},
                                       {10s + bits(128 * 11 + 51 + 55), heartbeat}}));
}

TEST(BusOff, WhoseBitRateBecomesHigherIsNotOverInThePast) {
  SimulatedBus bus;
  BusTestNode sender(bus, {.recover_automatically = false});
  BusTestNode receiver(bus);
  bus.disturb(32, 20);
  sender.send(sync);
  bus.advance(Time(10s));
  bus.set_bit_rate(sender.id, SimulatedBusOptions{}.bit_rate / 2);
  bus.recover(sender.id);
  const Duration later = 10s + bits(128 * 11 + 100);
  bus.advance(Time(later));
  EXPECT_EQ(sender.state(), BusState::bus_off) << "its bits are twice as long";
  bus.set_bit_rate(sender.id, 0);
  receiver.send(heartbeat);
  EXPECT_EQ(bus.next_event(), Time(later));
  bus.advance(Time(11s));
  EXPECT_EQ(sender.states.back(), (TimedState{later, BusState::error_active}));
}

TEST(BusOff, NeitherReceivesNorAcknowledges) {
  SimulatedBus bus;
  BusTestNode off(bus, {.recover_automatically = false});
  BusTestNode other(bus);
  bus.disturb(32, 20);
  off.send(sync);
  bus.advance(Time(10s));
  other.send(heartbeat);
  bus.advance(Time(20s));
  EXPECT_TRUE(off.received.empty());
  EXPECT_TRUE(other.sent.empty());
  EXPECT_EQ(other.state(), BusState::error_passive);
}

TEST(BusOff, OnABusyBusEndsAfterOneHundredAndTwentyEightFrames) {
  SimulatedBus bus({.transmit_queue_max = 200});
  BusTestNode off(bus, {.recover_automatically = false});
  BusTestNode other(bus);
  BusTestNode listener(bus);
  bus.disturb(32, 20);
  off.send(heartbeat);
  bus.advance(Time(10s));
  bus.recover(off.id);
  for (int i = 0; i < 200; ++i) other.send(sync);
  bus.advance(Time(20s));
  // Each frame ends with eleven recessive bits: delimiter, end of frame, intermission.
  EXPECT_EQ(off.states.back(), (TimedState{10s + bits(128 * 51), BusState::error_active}));
}

TEST(SameIdentifier, WithOtherDataDestroysBothFramesInTheBitThatDiffers) {
  SimulatedBus bus;
  BusTestNode first(bus);
  BusTestNode second(bus);
  BusTestNode listener(bus);
  ErrorLog log(bus);
  first.send(heartbeat);
  second.send(stopped);
  bus.advance(Time(bits(30)));
  // 705#05 and 705#04 differ in bit 30 with stuff bits.
  ASSERT_EQ(log.times, (std::vector<Duration>{bits(30)}));
  EXPECT_EQ(log.errors[0].detector, first.id);
  EXPECT_EQ(first.tec(), 8);
  EXPECT_EQ(second.tec(), 8);
  EXPECT_EQ(listener.rec(), 1);
}

TEST(SameIdentifier, WithOtherDataTakesBothToErrorPassiveBeforeEachGetsThrough) {
  SimulatedBus bus;
  BusTestNode first(bus);
  BusTestNode second(bus);
  BusTestNode listener(bus);
  first.send(heartbeat);
  second.send(stopped);
  bus.advance(Time(10s));
  // Each attempt takes 30 + 6 + 6 + 8 + 3 = 53 bits, until both are error-passive after the 16th;
  // then the flag of the one that sends the recessive bit is not seen, and the other continues.
  const States both{{bits(11 * 53 + 30), BusState::error_warning},
                    {bits(15 * 53 + 30), BusState::error_passive}};
  EXPECT_EQ(States(first.states.begin(), first.states.begin() + 2), both);
  EXPECT_EQ(States(second.states.begin(), second.states.begin() + 2), both);
  const std::int64_t begin = 16 * 53 + 8;
  EXPECT_EQ(listener.received,
            (Frames{{bits(begin + 54), stopped}, {bits(begin + 55 + 3 + 8 + 55), heartbeat}}));
  EXPECT_EQ(second.tec(), 16 * 8 - 1);
  EXPECT_EQ(first.tec(), 17 * 8 - 1);
  EXPECT_EQ(listener.rec(), 16 - 2);
}

TEST(SameIdentifier, WithOtherLengthIsWonByTheShorterFrameWhateverTheData) {
  SimulatedBus bus;
  BusTestNode longer(bus);
  BusTestNode shorter(bus);
  BusTestNode listener(bus);
  longer.send(Frame::data_frame(0x705, {0, 0}));
  shorter.send(heartbeat);
  bus.advance(Time(10s));
  ASSERT_EQ(listener.received.size(), 2U);
  EXPECT_EQ(listener.received[0].frame, heartbeat);
}

TEST(SameIdentifier, LeavesTheOneThatHasDroppedOutNoReceiverOfTheOther) {
  SimulatedBus bus;
  BusTestNode first(bus);
  BusTestNode second(bus);
  BusTestNode listener(bus);
  first.send(heartbeat);
  second.send(stopped);
  bus.advance(Time(bits(16 * 53)));
  ASSERT_EQ(first.state(), BusState::error_passive);
  bus.disturb(1, 40);
  bus.advance(Time(bits(16 * 53 + 8 + 40)));
  EXPECT_EQ(first.tec(), 17 * 8);
  EXPECT_EQ(second.tec(), 17 * 8);
  EXPECT_EQ(first.rec(), 0);
  EXPECT_EQ(listener.rec(), 17);
}

TEST(Misreading, MakesAReceiverDestroyFramesUntilItIsErrorPassive) {
  SimulatedBus bus;
  BusTestNode sender(bus);
  BusTestNode faulty(bus, {.misread_probability = 1.0});
  BusTestNode receiver(bus);
  ErrorLog log(bus);
  sender.send(sync);
  bus.advance(Time(1s));
  // One for the error, eight for being the first to detect it: 9 * 15 = 135.
  EXPECT_EQ(log.errors.size(), 15U);
  EXPECT_EQ(log.errors[0].detector, faulty.id);
  EXPECT_EQ(log.errors[0].kind, BusErrorKind::stuff);
  EXPECT_EQ(faulty.state(), BusState::error_passive);
  EXPECT_EQ(faulty.rec(), 135 + 1);
  EXPECT_TRUE(faulty.received.empty());
  EXPECT_EQ(receiver.received.size(), 1U);
  EXPECT_EQ(receiver.rec(), 15 - 1);
  EXPECT_EQ(sender.tec(), 15 * 8 - 1);
}

TEST(ForeignBitRate, DestroysFramesUntilTheNodeIsErrorPassiveAndReceivesNothing) {
  SimulatedBus bus;
  BusTestNode sender(bus);
  BusTestNode receiver(bus);
  BusTestNode foreign(bus, {.bit_rate = 250'000});
  sender.send(sync);
  bus.advance(Time(1s));
  // Seen after six bits: 6 + 6 + 6 + 8 + 3 = 29 bits each, fifteen times.
  EXPECT_EQ(receiver.received, (Frames{{bits(15 * 29 + 47), sync}}));
  EXPECT_EQ(bus.statistics().error_frames, 15U);
  EXPECT_EQ(sender.tec(), 15 * 8 - 1);
  EXPECT_EQ(foreign.rec(), 15 * 9 + 1);
  EXPECT_EQ(foreign.state(), BusState::error_passive);
  EXPECT_TRUE(foreign.received.empty());
}

TEST(ForeignBitRate, OfASlowNodeLastsAsLongAsItsOwnBits) {
  SimulatedBus bus;
  BusTestNode sender(bus);
  BusTestNode receiver(bus);
  BusTestNode foreign(bus, {.bit_rate = 50'000});
  ErrorLog log(bus);
  sender.send(sync);
  bus.advance(Time(1s));
  // Six bits of 20 us, a flag of six more, an echo of six, eleven bits of 8 us.
  ASSERT_GE(log.times.size(), 2U);
  EXPECT_EQ(log.times[0], 120us);
  EXPECT_EQ(log.times[1], 120us + 120us + 48us + 88us + 120us);
}

TEST(ForeignBitRate, OfAVerySlowNodeDestroysTheAcknowledgementAtTheLatest) {
  SimulatedBus bus;
  BusTestNode sender(bus);
  BusTestNode receiver(bus);
  BusTestNode foreign(bus, {.bit_rate = 10'000});
  ErrorLog log(bus);
  sender.send(sync);
  bus.advance(Time(1s));
  EXPECT_EQ(log.times[0], bits(40));
  EXPECT_EQ(log.errors[0].detector, foreign.id);
}

TEST(ForeignBitRate, OfANodeThatOnlyListensHarmsNobody) {
  SimulatedBus bus;
  BusTestNode sender(bus);
  BusTestNode receiver(bus);
  BusTestNode foreign(bus, {.bit_rate = 250'000, .listen_only = true});
  sender.send(sync);
  bus.advance(Time(1s));
  EXPECT_EQ(receiver.received, (Frames{{bits(47), sync}}));
  EXPECT_TRUE(foreign.received.empty());
  EXPECT_EQ(bus.statistics().error_frames, 0U);
}

TEST(ForeignBitRate, DoesNotAcknowledge) {
  SimulatedBus bus;
  BusTestNode sender(bus);
  BusTestNode foreign(bus, {.bit_rate = 250'000});
  sender.send(sync);
  bus.advance(Time(1s));
  EXPECT_TRUE(sender.sent.empty());
  EXPECT_EQ(sender.state(), BusState::error_passive);
}

TEST(ForeignBitRate, IsNoneWhenAllNodesHaveChangedToIt) {
  SimulatedBus bus;
  BusTestNode sender(bus);
  BusTestNode receiver(bus);
  bus.set_bit_rate(sender.id, 500'000);
  bus.set_bit_rate(receiver.id, 500'000);
  sender.send(sync);
  bus.advance(Time(1s));
  EXPECT_EQ(receiver.received, (Frames{{94us, sync}}));  // 47 bits of 2 us
  EXPECT_EQ(bus.statistics().error_frames, 0U);
}

TEST(FrameErrorProbability, DestroysItsShareOfTheFramesInAnyBitAndLosesNone) {
  SimulatedBus bus({.faults = {.frame_error_probability = 0.1}, .seed = 3});
  BusTestNode sender(bus);
  BusTestNode receiver(bus);
  ErrorLog log(bus);
  constexpr std::size_t count = 10'000;
  std::size_t queued = 0;
  while (sender.sent.size() < count) {
    while (queued < count && sender.send(sync)) ++queued;
    bus.advance(bus.next_event());
  }
  const double attempts = static_cast<double>(count + log.errors.size());
  EXPECT_NEAR(static_cast<double>(log.errors.size()) / attempts, 0.1, 4 * 0.003);
  std::vector<int> hits(49);
  for (const BusError& error : log.errors) ++hits.at(error.bit);
  EXPECT_EQ(hits[0], 0);
  for (std::size_t bit = 1; bit <= 48; ++bit) EXPECT_GT(hits[bit], 0) << bit;
  // A frame disturbed in its last bit is received twice.
  EXPECT_EQ(receiver.received.size(), count + static_cast<std::size_t>(hits[48]));
}

TEST(FrameErrorProbability, BeginsAndEndsWhenItIsSet) {
  SimulatedBus bus;
  BusTestNode sender(bus);
  BusTestNode receiver(bus);
  bus.set_frame_error_probability(1.0);
  sender.send(sync);
  bus.advance(Time(5ms));
  EXPECT_TRUE(sender.sent.empty());
  EXPECT_GE(bus.statistics().error_frames, 8U);  // at most 48 + 23 bits each, in 625 bits
  bus.set_frame_error_probability(0.0);
  bus.advance(Time(10ms));
  EXPECT_EQ(sender.sent.size(), 1U);
}

TEST(BitErrorRate, DestroysFramesByTheirLength) {
  SimulatedBus bus({.faults = {.bit_error_rate = 0.001}, .seed = 5});
  BusTestNode sender(bus);
  BusTestNode receiver(bus);
  constexpr std::size_t count = 20'000;
  std::size_t queued = 0;
  while (sender.sent.size() < count) {
    while (queued < count && sender.send(sync)) ++queued;
    bus.advance(bus.next_event());
  }
  const double errors = static_cast<double>(bus.statistics().error_frames);
  // 1 - 0.999^48 = 4.69 %, with a standard deviation of 0.15 %.
  EXPECT_NEAR(errors / (static_cast<double>(count) + errors), 0.0469, 4 * 0.0015);
}

TEST(Seed, DecidesEveryErrorAndAnotherSeedDecidesOthers) {
  const auto errors_with = [](std::uint64_t seed) {
    SimulatedBus bus(
        {.faults = {.frame_error_probability = 0.2, .bit_error_rate = 0.001}, .seed = seed});
    BusTestNode sender(bus);
    BusTestNode receiver(bus, {.misread_probability = 0.01});
    ErrorLog log(bus);
    for (int i = 0; i < 500; ++i) {
      while (!sender.send(sync)) bus.advance(bus.next_event());
    }
    bus.advance(bus.now() + 10s);
    return log.times;
  };
  EXPECT_EQ(errors_with(1), errors_with(1));
  EXPECT_NE(errors_with(1), errors_with(2));
  EXPECT_GT(errors_with(1).size(), 50U);
}

}  // namespace
}  // namespace canvoy::simulated_bus_errors_test
