// A GPS receiver at its wire: the codes of 4.2.10, typed from its tables.
#include "canvoy/devices/cia447/gps/gps_unit.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "canvoy/devices/cia447/gps/nmea.hpp"
#include "canvoy/devices/cia447/kit/car_bench_test.hpp"

namespace canvoy::cia447::gps_unit_test {
namespace {

/// PDO 70 is the 16th of the list: 380h + 15 of node 5.
constexpr std::uint32_t position_pdo = 0x38F;

class Gps : public testing::Test {
 protected:
  GpsReading read() { return reading; }
  GpsHardware hardware() { return {.read = callback<&Gps::read>(*this)}; }
  void see(const GpsReading& now) {
    reading = now;
    bench.cable.run_for(1s);
  }
  std::string ask(const std::string& place) {
    const std::string answer = bench.ask("40 " + place + " 00 00 00 00");
    return answer.size() > 12 ? answer.substr(12) : answer;
  }

  GpsReading reading;
  CarBench bench{only_unit<GpsKind>, [this](Environment& environment) {
                   environment.provide(callback<&Gps::hardware>(*this));
                 }};
};

TEST_F(Gps, KnowsNothingAtFirst) {
  EXPECT_EQ(bench.cable.last(position_pdo), "38F#FF FF FF FF FF FF FF FF");
  EXPECT_EQ(ask("B1 60 00"), "FF 00 00 00");
  EXPECT_EQ(ask("B2 60 00"), "FF FF FF FF");
  EXPECT_EQ(ask("B3 60 00"), "FF FF FF FF");
  EXPECT_EQ(ask("B4 60 00"), "FF FF FF 00");
  EXPECT_EQ(ask("B5 60 00"), "02 00 00 00");
  EXPECT_EQ(ask("B5 60 01"), "FF FF 00 00");
  EXPECT_EQ(ask("B5 60 02"), "FF FF 00 00");
  EXPECT_EQ(ask("B6 60 00"), "FF FF 00 00");
}

TEST_F(Gps, TellsThePositionInStepsOfTenMillionths) {
  see({.fix = GpsFix::fix_3d, .latitude = 0, .longitude = 0});
  EXPECT_EQ(bench.cable.last(position_pdo), "38F#00 00 00 00 00 00 00 00");
  see({.fix = GpsFix::fix_3d, .latitude = 0.0000001, .longitude = 0.0000002});
  EXPECT_EQ(bench.cable.last(position_pdo), "38F#01 00 00 00 02 00 00 00");
  see({.fix = GpsFix::fix_3d, .latitude = 90, .longitude = 180});
  EXPECT_EQ(bench.cable.last(position_pdo), "38F#00 E9 A4 35 00 D2 49 6B");
}

TEST_F(Gps, SouthAndWestBeginAboveNorthAndEast) {
  // Errata Z36: neither a sign nor a turn of the circle.
  see({.fix = GpsFix::fix_3d, .latitude = -0.0000001, .longitude = -0.0000001});
  EXPECT_EQ(bench.cable.last(position_pdo), "38F#01 E9 A4 35 01 D2 49 6B");
  see({.fix = GpsFix::fix_3d, .latitude = -90, .longitude = -180});
  EXPECT_EQ(bench.cable.last(position_pdo), "38F#00 D2 49 6B 00 A4 93 D6");
  // 33.5 south is 900 000 000 + 335 000 000 = 499C 9AC0h; 70.25 west is 1 800 000 000 +
  // 702 500 000 = 9529 1EA0h.
  see({.fix = GpsFix::fix_2d, .latitude = -33.5, .longitude = -70.25});
  EXPECT_EQ(bench.cable.last(position_pdo), "38F#C0 9A 9C 49 A0 1E 29 95");
}

TEST_F(Gps, OnePositionIsOneFrame) {
  see({.fix = GpsFix::fix_3d, .latitude = 1, .longitude = 1});
  bench.cable.clear();
  see({.fix = GpsFix::fix_3d, .latitude = 2, .longitude = 2});
  EXPECT_EQ(bench.cable.count(position_pdo), 1u);
  see({.fix = GpsFix::fix_3d, .latitude = 2, .longitude = 2});
  EXPECT_EQ(bench.cable.count(position_pdo), 1u) << "a car that stands tells nothing new";
}

TEST_F(Gps, ALostFixMakesPositionHeightAndMovementNotAvailable) {
  const GpsReading found = {.fix = GpsFix::fix_3d,
                            .latitude = 1,
                            .longitude = 1,
                            .altitude = 500,
                            .velocity = 10,
                            .heading = 90,
                            .tracked_satellites = 7,
                            .time = GpsTime{1, 2, 3}};
  see(found);
  EXPECT_EQ(ask("B6 60 00"), "DC 05 00 00") << "1000 + 500";
  GpsReading lost = found;
  lost.fix = GpsFix::none;
  see(lost);
  EXPECT_EQ(bench.cable.last(position_pdo), "38F#FF FF FF FF FF FF FF FF");
  EXPECT_EQ(ask("B5 60 01"), "FF FF 00 00");
  EXPECT_EQ(ask("B5 60 02"), "FF FF 00 00");
  EXPECT_EQ(ask("B6 60 00"), "FF FF 00 00");
  EXPECT_EQ(ask("B1 60 00"), "7F 00 00 00") << "satellites and clock are told on";
  see(found);
  EXPECT_EQ(bench.cable.last(position_pdo), "38F#80 96 98 00 80 96 98 00");
  EXPECT_EQ(ask("B5 60 01"), "E8 03 00 00");
}

TEST_F(Gps, InTwoDimensionsThereIsNoHeight) {
  see({.fix = GpsFix::fix_2d, .latitude = 1, .longitude = 1, .altitude = 500});
  EXPECT_EQ(bench.cable.last(position_pdo), "38F#80 96 98 00 80 96 98 00");
  EXPECT_EQ(ask("B6 60 00"), "FF FF 00 00");
}

TEST_F(Gps, ABrokenReceiverIsAFailureOfAllSignals) {
  see({.has_failed = true, .fix = GpsFix::fix_3d, .latitude = 1, .longitude = 1});
  EXPECT_EQ(bench.cable.last(position_pdo), "38F#FE FF FF FF FE FF FF FF");
  EXPECT_EQ(ask("B1 60 00"), "EE 00 00 00");
  EXPECT_EQ(ask("B2 60 00"), "FE FE FE FE");
  // Year FFFEh, month Eh, day 3Eh, reserved bits 1.
  EXPECT_EQ(ask("B3 60 00"), "FE FF EE FF");
  // Hour 1Eh, minute 3Eh, second 1FFEh: 1 1111 1111 1110 11 1110 1 1110b.
  EXPECT_EQ(ask("B4 60 00"), "DE F7 FF 00");
  EXPECT_EQ(ask("B5 60 01"), "FE FF 00 00");
  EXPECT_EQ(ask("B5 60 02"), "FE FF 00 00");
  EXPECT_EQ(ask("B6 60 00"), "FE FF 00 00");
}

TEST_F(Gps, WhatCannotBeIsAFailure) {
  see({.fix = GpsFix::fix_3d, .latitude = 90.1, .longitude = 1});
  EXPECT_EQ(bench.cable.last(position_pdo), "38F#FE FF FF FF 80 96 98 00");
  see({.fix = GpsFix::fix_3d, .latitude = std::nan(""), .longitude = -180.1});
  EXPECT_EQ(bench.cable.last(position_pdo), "38F#FF FF FF FF FE FF FF FF");
  see({.fix = GpsFix::fix_3d, .velocity = -1, .hdop = -1, .date = GpsDate{2025, 2, 29}});
  EXPECT_EQ(ask("B5 60 01"), "FE FF 00 00");
  EXPECT_EQ(ask("B2 60 00"), "FF FE FF F2");
  EXPECT_EQ(ask("B3 60 00"), "FE FF EE FF");
  see({.date = GpsDate{2100, 2, 29}});
  EXPECT_EQ(ask("B3 60 00"), "FE FF EE FF") << "no leap year";
  see({.date = GpsDate{2000, 2, 29}});
  EXPECT_EQ(ask("B3 60 00"), "D0 07 D2 FD") << "a leap year";
  see({.time = GpsTime{24, 0, 0}});
  EXPECT_EQ(ask("B4 60 00"), "DE F7 FF 00");
}

TEST_F(Gps, MonthsHaveTheDaysThatTheyHave) {
  constexpr unsigned days[] = {31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
  for (unsigned month = 1; month <= 12; ++month) {
    see({.date = GpsDate{2025, month, days[month - 1]}});
    EXPECT_NE(ask("B3 60 00"), "FE FF EE FF") << month;
    see({.date = GpsDate{2025, month, days[month - 1] + 1}});
    EXPECT_EQ(ask("B3 60 00"), "FE FF EE FF") << month;
  }
}

TEST_F(Gps, TellsHowManySatellitesThereAre) {
  see({.visible_satellites = 11, .tracked_satellites = 0});
  EXPECT_EQ(ask("B1 60 00"), "0B 00 00 00");
  see({.visible_satellites = 13, .tracked_satellites = 12});
  EXPECT_EQ(ask("B1 60 00"), "CD 00 00 00");
  see({.visible_satellites = 31, .tracked_satellites = 22});
  EXPECT_EQ(ask("B1 60 00"), "DD 00 00 00") << "there is no code for more than 13";
}

TEST_F(Gps, TellsHowGoodThePositionIs) {
  see({.fix = GpsFix::fix_3d, .vdop = 2.1, .hdop = 1.3, .pdop = 2.5});
  EXPECT_EQ(ask("B2 60 00"), "02 01 03 F2") << "in whole steps (errata Z27)";
  see({.fix = GpsFix::fix_2d, .vdop = 99.99, .hdop = 80, .pdop = 0});
  EXPECT_EQ(ask("B2 60 00"), "50 50 00 F1");
  see({.fix = GpsFix::none});
  EXPECT_EQ(ask("B2 60 00"), "FF FF FF F0");
}

TEST_F(Gps, TellsDateAndTime) {
  // 23 March 1994: year 07CAh, month 3, day 23 = 01 0111b, reserved 11 1111b.
  see({.date = GpsDate{1994, 3, 23}, .time = GpsTime{12, 35, 19}});
  EXPECT_EQ(ask("B3 60 00"), "CA 07 73 FD");
  // Second 1900 = 0 0111 0110 1100b, minute 35 = 10 0011b, hour 12 = 0 1100b.
  EXPECT_EQ(ask("B4 60 00"), "6C 64 3B 00");
  see({.date = GpsDate{2024, 2, 29}, .time = GpsTime{23, 59, 59.99}});
  // 07E8h, 2, 29 = 01 1101b.
  EXPECT_EQ(ask("B3 60 00"), "E8 07 D2 FD");
  // 176Fh = 1 0111 0110 1111b, 11 1011b, 1 0111b.
  EXPECT_EQ(ask("B4 60 00"), "77 7F BB 00");
  see({.time = GpsTime{23, 59, 60.2}});
  EXPECT_EQ(ask("B4 60 00"), "77 7F BB 00") << "a second that is inserted has no code";
  see({.time = GpsTime{0, 0, 0}});
  EXPECT_EQ(ask("B4 60 00"), "00 00 00 00");
}

TEST_F(Gps, TellsTheMovement) {
  see({.fix = GpsFix::fix_3d, .velocity = 13.89, .heading = 84.4});
  EXPECT_EQ(ask("B5 60 01"), "6D 05 00 00") << "1389 hundredths";
  EXPECT_EQ(ask("B5 60 02"), "4C 03 00 00") << "844 tenths";
  see({.fix = GpsFix::fix_3d, .velocity = 0, .heading = 359.94});
  EXPECT_EQ(ask("B5 60 01"), "00 00 00 00");
  EXPECT_EQ(ask("B5 60 02"), "0F 0E 00 00");
  see({.fix = GpsFix::fix_3d, .velocity = 1000, .heading = 359.95});
  EXPECT_EQ(ask("B5 60 01"), "FD FF 00 00") << "FFFDh is the highest";
  EXPECT_EQ(ask("B5 60 02"), "00 00 00 00") << "a whole turn is north";
  see({.fix = GpsFix::fix_3d, .heading = -90});
  EXPECT_EQ(ask("B5 60 02"), "8C 0A 00 00") << "270.0";
  see({.fix = GpsFix::fix_3d, .heading = std::nan("")});
  EXPECT_EQ(ask("B5 60 02"), "FF FF 00 00");
}

TEST_F(Gps, TellsTheHeightFromAThousandMetresBelowTheSea) {
  see({.fix = GpsFix::fix_3d, .altitude = -431});
  EXPECT_EQ(ask("B6 60 00"), "39 02 00 00");
  see({.fix = GpsFix::fix_3d, .altitude = -1000});
  EXPECT_EQ(ask("B6 60 00"), "00 00 00 00");
  see({.fix = GpsFix::fix_3d, .altitude = -1200});
  EXPECT_EQ(ask("B6 60 00"), "00 00 00 00");
  see({.fix = GpsFix::fix_3d, .altitude = 2599});
  EXPECT_EQ(ask("B6 60 00"), "0F 0E 00 00");
  see({.fix = GpsFix::fix_3d, .altitude = 2757.6});
  EXPECT_EQ(ask("B6 60 00"), "AE 0E 00 00") << "on the Stelvio the scale goes on (errata Z26)";
  see({.fix = GpsFix::fix_3d, .altitude = 1e9});
  EXPECT_EQ(ask("B6 60 00"), "FD FF 00 00");
}

TEST_F(Gps, IsLookedAtEachSecondAndAfterAReset) {
  reading = {.fix = GpsFix::fix_3d, .latitude = 1, .longitude = 1};
  bench.cable.clear();
  bench.cable.run_for(999ms);
  EXPECT_EQ(bench.cable.count(position_pdo), 0u);
  bench.cable.run_for(1ms);
  EXPECT_EQ(bench.cable.count(position_pdo), 1u);
  bench.cable.send("000#81 05");
  bench.cable.clear();
  bench.cable.send("000#01 05");
  EXPECT_EQ(bench.cable.last(position_pdo), "38F#80 96 98 00 80 96 98 00");
}

TEST_F(Gps, IsReadOnly) {
  EXPECT_EQ(bench.ask("23 B0 60 01 00 00 00 00"), "80 B0 60 01 02 00 01 06");
  EXPECT_EQ(bench.ask("2B B6 60 00 00 00 00 00"), "80 B6 60 00 02 00 01 06");
}

struct Talker {
  NmeaReceiver nmea;
  GpsUnit* unit = nullptr;

  GpsReading read() { return nmea.reading(); }
  GpsHardware hardware() { return {.read = callback<&Talker::read>(*this)}; }
  GpsSettings settings() { return {.period = 0s}; }
};

TEST(GpsByNmea, SentencesGoToTheBusWhenTheySaySo) {
  Talker talker;
  CarBench bench(only_unit<GpsKind>, [&](Environment& environment) {
    environment.provide(callback<&Talker::hardware>(talker));
    environment.provide(callback<&Talker::settings>(talker));
    environment.watch(talker.unit);
  });
  talker.nmea.receive("$GPRMC,123519,A,4807.038,N,01131.000,E,022.4,084.4,230394,003.1,W*6A\r\n");
  bench.cable.clear();
  bench.cable.run_for(1h);
  EXPECT_EQ(bench.cable.count(position_pdo), 0u);
  talker.unit->hardware_changed();
  bench.cable.run_for(0s);
  // 48.1173 and 11.5166667 degrees: 481 173 000 = 1CAE 1E08h, 115 166 667 = 06DD 4DCBh.
  EXPECT_EQ(bench.cable.last(position_pdo), "38F#08 1E AE 1C CB 4D DD 06");
  EXPECT_EQ(bench.ask("40 B5 60 01 00 00 00 00"), "4B B5 60 01 80 04 00 00") << "22.4 knots";
  EXPECT_EQ(talker.unit->reading().time, (GpsTime{12, 35, 19}));
}

TEST(GpsWithoutAReceiver, TellsThatNothingIsAvailable) {
  CarBench bench(only_unit<GpsKind>);
  bench.cable.run_for(10s);
  EXPECT_EQ(bench.cable.last(position_pdo), "38F#FF FF FF FF FF FF FF FF");
}

}  // namespace
}  // namespace canvoy::cia447::gps_unit_test
