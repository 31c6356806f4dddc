// Frames on an undisturbed bus, with times calculated by hand.
//
// Lengths from start to end of frame (frame_bits_test.cpp): 080# 48 bits, 705#05 56, 705#04 55,
// 000#01.00 65, 181#01.02.03.04.05.06.07.08 117, 555# 45. A receiver has a frame one bit before its
// end; three bits later the next one may start. At 125 kbit/s a bit takes 8 us.
#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "canvoy/can/simulated/simulated_bus.hpp"
#include "canvoy/can/simulated/simulated_bus_test.hpp"

namespace canvoy::simulated_bus_frame_test {
namespace {

using Frames = std::vector<TimedFrame>;

const Frame sync = Frame::data_frame(0x080, {});
const Frame heartbeat = Frame::data_frame(0x705, {5});
const Frame start_all = Frame::data_frame(0x000, {1, 0});
const Frame pdo = Frame::data_frame(0x181, {1, 2, 3, 4, 5, 6, 7, 8});

constexpr Duration bits(std::int64_t count) {
  return Duration(count * 8);
}

TEST(SimulatedBusFrame, IsReceivedOneBitBeforeItsEndAndSentAtItsEnd) {
  SimulatedBus bus;
  BusTestNode sender(bus);
  BusTestNode receiver(bus);
  sender.send(heartbeat);
  bus.advance(Time(bits(55)) - 1us);
  EXPECT_TRUE(receiver.received.empty());
  bus.advance(Time(bits(55)));
  EXPECT_EQ(receiver.received, (Frames{{bits(55), heartbeat}}));
  EXPECT_TRUE(sender.sent.empty());
  bus.advance(Time(bits(56)));
  EXPECT_EQ(sender.sent, (Frames{{bits(56), heartbeat}}));
}

TEST(SimulatedBusFrame, IsNotReceivedByItsSender) {
  SimulatedBus bus;
  BusTestNode sender(bus);
  BusTestNode receiver(bus);
  sender.send(heartbeat);
  bus.advance(Time(1s));
  EXPECT_TRUE(sender.received.empty());
  EXPECT_TRUE(receiver.sent.empty());
}

TEST(SimulatedBusFrame, StartsWhenItIsQueuedOnAnIdleBus) {
  SimulatedBus bus;
  BusTestNode sender(bus);
  BusTestNode receiver(bus);
  bus.advance(Time(1234us));
  sender.send(sync);
  EXPECT_EQ(bus.next_event(), Time(1234us));
  bus.advance(Time(1s));
  EXPECT_EQ(receiver.received, (Frames{{1234us + bits(47), sync}}));
}

TEST(SimulatedBusFrame, IsFollowedByTheNextAfterThreeBitsOfIntermission) {
  SimulatedBus bus;
  BusTestNode sender(bus);
  BusTestNode receiver(bus);
  sender.send(heartbeat);
  sender.send(sync);
  bus.advance(Time(1s));
  EXPECT_EQ(receiver.received, (Frames{{bits(55), heartbeat}, {bits(56 + 3 + 47), sync}}));
}

TEST(SimulatedBusFrame, TakesItsBitsAtEveryBitRateOfCiA301) {
  for (const std::int64_t kbit_s : {10, 20, 50, 125, 250, 500, 800, 1000}) {
    SimulatedBus bus({.bit_rate = static_cast<std::uint32_t>(kbit_s * 1000)});
    BusTestNode sender(bus);
    BusTestNode receiver(bus);
    sender.send(heartbeat);
    bus.advance(Time(1s));
    const Duration rounded_up((55 * 1000 + kbit_s - 1) / kbit_s);
    EXPECT_EQ(receiver.received, (Frames{{rounded_up, heartbeat}})) << kbit_s;
  }
}

TEST(SimulatedBusFrame, DoesNotDriftAtARateWhoseBitsAreNoWholeMicroseconds) {
  SimulatedBus bus({.bit_rate = 800'000});
  BusTestNode sender(bus);
  BusTestNode receiver(bus);
  constexpr std::int64_t frames = 10'000;
  for (std::int64_t i = 0; i < frames; ++i) {
    while (!sender.send(heartbeat)) bus.advance(bus.next_event());
  }
  bus.advance(Time(1s));
  ASSERT_EQ(receiver.received.size(), 10'000U);
  // 1.25 us a bit: 9999 frames with intermission, and the last one up to its last bit but one:
  // 589'996 bits, 737'495 us.
  EXPECT_EQ(receiver.received.back().at, 737'495us);
}

TEST(SimulatedBusFrame, WithTheLowerIdentifierWinsWhenBothStartTogether) {
  SimulatedBus bus;
  BusTestNode first(bus);
  BusTestNode second(bus);
  BusTestNode listener(bus);
  first.send(heartbeat);
  second.send(sync);
  bus.advance(Time(1s));
  EXPECT_EQ(listener.received, (Frames{{bits(47), sync}, {bits(48 + 3 + 55), heartbeat}}));
  EXPECT_EQ(first.received, (Frames{{bits(47), sync}}));
  EXPECT_EQ(bus.statistics().error_frames, 0U);
}

TEST(SimulatedBusFrame, IsNotInterruptedByAMoreUrgentOneThatComesLater) {
  SimulatedBus bus;
  BusTestNode first(bus);
  BusTestNode second(bus);
  BusTestNode listener(bus);
  first.send(heartbeat);
  bus.advance(Time(1us));
  second.send(start_all);
  bus.advance(Time(1s));
  EXPECT_EQ(listener.received, (Frames{{bits(55), heartbeat}, {bits(56 + 3 + 64), start_all}}));
}

TEST(SimulatedBusFrame, ThatIsADataFrameWinsOverTheRemoteFrameThatAsksForIt) {
  SimulatedBus bus;
  BusTestNode asker(bus);
  BusTestNode producer(bus);
  BusTestNode listener(bus);
  asker.send(Frame::remote_frame(0x181, 8));
  producer.send(pdo);
  bus.advance(Time(1s));
  ASSERT_EQ(listener.received.size(), 2U);
  EXPECT_EQ(listener.received[0], (TimedFrame{bits(116), pdo}));
  EXPECT_TRUE(listener.received[1].frame.is_remote());
}

TEST(SimulatedBusFrame, WithElevenBitsWinsOverTwentyNineThatBeginWithThem) {
  SimulatedBus bus;
  BusTestNode extended(bus);
  BusTestNode standard(bus);
  BusTestNode listener(bus);
  extended.send(Frame::data_frame(0x080U << 18 | 1, {}));
  standard.send(sync);
  bus.advance(Time(1s));
  ASSERT_EQ(listener.received.size(), 2U);
  EXPECT_EQ(listener.received[0], (TimedFrame{bits(47), sync}));
  EXPECT_TRUE(listener.received[1].frame.is_extended());
}

TEST(SimulatedBusFrame, ThatLosesArbitrationStaysInFrontOfAQueueInOrder) {
  SimulatedBus bus;
  BusTestNode in_order(bus, {.transmit_order = TransmitOrder::as_queued});
  BusTestNode other(bus);
  BusTestNode listener(bus);
  in_order.send(heartbeat);
  in_order.send(start_all);
  other.send(pdo);
  bus.advance(Time(1s));
  EXPECT_EQ(listener.received, (Frames{{bits(116), pdo},
                                       {bits(117 + 3 + 55), heartbeat},
                                       {bits(117 + 3 + 56 + 3 + 64), start_all}}));
}

TEST(SimulatedBusFrame, ThatIsUrgentOvertakesInAQueueByIdentifier) {
  SimulatedBus bus;
  BusTestNode by_identifier(bus, {.transmit_order = TransmitOrder::by_identifier});
  BusTestNode other(bus);
  BusTestNode listener(bus);
  by_identifier.send(heartbeat);
  by_identifier.send(start_all);
  other.send(pdo);
  bus.advance(Time(1s));
  EXPECT_EQ(listener.received, (Frames{{bits(64), start_all},
                                       {bits(65 + 3 + 116), pdo},
                                       {bits(65 + 3 + 117 + 3 + 55), heartbeat}}));
}

/// A frame that waits behind one that breaks off is first in a queue by identifier, and takes part
/// with its own identifier.
TEST(SimulatedBusFrame, ThatIsUrgentIsNextWhereTheOneOnTheWireBreaksOff) {
  SimulatedBus bus;
  BusTestNode by_identifier(bus, {.transmit_order = TransmitOrder::by_identifier});
  BusTestNode other(bus);
  BusTestNode listener(bus);
  by_identifier.send(heartbeat);
  bus.advance(Time(bits(20)));
  by_identifier.send(start_all);
  other.send(pdo);
  bus.set_bit_rate(by_identifier.id, SimulatedBusOptions{}.bit_rate);
  bus.advance(Time(1s));
  std::vector<Frame> order;
  for (const TimedFrame& each : listener.received) order.push_back(each.frame);
  EXPECT_EQ(order, (std::vector<Frame>{start_all, pdo, heartbeat}));
}

TEST(SimulatedBusFrame, SentByTwoAtOnceWithTheSameDataGoesThroughAsOne) {
  SimulatedBus bus;
  BusTestNode first(bus);
  BusTestNode second(bus);
  BusTestNode listener(bus);
  first.send(heartbeat);
  second.send(heartbeat);
  bus.advance(Time(1s));
  EXPECT_EQ(listener.received, (Frames{{bits(55), heartbeat}}));
  EXPECT_EQ(first.sent, (Frames{{bits(56), heartbeat}}));
  EXPECT_EQ(second.sent, (Frames{{bits(56), heartbeat}}));
  EXPECT_TRUE(first.received.empty());
  EXPECT_EQ(bus.statistics().frames, 1U);
  EXPECT_EQ(bus.statistics().error_frames, 0U);
}

TEST(SimulatedBusFrame, IsHandedOnlyToControllersWhoseFilterLetsItPass) {
  SimulatedBus bus;
  BusTestNode sender(bus);
  BusTestNode all(bus);
  BusTestNode some(bus, {.accept_all = false});
  bus.accept(some.id, 0x705, true);
  bus.accept(all.id, 0x080, false);
  sender.send(heartbeat);
  sender.send(sync);
  sender.send(Frame::data_frame(0x12345, {}));
  bus.advance(Time(1s));
  EXPECT_EQ(some.received, (Frames{{bits(55), heartbeat}}));
  ASSERT_EQ(all.received.size(), 2U);
  EXPECT_EQ(all.received[1].frame.id, 0x12345U);
  bus.accept_extended(all.id, false);
  sender.send(Frame::data_frame(0x12345, {}));
  bus.advance(Time(2s));
  EXPECT_EQ(all.received.size(), 2U);
}

TEST(SimulatedBusFrame, IsAcknowledgedByControllersThatFilterItOut) {
  SimulatedBus bus;
  BusTestNode sender(bus);
  BusTestNode deaf(bus, {.accept_all = false});
  sender.send(heartbeat);
  bus.advance(Time(1s));
  EXPECT_EQ(sender.sent.size(), 1U);
  EXPECT_TRUE(deaf.received.empty());
}

TEST(SimulatedBusFrame, ThatAnswersOneIsSentRightAfterTheIntermission) {
  SimulatedBus bus;
  struct Answering {
    SimulatedBus& bus;
    ControllerId id = no_controller;
  } answering{bus};
  BusTestNode asker(bus);
  answering.id = bus.attach(
      {.listener = {.context = &answering, .on_frame = [](void* context, Time, const Frame&) {
                      auto& self = *static_cast<Answering*>(context);
                      self.bus.send(self.id, heartbeat);
                    }}});
  asker.send(sync);
  bus.advance(Time(1s));
  EXPECT_EQ(asker.received, (Frames{{bits(48 + 3 + 55), heartbeat}}));
}

TEST(SimulatedBusFrame, IsRefusedWhereItCannotBeSent) {
  SimulatedBus bus;
  BusTestNode node(bus);
  BusTestNode listener(bus, {.listen_only = true});
  Frame error = sync;
  error.flags = FrameFlags::error;
  Frame too_long = sync;
  too_long.length = 9;
  Frame foreign_id = sync;
  foreign_id.id = 0x800;
  EXPECT_FALSE(node.send(error));
  EXPECT_FALSE(node.send(too_long));
  EXPECT_FALSE(node.send(foreign_id));
  EXPECT_FALSE(listener.send(sync));
  bus.power(node.id, false);
  EXPECT_FALSE(node.send(sync));
  EXPECT_EQ(bus.next_event(), never);
}

TEST(SimulatedBusFrame, IsRefusedWhileTheTransmitQueueIsFull) {
  SimulatedBus bus({.transmit_queue_max = 2});
  BusTestNode node(bus);
  BusTestNode listener(bus);
  EXPECT_TRUE(node.send(sync));
  EXPECT_TRUE(node.send(sync));
  EXPECT_FALSE(node.send(sync));
  bus.advance(Time(bits(48)) - 1us);
  EXPECT_FALSE(node.send(sync));
  bus.advance(Time(bits(48)));
  EXPECT_TRUE(node.send(heartbeat));
}

TEST(SimulatedBusFrame, WaitsInTheReceiveQueueAndIsLostWhenThatIsFull) {
  SimulatedBus bus({.receive_queue_max = 2});
  BusTestNode sender(bus);
  BusTestNode polled(bus, {.queue_received = true});
  for (std::uint8_t i = 1; i <= 4; ++i) sender.send(Frame::data_frame(0x705, {i}));
  bus.advance(Time(1s));
  EXPECT_TRUE(polled.received.empty());
  EXPECT_EQ(bus.statistics(polled.id).received, 2U);
  EXPECT_EQ(bus.statistics(polled.id).overruns, 2U);
  EXPECT_TRUE(bus.take_overrun(polled.id));
  EXPECT_FALSE(bus.take_overrun(polled.id));
  Frame frame;
  EXPECT_TRUE(bus.receive(polled.id, frame));
  EXPECT_EQ(frame.data[0], 1);
  EXPECT_TRUE(bus.receive(polled.id, frame));
  EXPECT_EQ(frame.data[0], 2);
  EXPECT_FALSE(bus.receive(polled.id, frame));
}

TEST(SimulatedBusFrame, DroppedBeforeItIsOnTheWireIsNotSent) {
  SimulatedBus bus;
  BusTestNode sender(bus);
  BusTestNode listener(bus);
  sender.send(sync);
  sender.send(heartbeat);
  bus.advance(Time(1us));
  bus.discard_pending(sender.id);
  bus.advance(Time(1s));
  EXPECT_EQ(listener.received, (Frames{{bits(47), sync}}));
}

TEST(SimulatedBusFrame, ThroughAPortIsSentAndFilteredAsThroughTheBus) {
  SimulatedBus bus;
  BusTestNode sender(bus);
  BusTestNode receiver(bus, {.accept_all = false});
  const Port port = bus.port(sender.id);
  const Port filter = bus.port(receiver.id);
  filter.accept(filter.context, 0x080, true);
  EXPECT_TRUE(port.send(port.context, heartbeat));
  EXPECT_TRUE(port.send(port.context, sync));
  bus.advance(Time(1s));
  EXPECT_EQ(receiver.received, (Frames{{bits(56 + 3 + 47), sync}}));
}

TEST(SimulatedBusTime, IsNeverWhileNothingIsUnderWay) {
  SimulatedBus bus;
  BusTestNode sender(bus);
  BusTestNode listener(bus);
  EXPECT_EQ(bus.next_event(), never);
  sender.send(sync);
  bus.advance(never);
  EXPECT_EQ(bus.next_event(), never);
  EXPECT_EQ(bus.now(), Time(bits(48)));
}

TEST(SimulatedBusTime, StopsAtEachThingThatANodeIsToldWhenStepped) {
  SimulatedBus bus;
  BusTestNode sender(bus);
  BusTestNode receiver(bus);
  sender.send(heartbeat);
  EXPECT_EQ(bus.step(Time(1s)), Time(bits(55)));
  EXPECT_EQ(bus.step(Time(1s)), Time(bits(56)));
  EXPECT_EQ(bus.step(Time(1s)), Time(1s));
}

TEST(SimulatedBusTime, ReturnsWhenItIsInterruptedAndGoesOnAfterwards) {
  SimulatedBus bus;
  BusTestNode sender(bus);
  BusTestNode receiver(bus);
  bus.observe({.context = &bus, .on_frame = [](void* context, Time, ControllerId, const Frame&) {
                 static_cast<SimulatedBus*>(context)->interrupt();
               }});
  sender.send(heartbeat);
  bus.advance(Time(1s));
  EXPECT_EQ(bus.now(), Time(bits(55)));
  bus.advance(Time(1s));
  EXPECT_EQ(bus.now(), Time(1s));
}

TEST(SimulatedBusLoad, CountsFramesWithStuffBitsAndIntermissions) {
  SimulatedBus bus;
  BusTestNode sender(bus);
  BusTestNode listener(bus);
  for (Duration at = 0us; at < 2s; at += 1ms) {
    bus.advance(Time(at));
    sender.send(sync);
  }
  bus.advance(Time(2s));
  // 48 + 3 bits of each 125.
  EXPECT_NEAR(bus.load_total(), 51.0 / 125, 1e-9);
  EXPECT_NEAR(bus.load(), 51.0 / 125, 1e-9);
  bus.advance(Time(2500ms));
  EXPECT_NEAR(bus.load(), 51.0 / 250, 0.001);
  EXPECT_NEAR(bus.load_total(), 2 * 51.0 / 125 / 2.5, 1e-9);
  EXPECT_EQ(bus.statistics().frames, 2000U);
  EXPECT_EQ(bus.statistics().frame_bits, 2000U * 48);
}

TEST(SimulatedBusTap, SeesEveryFrameWithItsSenderWhenReceiversHaveIt) {
  SimulatedBus bus;
  struct Seen {
    Frames frames;
    std::vector<int> senders;
  } seen;
  EXPECT_TRUE(bus.observe(
      {.context = &seen,
       .on_frame = [](void* context, Time now, ControllerId sender, const Frame& frame) {
         static_cast<Seen*>(context)->frames.push_back({now.time_since_epoch(), frame});
         static_cast<Seen*>(context)->senders.push_back(sender);
       }}));
  BusTestNode first(bus);
  BusTestNode second(bus);
  first.send(heartbeat);
  second.send(sync);
  bus.advance(Time(1s));
  EXPECT_EQ(seen.frames, (Frames{{bits(47), sync}, {bits(48 + 3 + 55), heartbeat}}));
  EXPECT_EQ(seen.senders, (std::vector<int>{second.id, first.id}));
}

TEST(SimulatedBusTap, IsToldOfStatesAndOverrunsAsTheNodesAre) {
  SimulatedBus bus({.receive_queue_max = 1});
  struct Told {
    std::vector<ControllerId> overrun;
    std::vector<Duration> overrun_at;
    std::vector<ControllerId> passive;
  } told;
  bus.observe(
      {.context = &told,
       .on_state =
           [](void* context, Time, ControllerId id, BusState state) {
             if (state != BusState::error_passive) return;
             static_cast<Told*>(context)->passive.push_back(id);
           },
       .on_overrun = [](void* context, Time,
                        ControllerId id) { static_cast<Told*>(context)->overrun.push_back(id); }});
  BusTestNode sender(bus);
  const ControllerId polled = bus.attach(
      {.listener = {.context = &told,
                    .on_overrun =
                        [](void* context, Time now) {
                          static_cast<Told*>(context)->overrun_at.push_back(now.time_since_epoch());
                        }},
       .queue_received = true});
  sender.send(sync);
  sender.send(sync);
  bus.advance(Time(1ms));
  EXPECT_EQ(told.overrun, std::vector<ControllerId>{polled});
  EXPECT_EQ(told.overrun_at, std::vector<Duration>{bits(51 + 47)});
  bus.power(polled, false);
  sender.send(sync);
  bus.advance(Time(1s));
  EXPECT_EQ(told.passive, std::vector<ControllerId>{sender.id});
}

/// Two nodes that send the same frame; when the first is notified, the second loses its power and
/// optionally returns with another frame.
class SimulatedBusSameFrame : public testing::Test {
 protected:
  struct First {
    SimulatedBus& bus;
    ControllerId other = no_controller;
    bool restarts = false;
  };
  static void on_sent(void* context, Time, const Frame&) {
    First& first = *static_cast<First*>(context);
    first.bus.power(first.other, false);
    if (!first.restarts) return;
    first.bus.power(first.other, true);
    EXPECT_TRUE(first.bus.send(first.other, boot_up));
  }
  void run(bool restarts) {
    first.restarts = restarts;
    const ControllerId first_id =
        bus.attach({.listener = {.context = &first, .on_sent = &SimulatedBusSameFrame::on_sent}});
    BusTestNode second(bus);
    BusTestNode witness(bus);
    first.other = second.id;
    EXPECT_TRUE(bus.send(first_id, heartbeat));
    second.send(heartbeat);
    bus.advance(Time(1s));
    for (const TimedFrame& frame : witness.received) heard.push_back(frame.frame);
    for (const TimedFrame& frame : second.sent) told.push_back(frame.frame);
    EXPECT_EQ(bus.statistics(second.id).sent, restarts ? 2U : 1U);
    bus.power(second.id, true);
    EXPECT_TRUE(second.send(boot_up)) << "there is room in its queue";
  }

  static constexpr Frame boot_up = Frame::data_frame(0x705, {0});
  SimulatedBus bus;
  First first{bus};
  std::vector<Frame> heard;
  std::vector<Frame> told;  // to the second
};

TEST_F(SimulatedBusSameFrame, WhatASenderQueuesThatTheOtherRestartsIsSent) {
  run(true);
  EXPECT_EQ(heard, (std::vector<Frame>{heartbeat, boot_up}));
  EXPECT_EQ(told, std::vector<Frame>{boot_up}) << "the first frame was of the life before";
}

TEST_F(SimulatedBusSameFrame, ASenderThatTheOtherSwitchesOffIsToldNothing) {
  run(false);
  EXPECT_EQ(heard, std::vector<Frame>{heartbeat});
  EXPECT_EQ(told, std::vector<Frame>{});
}

TEST(SimulatedBusControllers, AreAsManyAsTheBusWasMadeFor) {
  SimulatedBus bus({.controllers_max = 2});
  EXPECT_EQ(bus.attach({}), 0);
  EXPECT_EQ(bus.attach({}), 1);
  EXPECT_EQ(bus.attach({}), no_controller);
}

TEST(SimulatedBusControllers, MayBeAsManyAsOneHundredAndTwentyEight) {
  SimulatedBus bus({.controllers_max = 128});
  std::vector<std::unique_ptr<BusTestNode>> nodes;
  for (int i = 0; i < 128; ++i) nodes.push_back(std::make_unique<BusTestNode>(bus));
  for (const auto& node : nodes) node->send(Frame::data_frame(0x700U + node->id, {5}));
  bus.advance(Time(1s));
  for (const auto& node : nodes) {
    EXPECT_EQ(node->received.size(), 127U);
    EXPECT_EQ(node->sent.size(), 1U);
  }
}

}  // namespace
}  // namespace canvoy::simulated_bus_frame_test
