// Changes of the cable and of single nodes, with times counted by hand.
//
// 080# has 48 bits, 705#05 56, 000#01.00 65; at 125 kbit/s a bit takes 8 us.
#include <gtest/gtest.h>

#include <vector>

#include "canvoy/can/simulated/simulated_bus.hpp"
#include "canvoy/can/simulated/simulated_bus_test.hpp"

namespace canvoy::simulated_cable_test {
namespace {

using Frames = std::vector<TimedFrame>;
using States = std::vector<TimedState>;

const Frame sync = Frame::data_frame(0x080, {});
const Frame heartbeat = Frame::data_frame(0x705, {5});
const Frame start_all = Frame::data_frame(0x000, {1, 0});

constexpr Duration bits(std::int64_t count) {
  return Duration(count * 8);
}

/// Four nodes along a cable.
class CableTest : public testing::Test {
 protected:
  SimulatedBus bus_{{.transmit_queue_max = 100}};
  BusTestNode a_{bus_};
  BusTestNode b_{bus_};
  BusTestNode c_{bus_};
  BusTestNode d_{bus_};
};

TEST_F(CableTest, CutInTwoCarriesTwoFramesAtOnceAndNoneAcross) {
  bus_.cut_cable(b_.id);
  a_.send(heartbeat);
  c_.send(sync);
  bus_.advance(Time(1s));
  EXPECT_EQ(b_.received, (Frames{{bits(55), heartbeat}}));
  EXPECT_EQ(d_.received, (Frames{{bits(47), sync}}));
  EXPECT_TRUE(a_.received.empty());
  EXPECT_TRUE(c_.received.empty());
}

TEST_F(CableTest, CutInFourLeavesEachNodeAlone) {
  for (const BusTestNode* node : {&a_, &b_, &c_}) bus_.cut_cable(node->id);
  for (BusTestNode* node : {&a_, &b_, &c_, &d_}) node->send(sync);
  bus_.advance(Time(1s));
  for (const BusTestNode* node : {&a_, &b_, &c_, &d_}) {
    EXPECT_TRUE(node->sent.empty());
    EXPECT_EQ(node->state(), BusState::error_passive);
  }
}

TEST_F(CableTest, CutDuringAFrameLeavesItWholeOnTheSideOfTheSender) {
  a_.send(heartbeat);
  bus_.advance(Time(bits(20)));
  bus_.cut_cable(b_.id);
  EXPECT_EQ(c_.rec(), 1);
  EXPECT_EQ(d_.rec(), 1);
  // The other side sees six recessive bits, a flag, a delimiter and an intermission: 23 bits.
  c_.send(sync);
  bus_.advance(Time(1s));
  EXPECT_EQ(b_.received, (Frames{{bits(55), heartbeat}}));
  EXPECT_EQ(a_.sent, (Frames{{bits(56), heartbeat}}));
  EXPECT_EQ(d_.received, (Frames{{bits(20 + 23 + 47), sync}}));
}

TEST_F(CableTest, CutDuringAFrameLeavesTheSenderOnTheFarSideWithIt) {
  d_.send(heartbeat);
  bus_.advance(Time(bits(20)));
  bus_.cut_cable(b_.id);
  bus_.advance(Time(1s));
  EXPECT_EQ(c_.received, (Frames{{bits(55), heartbeat}}));
  EXPECT_TRUE(a_.received.empty());
  EXPECT_EQ(a_.rec(), 1);
}

TEST_F(CableTest, CutDuringAFrameTakesTheAcknowledgementFromASenderThatIsAloneThen) {
  a_.send(heartbeat);
  bus_.advance(Time(bits(20)));
  bus_.cut_cable(a_.id);
  // The slot is bit 48 of 56.
  bus_.advance(Time(bits(48)) - 1us);
  EXPECT_EQ(a_.tec(), 0);
  bus_.advance(Time(bits(48)));
  EXPECT_EQ(a_.tec(), 8);
  EXPECT_TRUE(b_.received.empty());
}

TEST_F(CableTest, MendedCarriesFramesToAllAgain) {
  bus_.cut_cable(b_.id);
  bus_.advance(Time(1ms));
  bus_.mend_cable();
  a_.send(heartbeat);
  bus_.advance(Time(1s));
  EXPECT_EQ(d_.received, (Frames{{1ms + bits(55), heartbeat}}));
}

TEST_F(CableTest, MendedDuringAFrameLetsTheOthersComeInWithTheNext) {
  bus_.cut_cable(b_.id);
  a_.send(heartbeat);
  bus_.advance(Time(bits(10)));
  d_.send(start_all);
  bus_.mend_cable();
  bus_.advance(Time(1s));
  EXPECT_EQ(b_.received[0], (TimedFrame{bits(55), heartbeat}));
  EXPECT_EQ(c_.received[0].frame, start_all);
  EXPECT_EQ(a_.received, c_.received);
}

TEST_F(CableTest, MendedWhileBothSidesSendDestroysBothFramesWhichAreThenSentAgain) {
  bus_.cut_cable(b_.id);
  a_.send(heartbeat);
  d_.send(sync);
  bus_.advance(Time(bits(10)));
  bus_.mend_cable();
  EXPECT_EQ(a_.tec(), 8);
  EXPECT_EQ(d_.tec(), 8);
  bus_.advance(Time(1s));
  // Flags, delimiter and intermission: 23 bits. Then 080h wins.
  EXPECT_EQ(b_.received, (Frames{{bits(33 + 47), sync}, {bits(33 + 51 + 55), heartbeat}}));
  EXPECT_EQ(bus_.statistics().error_frames, 2U);
}

TEST_F(CableTest, TakesANodeOffAndBackOn) {
  bus_.unplug(b_.id);
  a_.send(heartbeat);
  b_.send(sync);
  bus_.advance(Time(1s));
  EXPECT_EQ(d_.received, (Frames{{bits(55), heartbeat}}));
  EXPECT_TRUE(b_.received.empty());
  EXPECT_EQ(b_.state(), BusState::error_passive);
  bus_.plug(b_.id);
  bus_.advance(Time(2s));
  ASSERT_EQ(d_.received.size(), 2U);
  EXPECT_EQ(d_.received[1].frame, sync);
  EXPECT_EQ(b_.sent.size(), 1U);
}

TEST_F(CableTest, MovesAControllerOnTheWayBackFromBusOffWithoutLosingIt) {
  bus_.disturb(32, 20);
  b_.send(sync);
  bus_.advance(Time(20ms));
  ASSERT_EQ(b_.state(), BusState::bus_off);
  bus_.cut_cable(a_.id);
  bus_.advance(Time(1s));
  EXPECT_EQ(b_.state(), BusState::error_active);
  EXPECT_EQ(c_.received.size(), 1U);
}

TEST_F(CableTest, IsCutAndMendedAtTheTimesOfTheFaults) {
  SimulatedBus bus(
      {.faults = {.cable_cut = {.after = 0, .from = Time(10ms), .until = Time(20ms)}}});
  BusTestNode near(bus);
  BusTestNode far(bus);
  EXPECT_EQ(bus.next_event(), Time(10ms));
  for (const Duration at : {5ms, 15ms, 25ms}) {
    bus.advance(Time(at));
    far.send(sync);
  }
  bus.advance(Time(1s));
  ASSERT_EQ(near.received.size(), 3U);
  EXPECT_EQ(near.received[0].at, 5ms + bits(47));
  // The frame sent in between is repeated until the cable is whole.
  EXPECT_GT(near.received[1].at, 20ms);
  EXPECT_LT(near.received[1].at, 21ms);
}

TEST(Power, CutOffDuringAFrameDestroysIt) {
  SimulatedBus bus;
  BusTestNode sender(bus);
  BusTestNode receiver(bus);
  BusTestNode third(bus);
  sender.send(heartbeat);
  bus.advance(Time(bits(20)));
  bus.power(sender.id, false);
  third.send(sync);
  bus.advance(Time(1s));
  // Six bits until the others see it, their flag, delimiter, intermission.
  EXPECT_EQ(receiver.received, (Frames{{bits(20 + 6 + 6 + 8 + 3 + 47), sync}}));
  EXPECT_TRUE(sender.received.empty());
}

TEST(Power, ComesBackWithCountersAndQueuesEmpty) {
  SimulatedBus bus;
  BusTestNode node(bus);
  node.send(sync);
  node.send(sync);
  bus.advance(Time(1s));
  ASSERT_EQ(node.tec(), 128);
  bus.power(node.id, false);
  bus.power(node.id, true);
  EXPECT_EQ(node.tec(), 0);
  EXPECT_EQ(node.state(), BusState::error_active);
  bus.advance(Time(2s));
  EXPECT_EQ(node.tec(), 0);
}

TEST(Power, EndsBusOffAtOnceAndForGood) {
  SimulatedBus bus;
  BusTestNode node(bus);
  BusTestNode receiver(bus);
  bus.disturb(32, 20);
  node.send(sync);
  bus.advance(Time(bits(31 * 43 + 16 * 8 + 20)));
  ASSERT_EQ(node.state(), BusState::bus_off);
  bus.power(node.id, false);
  bus.power(node.id, true);
  EXPECT_EQ(node.state(), BusState::error_active);
  bus.disturb(2, 20);
  node.send(sync);
  bus.advance(Time(1s));
  // No recovery is under way that would clear the counters.
  EXPECT_EQ(node.tec(), 2 * 8 - 1);
}

TEST(BabblingNode, WithTheMostUrgentIdentifierStarvesAllOthers) {
  SimulatedBus bus;
  BusTestNode babbler(bus);
  BusTestNode node(bus);
  BusTestNode receiver(bus, {.accept_all = false});
  bus.accept(receiver.id, 0x080, true);
  bus.babble(babbler.id, Frame::data_frame(0x000, {0x82, 0}));
  node.send(sync);
  bus.advance(Time(1s));
  EXPECT_TRUE(node.sent.empty());
  EXPECT_NEAR(bus.load_total(), 1.0, 0.001);
  bus.stop_babbling(babbler.id);
  bus.advance(Time(2s));
  EXPECT_EQ(node.sent.size(), 1U);
  EXPECT_EQ(receiver.received.size(), 1U);
}

TEST(BabblingNode, WithTheLeastUrgentIdentifierFillsTheBusButDelaysNobodyForMoreThanAFrame) {
  SimulatedBus bus;
  BusTestNode babbler(bus);
  BusTestNode node(bus);
  bus.babble(babbler.id, Frame::data_frame(0x7FF, {}));
  bus.advance(Time(100ms));
  node.send(sync);
  bus.advance(Time(200ms));
  ASSERT_EQ(node.sent.size(), 1U);
  EXPECT_LE(node.sent[0].at, 100ms + bits(60 + 3 + 48));
  EXPECT_NEAR(bus.load_total(), 1.0, 0.01);
}

TEST(BabblingNode, StillSendsWhatItHasQueuedWhenItStops) {
  SimulatedBus bus(
      {.faults = {
           .babbling = {.controller = 0, .frame = sync, .from = Time(1ms), .until = Time(2ms)}}});
  BusTestNode babbler(bus);
  BusTestNode receiver(bus);
  bus.advance(Time(1500us));
  babbler.send(heartbeat);
  bus.advance(Time(1s));
  // From bit 125 to bit 250 each 51 bits: three frames; the third began before the end.
  EXPECT_EQ(receiver.received, (Frames{{bits(125 + 47), sync},
                                       {bits(125 + 51 + 47), sync},
                                       {bits(125 + 102 + 47), sync},
                                       {bits(125 + 153 + 55), heartbeat}}));
  EXPECT_EQ(babbler.sent.size(), 1U);
}

TEST(NodeClock, DriftsAsItsControllerWasAttached) {
  SimulatedBus bus;
  BusTestNode exact(bus);
  BusTestNode fast(bus, {.clock_drift_ppm = 100});
  EXPECT_EQ(bus.clock(exact.id).node_time(Time(10s)), Time(10s));
  EXPECT_EQ(bus.clock(fast.id).node_time(Time(10s)), Time(10s + 1ms));
}

}  // namespace
}  // namespace canvoy::simulated_cable_test
