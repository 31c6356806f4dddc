// Compares people with the classical calculation of an up-peak: cars that do only what it assumes
// must reach its interval and its handling capacity.
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "canvoy/worlds/lift/crowd.hpp"
#include "canvoy/worlds/lift/round_trip_time.hpp"

namespace canvoy::lift::up_peak_test {
namespace {

Duration of_seconds(double seconds) {
  return Duration(std::llround(seconds * 1e6));
}

/// Waits at the main floor until it is full, takes all passengers up floor by floor, and returns.
class IdealCar {
 public:
  IdealCar(const Building& building, LiftNumber number) : building_(&building), number_(number) {}

  Time deadline() const { return next_; }
  void advance(Time now, Crowd& crowd) {
    switch (step_) {
      case Step::open:
        crowd.car_changed(now, number_, view(DoorView::open));
        step_ = Step::transfer;
        next_ = now + 20ms;
        return;
      case Step::transfer:
        return wait(now, crowd);
      case Step::leave:
        crowd.car_changed(now, number_, view(DoorView::closed));
        return travel(now, crowd);
    }
  }

 private:
  enum class Step { open, transfer, leave };

  CarView view(DoorView door) const {
    return {.floor = door == DoorView::closed ? no_floor : floor_, .door = door};
  }
  /// Waits until the car is full, or until all passengers for the floor have left.
  void wait(Time now, const Crowd& crowd) {
    next_ = now + 20ms;
    const auto riders = crowd.riding(number_);
    const bool is_main = floor_ == building_->main_floor;
    if (is_main && riders.size() < persons_max()) return;
    for (const PassengerId who : riders) {
      if (crowd.passengers()[who].wish.to == floor_) return;
    }
    if (crowd.load_kg(number_) > 0 && riders.empty()) return;
    step_ = Step::leave;
    next_ = now + of_seconds(building_->lift(number_).door.close_time_s);
  }
  std::size_t persons_max() const { return 10; }
  void travel(Time now, const Crowd& crowd) {
    std::set<FloorNumber> wanted;
    for (const PassengerId who : crowd.riding(number_)) {
      wanted.insert(crowd.passengers()[who].wish.to);
    }
    const FloorNumber to = wanted.empty() ? building_->main_floor : *wanted.begin();
    const LiftDesign& lift = building_->lift(number_);
    const double way_m = std::abs(building_->height_m(to) - building_->height_m(floor_));
    const double flight_s =
        flight_time_s({lift.speed_m_s, lift.acceleration_m_s2, lift.jerk_m_s3}, way_m);
    floor_ = to;
    step_ = Step::open;
    next_ = now + of_seconds(flight_s + lift.door.open_time_s);
  }

  const Building* building_;
  LiftNumber number_;
  FloorNumber floor_ = 1;
  Step step_ = Step::open;
  Time next_{};
};

/// An up-peak with so many people that the cars are always full: `lifts` cars for 10 persons,
/// `floors` floors.
DepartureStatistics up_peak(const Building& building, std::uint64_t seed) {
  PassengerOptions options{.fill_share = 1, .holds_door = 0, .seed = seed};
  options.patience_least = options.patience_most = Duration(30min);
  Crowd crowd(
      building,
      Traffic(building,
              {.pattern = TrafficPattern::up_peak, .percent_in_5_minutes = 10, .seed = seed}),
      {}, options);
  std::vector<IdealCar> cars;
  for (std::size_t i = 1; i <= building.lifts.size(); ++i) {
    cars.emplace_back(building, static_cast<LiftNumber>(i));
  }
  const auto run_until = [&](Time until) {
    while (true) {
      auto* const next = &*std::min_element(
          cars.begin(), cars.end(),
          [](const IdealCar& a, const IdealCar& b) { return a.deadline() < b.deadline(); });
      const Time at = std::min(next->deadline(), crowd.deadline());
      if (at > until) return;
      crowd.advance(at);
      if (next->deadline() <= at) next->advance(at, crowd);
    }
  };
  run_until(Time(10min));
  crowd.departures().restart();
  run_until(Time(100min));
  return crowd.departures();
}

class UpPeakTest : public testing::TestWithParam<std::uint64_t> {};

TEST_P(UpPeakTest, IntervalAndCapacityAreThoseOfTheCalculation) {
  UniformBuilding uniform{.floors = 13, .lifts = 2, .population_per_floor = 60};
  uniform.lift.car.rated_persons = 10;
  const Building building = uniform_building(uniform);
  const DepartureStatistics seen = up_peak(building, GetParam());
  const RoundTrip expected = round_trip_time(round_trip_options(building, 10));
  EXPECT_GT(seen.count(), 40U);
  EXPECT_DOUBLE_EQ(seen.persons_mean(), 10);
  EXPECT_NEAR(seen.interval_s(), expected.interval_s, expected.interval_s * 0.1);
  EXPECT_NEAR(seen.persons_in_5_minutes(), expected.persons_in_5_minutes,
              expected.persons_in_5_minutes * 0.1);
}
INSTANTIATE_TEST_SUITE_P(Seeds, UpPeakTest, testing::Values(1, 2));

}  // namespace
}  // namespace canvoy::lift::up_peak_test
