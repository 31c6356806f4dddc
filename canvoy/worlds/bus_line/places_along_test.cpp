#include "canvoy/worlds/bus_line/places_along.hpp"

#include <gtest/gtest.h>

namespace canvoy::bus_line::places_along_test {
namespace {

/// The path goes to the end and returns along the same street.
TEST(PlacesAlong, StopsStandOnTheirWayInTheirOrder) {
  const Path path({{0, 0}, {0, 0.02}, {0, 0}});
  const std::vector<double> metres =
      places_along(path, {{0.0001, 0.005}, {0.0001, 0.015}, {-0.0001, 0.01}, {0, 0.001}});
  const double degree = path.metres() / 0.04;
  EXPECT_NEAR(metres[0], 0.005 * degree, 1);
  EXPECT_NEAR(metres[1], 0.015 * degree, 1);
  EXPECT_NEAR(metres[2], 0.03 * degree, 1);
  EXPECT_NEAR(metres[3], 0.039 * degree, 1);
}

/// Two points make a path; the way east has no part in it.
TEST(PlacesAlong, StopsOfAStreetToTheNorthAreWhereTheyAre) {
  const Path path({{0, 0}, {0.02, 0}});
  const double degree = path.metres() / 0.02;
  const std::vector<double> metres = places_along(path, {{0.00512, 0.0001}, {0.01507, -0.0001}});
  EXPECT_NEAR(metres[0], 0.00512 * degree, 1);
  EXPECT_NEAR(metres[1], 0.01507 * degree, 1);
}

TEST(PlacesAlong, WithoutAPathAllAreAtItsBeginning) {
  EXPECT_EQ(places_along(Path({{0, 0}}), {{0, 0.01}, {0, 0.02}}), (std::vector<double>{0, 0}));
}

}  // namespace
}  // namespace canvoy::bus_line::places_along_test
