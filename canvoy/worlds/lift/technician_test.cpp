// A technician at a lift: the steps of the work, and their times.
#include "canvoy/worlds/lift/technician.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <vector>

namespace canvoy::lift::technician_test {
namespace {

using Log = std::vector<std::string>;

class TechnicianTest : public testing::Test {
 protected:
  static std::string name(TechnicianStep step) {
    constexpr const char* names[] = {"called: trip",  "called: people",    "arrives", "moves car",
                                     "lets out",      "inspects",          "resets",  "leaves",
                                     "called: fault", "called: complaint", "rides",   "restarts",
                                     "gives up"};
    return names[static_cast<std::size_t>(step)];
  }
  TechnicianHands hands() {
    return {
        .stop_switch = [this](bool is) { log.push_back(is ? "stop" : "stop released"); },
        .crank =
            [this](double speed) {
              if (can_be_cranked) log.push_back("crank " + std::to_string(speed).substr(0, 4));
              return can_be_cranked;
            },
        .hold_door = [this](bool is) { log.push_back(is ? "door held" : "door let go"); },
        .reset = [this] { log.push_back("reset"); },
        .inspection = [this](bool is) { log.push_back(is ? "inspection on" : "inspection off"); },
        .drive =
            [this](Direction way) {
              constexpr const char* names[] = {"let go", "up", "down"};
              log.push_back(names[static_cast<std::size_t>(way)]);
              car.stands = way == Direction::none || !obeys;
            },
        .restart = [this] { log.push_back("power off and on"); },
        .tell = [this](TechnicianStep step, FloorNumber) { log.push_back(name(step)); }};
  }
  /// Each second, and at deadline().
  void look_until(Time until) {
    for (; now <= until; now += 1s) sut.look(now, car);
  }
  /// Until the technician has come; earlier steps are ignored.
  void await() {
    sut.call(now, TechnicianCause::trip);
    while (!sut.is_there() && sut.is_called()) {
      log.clear();
      sut.look(now += 1s, car);
    }
  }

  Log log;
  bool can_be_cranked = true;
  bool obeys = true;
  TechnicianView car{.is_tripped = true};
  Time now{};
  Technician sut{hands(), 1};
};

TEST_F(TechnicianTest, ComesInOneToTwoAndAHalfMinutesByHisSeed) {
  std::set<Time> arrivals;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    Technician each(hands(), seed);
    each.call(Time(10s), TechnicianCause::trapped);
    each.call(Time(20s), TechnicianCause::trip);  // the technician is under way already
    Time at(10s);
    while (!each.is_there()) each.look(at += 1s, car);
    arrivals.insert(at);
  }
  EXPECT_EQ(*arrivals.begin(), Time(70s));
  EXPECT_EQ(*arrivals.rbegin(), Time(160s));
  EXPECT_GT(arrivals.size(), 60U);
}

TEST_F(TechnicianTest, InspectsAndResetsAnEmptyCar) {
  await();
  EXPECT_EQ(log, (Log{"arrives", "stop", "inspects"}));
  log.clear();
  const Time came = now;
  while (sut.is_called()) look_until(now + 1s);
  EXPECT_EQ(log, (Log{"stop released", "reset", "resets", "rides", "inspection on", "up", "let go",
                      "down", "let go", "inspection off", "leaves"}));
  // 20 to 40 s, two rides of 4 s with a pause of 3 s after each, by looks of a second each.
  EXPECT_GE(now - came, 34s);
  EXPECT_LE(now - came, 62s);
  EXPECT_FALSE(sut.has_given_up());
}

TEST_F(TechnicianTest, RidesDownFromTheUpperHalfFirst) {
  car.is_low = false;
  await();
  log.clear();
  while (sut.is_called()) look_until(now + 1s);
  EXPECT_EQ(log, (Log{"stop released", "reset", "resets", "rides", "inspection on", "down",
                      "let go", "up", "let go", "inspection off", "leaves"}));
}

TEST_F(TechnicianTest, SwitchesALiftThatDoesNotObeyOffAndOnOnceAndThenLeavesItOutOfService) {
  obeys = false;
  await();
  log.clear();
  while (sut.is_called()) look_until(now + 1s);
  EXPECT_EQ(log, (Log{"stop released", "reset", "resets", "rides", "inspection on", "up", "let go",
                      "inspection off", "power off and on", "restarts", "inspection on", "up",
                      "let go", "inspection off", "gives up", "leaves"}));
  EXPECT_TRUE(sut.has_given_up());
}

TEST_F(TechnicianTest, StopsNoCarThatMoves) {
  car = {.is_out = true, .stands = false};
  sut.call(now, TechnicianCause::fault);
  EXPECT_EQ(log, Log{"called: fault"});
  look_until(now + 5min);
  EXPECT_EQ(log, Log{"called: fault"});
  car.stands = true;
  look_until(now + 1s);
  EXPECT_EQ(log, (Log{"called: fault", "arrives", "stop", "inspects"}));
}

TEST_F(TechnicianTest, LooksAtALiftOfWhichPeopleComplainWhateverItShows) {
  car.is_tripped = false;
  sut.call(now, TechnicianCause::complaint);
  look_until(now + 3min);
  EXPECT_EQ(log[0], "called: complaint");
  EXPECT_EQ(log[1], "arrives");
}

TEST_F(TechnicianTest, MovesACarWithPeopleToTheNearestFloorFirst) {
  car.is_shut_in = true;
  car.is_empty = car.is_whole = false;
  car.to_floor_m = -1.2;
  await();
  EXPECT_EQ(log, (Log{"arrives", "stop", "crank -0.3", "moves car"}));
  log.clear();
  EXPECT_EQ(sut.deadline(), now + 4s) << "1.2 m at 0.3 m/s";
  sut.look(now + 4s - 1us, car);
  EXPECT_EQ(log, Log{});
  sut.look(now += 4s, car);
  EXPECT_EQ(log, (Log{"crank 0.00", "lets out", "door held"}));
  log.clear();
  look_until(now + 30s);
  EXPECT_EQ(log, Log{}) << "somebody is still in it";
  car.is_empty = true;
  look_until(now + 10min);
  EXPECT_EQ(log, Log{"door let go"}) << "it is not whole";
  car.is_whole = true;
  look_until(now + 2min);
  EXPECT_EQ(log,
            (Log{"door let go", "inspects", "stop released", "reset", "resets", "rides",
                 "inspection on", "up", "let go", "down", "let go", "inspection off", "leaves"}));
}

TEST_F(TechnicianTest, WhoDoesNotGetOutIsLeftInTheCar) {
  car.is_shut_in = true;
  car.is_empty = false;
  await();
  EXPECT_EQ(log, (Log{"arrives", "stop", "lets out", "door held"})) << "it is at a floor";
  log.clear();
  look_until(now + 3min - 2s);
  EXPECT_EQ(log, Log{});
  look_until(now + 3s);
  EXPECT_EQ(log, (Log{"door let go", "inspects"}));
}

TEST_F(TechnicianTest, ACarThatIsMovedElsewhereIsNotCranked) {
  can_be_cranked = false;
  car.is_shut_in = true;
  car.is_empty = false;
  car.to_floor_m = 1;
  await();
  EXPECT_EQ(log, (Log{"arrives", "stop", "inspects"}));
}

TEST_F(TechnicianTest, LeavesWhereNobodyNeedsHimAnyMore) {
  car.is_tripped = false;
  await();
  EXPECT_EQ(log, Log{"leaves"});
  EXPECT_FALSE(sut.is_called());
}

}  // namespace
}  // namespace canvoy::lift::technician_test
