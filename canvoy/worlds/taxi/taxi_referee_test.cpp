// Referees of a taxi that the sabotage of another one would hide: each breaks alone. And shifts
// without events, or with sleep in the middle of them.
#include <gtest/gtest.h>

#include <algorithm>

#include "canvoy/can/testing/tries_all.hpp"
#include "canvoy/worlds/taxi/taxi_network.hpp"

namespace canvoy::taxi::taxi_referee_test {
namespace {

/// Trips take minutes.
TaxiOptions evening_shift() {
  TaxiOptions options;
  options.length = 4h;
  options.alarm = 1h;
  options.shift.waiting_max = 30s;
  options.shift.trip_max_metres = 2000;
  return options;
}

std::string broken(const TaxiNetwork& network) {
  std::string names;
  for (const Invariant& invariant : network.invariants()) {
    if (!invariant.held) names += std::string(invariant_name(invariant.kind).name) + " ";
  }
  return names;
}

TEST(TaxiReferee, WheelsThatAreTooLargeWhereTimeAloneCosts) {
  static constexpr cia447::TariffLevel by_time[] = {
      {.name = {'1', 0}, .initial_fare = 3900, .time_rate = 33'000, .increment = 100}};
  TaxiOptions options = evening_shift();
  options.meter.tariff = options.tariff_of_town = {.id = 1, .levels = by_time};
  options.car.wheel_circumference_m = 2.1;  // the meter's k is of wheels of 2 m
  TaxiNetwork network(options);
  network.run_until(Time(25min));
  EXPECT_EQ(broken(network), "distance ");
}

TEST(TaxiReferee, AMeterThatObeysTooLate) {
  TaxiNetwork network(evening_shift());
  while (network.snapshot().driver != Activity::hiring && network.now() < Time(2h)) {
    network.run_until(network.now() + 100ms);
    const Activity driver = network.snapshot().driver;
    network.sabotage().blocks_keys = driver == Activity::boarding || driver == Activity::hiring;
  }
  ASSERT_EQ(network.snapshot().driver, Activity::hiring);
  network.run_until(network.now() + 5s);
  network.sabotage().blocks_keys = false;
  network.run_until(Time(25min));
  EXPECT_EQ(broken(network), "no_service ");
}

/// Invariants that are broken after 126 minutes with a driver who begins at `begin`, and whether
/// all are decided.
std::string broken_with(const ScheduledFault& fault, Time begin) {
  TaxiOptions options = evening_shift();
  options.shift.begin = begin;
  options.faults.faults = {fault};
  TaxiNetwork network(options);
  network.run_until(Time(126min));
  const auto carried = static_cast<std::size_t>(InvariantKind::carried);
  return broken(network) +
         (network.invariants().at(carried).is_decided() ? "decided" : "undecided");
}

TEST(TaxiReferee, TimeThatAFaultExcusesIsNoneInWhichSomebodyIsCarried) {
  constexpr Time oversleeps(126min);
  const auto until = [](Duration end) {
    return ScheduledFault{.duration = end, .node = taximeter_id};
  };
  EXPECT_EQ(broken_with(until(10min), oversleeps), "undecided");
  EXPECT_EQ(broken_with(until(2min), oversleeps), "carried decided")
      << "more than two hours are left";
  const ScheduledFault at_last{.start = Time(122min), .node = alarm_id};
  EXPECT_EQ(broken_with(at_last, oversleeps), "carried decided") << "two hours were before it";
  EXPECT_EQ(broken_with(at_last, Time(2min)), "decided");
  if (!tries_all()) return;
  EXPECT_EQ(broken_with(until(for_the_rest), oversleeps), "undecided") << "its end is not known";
  EXPECT_EQ(broken_with(until(3h), oversleeps), "undecided");
}

TEST(TaxiReferee, ANavigationThatLeadsElsewhere) {
  TaxiNetwork network(evening_shift());
  while (network.snapshot().driver != Activity::carrying && network.now() < Time(2h)) {
    network.run_until(network.now() + 1s);
  }
  network.run_until(network.now() + 10s);
  ASSERT_EQ(broken(network), "");
  // A person selects another place at the system itself, ten kilometres away.
  network.navigation().select({48.05, 11.575});
  network.world().touched(navigation_id - SlotIndex{1});
  network.run_until(network.now() + 10s);
  EXPECT_EQ(broken(network), "terminal_place ");
}

TEST(TaxiShifts, OfASecondAndOfAMinuteHaveNoTripAndHold) {
  for (const Duration length : {Duration(1s), Duration(1min), Duration(5min)}) {
    TaxiOptions options = evening_shift();
    options.length = length;
    TaxiNetwork network(options);
    network.run_until(Time(length));
    EXPECT_EQ(broken(network), "");
    EXPECT_EQ(network.trips().size(), 0u);
  }
}

TEST(TaxiShifts, OfWhatHappensWhileAllSleepTheyLearnWhenTheyWakeUp) {
  TaxiOptions options = evening_shift();
  options.shift.waiting_max = 24h;
  TaxiNetwork network(options);
  constexpr std::size_t vacant = 1;  // lamp 2 (4.2.16.4)
  cia447::CarMaster& master = *network.node(cia447::gateway_node_id).device().master();
  const auto touch_all = [&] {
    for (SlotIndex slot = 0; slot < device_names.size(); ++slot) network.world().touched(slot);
  };
  network.run_until(Time(3min));
  ASSERT_EQ(network.snapshot().lamps[vacant], cia447::Lamp::on);
  master.send_to_sleep();
  touch_all();
  network.run_until(Time(4min));
  ASSERT_TRUE(network.snapshot().is_asleep);
  const std::uint64_t frames = network.world().bus().statistics().frames;
  network.meter().hire();
  touch_all();
  network.run_until(Time(5min));
  EXPECT_EQ(network.world().bus().statistics().frames, frames) << "a sleeping device is silent";
  master.wake_up();
  touch_all();
  network.run_until(Time(5min + 20s));
  EXPECT_EQ(network.snapshot().lamps[vacant], cia447::Lamp::off);
  EXPECT_EQ(network.snapshot().screens[0].holder, taximeter_id);
  EXPECT_NE(network.snapshot().screens[0].text.find("FARE"), std::string::npos);
  EXPECT_EQ(network.snapshot().screens[1].holder, driver_id);
  EXPECT_EQ(broken(network), "");
}

}  // namespace
}  // namespace canvoy::taxi::taxi_referee_test
