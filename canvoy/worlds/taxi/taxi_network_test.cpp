// Shifts of a taxi: all invariants hold without a fault, and after each; and each referee detects
// its errors.
#include "canvoy/worlds/taxi/taxi_network.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "canvoy/can/testing/tries_all.hpp"
#include "canvoy/worlds/car/real_device_test.hpp"

namespace canvoy::taxi::taxi_network_test {
namespace {

/// No passenger is fetched after 25 minutes: by this time the driver has gone, and the network
/// sleeps from a minute later for nineteen minutes.
constexpr Duration shift_over = 34min;
constexpr Duration awake_again = 55min;

/// Trips take minutes.
TaxiOptions short_shift(std::uint64_t seed) {
  TaxiOptions options;
  options.faults.seed = seed;
  options.length = 50min;  // the last one begins before half of it
  options.alarm = 10min;
  options.shift.waiting_max = 30s;
  options.shift.trip_max_metres = 2000;
  return options;
}

/// Trips are those of a town.
TaxiOptions evening(std::uint64_t seed) {
  TaxiOptions options;
  options.faults.seed = seed;
  options.length = tries_all() ? Duration(4h) : Duration(2h);
  return options;
}

/// Names of the broken invariants.
std::string broken(const TaxiNetwork& network) {
  std::string names;
  for (const Invariant& invariant : network.invariants()) {
    if (!invariant.held) names += std::string(invariant_name(invariant.kind).name) + " ";
  }
  return names;
}

template <class What>
std::size_t count(const TaxiNetwork& network) {
  return static_cast<std::size_t>(std::ranges::count_if(
      network.events(),
      [](const TaxiEvent& event) { return std::holds_alternative<What>(event.what); }));
}

/// Times at which the network falls asleep, and wakes up.
std::string sleep_of(const TaxiNetwork& network) {
  std::string seen;
  for (const TaxiEvent& event : network.events()) {
    const auto* changed = std::get_if<car::NetworkChanged>(&event.what);
    if (changed == nullptr) continue;
    if (changed->event.kind == cia447::CarEvent::Kind::asleep) seen += "asleep ";
    if (changed->event.kind == cia447::CarEvent::Kind::awake) seen += "awake ";
  }
  return seen;
}

TEST(TaxiShift, PeopleAreCarriedAndPayWhatTheTariffAsksAndThenTheNetworkSleepsAndWakesUp) {
  TaxiNetwork network(short_shift(1));
  network.run_until(Time(awake_again));
  EXPECT_EQ(broken(network), "");
  ASSERT_GE(network.trips().size(), 3u);
  EXPECT_EQ(count<ShiftChanged>(network), 2u) << "it begins and ends";
  EXPECT_EQ(count<AlarmPressed>(network), 1u);
  const auto& lines = network.paper().lines();
  const auto totals = std::ranges::count_if(
      lines, [](const std::string& line) { return line.starts_with("TOTAL"); });
  EXPECT_EQ(static_cast<std::size_t>(totals), network.trips().size()) << "a receipt for each";
  EXPECT_EQ(sleep_of(network), "asleep awake ");
  for (const auto& node : network.nodes()) EXPECT_TRUE(node->is_operational());
}

/// From 21:45 on, over the change to level 2 of the example's tariff at 22:00, with a meter clock
/// that is five hours behind.
constexpr Time night(15min);
TaxiOptions late_shift(std::initializer_list<ScheduledFault> faults) {
  TaxiOptions options = short_shift(1);
  options.begin += 3h + 45min;
  options.meter_clock_ahead = -5h;
  options.faults.faults = faults;
  return options;
}
/// Levels that trips were charged with before and after 22:00.
std::string levels(const TaxiNetwork& network) {
  std::string by_day;
  std::string by_night;
  for (const TaxiEvent& event : network.events()) {
    const auto* tariff = std::get_if<TariffChanged>(&event.what);
    if (tariff == nullptr) continue;
    std::string& seen = event.at < night ? by_day : by_night;
    const char level = static_cast<char>(tariff->level[0]);
    if (seen.find(level) == std::string::npos) seen += level;
  }
  return by_day + " " + by_night;
}

/// 2026-10-25: at 3:00 clocks are set to 2:00. The level of the hour from 2:00 on applies for two
/// hours.
TEST(TaxiClock, TheNightInWhichClocksAreSetBackHasItsHourTwice) {
  static constexpr cia447::TariffHours hours[] = {
      {.from = cia447::time_of_day(2, 0), .to = cia447::time_of_day(3, 0), .level = 1}};
  TaxiOptions options = short_shift(1);
  options.length = 5h;
  options.shift.waiting_max = 1min;
  options.begin = std::chrono::sys_days{std::chrono::year{2026} / 10 / 25} + 30min;
  options.zone = {.name = "CET", .offset_minutes = 60, .summer = cia447::european_summer};
  options.meter.tariff.hours = options.tariff_of_town.hours = hours;
  TaxiNetwork network(options);
  network.run_until(Time(8h));
  EXPECT_EQ(broken(network), "");
  EXPECT_EQ(car::undecided_names(network), "");
  for (const TaxiEvent& event : network.events()) {
    EXPECT_FALSE(std::holds_alternative<MeterRecorded>(event.what)) << "no clock is refused";
    const auto* tariff = std::get_if<TariffChanged>(&event.what);
    if (tariff == nullptr) continue;
    const auto since = event.at - Time{};
    const bool is_clear = since % 1h < 29min || since % 1h > 31min;  // 2:00 is 1 h 30 min on
    const bool is_in_hour = since > 90min && since < 210min;
    if (!is_clear) continue;
    EXPECT_EQ(static_cast<char>(tariff->level[0]), is_in_hour ? '2' : '1') << since / 1min;
  }
}

/// 2026-03-29: at 2:00 clocks are set to 3:00.
TEST(TownClock, ShowsNoHourInSpringAndOneTwiceInAutumn) {
  constexpr cia447::TimeZone zone = {
      .name = "CET", .offset_minutes = 60, .summer = cia447::european_summer};
  const auto seconds = [](std::chrono::year_month_day date, Duration time) {
    return (std::chrono::sys_days{date}.time_since_epoch() + time) / 1s;
  };
  const std::chrono::year_month_day autumn = std::chrono::year{2026} / 10 / 25;
  const TownClock clock(seconds(autumn, 30min), zone);
  EXPECT_EQ(clock.local(Time(2h + 30min - 1s)), seconds(autumn, 3h - 1s));
  EXPECT_EQ(clock.local(Time(2h + 30min)), seconds(autumn, 2h));
  EXPECT_EQ(clock.local(Time(3h + 30min)), seconds(autumn, 3h));
  const std::chrono::year_month_day spring = std::chrono::year{2026} / 3 / 29;
  const TownClock other(seconds(spring, 1h), zone);
  EXPECT_EQ(other.local(Time(1h - 1s)), seconds(spring, 2h - 1s));
  EXPECT_EQ(other.local(Time(1h)), seconds(spring, 3h));
}

TEST(TaxiClock, TheTariffGoesByTheClockOnTheBus) {
  TaxiNetwork network(late_shift({}));
  network.run_until(Time(shift_over));
  EXPECT_EQ(broken(network), "");
  EXPECT_EQ(levels(network), "1 2");
}

TEST(TaxiClock, TheMeterGoesOnFromItWhileItIsLost) {
  TaxiNetwork network(late_shift({{.kind = FaultKind::lost_node,
                                   .start = night - 5min,
                                   .duration = 10min,
                                   .node = driver_id}}));
  network.run_until(night + 6min);
  EXPECT_TRUE(network.node(driver_id).is_operational());
  network.run_until(Time(shift_over));
  EXPECT_EQ(broken(network), "");
  EXPECT_EQ(levels(network), "1 2");
}

TEST(TaxiClock, AndKnowsTheTimeAfterALossOfItsOwnPowerMeanwhile) {
  TaxiNetwork network(late_shift(
      {{.kind = FaultKind::lost_node, .start = night - 7min, .duration = 1h, .node = driver_id},
       {.kind = FaultKind::lost_node,
        .start = night - 2min,
        .duration = 20s,
        .node = taximeter_id}}));
  network.run_until(Time(shift_over));
  EXPECT_EQ(broken(network), "");
  EXPECT_EQ(levels(network), "1 2");
}

TEST(TaxiClock, AClockThatIsWrongMakesFaresWrong) {
  TaxiOptions options = late_shift({});
  options.clock_ahead = -2h;
  options.meter_clock_ahead = {};
  TaxiNetwork network(options);
  network.run_until(Time(shift_over));
  // The roof shows the level of a tariff that is not that of the hour.
  EXPECT_EQ(broken(network), "fare receipt_lines shift_slip roof_sign ");
}

TEST(TaxiShift, TheSameOptionsGiveTheSameShift) {
  TaxiNetwork one(short_shift(3));
  TaxiNetwork other(short_shift(3));
  one.run_until(Time(20min));
  other.run_until(Time(20min));
  EXPECT_EQ(one.world().bus().statistics().frames, other.world().bus().statistics().frames);
  EXPECT_EQ(one.drive().metres(), other.drive().metres());
  EXPECT_EQ(one.events().size(), other.events().size());
}

class TaxiSeed : public testing::TestWithParam<std::uint64_t> {};

TEST_P(TaxiSeed, AllHoldsWithoutAFault) {
  TaxiNetwork network(evening(GetParam()));
  network.run_until(Time(network.options().length));
  EXPECT_EQ(broken(network), "");
  EXPECT_GE(network.trips().size(), 2u);
}

INSTANTIATE_TEST_SUITE_P(Some, TaxiSeed, testing::Range<std::uint64_t>(4, tries_all() ? 10 : 5));

TEST(TaxiShift, GoesByADriveThatWasRecorded) {
  // 200 s at 36 km/h, a stop of 3 minutes, and 200 s at 36 km/h again.
  std::string text;
  const auto say = [&text](unsigned second, const char* speed) {
    const auto two = [](unsigned number) {
      return std::string{static_cast<char>('0' + number / 10),
                         static_cast<char>('0' + number % 10)};
    };
    std::string content = "GPRMC,12" + two(second / 60) + two(second % 60) +
                          ",A,4808.220,N,01134.500,E," + speed + ",084.4,211126,,";
    unsigned sum = 0;
    for (const char byte : content) sum ^= static_cast<unsigned char>(byte);
    constexpr std::string_view digits = "0123456789ABCDEF";
    text += "$" + content + "*" + digits[sum / 16] + digits[sum % 16] + "\n";
  };
  for (const unsigned begin : {0U, 400U}) {
    say(begin, "0");
    for (unsigned i = 1; i <= 200; ++i) say(begin + i, "19.4384");
    say(begin + 201, "0");
  }
  TaxiOptions options = short_shift(1);
  options.record = std::make_shared<const car::DriveRecord>(car::read_drive_record(text));
  TaxiNetwork network(options);
  network.run_until(Time(shift_over));
  EXPECT_EQ(broken(network), "");
  ASSERT_EQ(network.trips().size(), 2u) << "then the driver goes home";
  EXPECT_EQ(count<ShiftChanged>(network), 2u);
  for (const Trip& trip : network.trips()) EXPECT_NEAR(trip.metres, 2000, 0.1);
}

TEST(TaxiShift, TheTerminalShowsTheFareAndWhereTheCarIs) {
  TaxiNetwork network(evening(1));
  while (network.snapshot().meter != cia447::Taximeter::hired) {
    network.run_until(network.now() + 1s);
  }
  network.run_until(network.now() + 30s);
  const TaxiSnapshot now = network.snapshot();
  EXPECT_EQ(now.screens[0].holder, taximeter_id);
  EXPECT_TRUE(now.screens[0].text.starts_with("Tariff 1\nFARE")) << now.screens[0].text;
  EXPECT_EQ(now.screens[1].holder, driver_id) << "its unit asks the navigation system";
  EXPECT_NE(now.screens[1].text.find("\n> "), std::string::npos) << now.screens[1].text;
  EXPECT_TRUE(now.screens[1].text.ends_with(" km to go")) << now.screens[1].text;
  while (network.snapshot().meter != cia447::Taximeter::for_hire) {
    network.run_until(network.now() + 1s);
  }
  network.run_until(network.now() + 30s);
  EXPECT_EQ(network.snapshot().screens[0].holder, 0u) << "the car has display 1 again";
  EXPECT_TRUE(network.snapshot().screens[1].text.ends_with("\nMunich"));
}

std::size_t receipts(TaxiNetwork& network) {
  return static_cast<std::size_t>(
      std::ranges::count_if(network.paper().lines(),
                            [](const std::string& line) { return line.starts_with("Receipt "); }));
}

TEST(TaxiShift, TheLastReceiptComesWhenThereIsPaperAgain) {
  TaxiOptions options = short_shift(1);
  options.faults.faults = {{.kind = FaultKind::paper_out, .start = Time(1min), .duration = 15min}};
  TaxiNetwork network(options);
  network.run_until(Time(16min - 1ms));
  const std::size_t carried = network.trips().size();
  ASSERT_GE(carried, 2u);
  EXPECT_EQ(receipts(network), 0u);
  network.run_until(Time(16min + 10s));
  ASSERT_EQ(network.trips().size(), carried) << "nobody pays within these ten seconds";
  ASSERT_EQ(receipts(network), 1u);
  EXPECT_EQ(network.paper().lines()[2], "Receipt " + std::to_string(carried));
  network.run_until(Time(shift_over));
  EXPECT_EQ(broken(network), "");
  EXPECT_EQ(receipts(network), network.trips().size() - carried + 1);
}

TEST(TaxiShift, APrinterThatStartsLooksForPaper) {
  TaxiOptions options = short_shift(1);
  options.faults.faults = {{.kind = FaultKind::paper_out, .start = Time(1min), .duration = 15min},
                           {.kind = FaultKind::restart, .start = Time(10min), .node = printer_id}};
  TaxiNetwork network(options);
  network.run_until(Time(16min - 1ms));
  ASSERT_GE(network.trips().size(), 2u);
  EXPECT_EQ(receipts(network), 0u);
}

TEST(TaxiShift, TheTerminalNamesNoPlaceWithoutSatellites) {
  TaxiOptions options = evening(1);
  options.faults.faults = {{.kind = FaultKind::no_fix, .start = Time(20min), .duration = 10min}};
  TaxiNetwork network(options);
  network.run_until(Time(20min - 1ms));
  EXPECT_NE(network.snapshot().screens[1].text, "");
  network.run_until(Time(20min + 5s));
  EXPECT_EQ(network.snapshot().screens[1].text, "\n> Freimann")
      << "there they go, wherever they are";
  network.run_until(Time(30min + 5s));
  EXPECT_TRUE(network.snapshot().screens[1].text.find('\n') != 0);
}

/// Time at which the network of this shift has fallen asleep.
Time asleep_at(const TaxiOptions& options) {
  TaxiNetwork network(options);
  while (!network.snapshot().is_asleep && network.now() < Time(1h)) {
    network.run_until(network.now() + 1s);
  }
  return network.now();
}

TEST(TaxiShift, AGatewayThatHadNoPowerWakesTheOthersWhenItIsBack) {
  TaxiOptions options = short_shift(1);
  const ScheduledFault lost = {.kind = FaultKind::lost_node,
                               .start = asleep_at(options) + 1min,
                               .duration = 25min,
                               .node = cia447::gateway_node_id};
  options.faults.faults = {lost};
  TaxiNetwork network(options);
  network.run_until(lost.end() - 1s);
  EXPECT_FALSE(network.node(taximeter_id).is_operational());
  network.run_until(lost.end() + 20s);
  for (const auto& node : network.nodes()) {
    EXPECT_TRUE(node->is_operational()) << node->place().name;
  }
}

/// The cable is cut when the command to sleep is given, and the gateway restarts while all devices
/// sleep.
TEST(TaxiShift, ANetworkHalfAsleepDoesNotStaySo) {
  TaxiOptions options = short_shift(1);
  const Time asleep = asleep_at(options);
  const ScheduledFault cut = {.kind = FaultKind::cable_cut, .start = asleep - 10s, .duration = 20s};
  const ScheduledFault restart = {
      .kind = FaultKind::restart, .start = asleep + 5min, .node = cia447::gateway_node_id};
  options.faults.faults = {cut, restart};
  TaxiNetwork network(options);
  network.run_until(cut.end() + 30s);
  for (const auto& node : network.nodes()) {
    EXPECT_EQ(node->device().sleep().state(), cia447::SleepState::asleep) << node->place().name;
  }
  network.run_until(restart.start + 30s);
  for (const auto& node : network.nodes()) {
    EXPECT_TRUE(node->is_operational()) << node->place().name;
  }
}

TEST(TaxiShift, AMeterWithoutPowerShowsNothing) {
  TaxiOptions options = short_shift(1);
  TaxiNetwork healthy(options);
  while (healthy.snapshot().meter != cia447::Taximeter::hired && healthy.now() < Time(1h)) {
    healthy.run_until(healthy.now() + 1s);
  }
  const Time hired = healthy.now();
  options.faults.faults = {
      {.kind = FaultKind::lost_node, .start = hired + 10s, .duration = 5s, .node = taximeter_id}};
  TaxiNetwork network(options);
  network.run_until(hired + 9s);
  const std::uint32_t fare = network.snapshot().trip.fare;
  EXPECT_EQ(network.snapshot().meter, cia447::Taximeter::hired);
  EXPECT_NE(fare, cia447::TripData::unknown);
  network.run_until(hired + 12s);
  EXPECT_EQ(network.snapshot().meter, cia447::Taximeter::not_available);
  EXPECT_EQ(network.snapshot().trip.fare, cia447::TripData::unknown);
  network.run_until(hired + 20s);
  EXPECT_EQ(network.snapshot().meter, cia447::Taximeter::hired) << "it has kept the trip";
  EXPECT_GE(network.snapshot().trip.fare, fare);
  EXPECT_NE(network.snapshot().trip.fare, cia447::TripData::unknown);
}

TEST(TaxiShift, LampsAndDisplaysAreDarkWithoutPower) {
  TaxiOptions options = evening(1);
  options.faults.faults = {
      {.kind = FaultKind::lost_node, .start = Time(10min), .duration = 1min, .node = sign_id},
      {.kind = FaultKind::lost_node, .start = Time(10min), .duration = 1min, .node = terminal_id}};
  TaxiNetwork network(options);
  network.run_until(Time(10min - 1ms));
  const auto is_lit = [](cia447::Lamp lamp) { return lamp == cia447::Lamp::on; };
  EXPECT_TRUE(std::ranges::any_of(network.snapshot().lamps, is_lit));
  EXPECT_NE(network.snapshot().screens[1].text, "");
  network.run_until(Time(10min));
  EXPECT_TRUE(std::ranges::none_of(network.snapshot().lamps, is_lit));
  EXPECT_EQ(network.snapshot().screens[1].text, "");
  network.run_until(Time(11min + 20s));
  EXPECT_TRUE(std::ranges::any_of(network.snapshot().lamps, is_lit));
  EXPECT_NE(network.snapshot().screens[1].text, "");
}

// Each fault alone: state that was lost is restored, and no passenger pays too much.

struct FaultCase {
  const char* text;
};
class TaxiFault : public testing::TestWithParam<FaultCase> {};

TEST_P(TaxiFault, AloneBreaksNothing) {
  TaxiOptions options = short_shift(1);
  const ParsedFault<FaultKind> parsed = parse_fault<FaultKind>(GetParam().text);
  ASSERT_TRUE(parsed.fault) << parsed.error;
  options.faults.faults = {*parsed.fault};
  TaxiNetwork network(options);
  network.run_until(Time(25min));
  for (const auto& node : network.nodes()) {
    EXPECT_TRUE(node->is_operational()) << node->place().name;
  }
  network.run_until(Time(shift_over));
  EXPECT_EQ(broken(network), "") << GetParam().text;
  EXPECT_EQ(network.snapshot().driver, Activity::off_duty);
}

constexpr FaultCase fault_cases[] = {{"lost-node@15min+5s"},
                                     {"lost-node@15min+40s"},
                                     {"lost-node@0s+30s"},
                                     {"lost-node:node=1@15min+20s"},
                                     {"lost-node:node=1@0s+1min"},
                                     {"lost-node:node=3@5min+10min"},
                                     {"lost-node:node=5@15min+3min"},
                                     {"restart@15min"},
                                     {"restart:node=1@15min"},
                                     {"restart:node=3@20min"},
                                     {"restart:node=5@20min"},
                                     {"restart:node=6@20min"},
                                     {"restart:node=7@20min"},
                                     {"lost-node:node=6@20min+2min"},
                                     {"lost-node:node=7@20min+2min"},
                                     {"lost-node:node=4@20min+2min"},
                                     {"restart:node=8@20min"},
                                     {"cable-cut@15min+1min"},
                                     {"cable-cut@0s+20s"},
                                     {"babbling-node@15min+10s"},
                                     {"corrupted-frames@10min+1h"},
                                     {"corrupted-frames@0s"},
                                     {"wheel-signal@15min+3min"},
                                     {"paper-out@0s+10min"},
                                     {"paper-out@15min+3h"},
                                     {"no-fix@0s+10min"},
                                     {"no-fix@15min+1h"}};

INSTANTIATE_TEST_SUITE_P(Each, TaxiFault, testing::ValuesIn(fault_cases));

/// New wheels of 2.1 m, and a k for wheels of 2 m: a drive of 1 km, which another one confirms.
TEST(TaxiShift, ACalibrationDriveBeforeItMakesFaresRight) {
  TaxiOptions options = short_shift(1);
  options.car.wheel_circumference_m = 2.1;
  options.shift.calibration_metres = 1000;
  TaxiNetwork network(options);
  Duration calibrating{};
  for (Time at{}; at < Time(10min); at += 1s) {
    network.run_until(at);
    if (network.snapshot().driver == Activity::calibrating) calibrating += 1s;
  }
  EXPECT_GE(calibrating, 144s) << "twice 1 km at 50 km/h";
  network.run_until(Time(shift_over));
  EXPECT_EQ(broken(network), "");
  EXPECT_FALSE(network.trips().empty());
}

/// The meter boots on its way.
TEST(TaxiShift, ACalibrationDriveThatMissesPulsesIsRepeated) {
  TaxiOptions options = short_shift(1);
  options.car.wheel_circumference_m = 2.1;
  options.shift.calibration_metres = 1000;
  options.faults.faults = {
      {.kind = FaultKind::restart, .start = Time(options.shift.begin + 30s), .node = taximeter_id}};
  TaxiNetwork network(options);
  network.run_until(Time(shift_over));
  EXPECT_EQ(broken(network), "");
  EXPECT_FALSE(network.trips().empty());
}

// Each referee can fail: a sabotage in the whole network breaks it, and no other one.

TEST(TaxiSabotage, AMeterThatIsCheatedOfItsPulsesChargesTooLittle) {
  TaxiOptions options = short_shift(1);
  options.car.wheel_circumference_m = 2.1;  // the meter's k is of wheels of 2 m
  TaxiNetwork network(options);
  network.run_until(Time(shift_over));
  EXPECT_EQ(broken(network), "fare distance receipt_lines shift_slip ");
}

TEST(TaxiSabotage, ATariffThatIsNotTheOneThatHolds) {
  static constexpr cia447::TariffLevel dear[] = {{.name = {'1', 0},
                                                  .initial_fare = 3900,
                                                  .distance_rate = 2400,
                                                  .time_rate = 33'000,
                                                  .increment = 100}};
  TaxiOptions options = short_shift(1);
  options.tariff_of_town = options.meter.tariff;
  options.meter.tariff = {.id = 1, .levels = dear};
  TaxiNetwork network(options);
  network.run_until(Time(shift_over));
  EXPECT_EQ(broken(network), "fare ");
}

TEST(TaxiSabotage, AClockThatIsSlowMakesTripsShorter) {
  TaxiNetwork network(short_shift(1));
  network.world().set_clock_drift(taximeter_id - SlotIndex{1}, -10'000);
  network.run_until(Time(shift_over));
  EXPECT_EQ(broken(network), "duration ");
}

TEST(TaxiSabotage, APassengerWhoIsAskedForMoreThanTheMeterCounts) {
  TaxiNetwork network(short_shift(1));
  network.sabotage().pocketed = 500;
  network.run_until(Time(shift_over));
  EXPECT_EQ(broken(network), "totals receipts ");
}

TEST(TaxiSabotage, ASignThatIsNeverSwitched) {
  TaxiNetwork network(short_shift(1));
  network.sabotage().cuts_sign = true;
  network.run_until(Time(21min));
  EXPECT_EQ(broken(network), "roof_sign alarm ");
}

TEST(TaxiSabotage, ATerminalThatShowsNoFare) {
  TaxiNetwork network(short_shift(1));
  network.sabotage().cuts_screen = true;
  network.run_until(Time(21min));
  EXPECT_EQ(broken(network), "terminal_fare ");
}

TEST(TaxiSabotage, AReceiverThatDoesNotSeeTheCarMove) {
  TaxiNetwork network(short_shift(1));
  network.sabotage().blinds_receiver = true;
  network.run_until(Time(21min));
  EXPECT_EQ(broken(network), "terminal_place ");
}

TEST(TaxiSabotage, AReceiverThatTellsAPlaceWithoutSatellites) {
  TaxiOptions options = short_shift(1);
  options.faults.faults = {{.kind = FaultKind::no_fix, .start = Time(1min)}};
  TaxiNetwork network(options);
  network.sabotage().blinds_receiver = true;
  network.run_until(Time(21min));
  EXPECT_EQ(broken(network), "terminal_place ");
}

TEST(TaxiSabotage, ReceiptsAreReadWhereSomeAreMissing) {
  TaxiOptions options = short_shift(1);
  options.faults.faults = {{.kind = FaultKind::paper_out, .start = Time(1min), .duration = 15min}};
  TaxiNetwork network(options);
  network.sabotage().pocketed = 500;
  network.run_until(Time(shift_over));
  EXPECT_EQ(broken(network), "totals receipts ");
}

TEST(TaxiSabotage, FramesThatAreSentAgainExcuseNothing) {
  TaxiOptions options = short_shift(1);
  options.faults.faults = {{.kind = FaultKind::corrupted_frames}};
  TaxiNetwork network(options);
  network.sabotage().pocketed = 500;
  network.run_until(Time(shift_over));
  EXPECT_EQ(broken(network), "totals receipts ");
  ASSERT_GE(network.trips().size(), 2u);
  EXPECT_TRUE(std::ranges::none_of(network.trips(), &Trip::is_disturbed));
}

TEST(TaxiSabotage, ReceiptsAreMissedWherePaperWasThere) {
  TaxiOptions options = short_shift(1);
  options.faults.faults = {{.kind = FaultKind::no_fix, .start = Time(18min), .duration = 2min}};
  TaxiNetwork network(options);
  network.run_until(Time(1min));
  network.node(printer_id).power(false);  // by no fault of the plan
  network.run_until(Time(16min));
  ASSERT_GE(network.trips().size(), 2u);
  network.node(printer_id).power(true);
  network.run_until(Time(shift_over));
  EXPECT_EQ(broken(network), "receipts device_missing ");
}

TEST(TaxiSabotage, ADeviceThatDoesNotSleep) {
  TaxiNetwork network(short_shift(1));
  network.sabotage().speaks_asleep = true;
  network.run_until(Time(awake_again));
  EXPECT_EQ(broken(network), "silence ");
}

TEST(TaxiSabotage, AMeterThatDoesNotObey) {
  TaxiNetwork network(evening(1));
  network.sabotage().blocks_keys = true;
  network.run_until(Time(2h + 2min));
  EXPECT_EQ(broken(network), "no_service carried ");
}

TEST(TaxiSabotage, ADeviceThatIsNotThere) {
  TaxiNetwork network(short_shift(1));
  network.world().at(Time(20min), [&](Time) { network.node(alarm_id).power(false); });
  network.run_until(Time(21min));
  EXPECT_EQ(broken(network), "device_missing ");
}

}  // namespace
}  // namespace canvoy::taxi::taxi_network_test
