// Trips of a taximeter at its wire: wheel pulses in, payment, distance, time and tariff out (CiA
// 447-3, 4.2.12.1 to 4.2.12.5). With the example tariff: 3,90, then 2,30 a km or 33,00 an hour, by
// 0,10; at night 4,90 and 2,60 a km. 8000 pulses are a kilometre.
#include <gtest/gtest.h>

#include "canvoy/devices/cia447/taximeter/meter_bench_test.hpp"

namespace canvoy::cia447::taximeter_trip_test {
namespace {

constexpr std::uint64_t unknown = 0xFFFF'FFFF;

class Trip : public testing::Test {
 protected:
  MeterBench car;
};

TEST_F(Trip, BeforeTheFirstOneNothingIsKnown) {
  for (unsigned sub = 1; sub <= 6; ++sub) EXPECT_EQ(car.get(0x60D0, sub), unknown) << sub;
  EXPECT_EQ(car.get(0x60D1), unknown);
  for (unsigned sub = 1; sub <= 4; ++sub) EXPECT_EQ(car.get(0x60D2, sub), unknown) << sub;
  EXPECT_EQ(car.get(0x60D3), 0xFFFFu);
  for (unsigned sub = 1; sub <= 2; ++sub) EXPECT_EQ(car.get(0x60D4, sub), unknown) << sub;
  EXPECT_EQ(car.ask("40 D0 60 00 00 00 00 00"), "4F D0 60 00 06 00 00 00");
  EXPECT_EQ(car.ask("40 D2 60 00 00 00 00 00"), "4F D2 60 00 04 00 00 00");
  EXPECT_EQ(car.ask("40 D4 60 00 00 00 00 00"), "4F D4 60 00 02 00 00 00");
}

TEST_F(Trip, CostsItsInitialFareWhenTheTaxiIsHired) {
  car.begin_shift();
  EXPECT_TRUE(car.meter->hire());
  EXPECT_EQ(car.ask("40 D0 60 01 00 00 00 00"), "43 D0 60 01 3C 0F 00 00") << "3900";
  EXPECT_EQ(car.ask("40 D0 60 02 00 00 00 00"), "43 D0 60 02 00 00 00 00");
  EXPECT_EQ(car.ask("40 D0 60 03 00 00 00 00"), "43 D0 60 03 3C 0F 00 00");
  EXPECT_EQ(car.ask("40 D0 60 04 00 00 00 00"), "43 D0 60 04 00 00 00 00") << "mode S";
  EXPECT_EQ(car.ask("40 D0 60 05 00 00 00 00"), "43 D0 60 05 00 00 00 00");
  EXPECT_EQ(car.ask("40 D0 60 06 00 00 00 00"), "43 D0 60 06 3C 0F 00 00");
  EXPECT_EQ(car.ask("40 D3 60 00 00 00 00 00"), "4B D3 60 00 31 00 00 00") << "level 1";
  EXPECT_EQ(car.ask("40 D4 60 01 00 00 00 00"), "43 D4 60 01 E8 80 00 00") << "33000 an hour";
  EXPECT_EQ(car.ask("40 D4 60 02 00 00 00 00"), "43 D4 60 02 FC 08 00 00") << "2300 a km";
}

TEST_F(Trip, CostsDistanceWhereTheTaxiIsFast) {
  car.begin_shift();
  car.meter->hire();
  car.drive(100, 80);  // 36 km/h, 1 km; the counter overruns after 536 pulses
  EXPECT_TRUE(car.meter->stop());
  EXPECT_EQ(car.get(0x60D0, 1), 3900u + 2300u);
  EXPECT_EQ(car.get(0x60D1), 1000u);
  EXPECT_EQ(car.get(0x60D2, 1), 100u);
  EXPECT_EQ(car.get(0x60D2, 2), 0u);
  // At 12:00 local time, an hour ahead of UTC.
  EXPECT_EQ(car.get(0x60D2, 3), MeterBench::noon - 3600);
  EXPECT_EQ(car.get(0x60D2, 4), MeterBench::noon - 3600 + 100);
}

TEST_F(Trip, CostsTimeWhereItIsSlow) {
  car.begin_shift();
  car.meter->hire();
  car.drive(360, 0);
  car.meter->stop();
  EXPECT_EQ(car.get(0x60D0, 1), 3900u + 3300u);
  EXPECT_EQ(car.get(0x60D1), 0u);
  EXPECT_EQ(car.get(0x60D2, 2), 360u);
}

TEST_F(Trip, IsToldWhileItLasts) {
  car.begin_shift();
  car.meter->hire();
  car.drive(50, 80);
  car.cable().run_for(1s);
  EXPECT_EQ(car.get(0x60D1), 500u);
  // 1,15 for 0,5 km, and the last second was none of distance: 1,159.
  EXPECT_EQ(car.get(0x60D0, 1), 3900u + 1100u);
  EXPECT_EQ(car.get(0x60D2, 1), 51u);
  EXPECT_EQ(car.get(0x60D2, 4), unknown) << "it is not finished";
}

TEST(TripD, CostsBothAtOnce) {
  MeterBench car({.calculation = FareMode::double_calculation});
  car.begin_shift();
  car.meter->hire();
  car.drive(360, 80);  // 3,6 km: 8,28; a tenth of an hour: 3,30
  car.meter->stop();
  EXPECT_EQ(car.get(0x60D0, 1), 3900u + 11'500u);
  EXPECT_EQ(car.get(0x60D0, 4), 1u);
  EXPECT_EQ(car.get(0x60D2, 2), 360u);
  EXPECT_EQ(car.ask("40 DA 60 05 00 00 00 00"), "4F DA 60 05 44 00 00 00") << "\"D\"";
}

TEST_F(Trip, StaysToBeReadWhenTheTaxiIsForHireAndIsForgottenWhenItIsHired) {
  car.begin_shift();
  car.meter->hire();
  car.drive(100, 80);
  car.meter->stop();
  car.meter->for_hire();
  car.drive(100, 80);
  EXPECT_EQ(car.get(0x60D0, 1), 6200u);
  EXPECT_EQ(car.get(0x60D1), 1000u) << "what is driven for hire is none of the trip";
  EXPECT_EQ(car.get(0x60D2, 1), 100u);
  EXPECT_EQ(car.get(0x60D4, 2), 2300u);
  car.meter->hire();
  EXPECT_EQ(car.get(0x60D0, 1), 3900u);
  EXPECT_EQ(car.get(0x60D1), 0u);
  EXPECT_EQ(car.get(0x60D2, 1), 0u);
  EXPECT_EQ(car.get(0x60D2, 4), unknown);
}

TEST_F(Trip, GoesOnWhereItWasStopped) {
  car.begin_shift();
  car.meter->hire();
  car.drive(50, 80);
  car.meter->stop();
  car.drive(100, 80);
  EXPECT_EQ(car.get(0x60D0, 1), 3900u + 1100u) << "stopped: nothing costs";
  EXPECT_EQ(car.get(0x60D1), 500u);
  EXPECT_TRUE(car.meter->hire());
  EXPECT_EQ(car.get(0x60D0, 1), 3900u + 1100u);
  car.drive(50, 80);
  car.meter->stop();
  EXPECT_EQ(car.get(0x60D0, 1), 6200u);
  EXPECT_EQ(car.get(0x60D1), 1000u);
  EXPECT_EQ(car.get(0x60D2, 1), 100u);
  EXPECT_EQ(car.get(0x60D9, 7), 1u) << "one hiring";
}

TEST_F(Trip, SupplementsAreChargedBesideTheFare) {
  car.begin_shift();
  EXPECT_FALSE(car.meter->add_supplement(500)) << "nobody is there";
  car.meter->hire();
  EXPECT_TRUE(car.meter->add_supplement(500));
  EXPECT_TRUE(car.meter->add_supplement(1200));
  EXPECT_EQ(car.get(0x60D0, 1), 3900u);
  EXPECT_EQ(car.get(0x60D0, 2), 1700u);
  EXPECT_EQ(car.get(0x60D0, 3), 5600u);
  EXPECT_TRUE(car.meter->clear_supplements());
  EXPECT_EQ(car.get(0x60D0, 3), 3900u);
}

/// The example's: luggage 1,00, a booking 1,50, the airport 5,00.
TEST_F(Trip, EachServiceOfTheTariffCostsItsPrice) {
  car.begin_shift();
  EXPECT_FALSE(car.meter->charge(0)) << "nobody is there";
  car.meter->hire();
  EXPECT_TRUE(car.meter->charge(0));
  EXPECT_TRUE(car.meter->charge(0));
  EXPECT_TRUE(car.meter->charge(2));
  EXPECT_FALSE(car.meter->charge(3)) << "there is none";
  EXPECT_TRUE(car.meter->add_supplement(700));
  EXPECT_EQ(car.get(0x60D0, 2), 7700u);
  const auto& of_kinds = car.meter->record().trip.supplements_of_kind;
  EXPECT_EQ(of_kinds[0], 2000u);
  EXPECT_EQ(of_kinds[1], 0u);
  EXPECT_EQ(of_kinds[2], 5000u);
  EXPECT_TRUE(car.meter->clear_supplements());
  EXPECT_EQ(of_kinds[0] + of_kinds[2], 0u);
}

TEST_F(Trip, MayHaveAFixedPrice) {
  car.begin_shift();
  EXPECT_TRUE(car.meter->agree_price(25'000));
  car.meter->hire();
  car.meter->add_supplement(1000);
  car.drive(100, 80);
  car.meter->stop();
  EXPECT_EQ(car.get(0x60D0, 1), 25'000u);
  EXPECT_EQ(car.get(0x60D0, 3), 26'000u);
  EXPECT_EQ(car.get(0x60D0, 4), 2u);
  EXPECT_EQ(car.get(0x60D0, 6), 0u);
  EXPECT_EQ(car.get(0x60D1), 1000u);
  EXPECT_EQ(car.get(0x60D4, 2), 0u) << "no distance costs anything";
  car.meter->for_hire();
  car.meter->hire();
  EXPECT_EQ(car.get(0x60D0, 1), 3900u) << "the price was agreed for one trip";
  EXPECT_TRUE(car.meter->agree_price(10'000)) << "on the way, too";
  EXPECT_EQ(car.get(0x60D0, 1), 10'000u);
}

TEST_F(Trip, TheTariffChangesAtTenAtNightInTheMiddleOfIt) {
  car.set_clock({.year = 2026, .month = 11, .day = 23, .hour = 21, .minute = 58, .second = 15});
  car.begin_shift();
  car.meter->hire();
  car.drive(100, 80);  // 1 km by day
  EXPECT_EQ(car.get(0x60D3), 0x31u);
  EXPECT_EQ(car.get(0x60D4, 2), 2300u);
  car.drive(100, 80);
  car.meter->stop();
  EXPECT_EQ(car.get(0x60D3), 0x32u);
  EXPECT_EQ(car.get(0x60D4, 2), 2600u);
  // 1,05 km by day: 2,415; 0,95 km by night: 2,47. The level changes within a second, which is
  // 0,0024 less at most.
  EXPECT_EQ(car.get(0x60D0, 1), 3900u + 4800u);
  EXPECT_EQ(car.get(0x60D0, 6), 3900u);
}

TEST_F(Trip, BeginsWithTheInitialFareOfTheHour) {
  car.set_clock({.year = 2026, .month = 11, .day = 29, .hour = 12});  // a Sunday
  car.begin_shift();
  car.meter->hire();
  EXPECT_EQ(car.get(0x60D0, 1), 4900u);
  EXPECT_EQ(car.get(0x60D3), 0x32u);
}

TEST_F(Trip, TheDriverChoosesALevelForOneTrip) {
  car.begin_shift();
  EXPECT_FALSE(car.meter->choose_level(2)) << "there are two";
  EXPECT_TRUE(car.meter->choose_level(1));
  car.meter->hire();
  EXPECT_EQ(car.get(0x60D0, 1), 4900u);
  EXPECT_TRUE(car.meter->choose_level(0)) << "on the way";
  EXPECT_EQ(car.get(0x60D3), 0x31u);
  EXPECT_EQ(car.get(0x60D0, 1), 4900u);
  car.meter->choose_level(1);
  car.meter->stop();
  car.meter->for_hire();
  car.meter->hire();
  EXPECT_EQ(car.get(0x60D0, 1), 3900u);
}

TEST(TripWithoutClock, IsOfTheFirstLevelAndHasNoDate) {
  MeterBench car({}, nullptr, std::nullopt);
  car.begin_shift();
  car.meter->hire();
  car.drive(10, 80);
  car.meter->stop();
  EXPECT_EQ(car.get(0x60D3), 0x31u);
  EXPECT_EQ(car.get(0x60D2, 1), 10u);
  EXPECT_EQ(car.get(0x60D2, 3), unknown);
  EXPECT_EQ(car.get(0x60D2, 4), unknown);
}

TEST(TripByTheClockOnTheBus, GoesBeforeItsOwn) {
  MeterBench car({.clock_node = 7});
  // Node 7 writes a real time clock's objects (4.2.14): day above month (errata Z02): 24th of
  // December 2026, 23:30:00, valid, two hours ahead of UTC.
  EXPECT_EQ(car.ask_as(7, "23 F0 60 00 EA 07 8C F1"), "60 F0 60 00 00 00 00 00");
  EXPECT_EQ(car.ask_as(7, "23 F2 60 00 17 1E 00 00"), "60 F2 60 00 00 00 00 00");
  EXPECT_EQ(car.ask_as(7, "23 F4 60 00 11 01 CE FF"), "60 F4 60 00 00 00 00 00")
      << "GPS, accepted, valid, no summer time, 38h: +2 h";
  car.begin_shift();
  car.meter->hire();
  EXPECT_EQ(car.get(0x60D0, 1), 4900u) << "at night";
  // 2026-12-24 21:30:00 UTC.
  EXPECT_EQ(car.get(0x60D2, 3), 1'798'147'800u);
  car.drive(60, 0);
  car.meter->stop();
  EXPECT_EQ(car.get(0x60D2, 4), 1'798'147'860u) << "it goes on by itself";
}

TEST(TripByTheClockOnTheBus, IsNotBelievedWhereItIsNotValid) {
  MeterBench car({.clock_node = 7});
  car.ask_as(7, "23 F0 60 00 EA 07 8C F1");
  car.ask_as(7, "23 F2 60 00 17 1E 00 00");
  car.ask_as(7, "23 F4 60 00 11 00 CE FF");
  car.begin_shift();
  car.meter->hire();
  EXPECT_EQ(car.get(0x60D0, 1), 3900u) << "at noon, by its own";
}

TEST(TripInMiles, IsCountedInTheUnitThatIsSet) {
  // 1000 pulses a mile; 3000 thousandths a mile.
  static constexpr TariffLevel levels[] = {{.initial_fare = 2500, .distance_rate = 3000}};
  MeterBench car({.k = 1000,
                  .tariff = {.id = 7, .levels = levels},
                  .currency = {.code = "USD"},
                  .distance_unit = "mile",
                  .fastest_speed = 200});
  car.begin_shift();
  car.meter->hire();
  car.drive(77, 10);
  car.meter->stop();
  EXPECT_EQ(car.get(0x60D1), 770u);
  EXPECT_EQ(car.get(0x60D0, 1), 2500u + 2310u) << "no switching unit: each thousandth";
  EXPECT_EQ(car.get(0x60D3), 0u) << "a level without characters";
  EXPECT_EQ(car.ask("40 DA 60 08 00 00 00 00"), "47 DA 60 08 55 53 44 00");
  EXPECT_EQ(car.ask("40 DA 60 09 00 00 00 00"), "43 DA 60 09 6D 69 6C 65");
}

TEST(OdometerOperation, MeasuresAndCalculatesNoFare) {
  MeterBench car({.mode = TaximeterMode::odometer_operation});
  EXPECT_EQ(car.get(0x60DA, 2), 1u);
  car.begin_shift();
  car.meter->hire();
  car.drive(100, 80);
  car.meter->stop();
  EXPECT_EQ(car.get(0x60D0, 1), unknown);
  EXPECT_EQ(car.get(0x60D0, 4), unknown);
  EXPECT_EQ(car.get(0x60D4, 1), unknown);
  EXPECT_EQ(car.get(0x60D1), 1000u);
  EXPECT_EQ(car.get(0x60D2, 1), 100u);
  car.meter->for_hire();
  EXPECT_EQ(car.get(0x60D9, 5), 0u);
  EXPECT_EQ(car.get(0x60D9, 3), 1000u);
  car.meter->agree_price(20'000);
  car.meter->hire();
  EXPECT_EQ(car.get(0x60D0, 1), 20'000u) << "but a price may be agreed";
}

// The wheel signal (4.2.4.6).

TEST_F(Trip, ValuesThatAreLostOrSentTwiceChangeNothing) {
  car.begin_shift();
  car.meter->hire();
  for (unsigned cycle = 1; cycle <= 1000; ++cycle) {
    car.cable().run_for(100ms);
    car.turned += 8;
    if (cycle % 3 == 0 && cycle != 999) continue;
    car.send_count(car.turned % 65'536);
    if (cycle % 5 == 0) car.send_count(car.turned % 65'536);
  }
  car.meter->stop();
  EXPECT_EQ(car.get(0x60D1), 1000u);
  EXPECT_EQ(car.get(0x60D0, 1), 6200u);
}

TEST_F(Trip, TheCounterOverrunsWhere6056hSays) {
  EXPECT_EQ(car.ask_as(1, "27 56 60 00 E7 03 FD 00"), "60 56 60 00 00 00 00 00") << "999, valid";
  car.highest = 999;
  car.begin_shift();
  car.meter->hire();
  car.drive(100, 80);  // it overruns eight times
  car.meter->stop();
  EXPECT_EQ(car.get(0x60D1), 1000u);
}

TEST_F(Trip, AnOverrunValueThatIsNotValidIsNone) {
  car.ask_as(1, "27 56 60 00 E7 03 FF 00");
  car.begin_shift();
  car.meter->hire();
  car.drive(100, 80);
  car.meter->stop();
  EXPECT_EQ(car.get(0x60D1), 1000u);
}

TEST_F(Trip, WhileTheGatewayBeginsAnewNothingIsMadeUp) {
  car.begin_shift();
  car.meter->hire();
  car.drive(50, 80);
  for (unsigned cycle = 0; cycle < 10; ++cycle) {
    car.cable().run_for(100ms);
    car.send_count(0, 3);
  }
  car.turned = 0;
  car.send_count(0);
  car.drive(50, 80);
  car.meter->stop();
  EXPECT_EQ(car.get(0x60D1), 1000u);
  EXPECT_LE(car.get(0x60D0, 1), 6200u) << "a second of time is 0,009";
}

TEST_F(Trip, WithoutWheelSignalTimeCostsAndDistanceIsNotChargedASecondTime) {
  car.begin_shift();
  car.meter->hire();
  car.drive(10, 80);
  car.cable().run_for(20s);
  EXPECT_FALSE(car.display.has_wheel_signal);
  car.turned += 1600;
  car.send_count(car.turned % 65'536);
  car.cable().run_for(1s);
  EXPECT_TRUE(car.display.has_wheel_signal);
  car.meter->stop();
  EXPECT_EQ(car.get(0x60D1), 300u) << "all of it was driven";
  // 0,23 for the first 0,1 km, 21 s of time: 0,1925; together 0,4225.
  EXPECT_EQ(car.get(0x60D0, 1), 3900u + 400u);
}

TEST(TripD, DistanceThatComesLateIsCharged) {
  MeterBench car({.calculation = FareMode::double_calculation});
  car.begin_shift();
  car.meter->hire();
  car.cable().run_for(20s);
  car.turned += 1600;
  car.send_count(car.turned % 65'536);
  car.meter->stop();
  EXPECT_EQ(car.get(0x60D0, 1), 3900u + 600u) << "0,46 and 0,1833";
}

TEST_F(Trip, FramesOfOtherLengthsAreNotCounted) {
  car.begin_shift();
  car.meter->hire();
  car.cable().send("187#00 00 FF FF 10");
  car.cable().send("187#");
  car.drive(10, 80);
  car.meter->stop();
  EXPECT_EQ(car.get(0x60D1), 100u);
}

}  // namespace
}  // namespace canvoy::cia447::taximeter_trip_test
