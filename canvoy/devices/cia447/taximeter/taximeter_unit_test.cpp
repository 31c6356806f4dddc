// A taximeter at its wire: states, keys, totals, configuration, seal and errors (CiA
// 447-3, 4.2.12.6 to 4.2.12.8). 60D8h: the state in bits 3..0, ticof in bits 5..4, reserved bits 1.
#include "canvoy/devices/cia447/taximeter/taximeter_unit.hpp"

#include <gtest/gtest.h>

#include "canvoy/devices/cia447/taximeter/meter_bench_test.hpp"

namespace canvoy::cia447::taximeter_unit_test {
namespace {

constexpr std::uint64_t unknown = 0xFFFF'FFFF;
constexpr std::uint32_t emergency = 0x085;

class Meter : public testing::Test {
 protected:
  std::string status() { return car.cable().last(MeterBench::status_pdo); }
  /// A trip of a kilometre: 6,20.
  void make_trip() {
    EXPECT_TRUE(car.meter->hire());
    car.drive(100, 80);
    EXPECT_TRUE(car.meter->stop());
    EXPECT_TRUE(car.meter->for_hire());
  }
  void seal_anew() {
    car.seal_is_open = true;
    EXPECT_TRUE(car.meter->enter_service());
    car.seal_is_open = false;
    EXPECT_TRUE(car.meter->leave_service());
    car.cable().run_for(0s);
  }

  MeterBench car;
};

TEST_F(Meter, IsSignedOffAtFirst) {
  EXPECT_EQ(status(), "399#C3");
  EXPECT_EQ(car.ask("40 D8 60 00 00 00 00 00"), "4F D8 60 00 C3 00 00 00");
}

TEST_F(Meter, TellsEachStateByPdo) {
  EXPECT_TRUE(car.meter->sign_on());
  car.cable().run_for(0s);
  EXPECT_EQ(status(), "399#C0") << "for hire";
  EXPECT_TRUE(car.meter->hire());
  car.cable().run_for(0s);
  EXPECT_EQ(status(), "399#C1") << "hired";
  EXPECT_TRUE(car.meter->stop());
  car.cable().run_for(0s);
  EXPECT_EQ(status(), "399#C2") << "stopped";
  EXPECT_TRUE(car.meter->for_hire());
  EXPECT_TRUE(car.meter->standby());
  car.cable().run_for(0s);
  EXPECT_EQ(status(), "399#C5") << "standby mode";
  EXPECT_TRUE(car.meter->wake());
  car.cable().run_for(0s);
  EXPECT_EQ(status(), "399#C0") << "as it was";
  EXPECT_TRUE(car.meter->sign_off());
  car.cable().run_for(0s);
  EXPECT_EQ(status(), "399#C3") << "signed off";
  car.seal_is_open = true;
  EXPECT_TRUE(car.meter->enter_service());
  car.cable().run_for(0s);
  EXPECT_EQ(status(), "399#C4") << "service mode";
}

TEST_F(Meter, ChangesToOffModeForAWhile) {
  EXPECT_TRUE(car.meter->turn_off());
  car.cable().run_for(0s);
  EXPECT_EQ(status(), "399#D3") << "ticof, and signed off still";
  car.cable().run_for(2999ms);
  EXPECT_FALSE(car.is_off);
  car.cable().run_for(1ms);
  EXPECT_TRUE(car.is_off);
}

TEST_F(Meter, ComesBackFromOffModeByAnyKey) {
  car.meter->turn_off();
  car.cable().run_for(1s);
  EXPECT_TRUE(car.meter->wake());
  car.cable().run_for(0s);
  EXPECT_EQ(status(), "399#C3");
  car.meter->turn_off();
  car.cable().run_for(1s);
  EXPECT_TRUE(car.meter->sign_on());
  car.cable().run_for(10s);
  EXPECT_EQ(status(), "399#C0");
  EXPECT_FALSE(car.is_off);
  EXPECT_FALSE(car.meter->wake()) << "it is awake";
}

/// Keys that have an effect in each state: for hire, hired, stopped, signed off, service, standby.
TEST_F(Meter, KeysOfOtherStatesDoNothing) {
  struct Key {
    const char* name;
    bool (TaximeterUnit::*press)();
    const char* works;
  };
  constexpr Key keys[] = {
      {"sign on", &TaximeterUnit::sign_on, "...x.."},
      {"sign off", &TaximeterUnit::sign_off, "x....."},
      {"hire", &TaximeterUnit::hire, "x.x..."},
      {"stop", &TaximeterUnit::stop, ".x...."},
      {"for hire", &TaximeterUnit::for_hire, "..x..."},
      {"standby", &TaximeterUnit::standby, "x..x.."},
      {"wake", &TaximeterUnit::wake, ".....x"},
      {"turn off", &TaximeterUnit::turn_off, "x..x.x"},
      {"enter service", &TaximeterUnit::enter_service, "x..x.x"},
      {"leave service", &TaximeterUnit::leave_service, "......"},
  };
  for (const Key& key : keys) {
    for (unsigned state = 0; state < 6; ++state) {
      MeterBench other;
      other.seal_is_open = true;
      if (state <= 2) other.meter->sign_on();
      if (state == 1 || state == 2) other.meter->hire();
      if (state == 2) other.meter->stop();
      if (state == 4) other.meter->enter_service();
      if (state == 5) other.meter->standby();
      ASSERT_EQ(static_cast<unsigned>(other.meter->state()), state);
      EXPECT_EQ((other.meter->*key.press)(), key.works[state] == 'x') << key.name << " " << state;
      if (key.works[state] != 'x') {
        EXPECT_EQ(static_cast<unsigned>(other.meter->state()), state);
      }
    }
  }
}

TEST_F(Meter, ShowsThePassengerWhatIsToBePaid) {
  car.begin_shift();
  car.meter->hire();
  car.drive(100, 80);
  car.meter->add_supplement(500);
  car.meter->stop();
  EXPECT_EQ(car.display.state, Taximeter::stopped);
  EXPECT_EQ(car.display.trip.fare, 6200u);
  EXPECT_EQ(car.display.trip.supplements, 500u);
  EXPECT_EQ(car.display.trip.total, 6700u);
  EXPECT_TRUE(car.display.has_wheel_signal);
  EXPECT_FALSE(car.display.has_error);
}

TEST_F(Meter, NothingOfItIsWritten) {
  for (const char* request :
       {"2F D8 60 00 C1 00 00 00", "23 D0 60 01 00 00 00 00", "23 D9 60 01 00 00 00 00",
        "23 DA 60 01 01 00 00 00", "2F DB 60 00 00 00 00 00"}) {
    const std::string object = std::string(request).substr(3, 8);
    EXPECT_EQ(car.ask(request), "80 " + object + " 02 00 01 06");
  }
}

TEST_F(Meter, AnNmtResetTouchesNeitherTripNorTotals) {
  car.begin_shift();
  car.meter->hire();
  car.drive(50, 80);
  car.cable().send("000#81 05");
  car.cable().send("000#01 05");
  EXPECT_EQ(status(), "399#C1");
  car.drive(50, 80);
  car.cable().send("000#82 05");
  car.cable().send("000#01 05");
  car.meter->stop();
  EXPECT_EQ(car.get(0x60D0, 1), 6200u);
  EXPECT_EQ(car.get(0x60D1), 1000u);
  EXPECT_EQ(car.get(0x60D9, 7), 1u);
  EXPECT_EQ(car.get(0x60DA, 1), 8000u);
}

// Totals (4.2.12.7).

TEST_F(Meter, TotalsAreOfAllTimeAndOfTheShift) {
  car.begin_shift();
  car.drive(50, 80);
  make_trip();
  car.meter->hire();
  car.meter->add_supplement(700);
  car.drive(100, 80);
  car.meter->stop();
  EXPECT_EQ(car.get(0x60D9, 5), 6200u) << "a trip that is not at its end";
  car.meter->for_hire();
  EXPECT_EQ(car.ask("40 D9 60 00 00 00 00 00"), "4F D9 60 00 0C 00 00 00");
  const std::uint64_t expected[] = {2500, 2500, 2000, 2000, 13'100, 13'100,
                                    2,    2,    700,  700,  12'400, 12'400};
  for (unsigned sub = 1; sub <= 12; ++sub) {
    EXPECT_EQ(car.get(0x60D9, sub), expected[sub - 1]) << sub;
  }
}

TEST_F(Meter, TheLastShiftIsKeptUntilTheNextBegins) {
  car.begin_shift();
  make_trip();
  car.meter->sign_off();
  car.drive(100, 80);
  car.cable().run_for(1s);
  EXPECT_EQ(car.get(0x60D9, 1), 2000u);
  EXPECT_EQ(car.get(0x60D9, 2), 1000u) << "nobody is signed on";
  EXPECT_EQ(car.get(0x60D9, 6), 6200u);
  car.meter->sign_on();
  for (unsigned sub = 2; sub <= 12; sub += 2) EXPECT_EQ(car.get(0x60D9, sub), 0u) << sub;
  EXPECT_EQ(car.get(0x60D9, 1), 2000u);
  EXPECT_EQ(car.get(0x60D9, 5), 6200u);
}

TEST_F(Meter, DistanceIsNotLostInSmallPieces) {
  car.begin_shift();
  // 7 pulses at a time are 0,875 m.
  for (unsigned i = 0; i < 8000; ++i) {
    car.cable().run_for(100ms);
    car.turned += 7;
    car.send_count(car.turned % 65'536);
  }
  car.cable().run_for(1s);
  EXPECT_EQ(car.get(0x60D9, 1), 7000u);
}

TEST(TaxiTotals, BeginAnewBelowTheCodesThatMeanSomethingElse) {
  std::uint32_t total = 0xFFFF'FFFC;
  TaxiTotals::add(total, 1);
  EXPECT_EQ(total, 0xFFFF'FFFDu);
  TaxiTotals::add(total, 1);
  EXPECT_EQ(total, 0u);
  TaxiTotals::add(total, 0x1'0000'0000);
  EXPECT_EQ(total, 2u);
}

// Configuration (4.2.12.8).

TEST_F(Meter, TellsItsConfiguration) {
  EXPECT_EQ(car.ask("40 DA 60 00 00 00 00 00"), "4F DA 60 00 09 00 00 00");
  EXPECT_EQ(car.ask("40 DA 60 01 00 00 00 00"), "43 DA 60 01 40 1F 00 00") << "8000";
  EXPECT_EQ(car.ask("40 DA 60 02 00 00 00 00"), "4F DA 60 02 00 00 00 00");
  EXPECT_EQ(car.ask("40 DA 60 03 00 00 00 00"), "47 DA 60 03 01 00 00 00");
  EXPECT_EQ(car.ask("40 DA 60 05 00 00 00 00"), "4F DA 60 05 53 00 00 00") << "\"S\"";
  EXPECT_EQ(car.ask("40 DA 60 06 00 00 00 00"), "43 DA 60 06 FF FF FF FF") << "never sealed";
  EXPECT_EQ(car.ask("40 DA 60 07 00 00 00 00"), "47 DA 60 07 FF FF FF 00") << "no other tariff";
  EXPECT_EQ(car.ask("40 DA 60 08 00 00 00 00"), "47 DA 60 08 45 55 52 00") << "\"EUR\"";
  EXPECT_EQ(car.ask("40 DA 60 09 00 00 00 00"), "4B DA 60 09 6B 6D 00 00") << "\"km\"";
}

TEST(FutureTariff, TakesThePlaceOfTheOtherBetweenTwoTrips) {
  static constexpr TariffLevel dear[] = {{.initial_fare = 5000, .distance_rate = 4000}};
  MeterBench car(
      {.future_tariff = {.id = 2, .levels = dear}, .future_from = MeterBench::noon + 60});
  EXPECT_EQ(car.ask("40 DA 60 07 00 00 00 00"), "47 DA 60 07 02 00 00 00");
  car.begin_shift();
  car.meter->hire();
  car.drive(100, 80);
  EXPECT_EQ(car.get(0x60DA, 3), 1u) << "a trip is under way";
  car.meter->stop();
  EXPECT_EQ(car.get(0x60D0, 1), 6200u);
  car.meter->for_hire();
  car.meter->hire();
  EXPECT_EQ(car.get(0x60D0, 1), 5000u);
  EXPECT_EQ(car.ask("40 DA 60 03 00 00 00 00"), "47 DA 60 03 02 00 00 00");
  EXPECT_EQ(car.ask("40 DA 60 07 00 00 00 00"), "47 DA 60 07 FF FF FF 00");
}

TEST(FutureTariff, TakesOverInTheSecondFromWhichOnItHolds) {
  static constexpr TariffLevel dear[] = {{.initial_fare = 5000, .distance_rate = 4000}};
  MeterBench car(
      {.future_tariff = {.id = 2, .levels = dear}, .future_from = MeterBench::noon + 60});
  car.cable().run_for(59'999ms);
  EXPECT_EQ(car.get(0x60DA, 3), 1u);
  car.cable().run_for(1ms);
  EXPECT_EQ(car.get(0x60DA, 3), 2u);
}

// The seal.

TEST_F(Meter, ServiceModeIsBehindTheSeal) {
  EXPECT_FALSE(car.meter->enter_service());
  EXPECT_FALSE(car.meter->set_k(9000));
  car.seal_is_open = true;
  EXPECT_TRUE(car.meter->enter_service());
  EXPECT_FALSE(car.meter->set_k(0));
  EXPECT_TRUE(car.meter->set_k(10'000));
  EXPECT_FALSE(car.meter->leave_service()) << "it has to be sealed";
  car.seal_is_open = false;
  car.cable().run_for(10s);
  EXPECT_TRUE(car.meter->leave_service());
  EXPECT_EQ(car.meter->state(), Taximeter::signed_off);
  EXPECT_EQ(car.get(0x60DA, 1), 10'000u);
  EXPECT_EQ(car.get(0x60DA, 6), MeterBench::noon - 3600 + 10) << "the date of securing";
}

TEST_F(Meter, TheLastTripKeepsItsDistanceWhenKChanges) {
  car.begin_shift();
  make_trip();
  car.seal_is_open = true;
  car.meter->enter_service();
  car.meter->set_k(4000);
  EXPECT_EQ(car.get(0x60D1), 1000u);
  car.seal_is_open = false;
  car.meter->leave_service();
  car.drive(1, 80);  // only where to count from
  car.meter->sign_on();
  car.meter->hire();
  car.drive(100, 40);
  car.meter->stop();
  EXPECT_EQ(car.get(0x60D1), 1000u);
}

TEST_F(Meter, WhatTurnsOnTheTestStandIsNoDistance) {
  car.begin_shift();
  car.drive(10, 80);
  car.seal_is_open = true;
  car.meter->enter_service();
  car.drive(100, 80);
  EXPECT_EQ(car.get(0x60D9, 1), 100u);
}

// Errors: FF00h; what it is in the first byte after the error register, which has the bits of the
// profile and of any error: 21h.

TEST_F(Meter, AnotherWheelSignalSourceIsAnErrorUntilItIsSealedAnew) {
  EXPECT_EQ(car.ask_as(1, "2F 54 60 00 02 00 00 00"), "60 54 60 00 00 00 00 00") << "rear right";
  EXPECT_EQ(car.cable().count(emergency), 0u);
  car.begin_shift();
  car.ask_as(1, "2F 54 60 00 03 00 00 00");
  EXPECT_EQ(car.cable().last(emergency), "085#00 FF 21 01 02 03 00 00");
  EXPECT_FALSE(car.meter->hire()) << "no trip begins";
  car.cable().clear();
  car.ask_as(1, "2F 54 60 00 02 00 00 00");
  EXPECT_EQ(car.cable().count(emergency), 0u) << "it stays, even where it is taken back";
  EXPECT_FALSE(car.meter->hire());
  car.cable().clear();
  seal_anew();
  EXPECT_EQ(car.cable().last(emergency), "085#00 00 00 00 00 00 00 00");
  car.meter->sign_on();
  EXPECT_TRUE(car.meter->hire());
}

TEST_F(Meter, TheSameSourceOrOneThatFailsIsNone) {
  car.ask_as(1, "2F 54 60 00 05 00 00 00");
  car.begin_shift();
  for (const char* code : {"05", "FE", "FF", "07", "80", "05"}) {
    car.ask_as(1, "2F 54 60 00 " + std::string(code) + " 00 00 00");
    EXPECT_EQ(car.cable().count(emergency), 0u) << code;
  }
}

TEST_F(Meter, InServiceModeTheSourceMayChange) {
  car.ask_as(1, "2F 54 60 00 02 00 00 00");
  car.seal_is_open = true;
  car.meter->enter_service();
  car.ask_as(1, "2F 54 60 00 03 00 00 00");
  car.seal_is_open = false;
  car.meter->leave_service();
  EXPECT_EQ(car.cable().count(emergency), 0u);
  car.ask_as(1, "2F 54 60 00 02 00 00 00");
  EXPECT_EQ(car.cable().last(emergency), "085#00 FF 21 01 03 02 00 00");
}

TEST_F(Meter, AnotherNodeThatSendsWheelPulsesIsAnErrorAndIsNotCounted) {
  car.begin_shift();
  car.meter->hire();
  car.drive(10, 80);
  // PDO 17 of node 3: 280h + 7.
  car.send_count(car.turned % 65'536 + 200, 1, 0xFFFF, "287");
  EXPECT_EQ(car.cable().last(emergency), "085#00 FF 21 02 01 03 00 00");
  car.drive(10, 80);
  car.meter->stop();
  EXPECT_EQ(car.get(0x60D1), 100u) << "what was driven before";
  EXPECT_TRUE(car.meter->for_hire()) << "the trip can be ended";
  EXPECT_FALSE(car.meter->hire());
}

/// Requests of node 5 to the gateway are on 340h, answers on 2C0h (facts 2.2).
TEST_F(Meter, AsksTheGatewayForWhatNoPdoBrings) {
  car.cable().run_for(500ms);
  EXPECT_EQ(car.cable().last(0x340), "340#40 54 60 00 00 00 00 00");
  car.cable().send("2C0#4F 54 60 00 05 00 00 00");
  EXPECT_EQ(car.cable().last(0x340), "340#40 56 60 00 00 00 00 00");
  car.cable().send("2C0#47 56 60 00 E7 03 FD 00");
  EXPECT_EQ(car.get(0x6054), 5u);
  EXPECT_EQ(car.get(0x6056), 0xFD'03E7u);
  car.highest = 999;
  car.begin_shift();
  car.meter->hire();
  car.drive(100, 80);
  car.meter->stop();
  EXPECT_EQ(car.get(0x60D1), 1000u);
  // Ten seconds after the last request it has sent another; the source has changed.
  car.cable().clear();
  car.cable().run_for(10s);
  EXPECT_EQ(car.cable().last(0x340), "340#40 54 60 00 00 00 00 00");
  car.cable().send("2C0#4F 54 60 00 04 00 00 00");
  EXPECT_EQ(car.cable().last(emergency), "085#00 FF 21 01 05 04 00 00");
}

TEST_F(Meter, AGatewayThatLacksAnObjectHasOthers) {
  car.cable().run_for(500ms);
  car.cable().send("2C0#80 54 60 00 00 00 02 06");
  EXPECT_EQ(car.cable().last(0x340), "340#40 56 60 00 00 00 00 00");
  car.cable().send("2C0#43 56 60 00 E7 03 FD 00");  // four bytes are too many
  EXPECT_EQ(car.get(0x6056), 0xFF'FFFFu);
}

TEST(TaximeterClock, IsAskedByWhereItIs) {
  MeterBench car({.clock_node = 7}, nullptr, std::nullopt);
  // Requests of node 5 to node 7 are on 346h, answers on 2C6h.
  car.cable().run_for(500ms);
  EXPECT_EQ(car.cable().last(0x346), "346#40 F4 60 00 00 00 00 00");
  car.cable().send("2C6#43 F4 60 00 11 01 CE FF");
  EXPECT_EQ(car.cable().last(0x346), "346#40 F0 60 00 00 00 00 00");
  car.cable().send("2C6#43 F0 60 00 EA 07 8C F1");  // 2026-12-24, and midnight comes
  car.cable().send("2C6#43 F2 60 00 00 00 64 00");  // 0:00:01,00
  EXPECT_EQ(car.cable().last(0x346), "346#40 F0 60 00 00 00 00 00");
  car.cable().send("2C6#43 F0 60 00 EA 07 9C F1");
  car.begin_shift();
  car.meter->hire();
  // 2026-12-24 22:00:01 UTC.
  EXPECT_EQ(car.get(0x60D2, 3), 1'798'149'601u);
  EXPECT_EQ(car.get(0x60D0, 1), 4900u) << "at night";
}

/// The meter's own clock is a month behind: it is set by the other one.
TEST(TaximeterClock, GoesOnFromWhatTheBusSaidAfterALossOfPower) {
  SimulatedFlash memory(MeterBench::geometry);
  {
    MeterBench car({.clock_node = 7}, &memory);
    car.cable().run_for(500ms);
    car.cable().send("2C6#43 F4 60 00 11 01 CE FF");
    car.cable().send("2C6#43 F0 60 00 EA 07 9C F1");
    car.cable().send("2C6#43 F2 60 00 00 00 64 00");  // 0:00:01,00 of 2026-12-25
    car.cable().send("2C6#43 F0 60 00 EA 07 9C F1");
    car.begin_shift();
    car.meter->power_fails();
  }
  SimulatedFlash same(MeterBench::geometry, memory.bytes);
  MeterBench car({.clock_node = 7}, &same, MeterBench::noon + 10);
  car.meter->hire();
  EXPECT_EQ(car.get(0x60D2, 3), 1'798'149'611u) << "nobody has been asked yet";
  EXPECT_EQ(car.get(0x60D0, 1), 4900u) << "at night";
}

TEST_F(Meter, WheelsThatTurnWithoutPulsesAreAnErrorWhileTheyDo) {
  car.begin_shift();
  const auto turn = [this](unsigned cycles, unsigned step) {
    for (unsigned cycle = 0; cycle < cycles; ++cycle) {
      car.cable().run_for(100ms);
      car.turned += step;
      car.send_count(car.turned % 65'536, 1, 60);  // 30/min
    }
  };
  turn(49, 0);
  EXPECT_EQ(car.cable().count(emergency), 0u);
  turn(1, 0);
  EXPECT_EQ(car.cable().last(emergency), "085#00 FF 21 03 00 00 00 00");
  turn(1, 1);
  EXPECT_EQ(car.cable().last(emergency), "085#00 00 00 00 00 00 00 00");
  EXPECT_TRUE(car.meter->hire()) << "it does not keep anybody from driving";
}

TEST_F(Meter, KeepsTheNetworkAwakeWhileATripIsUnderWay) {
  const auto objections = [this] {
    car.cable().clear();
    car.cable().send("691#01 00 00 00 00 00 00 00");
    return car.cable().count(0x695);
  };
  EXPECT_EQ(objections(), 0u) << "signed off";
  car.begin_shift();
  EXPECT_EQ(objections(), 0u) << "for hire";
  car.meter->hire();
  EXPECT_EQ(objections(), 1u);
  EXPECT_EQ(car.cable().last(0x695), "695#81 01 00 00 00 00 00 00");
  car.meter->stop();
  EXPECT_EQ(objections(), 1u) << "nobody has paid yet";
  car.meter->for_hire();
  EXPECT_EQ(objections(), 0u);
}

TEST_F(Meter, AnErrorOutlastsAnNmtReset) {
  car.ask_as(1, "2F 54 60 00 02 00 00 00");
  car.ask_as(1, "2F 54 60 00 03 00 00 00");
  car.cable().clear();
  car.cable().send("000#81 05");
  EXPECT_EQ(car.cable().last(emergency), "085#00 FF 21 01 00 00 00 00");
}

}  // namespace
}  // namespace canvoy::cia447::taximeter_unit_test
