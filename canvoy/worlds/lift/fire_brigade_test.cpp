// Firefighters in a lift: the keys that they turn, and the buttons that they hold, and for how
// long.
#include "canvoy/worlds/lift/fire_brigade.hpp"

#include <gtest/gtest.h>

#include <string>
#include <utility>

namespace canvoy::lift::fire_brigade_test {
namespace {

constexpr FireBrigadeView open_at_1{.floor = 1, .is_open = true};
constexpr FireBrigadeView moving{};

struct FireBrigadeTest : testing::Test {
  std::string done() { return std::exchange(text, {}); }
  void note(const std::string& what, bool on) { text += what + (on ? "+ " : "- "); }

  std::string text;
  FloorNumber called = no_floor;
  FireBrigade sut{{.alarm_key = [this](bool on) { note("alarm", on); },
                   .car_key = [this](bool on) { note("key", on); },
                   .call =
                       [this](FloorNumber floor, bool on) {
                         called = floor;
                         note("call", on);
                       },
                   .door_open = [this](bool on) { note("open", on); },
                   .door_close = [this](bool on) { note("close", on); }},
                  {.fire_floor = 1, .floors = 5, .seed = 3}};
};

TEST_F(FireBrigadeTest, TheyGetInWhereTheCarStandsOpenAtTheFireFloorAndEverybodyHasLeft) {
  sut.begin(Time(0s));
  EXPECT_EQ(done(), "alarm+ ");
  FireBrigadeView car = open_at_1;
  car.floor = 2;
  sut.look(Time(1s), car);
  car = open_at_1;
  car.is_open = false;
  sut.look(Time(2s), car);
  car = open_at_1;
  car.is_empty = false;
  sut.look(Time(3s), car);
  EXPECT_EQ(done(), "");
  sut.look(Time(4s), open_at_1);
  EXPECT_EQ(done(), "key+ ");
}

TEST_F(FireBrigadeTest, TheyHoldTheButtonUntilTheCarLeavesAndTheOtherOneUntilItIsOpen) {
  sut.begin(Time(0s));
  sut.look(Time(1s), open_at_1);
  done();
  sut.look(Time(3s), open_at_1);
  EXPECT_EQ(done(), "") << "they are getting in";
  sut.look(Time(4s), open_at_1);
  EXPECT_EQ(done(), "close- open- call+ close+ ");
  EXPECT_GT(called, 1);
  sut.look(Time(5s), open_at_1);
  EXPECT_EQ(done(), "call- ");
  sut.look(Time(7s), moving);
  EXPECT_EQ(done(), "call- close- ");
  sut.look(Time(8s), moving);
  const FireBrigadeView there{.floor = called};
  sut.look(Time(9s), there);
  EXPECT_EQ(done(), "") << "they look for smoke";
  sut.look(Time(10s), there);
  EXPECT_EQ(done(), "open+ ");
  sut.look(Time(11s), there);
  EXPECT_EQ(done(), "");
  const FireBrigadeView opened{.floor = called, .is_open = true};
  sut.look(Time(12s), opened);
  EXPECT_EQ(done(), "open- ");
  EXPECT_EQ(sut.floors_searched(), 1U);
  const FloorNumber before = called;
  sut.look(Time(30s), opened);
  EXPECT_EQ(done(), "close- open- call- call+ close+ ");
  EXPECT_NE(called, before) << "to another floor";
}

TEST_F(FireBrigadeTest, ACarThatStaysIsAskedAgain) {
  sut.begin(Time(0s));
  sut.look(Time(1s), open_at_1);
  sut.look(Time(4s), open_at_1);
  done();
  sut.look(Time(24s), open_at_1);
  EXPECT_EQ(done(), "call- close- open- call- call+ close+ ");
}

TEST_F(FireBrigadeTest, WhenTheyGoTheyRideBackAndGiveTheKeysBackAtTheFireFloor) {
  sut.end(Time(0s));
  EXPECT_EQ(done(), "") << "they were not there";
  sut.begin(Time(0s));
  sut.look(Time(1s), open_at_1);
  sut.look(Time(4s), open_at_1);
  EXPECT_EQ(sut.waits(Time(6s)), 2s) << "since the finger is on the button";
  sut.look(Time(7s), moving);
  const FloorNumber away = called;
  sut.look(Time(9s), {.floor = away});
  EXPECT_EQ(sut.waits(Time(9s)), 0s) << "they are there";
  sut.look(Time(11s), {.floor = away, .is_open = true});
  done();
  sut.end(Time(12s));
  EXPECT_EQ(done(), "") << "they are still up there";
  EXPECT_TRUE(sut.is_there());
  sut.look(Time(13s), {.floor = away, .is_open = true});
  EXPECT_EQ(done(), "close- open- call- call+ close+ ");
  EXPECT_EQ(called, 1);
  sut.look(Time(15s), moving);
  sut.look(Time(20s), {.floor = 1});
  sut.look(Time(22s), {.floor = 1});
  done();
  sut.look(Time(24s), open_at_1);
  EXPECT_EQ(done(), "open- ");
  sut.look(Time(25s), open_at_1);
  EXPECT_EQ(done(), "close- open- call- key- alarm- ");
  EXPECT_FALSE(sut.is_there());
  EXPECT_EQ(sut.returns(), 1U);
}

TEST_F(FireBrigadeTest, WhereTheCarDoesNotTakeThemBackTheyTurnTheKeysBackWhereItIs) {
  sut.begin(Time(0s));
  sut.look(Time(1s), open_at_1);
  sut.look(Time(4s), open_at_1);
  sut.end(Time(5s));
  sut.look(Time(125s - 1us), {.floor = 4});
  EXPECT_TRUE(sut.is_there());
  done();
  sut.look(Time(125s), {.floor = 4});
  EXPECT_EQ(done(), "close- open- call- key- alarm- ");
  EXPECT_EQ(sut.returns(), 0U);
}

TEST_F(FireBrigadeTest, WithoutACarTheyHaveTheKeyOfTheFireFloorAlone) {
  sut.begin(Time(0s));
  done();
  sut.end(Time(5s));
  EXPECT_EQ(done(), "close- open- key- alarm- ");
  EXPECT_FALSE(sut.is_there());
}

}  // namespace
}  // namespace canvoy::lift::fire_brigade_test
