#include "canvoy/can/host/host_bus.hpp"

#include <gtest/gtest.h>

#include <deque>
#include <string>
#include <vector>

#include "canvoy/can/frame_text.hpp"
#include "canvoy/can/host/attachment.hpp"

namespace canvoy::host::host_bus_test {
namespace {

// A bus with the test at its other end.
class TestCarrier final : public Carrier {
 public:
  std::string_view name() const override { return "test0"; }
  SendResult send(const Frame& frame) override {
    if (answer == SendResult::sent) wire.push_back(frame);
    return answer;
  }

  void accept(const AcceptedIds* ids) override {
    filter = ids == nullptr ? "all" : "";
    for (std::size_t id = 0; ids != nullptr && id < ids->size(); ++id) {
      if ((*ids)[id])
        filter += FrameText(Frame::data_frame(static_cast<std::uint16_t>(id), {})).view();
    }
    ++filterings;
  }

  // Returns the oldest frame on the wire.
  void echo(Time time = {}) {
    ASSERT_FALSE(wire.empty());
    const Frame frame = wire.front();
    wire.pop_front();
    events_.frame(frame, time, Origin::own);
  }
  void hear(const Frame& frame, Time time = {}) { events_.frame(frame, time, Origin::elsewhere); }
  void tell(BusState state, Time time = {}) { events_.state(state, time); }
  void become_writable() {
    answer = SendResult::sent;
    events_.writable();
  }
  void complain(const Error& error) { events_.trouble(error); }

  SendResult answer = SendResult::sent;
  std::deque<Frame> wire;
  std::string filter = "all";  // 123#124#
  int filterings = 0;
};

struct Node {
  explicit Node(EventLoop& loop, HostBus& bus) : attachment(loop, bus), port(attachment.port()) {
    attachment.attach(*this);
  }

  void receive(const Frame& frame, Time time) {
    heard.emplace_back(FrameText(frame).view());
    times.push_back(time);
    if (on_receive) on_receive();
  }
  void bus_state(BusState state, Time) { states.push_back(state); }
  void tx_ready(Time) { ++ready; }
  Time deadline() const { return due; }
  void advance(Time now) {
    advanced.push_back(now);
    due = never;
  }
  bool send(const Frame& frame) const { return port.send(port.context, frame); }

  Attachment attachment;
  Port port;
  std::vector<std::string> heard;
  std::vector<Time> times;
  std::vector<BusState> states;
  std::vector<Time> advanced;
  std::function<void()> on_receive;
  Time due = never;
  int ready = 0;
};

using Heard = std::vector<std::string>;

class HostBusTest : public testing::Test {
 protected:
  std::unique_ptr<EventLoop> loop_ = *EventLoop::create();
  TestCarrier* carrier_ = new TestCarrier;  // the bus owns it
  HostBus bus_{*loop_, std::unique_ptr<Carrier>(carrier_)};
  const Frame frame_ = Frame::data_frame(0x185, {0x1E, 0x2F});
};

TEST_F(HostBusTest, AFrameFromElsewhereReachesAllNodes) {
  Node charger(*loop_, bus_);
  Node battery(*loop_, bus_);
  carrier_->hear(frame_);
  EXPECT_EQ(charger.heard, Heard{"185#1E2F"});
  EXPECT_EQ(battery.heard, Heard{"185#1E2F"});
  EXPECT_EQ(bus_.counters().received, 1U);
}

TEST_F(HostBusTest, ANodesFrameReachesItsSiblingsWhenItHasBeenOnTheBusButNeverItself) {
  Node charger(*loop_, bus_);
  Node battery(*loop_, bus_);
  EXPECT_TRUE(charger.send(frame_));
  EXPECT_EQ(carrier_->wire.size(), 1U);
  EXPECT_EQ(battery.heard, Heard{});
  carrier_->echo();
  EXPECT_EQ(battery.heard, Heard{"185#1E2F"});
  EXPECT_EQ(charger.heard, Heard{});
  EXPECT_EQ(bus_.counters().sent, 1U);
}

TEST_F(HostBusTest, EqualFramesOfTwoNodesReachTheOtherOneEach) {
  Node one(*loop_, bus_);
  Node two(*loop_, bus_);
  EXPECT_TRUE(one.send(frame_));
  EXPECT_TRUE(two.send(frame_));
  carrier_->echo();
  EXPECT_EQ(one.heard.size(), 0U);
  EXPECT_EQ(two.heard.size(), 1U);
  carrier_->echo();
  EXPECT_EQ(one.heard.size(), 1U);
  EXPECT_EQ(two.heard.size(), 1U);
}

TEST_F(HostBusTest, AFrameThatIsSentForNobodyReachesAllNodes) {
  Node charger(*loop_, bus_);
  EXPECT_TRUE(bus_.send(frame_));
  carrier_->echo();
  EXPECT_EQ(charger.heard, Heard{"185#1E2F"});
}

TEST_F(HostBusTest, AnObserverSeesOwnAndForeignFramesWithTheKernelsTimes) {
  std::vector<BusFrame> seen;
  bus_.on_frame([&](const BusFrame& heard) { seen.push_back(heard); });
  carrier_->hear(frame_, Time{5us});
  bus_.send(Frame::remote_frame(0x701, 1));
  carrier_->echo(Time{6us});
  ASSERT_EQ(seen.size(), 2U);
  EXPECT_EQ(seen[0].frame, frame_);
  EXPECT_EQ(seen[0].time, Time{5us});
  EXPECT_EQ(seen[0].origin, Origin::elsewhere);
  EXPECT_EQ(seen[1].frame, Frame::remote_frame(0x701, 1));
  EXPECT_EQ(seen[1].time, Time{6us});
  EXPECT_EQ(seen[1].origin, Origin::own);
}

TEST_F(HostBusTest, ErrorFramesAreForObserversOnly) {
  Node charger(*loop_, bus_);
  int seen = 0;
  bus_.on_frame([&](const BusFrame&) { ++seen; });
  Frame error;
  error.id = 0x40;
  error.flags = FrameFlags::error;
  carrier_->hear(error);
  EXPECT_EQ(charger.heard, Heard{});
  EXPECT_EQ(seen, 1);
}

TEST_F(HostBusTest, AnEchoOfWhichTheSenderIsNotKnownReachesNoNodeAndIsCounted) {
  Node charger(*loop_, bus_);
  EXPECT_TRUE(charger.send(frame_));
  carrier_->wire.front() = Frame::data_frame(0x186, {});
  carrier_->echo();
  EXPECT_EQ(charger.heard, Heard{});
  EXPECT_EQ(bus_.counters().unknown_echo, 1U);
}

TEST_F(HostBusTest, WithoutAFilterANodeHearsEverythingAfterItWhatItAcceptsAndWideIdentifiers) {
  Node charger(*loop_, bus_);
  charger.port.accept(charger.port.context, 0x185, true);
  charger.port.accept(charger.port.context, 0x000, true);
  charger.port.accept(charger.port.context, 0x185, false);
  carrier_->hear(frame_);
  carrier_->hear(Frame::data_frame(0x000, {1, 0}));
  carrier_->hear(Frame::data_frame(0x12345678, {}));
  EXPECT_EQ(charger.heard, (Heard{"000#0100", "12345678#"}));
}

TEST_F(HostBusTest, FramesWaitInOrderWhileTheCarrierIsBusy) {
  Node charger(*loop_, bus_);
  carrier_->answer = SendResult::busy;
  EXPECT_TRUE(charger.send(Frame::data_frame(1, {})));
  EXPECT_TRUE(charger.send(Frame::data_frame(2, {})));
  carrier_->answer = SendResult::sent;
  EXPECT_TRUE(charger.send(Frame::data_frame(3, {})));
  EXPECT_EQ(carrier_->wire.size(), 0U);
  carrier_->become_writable();
  ASSERT_EQ(carrier_->wire.size(), 3U);
  for (std::uint32_t i = 0; i < 3; ++i) EXPECT_EQ(carrier_->wire[i].id, i + 1);
}

TEST_F(HostBusTest, AFullQueueRefusesAndTellsThoseThatWereRefusedWhenThereIsRoom) {
  Node charger(*loop_, bus_);
  Node battery(*loop_, bus_);
  carrier_->answer = SendResult::busy;
  for (int i = 0; i < 256; ++i) ASSERT_TRUE(charger.send(frame_));
  EXPECT_FALSE(charger.send(frame_));
  EXPECT_EQ(bus_.counters().refused, 1U);
  carrier_->become_writable();
  EXPECT_EQ(carrier_->wire.size(), 256U);
  EXPECT_EQ(charger.ready, 1);
  EXPECT_EQ(battery.ready, 0);
  EXPECT_TRUE(charger.send(frame_));
}

TEST_F(HostBusTest, ACarrierThatRefusesMakesTheNodeKeepItsFrameUntilItIsTold) {
  Node charger(*loop_, bus_);
  carrier_->answer = SendResult::refused;
  EXPECT_FALSE(charger.send(frame_));
  carrier_->become_writable();
  EXPECT_EQ(charger.ready, 1);
}

TEST_F(HostBusTest, ABusStateIsToldOnceToNodesAndObservers) {
  Node charger(*loop_, bus_);
  std::vector<BusState> observed;
  bus_.on_state([&](BusState state, Time) { observed.push_back(state); });
  carrier_->tell(BusState::error_passive);
  carrier_->tell(BusState::error_passive);
  carrier_->tell(BusState::error_active);
  const std::vector<BusState> expected{BusState::error_passive, BusState::error_active};
  EXPECT_EQ(charger.states, expected);
  EXPECT_EQ(observed, expected);
  EXPECT_EQ(bus_.state(), BusState::error_active);
}

TEST_F(HostBusTest, BusOffDropsWhatIsUnderWayAndRefusesUntilItIsOver) {
  Node charger(*loop_, bus_);
  EXPECT_TRUE(charger.send(frame_));
  carrier_->answer = SendResult::busy;
  EXPECT_TRUE(charger.send(frame_));
  carrier_->tell(BusState::bus_off);
  EXPECT_EQ(bus_.counters().dropped, 2U);
  carrier_->answer = SendResult::sent;
  EXPECT_FALSE(charger.send(frame_));
  carrier_->tell(BusState::error_active);
  EXPECT_EQ(charger.ready, 1);
  EXPECT_TRUE(charger.send(frame_));
}

TEST_F(HostBusTest, TroubleIsHandedToTheObserver) {
  std::string line;
  bus_.on_trouble([&](const Error& error) { line = error.line(); });
  carrier_->complain({"test0", "the interface is down", "bring it up"});
  EXPECT_EQ(line, "test0: the interface is down; bring it up");
}

TEST_F(HostBusTest, ANodeMayLeaveWhileItReceives) {
  Node first(*loop_, bus_);
  auto second = std::make_unique<Node>(*loop_, bus_);
  Node third(*loop_, bus_);
  first.on_receive = [&] { second.reset(); };
  carrier_->hear(frame_);
  carrier_->hear(frame_);
  EXPECT_EQ(first.heard.size(), 2U);
  EXPECT_EQ(third.heard.size(), 2U);
}

TEST_F(HostBusTest, ANodeMayJoinWhileAnotherReceivesAndHearsTheNextFrame) {
  Node first(*loop_, bus_);
  std::unique_ptr<Node> second;
  first.on_receive = [&] {
    if (!second) second = std::make_unique<Node>(*loop_, bus_);
  };
  carrier_->hear(frame_);
  ASSERT_TRUE(second);
  EXPECT_EQ(second->heard.size(), 0U);
  carrier_->hear(frame_);
  EXPECT_EQ(second->heard.size(), 1U);
}

TEST_F(HostBusTest, AFrameOfANodeThatLeftReachesTheOthers) {
  Node charger(*loop_, bus_);
  {
    Node battery(*loop_, bus_);
    EXPECT_TRUE(battery.send(frame_));
  }
  carrier_->echo();
  EXPECT_EQ(charger.heard, Heard{"185#1E2F"});
}

TEST_F(HostBusTest, ANodeMayAnswerWithinReceive) {
  Node client(*loop_, bus_);
  Node server(*loop_, bus_);
  server.on_receive = [&] {
    if (server.heard.back() == "605#40") {
      EXPECT_TRUE(server.send(Frame::data_frame(0x585, {0x43})));
    }
  };
  EXPECT_TRUE(client.send(Frame::data_frame(0x605, {0x40})));
  carrier_->echo();
  EXPECT_EQ(client.heard, Heard{});
  carrier_->echo();
  EXPECT_EQ(client.heard, Heard{"585#43"});
}

TEST_F(HostBusTest, ANodesTimeNeverGoesBack) {
  Node charger(*loop_, bus_);
  charger.due = Time{};
  const Time before = loop_->now();
  loop_->run_until(before);
  ASSERT_EQ(charger.advanced.size(), 1U);
  carrier_->hear(frame_, Time{});
  EXPECT_GE(charger.times.back(), charger.advanced.back());
  const Time future = loop_->now() + 1h;
  carrier_->hear(frame_, future);
  EXPECT_LT(charger.times.back(), future);
  EXPECT_GE(charger.times[1], charger.times[0]);
}

TEST_F(HostBusTest, AnAttachedNodeIsAdvancedByTheLoopUntilItIsGone) {
  {
    Node charger(*loop_, bus_);
    const Time due = loop_->now() + 1ms;
    charger.due = due;
    loop_->run_until(due);
    ASSERT_EQ(charger.advanced.size(), 1U);
    EXPECT_GE(charger.advanced[0], due);
    charger.due = Time{};
  }
  loop_->run_until(loop_->now());
}

TEST_F(HostBusTest, SomethingThatOnlyListensCanBeAttachedToo) {
  struct Listener {
    void receive(const Frame& frame, Time) { heard = frame; }
    Frame heard;
  } listener;
  Attachment attachment(*loop_, bus_);
  attachment.attach(listener);
  carrier_->hear(frame_);
  EXPECT_EQ(listener.heard, frame_);
}

TEST_F(HostBusTest, ThreeHundredNodesShareTheBus) {
  std::deque<Node> nodes;
  for (int i = 0; i < 300; ++i) nodes.emplace_back(*loop_, bus_);
  EXPECT_TRUE(nodes[0].send(frame_));
  carrier_->echo();
  EXPECT_EQ(nodes[0].heard.size(), 0U);
  for (std::size_t i = 1; i < nodes.size(); ++i) ASSERT_EQ(nodes[i].heard.size(), 1U);
}

/// Sets the filter like a node.
void accept(const Node& node, std::uint16_t id, bool wanted = true) {
  node.port.accept(node.port.context, id, wanted);
}

TEST_F(HostBusTest, TheCarrierFiltersWhenEachNodeHasSaidWhatItWants) {
  Node charger(*loop_, bus_);
  Node battery(*loop_, bus_);
  accept(charger, 0x605);
  accept(charger, 0x000);
  loop_->run_until(loop_->now());
  EXPECT_EQ(carrier_->filter, "all") << "the battery hears everything";
  accept(battery, 0x60A);
  loop_->run_until(loop_->now());
  EXPECT_EQ(carrier_->filter, "000#605#60A#");
  EXPECT_EQ(carrier_->filterings, 1) << "what is said one after the other is set once";
}

TEST_F(HostBusTest, TheFilterLetsPassAtOnceWhatANodeWantsInAddition) {
  Node charger(*loop_, bus_);
  accept(charger, 0x605);
  loop_->run_until(loop_->now());
  accept(charger, 0x185);
  EXPECT_EQ(carrier_->filter, "185#605#");
  accept(charger, 0x605, false);
  loop_->run_until(loop_->now());
  EXPECT_EQ(carrier_->filter, "185#");
}

TEST_F(HostBusTest, TheFilterLetsOwnFramesComeBack) {
  Node charger(*loop_, bus_);
  accept(charger, 0x605);
  loop_->run_until(loop_->now());
  EXPECT_TRUE(charger.send(frame_));
  EXPECT_EQ(carrier_->filter, "185#605#");
  carrier_->echo();
  EXPECT_EQ(bus_.counters().sent, 1U);
}

TEST_F(HostBusTest, ThereIsNoFilterForAnObserverOrANodeThatWantsAll) {
  Node charger(*loop_, bus_);
  accept(charger, 0x605);
  loop_->run_until(loop_->now());
  EXPECT_EQ(carrier_->filter, "605#");
  {
    const Node curious(*loop_, bus_);
    EXPECT_EQ(carrier_->filter, "all");
  }
  loop_->run_until(loop_->now());
  EXPECT_EQ(carrier_->filter, "605#") << "it has left";
  bus_.on_frame([](const BusFrame&) {});
  EXPECT_EQ(carrier_->filter, "all");
}

TEST(OpenBus, TheSimulatedBusIsNoneOfTheHost) {
  const std::unique_ptr<EventLoop> loop = *EventLoop::create();
  const auto bus = open_bus(*loop, "sim");
  ASSERT_FALSE(bus);
  EXPECT_EQ(
      bus.error().line(),
      "sim: the simulated bus lives in one process only; give a bus that programs share: can0, "
      "vcan0, udp: or tcp:");
}

TEST(OpenBus, ABusThatDoesNotExistIsRefusedInOneLineThatSaysWhatToDo) {
  const std::unique_ptr<EventLoop> loop = *EventLoop::create();
  const auto bus = open_bus(*loop, "nocan7");
  ASSERT_FALSE(bus);
  EXPECT_EQ(bus.error().where, "nocan7");
  EXPECT_FALSE(bus.error().remedy.empty());
  EXPECT_EQ(bus.error().line().find('\n'), std::string::npos);
}

TEST(OpenBus, AnAddressThatMeansNothingIsRefused) {
  const std::unique_ptr<EventLoop> loop = *EventLoop::create();
  EXPECT_FALSE(open_bus(*loop, "tcp:host:1"));
}

}  // namespace
}  // namespace canvoy::host::host_bus_test
