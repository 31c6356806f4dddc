#include "canvoy/worlds/bus_line/route_match.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace canvoy::bus_line::route_match_test {
namespace {

/// To the north and back on the same street, about 1112 m each way.
Path there_and_back() {
  return Path({{0, 0}, {0.01, 0}, {0, 0}});
}

TEST(BusPathPlaces, AStreetThatIsDrivenThereAndBackHasTwo) {
  const Path path = there_and_back();
  const std::vector<double> places = path.places_near(path.at(400), 60);
  ASSERT_EQ(places.size(), 2U);
  EXPECT_NEAR(places[0], 400, 0.1);
  EXPECT_NEAR(places[1], path.metres() - 400, 0.1);
}

/// 11 m is a ten-thousandth of a degree.
TEST(BusPathPlaces, ACornerHasOne) {
  const Path path({{0, 0}, {0.01, 0}, {0.01, 0.01}});
  EXPECT_EQ(path.places_near({0.0101, 0.0001}, 60).size(), 1U);
  EXPECT_EQ(path.places_near({0.005, 0.005}, 60).size(), 0U);
}

TEST(RouteMatch, TheWheelsTellWhichHalfOfTheStreetItIs) {
  const Path path = there_and_back();
  RouteMatch match;
  match.take(path, path.at(400), 0);
  EXPECT_FALSE(match.metres(0, 0)) << "there or back";
  for (double driven = 10; driven <= 70; driven += 10)
    match.take(path, path.at(400 + driven), driven);
  ASSERT_TRUE(match.metres(70, 0));
  EXPECT_NEAR(*match.metres(70, 0), 470, 1);
  EXPECT_FALSE(match.metres(70, 100)) << "met for 70 m";
}

TEST(RouteMatch, WhoDrivesTheOtherWayIsNotOnTheRoute) {
  const Path path({{0, 0}, {0.01, 0}});
  RouteMatch match;
  for (double driven = 0; driven <= 300; driven += 10)
    match.take(path, path.at(800 - driven), driven);
  EXPECT_FALSE(match.metres(300, 50));
}

}  // namespace
}  // namespace canvoy::bus_line::route_match_test
