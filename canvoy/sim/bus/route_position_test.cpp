#include "canvoy/sim/bus/route_position.hpp"

#include <gtest/gtest.h>

namespace canvoy::bus::route_position_test {
namespace {

/// A road to the north, some 1112 m a hundredth of a degree, with stops at its start, at 400 m and
/// at 1000 m.
BusRoute road() {
  BusRoute route;
  route.path = Path({{0, 0}, {0.01, 0}});
  route.stops.resize(3);
  route.stops[1].metres = 400;
  route.stops[2].metres = 1000;
  return route;
}

/// A vehicle with wheels and doors, and what its computer knows of its position.
class Vehicle {
 public:
  Vehicle() { position_.begin(route_, now_); }

  /// Positions are looked for each 50 ms.
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
  RoutePosition& position() { return position_; }

 private:
  void look() {
    now_ += 50ms;
    position_.sense(now_);
    position_.locate();
    if (position_.is_located()) position_.follow();
  }

  BusRoute route_ = road();
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

}  // namespace
}  // namespace canvoy::bus::route_position_test
