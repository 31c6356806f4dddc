#include "canvoy/worlds/lift/crowd.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace canvoy::lift::crowd_test {
namespace {

/// A building of 5 floors with two cars for 4 persons, with doors that the test moves.
struct CrowdTest : testing::Test {
  CrowdTest() {
    building.lifts[0].car.rated_persons = 4;
    options.fill_share = 1;
    options.holds_door = 0;
    options.stops_closing_door = 0;
  }
  Crowd& people(std::vector<Arrival> list) {
    crowd.emplace(building, Traffic(std::move(list)), hands(), options);
    return *crowd;
  }
  PassengerHands hands() {
    return {
        .hall_button =
            [this](const HallButton& button, bool pressed) {
              note((button.direction == Direction::up ? "up " : "down ") +
                   std::to_string(button.floor) + (pressed ? " pressed" : " released"));
            },
        .car_button =
            [this](const CarButton& button, bool pressed) {
              note("car " + std::to_string(button.lift) + " floor " + std::to_string(button.floor) +
                   (pressed ? " pressed" : " released"));
            },
        .destination_button =
            [this](const DestinationButton& button, bool pressed) {
              if (pressed) {
                note("from " + std::to_string(button.floor) + " to " + std::to_string(button.to));
              }
            },
        .door_open_button = [this](LiftNumber,
                                   bool pressed) { note(pressed ? "door held" : "door let go"); },
        .doorway =
            [this](LiftNumber, DoorNumber door, bool blocked) {
              doorway = door;
              note(blocked ? "barrier broken" : "barrier free");
            },
        .load = [this](LiftNumber,
                       double kg) { note(std::to_string(static_cast<int>(kg)) + " kg"); },
    };
  }
  void note(const std::string& what) { diary.push_back(what); }
  /// Runs up to `until`, event by event.
  void run_until(Time until) {
    while (crowd->deadline() <= until) crowd->advance(crowd->deadline());
    crowd->advance(until);
  }
  std::vector<std::string> take_diary() { return std::exchange(diary, {}); }
  PassengerState state(PassengerId who) const { return crowd->passengers()[who].state; }

  using Diary = std::vector<std::string>;
  Building building = uniform_building({.floors = 5, .lifts = 2});
  PassengerOptions options;
  std::optional<Crowd> crowd;
  Diary diary;
  DoorNumber doorway = 0;  ///< door where a person has entered or left
};

constexpr CarView open_at(FloorNumber floor, Direction direction = Direction::none) {
  return {.floor = floor, .door = DoorView::open, .direction = direction};
}
constexpr CarView away{};

TEST_F(CrowdTest, APersonPressesTheButtonOfHisDirectionAndLetsGo) {
  people({{.at = Time(1s), .from = 3, .to = 1}, {.at = Time(10s), .from = 2, .to = 5}});
  run_until(Time(2s));
  EXPECT_EQ(take_diary(), (Diary{"down 3 pressed", "down 3 released"}));
  crowd->hall_lamp({3, Direction::down}, true);
  run_until(Time(11s));
  EXPECT_EQ(take_diary(), (Diary{"up 2 pressed", "up 2 released"}));
}

TEST_F(CrowdTest, WhoeverIsInADoorLeavesThatOneWhicheverElseOpens) {
  people({{.at = Time(1s), .from = 1, .to = 5}});
  run_until(Time(2s));
  CarView car = open_at(1);
  car.doorway = 2;
  crowd->car_changed(Time(3s), 1, car);
  EXPECT_EQ(doorway, 2);
  car.doorway = 1;
  crowd->car_changed(Time(3'100ms), 1, car);
  take_diary();
  run_until(Time(4s));
  EXPECT_EQ(take_diary().front(), "barrier free");
  EXPECT_EQ(doorway, 2);
}

TEST_F(CrowdTest, APersonPressesAgainWhileNoLampIsLit) {
  people({{.at = Time(1s), .from = 3, .to = 1}});
  run_until(Time(12s));
  EXPECT_EQ(crowd->presses(), 3U);
}

TEST_F(CrowdTest, ALampThatIsLitKeepsTheNextOneFromPressing) {
  people({{.at = Time(1s), .from = 3, .to = 1}, {.at = Time(2s), .from = 3, .to = 2}});
  run_until(Time(1500ms));
  crowd->hall_lamp({3, Direction::down}, true);
  run_until(Time(30s));
  EXPECT_EQ(crowd->presses(), 1U);
  run_until(Time(35s));
  EXPECT_EQ(crowd->presses(), 3U) << "but not for ever: each of the two has pressed";
}

TEST_F(CrowdTest, PeopleBoardOneAfterTheOtherThroughTheBarrierAndWeighWhatTheyWeigh) {
  people({{.at = Time(1s), .from = 2, .to = 5, .mass_kg = 80},
          {.at = Time(2s), .from = 2, .to = 4, .mass_kg = 60}});
  run_until(Time(10s));
  take_diary();
  crowd->car_changed(Time(10s), 1, open_at(2, Direction::up));
  run_until(Time(12s));
  EXPECT_EQ(take_diary(), (Diary{"barrier broken", "barrier free", "80 kg", "barrier broken",
                                 "car 1 floor 5 pressed", "car 1 floor 5 released"}));
  run_until(Time(12400ms));
  EXPECT_EQ(take_diary(), (Diary{"barrier free", "140 kg"}));
  EXPECT_EQ(crowd->riding(1).size(), 2U);
  EXPECT_EQ(crowd->statistics().waiting().longest(), 10'400ms);
}

TEST_F(CrowdTest, ACarIsEmptyWhileNobodyIsInItNorOnTheWayThroughItsDoor) {
  people({{.at = Time(1s), .from = 2, .to = 3}});
  run_until(Time(10s));
  EXPECT_TRUE(crowd->is_empty(1));
  crowd->car_changed(Time(10s), 1, open_at(2));
  EXPECT_TRUE(crowd->riding(1).empty());
  EXPECT_FALSE(crowd->is_empty(1)) << "he is boarding";
  EXPECT_TRUE(crowd->is_empty(2));
  run_until(Time(20s));
  EXPECT_FALSE(crowd->is_empty(1));
  crowd->car_changed(Time(20s), 1, away);
  crowd->car_changed(Time(30s), 1, open_at(3));
  EXPECT_FALSE(crowd->is_empty(1)) << "he is leaving";
  run_until(Time(32s));
  EXPECT_TRUE(crowd->is_empty(1));
}

TEST_F(CrowdTest, WhoIsBoardingWhenACarIsEvacuatedLeavesItAgain) {
  people({{.at = Time(1s), .from = 2, .to = 3}});
  run_until(Time(10s));
  crowd->car_changed(Time(10s), 1, open_at(2));
  CarView recalled = open_at(2);
  recalled.accepts = false;
  recalled.evacuates = true;
  crowd->car_changed(Time(10'100ms), 1, recalled);
  EXPECT_FALSE(crowd->is_empty(1));
  run_until(Time(15s));
  EXPECT_TRUE(crowd->is_empty(1));
  EXPECT_EQ(state(0), PassengerState::evacuated);
}

TEST_F(CrowdTest, ThoseWhoArriveLeaveBeforeOthersBoardAndAreServed) {
  people({{.at = Time(1s), .from = 2, .to = 3, .mass_kg = 80},
          {.at = Time(2s), .from = 3, .to = 4, .mass_kg = 60}});
  run_until(Time(10s));
  crowd->car_changed(Time(10s), 1, open_at(2));
  run_until(Time(20s));
  crowd->car_changed(Time(20s), 1, away);
  run_until(Time(30s));
  take_diary();
  crowd->car_changed(Time(30s), 1, open_at(3, Direction::up));
  run_until(Time(32'400ms));
  EXPECT_EQ(take_diary(), (Diary{"barrier broken", "barrier free", "0 kg", "barrier broken",
                                 "barrier free", "60 kg"}));
  EXPECT_EQ(state(0), PassengerState::served);
  EXPECT_EQ(state(1), PassengerState::riding);
  EXPECT_EQ(crowd->statistics().to_destination().longest(), 30'200ms);
}

/// Like a car without a brake, which is then at no floor.
TEST_F(CrowdTest, WhoStepsOutOfACarThatLeavesItsFloorUnderHimStaysInIt) {
  people({{.at = Time(1s), .from = 2, .to = 3}});
  run_until(Time(10s));
  crowd->car_changed(Time(10s), 1, open_at(2));
  run_until(Time(20s));
  crowd->car_changed(Time(20s), 1, away);
  run_until(Time(30s));
  crowd->car_changed(Time(30s), 1, open_at(3));
  run_until(Time(30'100ms));
  ASSERT_EQ(state(0), PassengerState::leaving);
  crowd->car_changed(Time(30'100ms), 1, away);
  run_until(Time(40s));
  EXPECT_EQ(state(0), PassengerState::riding);
  EXPECT_EQ(crowd->riding(1).size(), 1U);
  crowd->car_changed(Time(40s), 1, open_at(3));
  run_until(Time(50s));
  EXPECT_EQ(state(0), PassengerState::served);
}

TEST_F(CrowdTest, NobodyBoardsACarThatGoesTheOtherWay) {
  people({{.at = Time(1s), .from = 2, .to = 5}});
  run_until(Time(10s));
  crowd->car_changed(Time(10s), 1, open_at(2, Direction::down));
  run_until(Time(20s));
  EXPECT_EQ(state(0), PassengerState::waiting);
}

TEST_F(CrowdTest, NobodyBoardsAFullCarAndWhoIsLeftBehindPressesAgain) {
  std::vector<Arrival> five(5, {.at = Time(1s), .from = 2, .to = 5});
  people(five);
  run_until(Time(2s));
  crowd->hall_lamp({2, Direction::up}, true);
  crowd->car_changed(Time(10s), 1, open_at(2, Direction::up));
  crowd->hall_lamp({2, Direction::up}, false);
  crowd->car_lamp({1, 5}, true);
  run_until(Time(20s));
  EXPECT_EQ(crowd->riding(1).size(), 4U);
  EXPECT_EQ(crowd->waiting(2).size(), 1U);
  take_diary();
  crowd->car_changed(Time(20s), 1, away);
  run_until(Time(20'700ms));
  EXPECT_EQ(take_diary(), Diary{"up 2 pressed"});
}

TEST_F(CrowdTest, WhoFindsNoPlaceWaitsUntilTheFullCarHasLeftBeforeHePresses) {
  std::vector<Arrival> five(5, {.at = Time(1s), .from = 2, .to = 5});
  people(five);
  run_until(Time(2s));
  crowd->car_changed(Time(10s), 1, open_at(2, Direction::up));
  run_until(Time(18s));
  take_diary();
  crowd->car_lamp({1, 5}, true);
  run_until(Time(60s));
  EXPECT_EQ(std::count(diary.begin(), diary.end(), "up 2 pressed"), 0);
  crowd->car_changed(Time(60s), 1, away);
  run_until(Time(60'600ms));
  EXPECT_EQ(std::count(diary.begin(), diary.end(), "up 2 pressed"), 1);
}

TEST_F(CrowdTest, TheLastOneStepsOutOfACarThatSaysItIsOverloaded) {
  std::vector<Arrival> two(2, {.at = Time(1s), .from = 2, .to = 5});
  people(two);
  crowd->car_changed(Time(10s), 1, open_at(2, Direction::up));
  run_until(Time(13s));
  ASSERT_EQ(crowd->riding(1).size(), 2U);
  CarView overloaded = open_at(2, Direction::up);
  overloaded.overload = true;
  crowd->car_changed(Time(13s), 1, overloaded);
  run_until(Time(14'500ms));
  ASSERT_EQ(crowd->riding(1).size(), 1U);
  crowd->car_changed(Time(14'500ms), 1, open_at(2, Direction::up));
  run_until(Time(40s));
  EXPECT_EQ(crowd->riding(1).size(), 1U) << "he does not try again while the door is open";
  EXPECT_EQ(crowd->waiting(2).size(), 1U);
  crowd->car_changed(Time(40s), 1, away);
  crowd->car_changed(Time(50s), 1, open_at(2, Direction::up));
  run_until(Time(60s));
  EXPECT_EQ(crowd->riding(1).size(), 2U);
}

TEST_F(CrowdTest, PatienceEnds) {
  options.patience_least = options.patience_most = 60s;
  people({{.at = Time(1s), .from = 2, .to = 5}});
  run_until(Time(61s) - Duration(1));
  EXPECT_EQ(state(0), PassengerState::waiting);
  EXPECT_EQ(crowd->longest_wait(Time(60s)), 59s);
  run_until(Time(61s));
  EXPECT_EQ(state(0), PassengerState::gave_up);
  EXPECT_EQ(crowd->statistics().gave_up_count(), 1U);
  EXPECT_EQ(crowd->waiting_count(), 0U);
}

TEST_F(CrowdTest, AHandStopsAClosingDoorForOneWhoComesLate) {
  options.stops_closing_door = 1;
  people({{.at = Time(10s), .from = 2, .to = 5}});
  crowd->car_changed(Time(5s), 1, open_at(2, Direction::up));
  run_until(Time(9s));
  CarView closing = open_at(2, Direction::up);
  closing.door = DoorView::opening;
  crowd->car_changed(Time(9s), 1, closing);
  run_until(Time(10s));
  take_diary();
  closing.door = DoorView::closing;
  crowd->car_changed(Time(10s), 1, closing);
  EXPECT_EQ(take_diary(), Diary{"barrier broken"});
}

TEST_F(CrowdTest, ADoorIsHeldByTheButtonForOneWhoComesLate) {
  options.holds_door = 1;
  options.hold_least = options.hold_most = 4s;
  people({{.at = Time(1s), .from = 2, .to = 5}});
  crowd->car_changed(Time(10s), 1, open_at(2));
  run_until(Time(11'300ms));
  EXPECT_EQ(diary.end()[-2], "door held");
  take_diary();
  run_until(Time(15'200ms));
  EXPECT_EQ(diary.back(), "door let go");
}

TEST_F(CrowdTest, WithDestinationControlPeopleSayWhereToAndTakeTheLiftThatTheyAreTold) {
  options.destination_control = true;
  people({{.at = Time(1s), .from = 2, .to = 5}});
  run_until(Time(2s));
  EXPECT_EQ(take_diary(), Diary{"from 2 to 5"});
  crowd->assigned({2, 5}, 2);
  run_until(Time(20s));
  EXPECT_TRUE(diary.empty());
  crowd->car_changed(Time(20s), 1, open_at(2));
  run_until(Time(25s));
  EXPECT_EQ(state(0), PassengerState::waiting);
  crowd->car_changed(Time(25s), 2, open_at(2));
  run_until(Time(30s));
  EXPECT_EQ(crowd->riding(2).size(), 1U);
  for (const std::string& what : diary) EXPECT_FALSE(what.starts_with("car "));
}

TEST_F(CrowdTest, WithDestinationControlAnAnswerIsThatOfWhoAsked) {
  options.destination_control = true;
  people({{.at = Time(1s), .from = 2, .to = 5}, {.at = Time(3s), .from = 2, .to = 5}});
  run_until(Time(2s));
  crowd->assigned({2, 5}, 2);
  run_until(Time(4s));
  EXPECT_EQ(take_diary(), (Diary{"from 2 to 5", "from 2 to 5"})) << "each one is counted";
  crowd->assigned({2, 5}, 1);
  crowd->car_changed(Time(20s), 1, open_at(2));
  run_until(Time(25s));
  EXPECT_EQ(state(0), PassengerState::waiting) << "his is lift 2";
  EXPECT_EQ(state(1), PassengerState::riding);
}

TEST_F(CrowdTest, WithDestinationControlWhoIsToldToWaitWaitsForHisLift) {
  options.destination_control = true;
  people({{.at = Time(1s), .from = 2, .to = 5}});
  run_until(Time(2s));
  crowd->assigned({2, 5}, 0);
  take_diary();
  run_until(Time(60s));
  EXPECT_EQ(take_diary(), Diary{});
  crowd->assigned({2, 5}, 2);
  crowd->car_changed(Time(61s), 2, open_at(2));
  run_until(Time(65s));
  EXPECT_EQ(state(0), PassengerState::riding);
}

TEST_F(CrowdTest, WithDestinationControlWhoIsNotFetchedForLongAsksAgain) {
  options.destination_control = true;
  options.ask_anyway = 3min;
  people({{.at = Time(1s), .from = 2, .to = 5}});
  run_until(Time(2s));
  crowd->assigned({2, 5}, 2);
  take_diary();
  run_until(Time(181s));
  EXPECT_EQ(take_diary(), Diary{});
  run_until(Time(185s));
  EXPECT_EQ(take_diary(), Diary{"from 2 to 5"});
}

TEST_F(CrowdTest, WithDestinationControlTheLastAnswerHolds) {
  options.destination_control = true;
  people({{.at = Time(1s), .from = 2, .to = 5}});
  run_until(Time(2s));
  crowd->assigned({2, 5}, 2);
  crowd->assigned({2, 5}, 1);
  crowd->car_changed(Time(20s), 2, open_at(2));
  run_until(Time(25s));
  EXPECT_EQ(state(0), PassengerState::waiting);
  crowd->car_changed(Time(25s), 1, open_at(2));
  run_until(Time(30s));
  EXPECT_EQ(crowd->riding(1).size(), 1U);
}

TEST_F(CrowdTest, WhoIsNotBroughtWhereHeSaidPressesInTheCar) {
  options.destination_control = true;
  people({{.at = Time(1s), .from = 2, .to = 5}});
  run_until(Time(2s));
  crowd->assigned({2, 5}, 1);
  crowd->car_changed(Time(10s), 1, open_at(2));
  run_until(Time(15s));
  crowd->car_changed(Time(15s), 1, away);
  take_diary();
  run_until(Time(40s));
  EXPECT_EQ(take_diary(), Diary{});
  run_until(Time(50s));
  EXPECT_EQ(take_diary().at(0), "car 1 floor 5 pressed");
}

TEST_F(CrowdTest, EverybodyLeavesACarThatIsEvacuatedAndNobodyBoards) {
  people({{.at = Time(1s), .from = 2, .to = 5}, {.at = Time(20s), .from = 1, .to = 5}});
  crowd->car_changed(Time(5s), 1, open_at(2));
  run_until(Time(10s));
  crowd->car_changed(Time(10s), 1, away);
  CarView fire = open_at(1);
  fire.evacuates = true;
  fire.accepts = false;
  crowd->car_changed(Time(30s), 1, fire);
  run_until(Time(50s));
  EXPECT_EQ(state(0), PassengerState::evacuated);
  EXPECT_EQ(state(1), PassengerState::waiting);
}

TEST_F(CrowdTest, PeopleLeaveACarThatStandsOpenAndDoesNotGoOnAndTryAnother) {
  people({{.at = Time(1s), .from = 2, .to = 5}});
  crowd->car_changed(Time(5s), 1, open_at(2));
  run_until(Time(5s) + options.patience_in_car);
  run_until(Time(100s));
  EXPECT_EQ(crowd->riding(1).size(), 0U);
  crowd->car_changed(Time(101s), 2, open_at(2));
  run_until(Time(110s));
  EXPECT_EQ(crowd->riding(2).size(), 1U);
}

TEST_F(CrowdTest, CarsThatLeaveTheMainFloorWithPeopleAreCounted) {
  people({{.at = Time(1s), .from = 1, .to = 5}});
  crowd->car_changed(Time(5s), 1, open_at(1));
  run_until(Time(20s));
  crowd->car_changed(Time(20s), 1, away);
  crowd->car_changed(Time(30s), 2, open_at(1));
  crowd->car_changed(Time(40s), 2, away);
  EXPECT_EQ(crowd->departures().count(), 1U);
}

TEST_F(CrowdTest, WishesThatTheBuildingCannotFulfilAreNone) {
  people({{.at = Time(1s), .from = 2, .to = 2},
          {.at = Time(2s), .from = 0, .to = 2},
          {.at = Time(3s), .from = 1, .to = 6}});
  run_until(Time(60s));
  EXPECT_TRUE(crowd->passengers().empty());
}

}  // namespace
}  // namespace canvoy::lift::crowd_test
