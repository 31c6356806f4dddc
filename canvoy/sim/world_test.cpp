#include "canvoy/sim/world.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace canvoy::world_test {
namespace {

/// Notes what it receives and when, and sends a frame of its own each `period`.
struct Probe {
  Port port{};
  std::uint32_t id = 0x700;
  Duration period{0};
  Time next = never;
  std::vector<std::string>* diary = nullptr;
  std::string name = "probe";
  bool is_stuck = false;
  const Port* onward = nullptr;  ///< receives what this one receives

  struct Heard {
    Time at;
    std::uint32_t id;
  };
  std::vector<Heard> heard;
  std::vector<Time> sent;
  std::vector<Time> called;
  std::vector<BusState> states;
  int starts = 0;

  void start(Time now) {
    ++starts;
    next = period == Duration(0) ? never : now + period;
  }
  void receive(const Frame& frame, Time now) {
    heard.push_back({now, frame.id});
    if (onward != nullptr) onward->send(onward->context, frame);
  }
  void advance(Time now) {
    called.push_back(now);
    if (diary != nullptr) diary->push_back(name);
    if (is_stuck) return;
    next += period;
    port.send(port.context, Frame::data_frame(id, {}));
  }
  Time deadline() const { return next; }
  void bus_state(BusState state, Time) { states.push_back(state); }
  void tx_ready(Time now) { sent.push_back(now); }
  void overrun(Time) {}
};

/// Two probes on a bus of 125 kbit/s, where a bit takes 8 µs.
class WorldTest : public testing::Test {
 protected:
  void SetUp() override {
    bus = sut.add_bus({.bit_rate = 125'000});
    for (Probe* probe : {&first, &second}) place(*probe);
  }
  SlotIndex place(Probe& probe, const SlotOptions& options = {.accept_all = true}) {
    const SlotIndex slot = sut.add_slot(bus, options);
    probe.port = sut.port(slot);
    sut.occupy(slot, probe);
    return slot;
  }

  World sut;
  BusIndex bus = 0;
  Probe first;
  Probe second;
  static constexpr SlotIndex first_slot = 0;
  static constexpr SlotIndex second_slot = 1;
};

TEST_F(WorldTest, AnEmptyWorldRunsToTheEnd) {
  World empty;
  empty.run_until(Time(8h));
  EXPECT_EQ(empty.now(), Time(8h));
}

TEST_F(WorldTest, ANodeIsCalledAtItsDeadlinesUpToAndIncludingTheLast) {
  first.period = 100ms;
  sut.start(first_slot);
  sut.run_until(Time(300ms));
  EXPECT_EQ(first.called, (std::vector<Time>{Time(100ms), Time(200ms), Time(300ms)}));
  EXPECT_EQ(sut.now(), Time(300ms));
}

TEST_F(WorldTest, AFrameArrivesWhenItsBitsAreOverTheWire) {
  first.period = 100ms;
  sut.start(first_slot);
  sut.start(second_slot);
  sut.run_until(Time(150ms));
  // ISO 11898-1: an empty 11-bit frame has 44 bits; identifier 700h and length 0 need stuff bits.
  // Receivers take a frame before the last bit of its end, so below 60 bits and above 40 bits.
  ASSERT_EQ(second.heard.size(), 1U);
  EXPECT_EQ(second.heard[0].id, 0x700U);
  EXPECT_GT(second.heard[0].at, Time(100ms) + 40 * 8us);
  EXPECT_LT(second.heard[0].at, Time(100ms) + 60 * 8us);
  ASSERT_EQ(first.sent.size(), 1U);
  EXPECT_GE(first.sent[0], second.heard[0].at);
  EXPECT_TRUE(first.heard.empty());
}

TEST_F(WorldTest, ANodeWithoutPowerHearsAndSendsNothing) {
  first.period = 100ms;
  sut.start(first_slot);
  sut.run_until(Time(150ms));
  EXPECT_TRUE(second.heard.empty());
  sut.start(second_slot);
  sut.run_until(Time(250ms));
  EXPECT_FALSE(second.heard.empty());
  sut.stop(first_slot);
  const std::size_t heard = second.heard.size();
  sut.run_until(Time(1s));
  EXPECT_EQ(second.heard.size(), heard);
  EXPECT_EQ(first.called.back(), Time(200ms));
}

TEST_F(WorldTest, ANodeThatIsStartedAgainBootsAgain) {
  sut.start(first_slot);
  sut.run_until(Time(1s));
  sut.start(first_slot);
  EXPECT_EQ(first.starts, 2);
  EXPECT_TRUE(sut.is_running(first_slot));
}

TEST_F(WorldTest, ANodeAloneOnTheBusIsToldThatItIsErrorPassive) {
  first.period = 100ms;
  sut.start(first_slot);
  sut.run_until(Time(1s));
  EXPECT_EQ(first.states, (std::vector{BusState::error_active, BusState::error_warning,
                                       BusState::error_passive}));
}

TEST_F(WorldTest, ByDefaultANodeIsHandedOnlyWhatItAskedFor) {
  Probe picky;
  place(picky, {});
  picky.port.accept(picky.port.context, 0x123, true);
  for (SlotIndex slot : {0U, 1U, 2U}) sut.start(slot);
  first.port.send(first.port.context, Frame::data_frame(0x124, {}));
  first.port.send(first.port.context, Frame::data_frame(0x123, {}));
  sut.run_until(Time(10ms));
  ASSERT_EQ(picky.heard.size(), 1U);
  EXPECT_EQ(picky.heard[0].id, 0x123U);
  EXPECT_EQ(second.heard.size(), 2U);
}

TEST_F(WorldTest, WhatIsDueAtOneTimeHappensActionsFirstThenInTheOrderOfAddition) {
  std::vector<std::string> diary;
  first.diary = second.diary = &diary;
  first.name = "first";
  second.name = "second";
  first.period = second.period = 10ms;
  struct Plant {
    std::vector<std::string>& diary;
    void step(Time) { diary.push_back("plant"); }
  } plant{diary};
  sut.add_plant(callback<&Plant::step>(plant), 10ms);
  sut.start(second_slot);
  sut.start(first_slot);
  sut.at(Time(10ms), [&](Time) { diary.push_back("action 1"); });
  sut.at(Time(10ms), [&](Time) { diary.push_back("action 2"); });
  sut.run_until(Time(10ms));
  EXPECT_EQ(diary, (std::vector<std::string>{"action 1", "action 2", "first", "second", "plant"}));
}

TEST_F(WorldTest, APlantIsSteppedEachPeriod) {
  struct Plant {
    std::vector<Time> steps;
    void step(Time now) { steps.push_back(now); }
  } plant;
  sut.add_plant(callback<&Plant::step>(plant), 100ms);
  sut.run_until(Time(350ms));
  EXPECT_EQ(plant.steps, (std::vector<Time>{Time(100ms), Time(200ms), Time(300ms)}));
}

TEST_F(WorldTest, ASleepingPlantIsSteppedWhenItIsWokenAndOnlyThen) {
  struct Plant {
    World& world;
    PlantIndex index = 0;
    std::vector<Time> steps{};
    void step(Time now) {
      steps.push_back(now);
      if (steps.size() < 3) world.wake(index, now + 5ms);
    }
  } plant{sut};
  plant.index = sut.add_sleeping_plant(callback<&Plant::step>(plant));
  sut.run_until(Time(1s));
  EXPECT_TRUE(plant.steps.empty());
  sut.wake(plant.index, Time(2s));
  sut.wake_before(plant.index, Time(3s));
  sut.run_until(Time(4s));
  const std::vector<Time> three{Time(2s), Time(2005ms), Time(2010ms)};
  EXPECT_EQ(plant.steps, three);
  sut.wake(plant.index, Time(10s));
  sut.wake_before(plant.index, Time(5s));
  sut.run_until(Time(6s));
  EXPECT_EQ(plant.steps.back(), Time(5s));
  EXPECT_EQ(plant.steps.size(), 4U);
  sut.wake(plant.index, Time(1s));  // time in the past
  sut.run_until(Time(6s));
  EXPECT_EQ(plant.steps.back(), Time(6s));
}

TEST_F(WorldTest, AnActionMayPlanAnother) {
  std::vector<Time> done;
  sut.at(Time(1s), [&](Time now) {
    done.push_back(now);
    sut.at(now + 1s, [&](Time later) { done.push_back(later); });
  });
  sut.run_until(Time(3s));
  EXPECT_EQ(done, (std::vector<Time>{Time(1s), Time(2s)}));
}

TEST_F(WorldTest, AnActionOfThePastIsDoneAtOnce) {
  sut.run_until(Time(2s));
  Time done = never;
  sut.at(Time(1s), [&](Time now) { done = now; });
  sut.run_until(Time(2s));
  EXPECT_EQ(done, Time(2s));
}

TEST_F(WorldTest, AFastClockCallsItsNodeEarlier) {
  Probe fast;
  const SlotIndex slot = place(fast, {.clock_drift_ppm = 100'000});
  fast.period = 1100ms;
  sut.start(slot);
  sut.run_until(Time(1s));
  EXPECT_EQ(fast.called, std::vector<Time>{Time(1100ms)}) << "on the clock of the node";
}

TEST_F(WorldTest, AClockThatBeginsToDriftDoesNotJump) {
  Probe node;
  const SlotIndex slot = place(node);
  node.period = 1s;
  sut.start(slot);
  sut.run_until(Time(10s));
  sut.set_clock_drift(slot, -500'000);
  sut.run_until(Time(11s));
  EXPECT_EQ(node.called.size(), 10U);
  sut.run_until(Time(12s));
  EXPECT_EQ(node.called.back(), Time(11s)) << "at half speed the next second takes two";
}

TEST_F(WorldTest, ANodeThatNeverHasEnoughDoesNotStopTheWorld) {
  first.is_stuck = true;
  first.period = 1ms;
  sut.start(first_slot);
  sut.run_until(Time(1ms) + 2us);
  EXPECT_EQ(sut.now(), Time(1ms) + 2us);
  EXPECT_EQ(sut.livelocks(), 3U);
}

TEST_F(WorldTest, WhatANodeWantsAfterItWasTouchedFromOutsideIsSeen) {
  first.period = 1h;
  sut.start(first_slot);
  sut.run_until(Time(1s));
  first.next = Time(2s);
  sut.touched(first_slot);
  sut.run_until(Time(3s));
  EXPECT_EQ(first.called, std::vector<Time>{Time(2s)});
}

TEST_F(WorldTest, ADeadlineThatAFrameBringsIsKept) {
  /// Is due a millisecond after each frame.
  struct Echo : Probe {
    void receive(const Frame& frame, Time now) {
      Probe::receive(frame, now);
      next = now + 1ms;
    }
    void advance(Time now) {
      called.push_back(now);
      next = never;
    }
  } echo;
  const SlotIndex slot = sut.add_slot(bus, {.accept_all = true});
  sut.occupy(slot, echo);
  first.period = 100ms;
  sut.start(first_slot);
  sut.start(slot);
  sut.run_until(Time(250ms));
  ASSERT_EQ(echo.heard.size(), 2U);
  EXPECT_EQ(echo.called, (std::vector<Time>{echo.heard[0].at + 1ms, echo.heard[1].at + 1ms}));
}

TEST_F(WorldTest, AnActionThatAFrameBringsIsDoneInTime) {
  struct Planner : Probe {
    World* world = nullptr;
    std::vector<Time> done;
    void receive(const Frame& frame, Time now) {
      Probe::receive(frame, now);
      world->at(now + 10us, [this](Time at) { done.push_back(at); });
    }
  } planner;
  planner.world = &sut;
  const SlotIndex slot = sut.add_slot(bus, {.accept_all = true});
  sut.occupy(slot, planner);
  first.period = 100ms;
  sut.start(first_slot);
  sut.start(slot);
  sut.run_until(Time(150ms));
  ASSERT_EQ(planner.heard.size(), 1U);
  EXPECT_EQ(planner.done, std::vector<Time>{planner.heard[0].at + 10us});
}

/// And two on a bus of 250 kbit/s, where a bit takes 4 µs.
class TwoBusesTest : public WorldTest {
 protected:
  void SetUp() override {
    WorldTest::SetUp();
    const BusIndex other_bus = sut.add_bus({.bit_rate = 250'000});
    for (Probe* probe : {&far, &far_peer}) {
      const SlotIndex slot = sut.add_slot(other_bus, {.accept_all = true});
      probe->port = sut.port(slot);
      sut.occupy(slot, *probe);
    }
  }

  Probe far;
  Probe far_peer;
};

TEST_F(TwoBusesTest, ShareOneTimeAndNoFrames) {
  first.period = far.period = 10ms;
  for (SlotIndex slot = 0; slot < 4; ++slot) sut.start(slot);
  sut.run_until(Time(15ms));
  ASSERT_EQ(second.heard.size(), 1U);
  ASSERT_EQ(far_peer.heard.size(), 1U);
  const Duration slow = second.heard[0].at - Time(10ms);
  const Duration fast = far_peer.heard[0].at - Time(10ms);
  EXPECT_NEAR(static_cast<double>(slow.count()), 2.0 * static_cast<double>(fast.count()), 1.0);
}

TEST_F(TwoBusesTest, AGatewaySendsAfterItHasReceived) {
  second.onward = &far.port;
  first.period = 100ms;
  for (SlotIndex slot = 0; slot < 4; ++slot) sut.start(slot);
  sut.run_until(Time(150ms));
  while (sut.now() < Time(250ms)) sut.run_until(sut.now() + 7us);
  ASSERT_EQ(second.heard.size(), 2U);
  ASSERT_EQ(far_peer.heard.size(), 2U);
  // An empty frame has more than 40 bits, of 4 us each.
  const Duration after = far_peer.heard[0].at - second.heard[0].at;
  EXPECT_GT(after, 40 * 4us);
  EXPECT_LT(after, 60 * 4us);
  EXPECT_EQ(far_peer.heard[1].at - second.heard[1].at, after);
}

}  // namespace
}  // namespace canvoy::world_test
