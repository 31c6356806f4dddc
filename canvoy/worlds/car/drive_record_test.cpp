// A recorded drive: what is read of NMEA 0183, and how the car follows it.
#include "canvoy/worlds/car/drive_record.hpp"

#include <gtest/gtest.h>

#include "canvoy/worlds/car/drive.hpp"

namespace canvoy::car::drive_record_test {
namespace {

std::string sentence(const std::string& content) {
  constexpr std::string_view digits = "0123456789ABCDEF";
  unsigned sum = 0;
  for (const char byte : content) sum ^= static_cast<unsigned char>(byte);
  return "$" + content + "*" + digits[sum / 16] + digits[sum % 16] + "\r\n";
}
std::string two_digits(unsigned number) {
  return {static_cast<char>('0' + number / 10), static_cast<char>('0' + number % 10)};
}
/// A sentence at a second of the hour of noon, with a speed in knots.
std::string rmc(unsigned second, const std::string& knots) {
  return sentence("GPRMC,12" + two_digits(second / 60) + two_digits(second % 60) +
                  ",A,4808.220,N,01134.500,E," + knots + ",084.4,211126,,");
}
constexpr double knot = 1852.0 / 3600;

/// Ten seconds at 20 knots, with a second before and after in which the car stands.
std::string short_drive(unsigned from) {
  std::string text = rmc(from, "0");
  for (unsigned i = 1; i <= 10; ++i) text += rmc(from + i, "20");
  return text + rmc(from + 11, "0");
}

TEST(DriveRecord, SpeedsAreThoseOfRmc) {
  const DriveRecord record = read_drive_record(short_drive(0));
  ASSERT_EQ(record.samples.size(), 12u);
  EXPECT_EQ(record.samples[5].at, Duration(5s));
  EXPECT_NEAR(record.samples[5].speed, 20 * knot, 1e-9);
  EXPECT_EQ(record.counts.passed_over(), 0u);
  ASSERT_EQ(record.legs.size(), 1u);
  EXPECT_EQ(record.legs[0].begin, Duration{});
  EXPECT_EQ(record.legs[0].end, Duration(11s));
}

TEST(DriveRecord, VtgOfTheSameSecondGoesBeforeAndNeedsAClock) {
  const std::string vtg = sentence("GPVTG,054.7,T,034.4,M,005.5,N,036.0,K");
  EXPECT_FALSE(read_drive_record(vtg).is_usable()) << "nobody says when";
  const DriveRecord record = read_drive_record(rmc(0, "3") + vtg + rmc(1, "3"));
  ASSERT_EQ(record.samples.size(), 2u);
  EXPECT_NEAR(record.samples[0].speed, 10, 1e-9) << "36 km/h";
  EXPECT_NEAR(record.samples[1].speed, 3 * knot, 1e-9);
}

TEST(DriveRecord, WithoutSpeedsThePositionsOfGgaTellThem) {
  // 0.006 minutes of latitude are 11.1 m on any sphere of the earth's size.
  const std::string text = sentence("GPGGA,120000,4808.220,N,01134.500,E,1,09,0.9,519.0,M,,M,,") +
                           sentence("GPGGA,120001,4808.226,N,01134.500,E,1,09,0.9,519.0,M,,M,,") +
                           sentence("GPGGA,120003,4808.232,N,01134.500,E,1,09,0.9,519.0,M,,M,,");
  const DriveRecord record = read_drive_record(text);
  ASSERT_EQ(record.samples.size(), 2u) << "of the first one nobody knows";
  EXPECT_NEAR(record.samples[0].speed, 11.1, 0.1);
  EXPECT_NEAR(record.samples[1].speed, 11.1 / 2, 0.05);
}

TEST(DriveRecord, WhatIsBrokenIsCountedAndPassedOver) {
  std::string wrong = rmc(3, "20");
  wrong[wrong.size() - 3] = wrong[wrong.size() - 3] == '0' ? '1' : '0';
  const std::string text = rmc(0, "20") + wrong + "noise\n" + rmc(4, "20") + rmc(2, "20") +
                           rmc(5, "200") + sentence("GPRMC,999999,A,,,,,,,,,") + rmc(6, "20");
  const DriveRecord record = read_drive_record(text);
  EXPECT_EQ(record.counts.lines.wrong_checksum, 1u);
  EXPECT_EQ(record.counts.lines.garbage, 1u);
  EXPECT_EQ(record.counts.lines.malformed, 1u);
  EXPECT_EQ(record.counts.out_of_order, 1u);
  EXPECT_EQ(record.counts.impossible, 1u) << "370 km/h";
  ASSERT_EQ(record.samples.size(), 3u);
  EXPECT_EQ(record.samples[1].at, Duration(4s));
  EXPECT_EQ(record.samples[2].at, Duration(6s));
}

TEST(DriveRecord, WhereNothingMovesItIsOfNoUse) {
  EXPECT_FALSE(read_drive_record("").is_usable());
  EXPECT_FALSE(read_drive_record("hello\n").is_usable());
  EXPECT_FALSE(read_drive_record(rmc(0, "20")).is_usable()) << "one moment";
  EXPECT_FALSE(read_drive_record(rmc(0, "0.2") + rmc(1, "0.5")).is_usable())
      << "what a receiver says of a car that stands";
}

TEST(DriveRecord, MidnightPassesAndAGapIsASecond) {
  const auto at = [](const char* time) {
    return sentence("GPRMC," + std::string(time) + ",A,4808.220,N,01134.500,E,20,084.4,211126,,");
  };
  const DriveRecord record =
      read_drive_record(at("235959.50") + at("000001") + at("001000") + at("010000"));
  ASSERT_EQ(record.samples.size(), 4u);
  EXPECT_EQ(record.samples[1].at, Duration(1500ms));
  EXPECT_EQ(record.samples[2].at, Duration(1500ms) + 9min + 59s);
  EXPECT_EQ(record.samples[3].at, record.samples[2].at + Duration(1s)) << "recorder off";
}

TEST(DriveRecord, AStopOfTwoMinutesIsAnArrivalAndARedLightIsNone) {
  const DriveRecord record =
      read_drive_record(short_drive(0) + short_drive(100) + short_drive(11 + 100 + 120));
  ASSERT_EQ(record.legs.size(), 2u);
  EXPECT_EQ(record.legs[0].end, Duration(111s));
  EXPECT_EQ(record.legs[1].begin, Duration(231s));
}

TEST(DriveRecord, ACutSentenceAtTheEndIsNone) {
  const std::string whole = short_drive(0);
  EXPECT_EQ(read_drive_record(whole.substr(0, whole.size() - 2)).samples.size(), 12u)
      << "the last line has no end";
  EXPECT_EQ(read_drive_record(whole.substr(0, whole.size() - 10)).samples.size(), 11u);
}

// The car.

TEST(Drive, GoesAsItWasRecorded) {
  const DriveRecord record = read_drive_record(short_drive(0));
  Drive drive(&record);
  EXPECT_TRUE(drive.is_standing());
  drive.step(1s);
  EXPECT_EQ(drive.metres(), 0) << "nobody has got in";
  drive.go_on();
  for (int i = 0; i < 5; ++i) drive.step(100ms);
  EXPECT_NEAR(drive.speed(), 10 * knot, 1e-6) << "half a second of the first one";
  for (int i = 0; i < 50; ++i) drive.step(100ms);
  EXPECT_FALSE(drive.is_standing());
  EXPECT_NEAR(drive.speed(), 20 * knot, 1e-6);
  EXPECT_NEAR(drive.receiver().velocity.value_or(0), 20 * knot, 1e-6);
  EXPECT_NEAR(drive.receiver().latitude.value_or(0), 48.137, 1e-9);
  for (int i = 0; i < 60; ++i) drive.step(100ms);
  EXPECT_TRUE(drive.is_standing());
  EXPECT_TRUE(drive.is_through());
  // Ten seconds at 20 knots, and half a second before and after.
  EXPECT_NEAR(drive.metres(), 20 * knot * 10, 1e-6);
  drive.go_on();
  EXPECT_TRUE(drive.is_standing()) << "there is no more";
}

TEST(Drive, StandsBetweenTwoLegsUntilItIsToldToGoOn) {
  const DriveRecord record = read_drive_record(short_drive(0) + short_drive(300));
  Drive drive(&record);
  drive.go_on();
  drive.step(1h);
  const double first = drive.metres();
  EXPECT_TRUE(drive.is_standing());
  EXPECT_FALSE(drive.is_through());
  drive.step(1h);
  EXPECT_EQ(drive.metres(), first);
  drive.go_on();
  drive.step(5s);
  EXPECT_GT(drive.metres(), first);
  EXPECT_EQ(drive.receiver().time, (cia447::GpsTime{12, 5, 5}));
}

}  // namespace
}  // namespace canvoy::car::drive_record_test
