// The dispatcher of destination calls: worked examples, and what holds whatever happens.
#include "canvoy/devices/cia417/group/destination_dispatcher.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <vector>

#include "canvoy/can/random.hpp"

namespace canvoy::cia417::destination_dispatcher_test {
namespace {

using Answer = DestinationDispatcher::Answer;

GroupLift lift_at(std::uint8_t floor) {
  return {
      .in_service = true, .floor = floor, .served = {FloorSet::between(1, 20)}, .persons_max = 10};
}

class DestinationDispatcherTest : public testing::Test {
 protected:
  void board(const DestinationCall& call) { boarded.push_back(call.target); }
  void depart(unsigned lift, std::uint8_t floor, Direction direction, DoorMask doors = 1) {
    boarded.clear();
    dispatcher.departed(lift, {floor, direction}, doors,
                        callback<&DestinationDispatcherTest::board>(*this));
    std::ranges::sort(boarded);
  }
  unsigned persons(unsigned lift) const {
    unsigned sum = 0;
    for (const auto& slot : dispatcher.calls()) sum += slot.lift == lift ? slot.persons : 0;
    return sum;
  }

  std::array<GroupLift, 3> lifts{lift_at(1), lift_at(1), lift_at(1)};
  std::array<DestinationDispatcher::Slot, 30> slots;
  DestinationDispatcher dispatcher{lifts, slots};
  std::vector<unsigned> boarded;
};

TEST_F(DestinationDispatcherTest, PassengersForOneFloorComeTogether) {
  const Answer first = dispatcher.add({.source = 1, .target = 9});
  EXPECT_EQ(first, (Answer{DispatchAnswer::assigned, 1}));
  EXPECT_NE(dispatcher.add({.source = 1, .target = 12}).lift, 1) << "it would delay him";
  EXPECT_EQ(dispatcher.add({.source = 1, .target = 9}).lift, 1);
  EXPECT_EQ(persons(1), 2u);
}

TEST_F(DestinationDispatcherTest, ACarThatTurnsSoonTakesWhoComesThoughItGoesFarThereafter) {
  lifts[0] = lift_at(3);
  lifts[0].direction = Direction::up;
  lifts[0].car_calls.insert(3);
  lifts[1] = lifts[2] = lift_at(4);
  for (const std::size_t far : {1U, 2U}) {
    lifts[far].direction = Direction::up;
    lifts[far].car_calls.insert(12);
  }
  EXPECT_EQ(dispatcher.add({.source = 1, .target = 20}).lift, 1);
  EXPECT_EQ(dispatcher.add({.source = 1, .target = 8}).lift, 1) << "by 3, not by 20";
}

TEST_F(DestinationDispatcherTest, InUpPeakTheLiftsShareTheFloors) {
  for (GroupLift& lift : lifts) lift.persons_max = 20;
  for (unsigned i = 0; i < 24; ++i) {
    const auto target = static_cast<std::uint8_t>(2 + i % 6 * 3);
    EXPECT_EQ(dispatcher.add({.source = 1, .target = target}).answer, DispatchAnswer::assigned);
  }
  for (unsigned lift = 1; lift <= 3; ++lift) {
    EXPECT_GE(persons(lift), 4u);
    EXPECT_LE(persons(lift), 12u);
    EXPECT_LE(dispatcher.route(lift).stops().size(), 4u) << "the lobby, and some of six floors";
  }
}

TEST_F(DestinationDispatcherTest, MoreThanACarHoldsGoToAnother) {
  for (unsigned i = 0; i < 9; ++i) (void)dispatcher.add({.source = 1, .target = 9});
  EXPECT_EQ(persons(1), 8u) << "80 % of 10";
  EXPECT_EQ(persons(2), 1u);
}

TEST_F(DestinationDispatcherTest, WhileAllCarsAreFullWhoComesWaitsAndIsGivenALiftLater) {
  std::vector<std::pair<unsigned, unsigned>> told;
  auto note = [&](const DestinationCall& call, unsigned lift) {
    told.emplace_back(call.target, lift);
  };
  for (unsigned i = 0; i < 24; ++i) (void)dispatcher.add({.source = 1, .target = 9});
  dispatcher.on_assigned(Callback<void(const DestinationCall&, unsigned)>::of(note));
  EXPECT_EQ(dispatcher.add({.source = 1, .target = 12}), (Answer{DispatchAnswer::waits, 0}));
  EXPECT_EQ(dispatcher.add({.source = 1, .target = 12}), (Answer{DispatchAnswer::waits, 0}));
  EXPECT_EQ(dispatcher.add({.source = 1, .target = 5}), (Answer{DispatchAnswer::waits, 0}));
  EXPECT_EQ(dispatcher.calls().size(), 5u) << "three cars, and two floors that wait";
  EXPECT_EQ(dispatcher.add({.source = 5, .target = 2}).answer, DispatchAnswer::assigned)
      << "that way there is room";
  told.clear();

  lifts[1].direction = Direction::up;
  depart(2, 1, Direction::up);
  dispatcher.assign_waiting();
  EXPECT_TRUE(told.empty()) << "they are in the car, and it still is there";
  lifts[1].floor = 2;
  dispatcher.assign_waiting();
  EXPECT_EQ(told, (decltype(told){{12, 2}, {5, 2}})) << "who waits longest first";
  EXPECT_EQ(persons(2), 3u);
}

TEST_F(DestinationDispatcherTest, WhoIsInTheCarCountsUntilHeIsOut) {
  for (unsigned i = 0; i < 8; ++i) {
    (void)dispatcher.add({.source = 1, .target = 9, .lifts = 0b001});
  }
  lifts[0].direction = Direction::up;
  depart(1, 1, Direction::up);
  lifts[0].floor = 3;
  lifts[0].car_calls.insert(9);
  EXPECT_EQ(dispatcher.riders().size(), 1u);
  EXPECT_EQ(dispatcher.add({.source = 5, .target = 12, .lifts = 0b001}).answer,
            DispatchAnswer::waits)
      << "the car comes by, and is full";
  EXPECT_EQ(dispatcher.add({.source = 9, .target = 13, .lifts = 0b001}).lift, 1)
      << "eight get out there";
  dispatcher.alighted(1, 9);
  EXPECT_TRUE(dispatcher.riders().empty());
  dispatcher.assign_waiting();
  EXPECT_EQ(persons(0), 0u);
}

TEST_F(DestinationDispatcherTest, WhenManyWantToTravelStopsAreDear) {
  std::array<GroupLift, 2> two{lift_at(1), lift_at(1)};
  DestinationDispatcher group(two, slots);
  for (unsigned i = 0; i < 4; ++i) {
    (void)group.add({.source = 1, .target = 5, .lifts = 0b01});
    (void)group.add({.source = 1, .target = 15, .lifts = 0b10});
  }
  EXPECT_EQ(group.add({.source = 1, .target = 15}).lift, 2);
  EXPECT_EQ(group.add({.source = 1, .target = 5}).lift, 1);
  EXPECT_EQ(group.add({.source = 1, .target = 16}).lift, 2)
      << "beyond 15 one floor more, beyond 5 eleven";
}

TEST_F(DestinationDispatcherTest, WhoBoardsIsInTheCar) {
  (void)dispatcher.add({.source = 5, .target = 9, .lifts = 0b001});
  (void)dispatcher.add({.source = 5, .target = 12, .lifts = 0b001});
  (void)dispatcher.add({.source = 5, .target = 2, .lifts = 0b001});
  (void)dispatcher.add({.source = 6, .target = 9, .lifts = 0b001});
  depart(2, 5, Direction::up);
  EXPECT_TRUE(boarded.empty()) << "they were told lift 1";
  depart(1, 5, Direction::up, 0b10);
  EXPECT_TRUE(boarded.empty()) << "another door";
  depart(1, 5, Direction::up);
  EXPECT_EQ(boarded, (std::vector{9U, 12U}));
  depart(1, 5, Direction::none);
  EXPECT_EQ(boarded, (std::vector{2U}));
  EXPECT_EQ(dispatcher.calls().size(), 1u);
}

TEST_F(DestinationDispatcherTest, ALiftThatFailsHandsItsPassengersOver) {
  (void)dispatcher.add({.source = 1, .target = 9});
  (void)dispatcher.add({.source = 1, .target = 9});
  lifts[0].in_service = false;
  dispatcher.service_changed();
  EXPECT_EQ(persons(1), 0u);
  EXPECT_EQ(persons(2), 2u);
  lifts[1].in_service = lifts[2].in_service = false;
  dispatcher.service_changed();
  EXPECT_EQ(persons(0), 2u);
  EXPECT_EQ(dispatcher.add({.source = 3, .target = 1}).answer, DispatchAnswer::waits);
  lifts[2].in_service = true;
  dispatcher.service_changed();
  EXPECT_EQ(persons(3), 3u);
}

TEST_F(DestinationDispatcherTest, ALiftHasToServeBothFloorsByTheDoorsThatAreMeant) {
  lifts[0].served = {FloorSet::between(1, 5)};
  lifts[1].served = {FloorSet::between(1, 1), FloorSet::between(9, 9)};
  lifts[2].served = {FloorSet::between(9, 9)};
  EXPECT_EQ(dispatcher.add({.source = 1, .target = 9}).lift, 2);
  EXPECT_EQ(dispatcher.add({.source = 1, .target = 9, .target_doors = 0b10}).lift, 2);
  EXPECT_EQ(dispatcher.add({.source = 1, .target = 9, .target_doors = 0b01}).answer,
            DispatchAnswer::refused);
  EXPECT_EQ(dispatcher.add({.source = 5, .target = 9}).answer, DispatchAnswer::refused);
  EXPECT_EQ(dispatcher.add({.source = 3, .target = 3}).answer, DispatchAnswer::refused);
  EXPECT_EQ(dispatcher.add({.source = 0, .target = 3}).answer, DispatchAnswer::refused);
  EXPECT_EQ(dispatcher.add({.source = 1, .target = 255}).answer, DispatchAnswer::refused);
}

TEST_F(DestinationDispatcherTest, BeyondItsMemoryItSaysSo) {
  for (GroupLift& lift : lifts) lift.persons_max = 100;
  for (std::uint8_t i = 0; i < 30; ++i) {
    (void)dispatcher.add({.source = 1,
                          .target = static_cast<std::uint8_t>(2 + i % 19),
                          .lifts = static_cast<LiftMask>(i < 19 ? 1 : 2)});
  }
  EXPECT_EQ(dispatcher.add({.source = 2, .target = 1}).answer, DispatchAnswer::no_room);
  EXPECT_EQ(dispatcher.add({.source = 1, .target = 2, .lifts = 1}).answer, DispatchAnswer::assigned)
      << "one more of those who are known takes no room";
}

RC_GTEST_PROP(DestinationDispatcherProperty, NobodyIsLostAndNobodyIsWithALiftThatCannotServeHim,
              (std::uint64_t seed)) {
  Random random(seed);
  std::array<GroupLift, 8> lifts;
  for (GroupLift& lift : lifts) {
    lift = lift_at(static_cast<std::uint8_t>(1 + random.below(20)));
    lift.in_service = random.below(3) != 0;
    lift.served[1] = FloorSet::between(1 + random.below(20), 20);
  }
  std::array<DestinationDispatcher::Slot, 25> slots{};
  DestinationDispatcher dispatcher(lifts, slots);
  unsigned accepted = 0;
  const auto sum = [&](unsigned lift) {
    unsigned persons = 0;
    for (const auto& slot : dispatcher.calls()) {
      if (lift == 9 || slot.lift == lift) persons += slot.persons;
    }
    return persons;
  };
  for (unsigned step = 0; step < 100; ++step) {
    const unsigned kind = random.below(8);
    if (kind < 5) {
      const auto answer = dispatcher.add({.source = static_cast<std::uint8_t>(random.below(22)),
                                          .target = static_cast<std::uint8_t>(random.below(22)),
                                          .source_doors = static_cast<DoorMask>(random.below(4)),
                                          .target_doors = static_cast<DoorMask>(random.below(4)),
                                          .lifts = static_cast<LiftMask>(random.below(256))});
      accepted +=
          answer.answer == DispatchAnswer::assigned || answer.answer == DispatchAnswer::waits;
    } else if (kind < 7) {
      GroupLift& lift = lifts[random.below(8)];
      lift.in_service = !lift.in_service;
      dispatcher.service_changed();
    } else {
      const unsigned before = sum(9);
      dispatcher.departed(1 + random.below(8),
                          {static_cast<std::uint8_t>(random.below(22)), Direction::none}, 0b11);
      accepted -= before - sum(9);
    }
    RC_ASSERT(sum(9) == accepted);
    for (const auto& slot : dispatcher.calls()) {
      if (slot.lift == 0) continue;
      const GroupLift& lift = lifts[slot.lift - 1U];
      RC_ASSERT(lift.in_service && (slot.call.lifts & lift_bit(slot.lift)) != 0);
      RC_ASSERT(lift.serves(slot.call.source, slot.call.source_doors));
      RC_ASSERT((lift.doors_at(slot.call.target) & slot.call.target_doors) ==
                slot.call.target_doors);
      RC_ASSERT(lift.doors_at(slot.call.target) != 0);
    }
  }
}

}  // namespace
}  // namespace canvoy::cia417::destination_dispatcher_test
