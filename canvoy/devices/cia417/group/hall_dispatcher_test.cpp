// The dispatcher of hall calls: worked examples, and what holds whatever happens.
#include "canvoy/devices/cia417/group/hall_dispatcher.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <map>
#include <tuple>
#include <vector>

#include "canvoy/can/random.hpp"

namespace canvoy::cia417::hall_dispatcher_test {
namespace {

constexpr auto up = Direction::up;
constexpr auto down = Direction::down;

GroupLift lift_at(std::uint8_t floor, Direction direction = Direction::none) {
  return {.in_service = true,
          .floor = floor,
          .direction = direction,
          .served = {FloorSet::between(1, 20)}};
}

class HallDispatcherTest : public testing::Test {
 protected:
  HallDispatcherTest() { dispatcher.on_assigned(callback<&HallDispatcherTest::note>(*this)); }
  void note(const HallCall& call, unsigned lift) { told.emplace_back(call.floor, lift); }

  std::array<GroupLift, 3> lifts{lift_at(1), lift_at(10), lift_at(18)};
  std::array<HallDispatcher::Slot, 8> slots;
  HallDispatcher dispatcher{lifts, slots};
  std::vector<std::pair<unsigned, unsigned>> told;
};

TEST_F(HallDispatcherTest, TheNearestLiftComes) {
  EXPECT_EQ(dispatcher.add({.floor = 3, .direction = up}), DispatchAnswer::assigned);
  EXPECT_EQ(dispatcher.add({.floor = 11, .direction = down}), DispatchAnswer::assigned);
  EXPECT_EQ(dispatcher.add({.floor = 20, .direction = down}), DispatchAnswer::assigned);
  EXPECT_EQ(told, (decltype(told){{3, 1}, {11, 2}, {20, 3}}));
}

TEST_F(HallDispatcherTest, ACallIsKnownWhenItComesAgain) {
  dispatcher.add({.floor = 3, .direction = up});
  EXPECT_EQ(dispatcher.add({.floor = 3, .direction = up}), DispatchAnswer::assigned);
  EXPECT_EQ(dispatcher.calls().size(), 1u);
  EXPECT_EQ(told.size(), 1u);
}

TEST_F(HallDispatcherTest, ALiftThatHasToTurnComesLater) {
  lifts[1].direction = up;
  lifts[1].car_calls.insert(19);
  dispatcher.add({.floor = 9, .direction = down});
  EXPECT_EQ(told.back().second, 1u) << "12 s from below; 13.5 + 8 + 15 s by the turn";
}

TEST_F(HallDispatcherTest, ALiftThatIsFullIsPassedOver) {
  lifts[1].full = true;
  dispatcher.add({.floor = 11, .direction = down});
  EXPECT_EQ(told.back().second, 3u);
}

TEST_F(HallDispatcherTest, OfEqualLiftsTheFirstComes) {
  lifts[2] = lift_at(12);
  dispatcher.add({.floor = 11, .direction = down});
  EXPECT_EQ(told.back().second, 2u);
}

TEST_F(HallDispatcherTest, OnlyLiftsThatAreMeantAndHaveTheDoorCome) {
  lifts[2].served[1] = FloorSet::between(5, 5);
  EXPECT_EQ(dispatcher.add({.floor = 5, .direction = up, .doors = 0b10}), DispatchAnswer::assigned);
  EXPECT_EQ(told.back().second, 3u);
  EXPECT_EQ(dispatcher.add({.floor = 2, .direction = up, .lifts = 0b100}),
            DispatchAnswer::assigned);
  EXPECT_EQ(told.back().second, 3u);
  EXPECT_EQ(dispatcher.add({.floor = 6, .direction = up, .doors = 0b10}), DispatchAnswer::refused);
  EXPECT_EQ(dispatcher.add({.floor = 21, .direction = up}), DispatchAnswer::refused);
  EXPECT_EQ(dispatcher.add({.floor = 0}), DispatchAnswer::refused);
  EXPECT_EQ(dispatcher.add({.floor = 5, .doors = 0}), DispatchAnswer::refused);
}

TEST_F(HallDispatcherTest, NobodyIsSentToWhereHisLiftEnds) {
  lifts[1].floor = 20;
  lifts[2].served[0] = FloorSet::between(1, 30);
  EXPECT_EQ(dispatcher.add({.floor = 20, .direction = up}), DispatchAnswer::assigned);
  EXPECT_EQ(told.back().second, 3u) << "the lifts that end there are nearer, and of no use";
  EXPECT_EQ(dispatcher.add({.floor = 30, .direction = up}), DispatchAnswer::refused);
  EXPECT_EQ(dispatcher.add({.floor = 1, .direction = down}), DispatchAnswer::refused);
}

TEST_F(HallDispatcherTest, ALiftThatFailsHandsItsCallsOver) {
  dispatcher.add({.floor = 3, .direction = up});
  lifts[0].in_service = false;
  dispatcher.service_changed();
  EXPECT_EQ(told.back(), (std::pair{3U, 2U}));
  lifts[1].in_service = lifts[2].in_service = false;
  dispatcher.service_changed();
  EXPECT_EQ(told.back(), (std::pair{3U, 0U})) << "nobody can";
  EXPECT_EQ(dispatcher.add({.floor = 4, .direction = up}), DispatchAnswer::waits);
  lifts[2].in_service = true;
  dispatcher.service_changed();
  EXPECT_EQ(dispatcher.calls()[0].lift, 3);
  EXPECT_EQ(dispatcher.calls()[1].lift, 3);
}

TEST_F(HallDispatcherTest, AStopAnswersTheCallsOfItsDirectionAndDoors) {
  for (const Direction direction : {up, down, Direction::none}) {
    dispatcher.add({.floor = 3, .direction = direction});
  }
  dispatcher.answered(2, {3, up}, 0b10);
  EXPECT_EQ(dispatcher.calls().size(), 3u) << "another door";
  dispatcher.answered(2, {3, up}, 0b01);
  ASSERT_EQ(dispatcher.calls().size(), 1u);
  EXPECT_EQ(dispatcher.calls()[0].call.direction, down);
  dispatcher.answered(1, {3, Direction::none}, 0b01);
  EXPECT_TRUE(dispatcher.calls().empty());
}

TEST_F(HallDispatcherTest, ACallIsTakenBackByWhoMadeIt) {
  dispatcher.add({.floor = 3, .direction = up});
  dispatcher.add({.floor = 3, .direction = down});
  dispatcher.remove({.floor = 3, .direction = up});
  ASSERT_EQ(dispatcher.calls().size(), 1u);
  EXPECT_EQ(dispatcher.calls()[0].call.direction, down);
}

TEST_F(HallDispatcherTest, BeyondItsMemoryItSaysSo) {
  for (std::uint8_t floor = 1; floor <= 8; ++floor) {
    EXPECT_EQ(dispatcher.add({.floor = floor, .direction = up}), DispatchAnswer::assigned);
  }
  EXPECT_EQ(dispatcher.add({.floor = 9, .direction = up}), DispatchAnswer::no_room);
  dispatcher.answered(1, {1, up}, 1);
  EXPECT_EQ(dispatcher.add({.floor = 9, .direction = up}), DispatchAnswer::assigned);
}

TEST_F(HallDispatcherTest, AMuchBetterLiftTakesACallOver) {
  dispatcher.add({.floor = 5, .direction = up});
  ASSERT_EQ(told.back(), (std::pair{5U, 1U})) << "6 s away";
  lifts[1].floor = 6;
  dispatcher.reconsider();
  EXPECT_EQ(told.size(), 1u) << "4.5 s sooner is not worth it";
  lifts[0].car_calls = FloorSet::between(2, 4);
  lifts[0].direction = up;
  dispatcher.reconsider();
  EXPECT_EQ(told.back(), (std::pair{5U, 2U}));
}

// What holds whatever happens.

struct World {
  explicit World(std::uint64_t seed) : random(seed) {
    floors = 2 + random.below(253);
    for (GroupLift& lift : lifts) {
      lift.in_service = random.below(4) != 0;
      for (FloorSet& door : lift.served) {
        if (random.below(2) == 0) door = FloorSet::between(1 + random.below(floors), floors);
      }
      wander(lift);
    }
  }
  void wander(GroupLift& lift) {
    lift.floor = static_cast<std::uint8_t>(1 + random.below(floors));
    lift.direction = static_cast<Direction>(static_cast<int>(random.below(3)) - 1);
    lift.full = random.below(5) == 0;
    lift.car_calls.clear();
    for (unsigned i = random.below(5); i > 0; --i) lift.car_calls.insert(1 + random.below(floors));
  }
  HallCall call() {
    return {.floor = static_cast<std::uint8_t>(random.below(floors + 2)),
            .direction = static_cast<Direction>(static_cast<int>(random.below(3)) - 1),
            .doors = static_cast<DoorMask>(1U << random.below(5)),
            .priority = static_cast<CallPriority>(random.below(3)),
            .lifts = static_cast<LiftMask>(random.below(256))};
  }

  Random random;
  unsigned floors;
  std::array<GroupLift, 8> lifts;
  std::array<HallDispatcher::Slot, 40> slots{};
  HallDispatcher dispatcher{lifts, slots};
};

using Key = std::tuple<unsigned, int, unsigned, int>;
Key key_of(const HallCall& call) {
  return {call.floor, static_cast<int>(call.direction), call.doors,
          static_cast<int>(call.priority)};
}

RC_GTEST_PROP(HallDispatcherProperty, NoCallIsLostAndNoneIsWithALiftThatCannotServeIt,
              (std::uint64_t seed)) {
  World world(seed);
  std::map<Key, HallCall> model;
  for (unsigned step = 0; step < 120; ++step) {
    const unsigned kind = world.random.below(10);
    if (kind < 6) {
      const HallCall call = world.call();
      const DispatchAnswer answer = world.dispatcher.add(call);
      const bool kept = answer == DispatchAnswer::assigned || answer == DispatchAnswer::waits;
      if (kept) model.try_emplace(key_of(call), call);
    } else if (kind < 8) {
      GroupLift& lift = world.lifts[world.random.below(8)];
      lift.in_service = !lift.in_service;
      world.dispatcher.service_changed();
    } else if (kind == 8) {
      world.wander(world.lifts[world.random.below(8)]);
      world.dispatcher.reconsider();
    } else if (!model.empty()) {
      const HallCall call = model.begin()->second;
      const unsigned lift = 1 + world.random.below(8);
      if ((call.lifts & lift_bit(lift)) == 0) continue;
      world.dispatcher.answered(lift, {call.floor, call.direction}, call.doors);
      std::erase_if(model, [&](const auto& item) {
        const HallCall& other = item.second;
        const bool fits = call.direction == Direction::none || other.direction == Direction::none ||
                          other.direction == call.direction;
        return other.floor == call.floor && other.doors == call.doors && fits &&
               (other.lifts & lift_bit(lift)) != 0;
      });
    }
    RC_ASSERT(world.dispatcher.calls().size() == model.size());
    for (const auto& slot : world.dispatcher.calls()) {
      const auto found = model.find(key_of(slot.call));
      RC_ASSERT(found != model.end());
      const LiftMask allowed = found->second.lifts;
      if (slot.lift == 0) {
        for (unsigned lift = 1; lift <= 8; ++lift) {
          const GroupLift& state = world.lifts[lift - 1];
          RC_ASSERT(!state.in_service || (allowed & lift_bit(lift)) == 0 ||
                    !state.serves(slot.call.floor, slot.call.doors) ||
                    !state.leaves(slot.call.floor, slot.call.direction));
        }
      } else {
        const GroupLift& state = world.lifts[slot.lift - 1U];
        RC_ASSERT(state.in_service);
        RC_ASSERT((allowed & lift_bit(slot.lift)) != 0);
        RC_ASSERT(state.serves(slot.call.floor, slot.call.doors));
        RC_ASSERT(state.leaves(slot.call.floor, slot.call.direction));
      }
    }
  }
}

RC_GTEST_PROP(HallDispatcherProperty, TheSameCallsGiveTheSameAssignments, (std::uint64_t seed)) {
  World one(seed);
  World other(seed);
  for (unsigned i = 0; i < 40; ++i) {
    (void)one.dispatcher.add(one.call());
    (void)other.dispatcher.add(other.call());
  }
  RC_ASSERT(one.dispatcher.calls().size() == other.dispatcher.calls().size());
  for (std::size_t i = 0; i < one.dispatcher.calls().size(); ++i) {
    RC_ASSERT(one.slots[i].call == other.slots[i].call);
    RC_ASSERT(one.slots[i].lift == other.slots[i].lift);
  }
}

}  // namespace
}  // namespace canvoy::cia417::hall_dispatcher_test
