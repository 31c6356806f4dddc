#include "canvoy/worlds/bus_line/route_position.hpp"

#include <gtest/gtest.h>

#include <utility>

namespace canvoy::bus_line::route_position_test {
namespace {

/// A road to the north, about 1112 m for a hundredth of a degree, with stops at its start, at 400 m
/// and at 1000 m.
BusRoute road() {
  BusRoute route;
  route.path = Path({{0, 0}, {0.01, 0}});
  route.stops.resize(3);
  route.stops[1].metres = 400;
  route.stops[2].metres = 1000;
  return route;
}

/// Like road(), but back, from its last stop on: stops at 0, 600 and 1000 m.
BusRoute road_back() {
  BusRoute route;
  const GeoPoint last = road().path.at(1000);
  route.path = Path({last, {0, 0}});
  route.stops.resize(3);
  route.stops[1].metres = 600;
  route.stops[2].metres = 1000;
  return route;
}

/// A vehicle with wheels and doors, and the position that its computer determines.
class Vehicle {
 public:
  explicit Vehicle(BusRoute route = road()) : route_(std::move(route)) {
    position_.begin(route_, now_);
  }
  /// Sets another journey.
  void begin(const BusRoute& route) { position_.begin(route, now_); }

  /// The position is read each 50 ms.
  void go(double metres, double metres_per_second = 10) {
    const double step = metres_per_second * 0.05;
    for (const double end = odometer_ + metres; odometer_ < end - step / 2;) {
      odometer_ += step;
      look();
    }
  }
  void stand(Duration time) {
    for (const Time end = now_ + time; now_ < end;) look();
  }
  void open_door(bool is_open) { door_is_open_ = is_open; }
  void fix(double metres) { position_.take_fix(route_.path.at(metres)); }
  void fix(const GeoPoint& point) { position_.take_fix(point); }
  void lose_satellites() { position_.take_fix({}); }
  /// Drives with a position each second, on this path from `from` m on.
  void go_on(const Path& path, double from, double metres, double metres_per_second = 10) {
    for (double at = 0; at < metres; at += metres_per_second) {
      go(metres_per_second, metres_per_second);
      fix(path.at(from + at + metres_per_second));
      look();
    }
  }
  /// Drives from the first stop of the road to its last one, and stands there.
  void drive_to_the_end() {
    fix(0);
    go(400);
    stand(1s);
    go(600);
  }
  RoutePosition& position() { return position_; }

 private:
  void look() {
    now_ += 50ms;
    position_.sense(now_);
    position_.locate();
    if (position_.is_located()) position_.follow();
  }

  BusRoute route_;
  Time now_{};
  double odometer_ = 0;
  bool door_is_open_ = false;
  RoutePosition position_{
      {.odometer =
           Callback<double()>([](void* it) { return static_cast<Vehicle*>(it)->odometer_; }, this),
       .has_open_door = Callback<bool()>(
           [](void* it) { return static_cast<Vehicle*>(it)->door_is_open_; }, this)}};
};

TEST(RoutePosition, WithoutAPositionItDoesNotKnowWhereItIs) {
  Vehicle vehicle;
  vehicle.stand(1min);
  EXPECT_FALSE(vehicle.position().is_located());
  EXPECT_FALSE(vehicle.position().knows_stop());
}

TEST(RoutePosition, AtTheFirstStopAJourneyBegins) {
  Vehicle vehicle;
  vehicle.fix(5);
  vehicle.stand(1s);
  EXPECT_TRUE(vehicle.position().is_located());
  EXPECT_EQ(vehicle.position().place(), 0U);
  vehicle.go(10);
  EXPECT_EQ(vehicle.position().place(), 1U);
  EXPECT_EQ(vehicle.position().reached(), 0U);
}

TEST(RoutePosition, WhoRollsNearTheFirstStopIsNotAtIt) {
  Vehicle vehicle;
  vehicle.go(8, 3);
  vehicle.fix(8);
  vehicle.stand(50ms);  // a look before the next pulse
  EXPECT_FALSE(vehicle.position().is_located());
  vehicle.go(22, 5);
  vehicle.fix(30);
  vehicle.go(371, 5);
  EXPECT_EQ(vehicle.position().reached(), 0U) << "a metre beyond the stop it may stand yet";
  vehicle.go(17, 5);
  // Within 16.7 m it can stop: that is 34.7 m beyond the stop, and would be 26.7 m from 8 m on.
  EXPECT_EQ(vehicle.position().reached(), 1U);
}

TEST(RoutePosition, AStopIsReachedWhereItStands) {
  Vehicle vehicle;
  vehicle.fix(0);
  vehicle.go(399);
  EXPECT_EQ(vehicle.position().reached(), 0U);
  vehicle.stand(1s);
  EXPECT_EQ(vehicle.position().reached(), 1U);
  EXPECT_EQ(vehicle.position().place(), 1U);
}

TEST(RoutePosition, AStopAtWhichItDoesNotStandIsPassed) {
  Vehicle vehicle;
  vehicle.fix(0);
  vehicle.go(405);
  EXPECT_EQ(vehicle.position().reached(), 1U);
  EXPECT_EQ(vehicle.position().place(), 2U);
}

TEST(RoutePosition, WhereDoorsOpenItIsAtTheStopThoughPulsesSayOtherwise) {
  Vehicle vehicle;
  vehicle.fix(0);
  vehicle.go(380);
  vehicle.stand(1s);
  EXPECT_EQ(vehicle.position().reached(), 0U);
  vehicle.open_door(true);
  vehicle.stand(1s);
  EXPECT_EQ(vehicle.position().reached(), 1U);
}

TEST(RoutePosition, OneThatBeginsOnTheWayKnowsTheNextStop) {
  Vehicle vehicle;
  vehicle.fix(600);
  vehicle.stand(1s);
  EXPECT_TRUE(vehicle.position().is_located());
  EXPECT_EQ(vehicle.position().place(), 2U);
  EXPECT_EQ(vehicle.position().reached(), 1U);
}

TEST(RoutePosition, FarFromItsRouteItIsNotLocated) {
  Vehicle vehicle;
  vehicle.position().take_fix(GeoPoint{0.005, 0.001});  // 111 m to the east
  vehicle.stand(1s);
  EXPECT_FALSE(vehicle.position().is_located());
}

// After trouble at the end of a journey.

TEST(RoutePosition, WithoutSatellitesTheNextJourneyBeginsWhereTheLastOneEnded) {
  const BusRoute back = road_back();
  Vehicle vehicle;
  vehicle.drive_to_the_end();
  vehicle.lose_satellites();
  vehicle.begin(back);  // before the wheels stand for long enough to be detected
  EXPECT_TRUE(vehicle.position().knows_stop());
  vehicle.stand(1s);
  EXPECT_TRUE(vehicle.position().is_located());
  EXPECT_EQ(vehicle.position().place(), 0U);
  vehicle.go(10);
  EXPECT_EQ(vehicle.position().place(), 1U);
}

TEST(RoutePosition, AnOldPositionDoesNotHideForLongThatItStandsAtTheFirstStop) {
  const BusRoute back = road_back();
  Vehicle vehicle;
  vehicle.drive_to_the_end();
  vehicle.fix(995);  // reported late
  vehicle.go(1);
  vehicle.begin(back);
  vehicle.stand(3s);
  EXPECT_TRUE(vehicle.position().is_located());
  EXPECT_EQ(vehicle.position().place(), 0U);
}

TEST(RoutePosition, AJourneyThatIsHeardOfLateHasBegunWhereItStood) {
  const BusRoute back = road_back();
  Vehicle vehicle;
  vehicle.drive_to_the_end();
  vehicle.stand(1s);
  vehicle.lose_satellites();
  vehicle.go(20);
  EXPECT_FALSE(vehicle.position().knows_stop()) << "it has left the end for somewhere";
  vehicle.go(700);
  vehicle.begin(back);
  vehicle.stand(50ms);
  EXPECT_TRUE(vehicle.position().is_located());
  EXPECT_EQ(vehicle.position().place(), 2U) << "720 m along, beyond the stop at 600 m";
}

TEST(RoutePosition, WhereTheNextJourneyBeginsElsewhereItsWayThereIsNotOnIt) {
  const BusRoute other = road();  // from 0 m, some 1000 m from the end
  Vehicle vehicle;
  vehicle.drive_to_the_end();
  vehicle.stand(1s);
  vehicle.begin(other);
  vehicle.fix(1000);
  vehicle.stand(3s);
  EXPECT_FALSE(vehicle.position().is_located());
  EXPECT_TRUE(vehicle.position().knows_stop()) << "it goes to the first stop";
  vehicle.go_on(road_back().path, 0, 900);
  EXPECT_FALSE(vehicle.position().is_located()) << "along it, the other way";
  vehicle.go_on(road_back().path, 900, 100);
  vehicle.stand(1s);
  EXPECT_TRUE(vehicle.position().is_located());
  EXPECT_EQ(vehicle.position().place(), 0U);
}

TEST(RoutePosition, WithoutSatellitesItIsAtTheFirstStopWhereTheWayThereEnds) {
  const BusRoute other = road();
  Vehicle vehicle;
  vehicle.drive_to_the_end();
  vehicle.stand(1s);
  vehicle.lose_satellites();
  vehicle.begin(other);
  vehicle.go(500);
  vehicle.stand(1s);
  EXPECT_FALSE(vehicle.position().is_located()) << "at red lights";
  vehicle.go(498);
  vehicle.stand(1s);
  EXPECT_TRUE(vehicle.position().is_located());
  EXPECT_EQ(vehicle.position().place(), 0U);
}

TEST(RoutePosition, WithoutSatellitesOneThatGoesFartherThanThereIsLost) {
  const BusRoute other = road();
  Vehicle vehicle;
  vehicle.drive_to_the_end();
  vehicle.stand(1s);
  vehicle.lose_satellites();
  vehicle.begin(other);
  vehicle.go(1050);
  EXPECT_FALSE(vehicle.position().knows_stop());
  vehicle.go_on(other.path, 50, 60);
  EXPECT_FALSE(vehicle.position().knows_stop()) << "not yet for 100 m";
  vehicle.go_on(other.path, 110, 60);
  EXPECT_TRUE(vehicle.position().is_located());
  EXPECT_EQ(vehicle.position().place(), 1U);
}

TEST(RoutePosition, PositionsThatSayAnotherPlaceAreRight) {
  Vehicle vehicle;
  vehicle.fix(0);
  vehicle.go(100);
  vehicle.fix(100);
  vehicle.fix(300);
  vehicle.fix(300);
  EXPECT_TRUE(vehicle.position().is_located()) << "two may be wrong";
  vehicle.fix(300);
  EXPECT_FALSE(vehicle.position().knows_stop());
  vehicle.go_on(road().path, 300, 150);
  EXPECT_TRUE(vehicle.position().is_located());
  EXPECT_EQ(vehicle.position().place(), 2U) << "450 m along, beyond the stop at 400 m";
}

TEST(RoutePosition, ASinglePositionIsNotBelievedAgainstTheNextOne) {
  Vehicle vehicle;
  vehicle.fix(600);  // it has waited on a disturbed bus
  vehicle.stand(1s);
  vehicle.fix(100);
  vehicle.stand(1s);
  EXPECT_TRUE(vehicle.position().is_located());
  EXPECT_EQ(vehicle.position().place(), 1U);
}

/// Stops at 400 m on the way there and at 1800 m on the way back.
TEST(RoutePosition, OnAStreetThatIsDrivenThereAndBackItWaitsForItsDirection) {
  BusRoute route;
  route.path = Path({{0, 0}, {0.01, 0}, {0, 0}});
  route.stops.resize(3);
  route.stops[1].metres = 400;
  route.stops[2].metres = 1800;
  Vehicle vehicle(route);
  vehicle.fix(1500);  // or 724 m on the way there
  vehicle.stand(1s);
  EXPECT_FALSE(vehicle.position().knows_stop());
  vehicle.go_on(route.path, 1500, 70);
  EXPECT_TRUE(vehicle.position().is_located());
  EXPECT_EQ(vehicle.position().place(), 2U);
  EXPECT_EQ(vehicle.position().reached(), 1U);
}

// Passing a stop: faster than 7 m/s, no bus stops at it.

TEST(RoutePosition, WhoRollsByAStopSlowlyMayStillStandThere) {
  Vehicle vehicle;
  vehicle.fix(0);
  vehicle.go(390);
  vehicle.go(20, 3);  // 9 / 1.5 = 6 m to stand, of 20 m
  EXPECT_EQ(vehicle.position().place(), 1U);
  vehicle.open_door(true);
  vehicle.stand(1s);
  EXPECT_EQ(vehicle.position().reached(), 1U);
}

TEST(RoutePosition, WhoRollsByAStopSlowlyHasPassedItWhereHeCannotStandThereAnyMore) {
  Vehicle vehicle;
  vehicle.fix(0);
  vehicle.go(390);
  vehicle.go(20, 5);  // 25 / 1.5 = 17 m to stand, of 20 m
  EXPECT_EQ(vehicle.position().place(), 1U);
  vehicle.go(8, 5);  // of 12 m
  EXPECT_EQ(vehicle.position().place(), 2U);
}

}  // namespace
}  // namespace canvoy::bus_line::route_position_test
