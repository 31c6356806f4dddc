// The search for a home switch, by each method of CiA 402 that uses an edge of it: a simple
// simulated car that starts below, at and above the switch. Limit switches are at -20000 and 40000,
// index pulses every 4000 increments.
#include "canvoy/devices/cia417/drive/drive_homing.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace canvoy::cia417::drive_homing_test {
namespace {

constexpr double lower_limit = -20'000;
constexpr double upper_limit = 40'000;
constexpr double index_pitch = 4'000;
constexpr double endless = std::numeric_limits<double>::infinity();

/// Where a switch is on.
struct Zone {
  double from;
  double to;
};
constexpr Zone above{10'000, endless};
constexpr Zone below{-endless, 10'000};
constexpr Zone piece{10'000, 13'000};

/// A car that turns at once, 20 increments a step.
class Car {
 public:
  Car(Zone zone, double position, bool mirrored)
      : zone_(zone), sign_(mirrored ? -1 : 1), position_(position) {}

  DriveReadings sense() const {
    DriveReadings seen;
    seen.position = sign_ * position_;
    seen.velocity = sign_ * moved_;
    seen.home_switch = is_on(position_);
    const auto told = [&](const std::optional<double>& place) {
      return place ? std::optional(sign_ * *place) : std::nullopt;
    };
    seen.home_position = told(edge_);
    seen.index_position = told(index_);
    if (position_ <= lower_limit) seen.lower_limit_position = sign_ * lower_limit;
    if (position_ >= upper_limit) seen.upper_limit_position = sign_ * upper_limit;
    return seen;
  }
  /// `direction` is that of the increments.
  void step(int direction) {
    moved_ = 20.0 * direction * sign_;
    const double next = position_ + moved_;
    if (is_on(next) != is_on(position_)) {
      const bool is_lower = std::abs(next - zone_.from) < std::abs(next - zone_.to);
      edge_ = is_lower ? zone_.from : zone_.to;
    }
    const double pulse = std::round(next / index_pitch) * index_pitch;
    if ((position_ - pulse) * (next - pulse) <= 0) index_ = pulse;
    position_ = next;
    lowest = std::min(lowest, position_);
    highest = std::max(highest, position_);
  }

  double lowest = endless;
  double highest = -endless;

 private:
  bool is_on(double position) const { return position >= zone_.from && position <= zone_.to; }

  Zone zone_;
  double sign_;
  double position_;
  double moved_ = 0;
  std::optional<double> edge_;
  std::optional<double> index_;
};

struct Case {
  int method;
  Zone zone;
  double begins;
  double home;
  double lowest;   ///< it goes so far,
  double highest;  ///< and so far
};

std::optional<double> search_home(int method, Car& car, bool mirrored) {
  HomingSearch search(static_cast<HomingMethod>(method));
  search.begin(car.sense(), !mirrored);
  for (int i = 0; i < 10'000; ++i) {
    const std::optional<double> home = search.look(car.sense());
    if (home) return *home * (mirrored ? -1 : 1);
    car.step(search.direction());
  }
  return std::nullopt;
}

class EdgeOfAHomeSwitch : public testing::TestWithParam<Case> {};

TEST_P(EdgeOfAHomeSwitch, IsFoundFromWhereverTheCarBegins) {
  for (const bool mirrored : {false, true}) {
    Car car(GetParam().zone, GetParam().begins, mirrored);
    EXPECT_EQ(search_home(GetParam().method, car, mirrored), GetParam().home) << mirrored;
    EXPECT_NEAR(std::min(car.lowest, GetParam().begins), GetParam().lowest, 40) << mirrored;
    EXPECT_NEAR(std::max(car.highest, GetParam().begins), GetParam().highest, 40) << mirrored;
  }
}

std::string name_of(const testing::TestParamInfo<Case>& info) {
  const std::string from = std::to_string(static_cast<int>(info.param.begins));
  return "Method" + std::to_string(info.param.method) + "From" + from;
}

// A switch that is on above 10000.
INSTANTIATE_TEST_SUITE_P(Above, EdgeOfAHomeSwitch,
                         testing::Values(Case{3, above, 0, 8'000, 0, 10'000},
                                         Case{3, above, 20'000, 8'000, 8'000, 20'000},
                                         Case{4, above, 0, 12'000, 0, 12'000},
                                         Case{4, above, 20'000, 12'000, 10'000, 20'000},
                                         Case{19, above, 0, 10'000, 0, 10'000},
                                         Case{19, above, 20'000, 10'000, 10'000, 20'000},
                                         Case{20, above, 0, 10'000, 0, 10'000},
                                         Case{20, above, 20'000, 10'000, 10'000, 20'000}),
                         name_of);
// One that is on below 10000.
INSTANTIATE_TEST_SUITE_P(Below, EdgeOfAHomeSwitch,
                         testing::Values(Case{5, below, 20'000, 12'000, 10'000, 20'000},
                                         Case{5, below, 0, 12'000, 0, 12'000},
                                         Case{6, below, 20'000, 8'000, 8'000, 20'000},
                                         Case{6, below, 0, 8'000, 0, 10'000},
                                         Case{21, below, 20'000, 10'000, 10'000, 20'000},
                                         Case{21, below, 0, 10'000, 0, 10'000},
                                         Case{22, below, 20'000, 10'000, 10'000, 20'000},
                                         Case{22, below, 0, 10'000, 0, 10'000}),
                         name_of);
// A switch that is on from 10000 to 13000; methods 7 to 10 start upwards.
INSTANTIATE_TEST_SUITE_P(
    PieceUpwards, EdgeOfAHomeSwitch,
    testing::Values(
        Case{7, piece, 0, 8'000, 0, 10'000}, Case{7, piece, 11'000, 8'000, 8'000, 11'000},
        Case{7, piece, 20'000, 8'000, 8'000, 40'000}, Case{8, piece, 0, 12'000, 0, 12'000},
        Case{8, piece, 11'000, 12'000, 10'000, 12'000},
        Case{8, piece, 20'000, 12'000, 10'000, 40'000}, Case{9, piece, 0, 12'000, 0, 13'000},
        Case{9, piece, 11'000, 12'000, 11'000, 13'000},
        Case{9, piece, 20'000, 12'000, 12'000, 40'000}, Case{10, piece, 0, 16'000, 0, 16'000},
        Case{10, piece, 11'000, 16'000, 11'000, 16'000},
        Case{10, piece, 20'000, 16'000, 13'000, 40'000}, Case{23, piece, 0, 10'000, 0, 10'000},
        Case{23, piece, 20'000, 10'000, 10'000, 40'000},
        Case{24, piece, 11'000, 10'000, 10'000, 11'000}, Case{25, piece, 0, 13'000, 0, 13'000},
        Case{26, piece, 20'000, 13'000, 13'000, 40'000}),
    name_of);
// 11 to 14 begin downwards.
INSTANTIATE_TEST_SUITE_P(PieceDownwards, EdgeOfAHomeSwitch,
                         testing::Values(Case{11, piece, 20'000, 16'000, 13'000, 20'000},
                                         Case{11, piece, 11'000, 16'000, 11'000, 16'000},
                                         Case{11, piece, 0, 16'000, -20'000, 16'000},
                                         Case{12, piece, 20'000, 12'000, 12'000, 20'000},
                                         Case{12, piece, 11'000, 12'000, 11'000, 13'000},
                                         Case{12, piece, 0, 12'000, -20'000, 13'000},
                                         Case{13, piece, 20'000, 12'000, 10'000, 20'000},
                                         Case{13, piece, 11'000, 12'000, 10'000, 12'000},
                                         Case{13, piece, 0, 12'000, -20'000, 12'000},
                                         Case{14, piece, 20'000, 8'000, 8'000, 20'000},
                                         Case{14, piece, 11'000, 8'000, 8'000, 11'000},
                                         Case{14, piece, 0, 8'000, -20'000, 10'000},
                                         Case{27, piece, 0, 13'000, -20'000, 13'000},
                                         Case{28, piece, 20'000, 13'000, 13'000, 20'000},
                                         Case{29, piece, 11'000, 10'000, 10'000, 11'000},
                                         Case{30, piece, 0, 10'000, -20'000, 10'000}),
                         name_of);

TEST(HomeSwitch, WhereNoneTellsTheSearchForItIsNotPossible) {
  const DriveReadings none;
  for (int method = 1; method <= 37; ++method) {
    const bool wants_switch = (method >= 3 && method <= 14) || (method >= 19 && method <= 30);
    const HomingSearch search(static_cast<HomingMethod>(method));
    EXPECT_EQ(search.is_possible(none), !wants_switch) << method;
  }
}

TEST(HomeSwitch, LimitSwitchesDoNotTurnTheSearchOfMethods3To6) {
  Car car(above, -30'000, false);
  EXPECT_EQ(search_home(3, car, false), 8'000);
  Car other(below, 50'000, false);
  EXPECT_EQ(search_home(6, other, false), 8'000);
}

}  // namespace
}  // namespace canvoy::cia417::drive_homing_test
