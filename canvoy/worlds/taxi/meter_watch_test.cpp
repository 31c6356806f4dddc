#include "canvoy/worlds/taxi/meter_watch.hpp"

#include <gtest/gtest.h>

namespace canvoy::taxi::meter_watch_test {
namespace {

using cia447::Taximeter;

cia447::TaximeterDisplay showing(Taximeter state, std::uint32_t total = 5000) {
  return {.state = state,
          .trip = {.fare = total,
                   .supplements = 0,
                   .total = total,
                   .distance = 1200,
                   .start = 1'795'284'000}};
}

TEST(MeterWatch, ATripHasEndedWhenTheMeterIsForHireAgain) {
  MeterWatch sut(30s);
  EXPECT_EQ(sut.look(Time(1s), showing(Taximeter::for_hire)), std::nullopt) << "of before";
  EXPECT_EQ(sut.look(Time(2s), showing(Taximeter::hired)), std::nullopt);
  EXPECT_EQ(sut.look(Time(3s), showing(Taximeter::stopped)), std::nullopt);
  EXPECT_EQ(sut.look(Time(4s), showing(Taximeter::for_hire, 5100)), 5100);
  EXPECT_EQ(sut.look(Time(5s), showing(Taximeter::for_hire, 5100)), std::nullopt) << "once";
}

struct Cut {
  Duration length;
  Taximeter state;
  std::uint32_t total;
  std::uint64_t wrong;
};
class MeterWatchCut : public testing::TestWithParam<Cut> {};

TEST_P(MeterWatchCut, LeavesTheTripInADefinedWay) {
  MeterWatch sut(30s);
  sut.look(Time(1s), showing(Taximeter::hired));
  sut.power_changes(Time(2s), false);
  const Time back = Time(2s) + GetParam().length;
  EXPECT_EQ(sut.look(back, {.state = Taximeter::not_available}), std::nullopt);
  sut.power_changes(back, true);
  const auto ended = sut.look(back + 1s, showing(GetParam().state, GetParam().total));
  EXPECT_EQ(ended.has_value(), GetParam().state == Taximeter::for_hire);
  EXPECT_EQ(sut.cuts(), 1u);
  EXPECT_EQ(sut.wrong_ends(), GetParam().wrong);
}

constexpr Cut cuts[] = {
    {5s, Taximeter::hired, 5000, 0},      {5s, Taximeter::hired, 4900, 1},  // some of it is lost
    {5s, Taximeter::for_hire, 5000, 1},                                     // an engine was started
    {5s, Taximeter::stopped, 5000, 1},    {30s, Taximeter::hired, 5000, 0},
    {30s, Taximeter::for_hire, 5000, 0},  // its clock has whole seconds
    {1min, Taximeter::for_hire, 5000, 0}, {1min, Taximeter::for_hire, 0, 1},
    {1min, Taximeter::hired, 5000, 1}};
INSTANTIATE_TEST_SUITE_P(Each, MeterWatchCut, testing::ValuesIn(cuts));

TEST(MeterWatch, ADisplayThatStaysDarkWithPowerIsWrong) {
  MeterWatch sut(30s);
  sut.look(Time(1s), showing(Taximeter::hired));
  sut.power_changes(Time(2s), false);
  sut.power_changes(Time(3s), true);
  sut.look(Time(6s), {.state = Taximeter::not_available});
  EXPECT_EQ(sut.wrong_ends(), 0u);
  sut.look(Time(7s), {.state = Taximeter::not_available});
  EXPECT_EQ(sut.wrong_ends(), 1u);
}

TEST(MeterWatch, WithoutATripThereIsNothingToLose) {
  MeterWatch sut(30s);
  sut.look(Time(1s), showing(Taximeter::for_hire));
  sut.power_changes(Time(2s), false);
  sut.power_changes(Time(3s), true);
  sut.look(Time(4s), showing(Taximeter::signed_off));
  EXPECT_EQ(sut.cuts(), 0u);
}

}  // namespace
}  // namespace canvoy::taxi::meter_watch_test
