// A real time clock at its wire (CiA 447-3, 4.2.14). 60F0h: year in bits 15..0, month in
// bits 19..16, day in bits 27..20, reserved bits 1 (errata Z02); 60F2h: hour, minute, and 1/100 s
// in bits 31..16.
#include "canvoy/devices/cia447/real_time_clock/real_time_clock_unit.hpp"

#include <gtest/gtest.h>

#include "canvoy/devices/cia447/kit/car_bench_test.hpp"

namespace canvoy::cia447::real_time_clock_unit_test {
namespace {

constexpr TimeZone berlin = {.name = "CET", .offset_minutes = 60, .summer = european_summer};

std::string hex(std::uint32_t number) {
  char text[16];
  std::snprintf(text, sizeof text, "%02X %02X %02X %02X", number & 0xFF, number >> 8 & 0xFF,
                number >> 16 & 0xFF, number >> 24);
  return text;
}

class ClockBench {
 public:
  explicit ClockBench(const RealTimeClockSettings& wanted = {.zone = berlin},
                      std::optional<ChipTime> kept = std::nullopt)
      : settings(wanted), chip(kept) {
    bench.emplace(only_unit<RealTimeClockKind>, [this](Environment& environment) {
      environment.provide(callback<&ClockBench::offered_settings>(*this));
      environment.provide(callback<&ClockBench::hardware>(*this));
      environment.watch(unit);
    });
  }
  ClockBench(const ClockBench&) = delete;
  ClockBench& operator=(const ClockBench&) = delete;

  std::string date() { return bench->ask("40 F0 60 00 00 00 00 00").substr(12); }
  std::string time() { return bench->ask("40 F2 60 00 00 00 00 00").substr(12); }
  std::string status() { return bench->ask("40 F4 60 00 00 00 00 00").substr(12); }
  /// The answer: "" for done, or the abort code's bytes.
  std::string set(const char* object, const std::string& value) {
    const std::string answer = bench->ask("23 " + std::string(object) + " 60 00 " + value);
    return answer.substr(0, 2) == "60" ? "" : answer.substr(12);
  }
  void run_for(Duration duration) { bench->cable.run_for(duration); }

  RealTimeClockSettings settings;
  std::optional<ChipTime> chip;
  std::optional<ChipTime> was_written;
  RealTimeClockUnit* unit = nullptr;
  std::optional<CarBench> bench;

 private:
  RealTimeClockSettings offered_settings() { return settings; }
  RealTimeClockHardware hardware() {
    return {.read = callback<&ClockBench::read>(*this),
            .write = callback<&ClockBench::write>(*this)};
  }
  std::optional<ChipTime> read() { return chip; }
  void write(const ChipTime& time) { was_written = time; }
};

ChipTime utc(std::int64_t year, unsigned month, unsigned day, unsigned hour, unsigned minute = 0,
             unsigned second = 0) {
  return {.since_1970 =
              std::chrono::seconds(seconds_since_1970({year, month, day, hour, minute, second}))};
}

constexpr const char* value_range = "30 00 09 06";
constexpr const char* device_state = "22 00 00 08";

TEST(RealTimeClock, HasNoDateBeforeOneIsSet) {
  ClockBench clock;
  EXPECT_EQ(clock.date(), "00 00 00 F0") << "no date is set";
  EXPECT_EQ(clock.time(), "00 00 00 00") << "0:00:00,00 (errata Z07)";
  // Battery buffered (3), user adjustable (0), not valid (0), summer time supported (1), not active
  // (0), +1 h (34h in bits 21..14), reserved bits 1.
  EXPECT_EQ(clock.status(), hex(0xFFC0'0000U | 0x34U << 14 | 1U << 10 | 3U));
  EXPECT_FALSE(clock.unit->is_valid());
}

TEST(RealTimeClock, GoesOnWithoutADate) {
  ClockBench clock;
  clock.run_for(25h + 61min + 2s + 340ms);
  EXPECT_EQ(clock.time(), "02 01 EA 00") << "2:01:02,34";
  EXPECT_EQ(clock.date(), "00 00 00 F0");
}

TEST(RealTimeClock, TellsWhatItsChipKept) {
  ClockBench clock({.zone = berlin}, utc(2026, 11, 23, 11, 59, 59));
  // 2026 (7EAh), November (Bh), the 23rd (17h).
  EXPECT_EQ(clock.date(), "EA 07 7B F1");
  EXPECT_EQ(clock.time(), "0C 3B 0C 17") << "12:59:59,00: 170Ch";
  EXPECT_EQ(clock.status(), hex(0xFFC0'0000U | 0x34U << 14 | 1U << 10 | 1U << 8 | 3U)) << "valid";
  clock.run_for(990ms);
  EXPECT_EQ(clock.time(), "0C 3B 6F 17") << "59,99 s: 176Fh, the most";
  clock.run_for(10ms);
  EXPECT_EQ(clock.time(), "0D 00 00 00");
}

TEST(RealTimeClock, EveryDateHasItsCode) {
  struct Date {
    std::int64_t year;
    unsigned month;
    unsigned day;
  };
  for (const Date& date : {Date{1, 1, 2}, Date{1999, 12, 31}, Date{2024, 2, 29}, Date{2025, 2, 28},
                           Date{9999, 10, 1}, Date{65'533, 12, 30}}) {
    ClockBench clock({}, utc(date.year, date.month, date.day, 12));
    const auto year = static_cast<std::uint32_t>(date.year);
    EXPECT_EQ(clock.date(), hex(0xF000'0000U | date.day << 20 | date.month << 16 | year));
  }
}

TEST(RealTimeClock, AfterTheLastYearThereIsNoDate) {
  ClockBench clock({}, utc(65'533, 12, 31, 23, 59, 59));
  clock.run_for(1s);
  EXPECT_EQ(clock.date(), "00 00 00 F0");
  EXPECT_EQ(clock.time(), "00 00 00 00");
}

TEST(RealTimeClock, MidnightAndTheLeapDayCome) {
  ClockBench clock({}, utc(2024, 2, 28, 23, 59, 59));
  EXPECT_EQ(clock.date(), "E8 07 C2 F1");
  clock.chip = std::nullopt;
  clock.run_for(1s);
  EXPECT_EQ(clock.date(), "E8 07 D2 F1") << "the 29th";
  clock.run_for(24h);
  EXPECT_EQ(clock.date(), "E8 07 13 F0") << "the first of March";
}

// Summer time (errata Z14: the offset in quarters of an hour, from -12 h).

TEST(RealTimeClock, GoesAnHourForwardInSpringAndBackInAutumn) {
  ClockBench clock({.zone = berlin}, utc(2026, 3, 29, 0, 59, 59));
  EXPECT_EQ(clock.time(), "01 3B 0C 17");
  clock.run_for(1s);
  EXPECT_EQ(clock.time(), "03 00 00 00");
  EXPECT_EQ(clock.status(), hex(0xFFC0'0000U | 0x38U << 14 | 1U << 12 | 1U << 10 | 1U << 8 | 3U));
  ClockBench autumn({.zone = berlin}, utc(2026, 10, 25, 0, 59, 59));
  EXPECT_EQ(autumn.time(), "02 3B 0C 17");
  autumn.run_for(1s);
  EXPECT_EQ(autumn.time(), "02 00 00 00");
  EXPECT_EQ(autumn.status(), hex(0xFFC0'0000U | 0x34U << 14 | 1U << 10 | 1U << 8 | 3U));
}

TEST(RealTimeClock, InTheHourThatThereIsTwiceASetTimeIsOfTheOneThatItIs) {
  ClockBench summer({.zone = berlin}, utc(2026, 10, 25, 0, 30, 0));
  EXPECT_EQ(summer.set("F3", "02 3B 0C 17"), "") << "02:59:59";
  EXPECT_EQ(summer.time(), "02 3B 0C 17");
  EXPECT_EQ(summer.status(), hex(0xFFC0'0000U | 0x38U << 14 | 1U << 12 | 1U << 10 | 1U << 8 | 3U));
  summer.run_for(1s);
  EXPECT_EQ(summer.time(), "02 00 00 00") << "once more";
  ClockBench winter({.zone = berlin}, utc(2026, 10, 25, 1, 30, 0));
  EXPECT_EQ(winter.set("F3", "02 3B 0C 17"), "");
  EXPECT_EQ(winter.status(), hex(0xFFC0'0000U | 0x34U << 14 | 1U << 10 | 1U << 8 | 3U));
  winter.run_for(1s);
  EXPECT_EQ(winter.time(), "03 00 00 00");
}

TEST(RealTimeClock, EveryOffsetHasItsCode) {
  for (int quarter = 0; quarter <= 0x68; ++quarter) {
    const auto minutes = static_cast<std::int16_t>((quarter - 48) * 15);
    ClockBench clock({.zone = {.offset_minutes = minutes}}, utc(2026, 11, 23, 12));
    EXPECT_EQ(clock.status(),
              hex(0xFFC0'0000U | static_cast<std::uint32_t>(quarter) << 14 | 1U << 8 | 3U))
        << quarter;
  }
}

TEST(RealTimeClock, TellsSourceAndTrustability) {
  ClockBench clock(
      {.source = RtcSource::gps, .trustability = RtcTrustability::accepted_by_authority},
      utc(2026, 11, 23, 12));
  EXPECT_EQ(clock.status(), hex(0xFFC0'0000U | 0x30U << 14 | 1U << 8 | 1U << 4 | 1U));
}

TEST(RealTimeClock, TheZoneHasSixCharacters) {
  ClockBench clock;
  EXPECT_EQ(clock.bench->ask("40 F5 60 00 00 00 00 00"), "41 F5 60 00 06 00 00 00");
  EXPECT_EQ(clock.bench->ask("60 00 00 00 00 00 00 00"), "03 43 45 54 20 20 20 00") << "\"CET   \"";
  ClockBench longer({.zone = {.name = "Europe/Berlin"}});
  EXPECT_EQ(longer.bench->ask("40 F5 60 00 00 00 00 00"), "41 F5 60 00 06 00 00 00");
  EXPECT_EQ(longer.bench->ask("60 00 00 00 00 00 00 00"), "03 45 75 72 6F 70 65 00")
      << "\"Europe\"";
  ClockBench accented({.zone = {.name = "H\xC3\xA9"}});
  EXPECT_EQ(accented.bench->ask("40 F5 60 00 00 00 00 00"), "41 F5 60 00 07 00 00 00");
  EXPECT_EQ(accented.bench->ask("60 00 00 00 00 00 00 00"), "01 48 C3 A9 20 20 20 20")
      << "of seven bytes";
}

// Setting it (4.2.14.2, 4.2.14.4).

TEST(RealTimeClock, IsValidWhenDateAndTimeWereSet) {
  ClockBench clock;
  EXPECT_EQ(clock.set("F1", "EA 07 7B F1"), "");
  EXPECT_EQ(clock.date(), "EA 07 7B F1");
  EXPECT_EQ(clock.time(), "00 00 00 00");
  EXPECT_FALSE(clock.unit->is_valid()) << "nobody has said what time it is";
  EXPECT_EQ(clock.set("F3", "0C 1E D0 07"), "") << "12:30:20,00";
  EXPECT_EQ(clock.time(), "0C 1E D0 07");
  EXPECT_TRUE(clock.unit->is_valid());
  clock.run_for(1s);
  EXPECT_EQ(clock.time(), "0C 1E 34 08");
  ASSERT_TRUE(clock.was_written.has_value());
  EXPECT_EQ(clock.was_written->since_1970, utc(2026, 11, 23, 11, 30, 20).since_1970);
  EXPECT_TRUE(clock.was_written->has_date);
}

TEST(RealTimeClock, OneFieldOfTheDateIsSet) {
  ClockBench clock({}, utc(2026, 11, 23, 12));
  EXPECT_EQ(clock.set("F1", "FF FF 5F F0"), "") << "the 5th; year and month as they are";
  EXPECT_EQ(clock.date(), "EA 07 5B F0");
  EXPECT_EQ(clock.set("F1", "FF FF F2 FF"), "") << "February";
  EXPECT_EQ(clock.date(), "EA 07 52 F0");
  EXPECT_EQ(clock.set("F1", "D0 07 FF FF"), "") << "2000";
  EXPECT_EQ(clock.date(), "D0 07 52 F0");
  EXPECT_EQ(clock.set("F1", "FF FF FF FF"), "");
  EXPECT_EQ(clock.date(), "D0 07 52 F0");
}

TEST(RealTimeClock, OneFieldOfTheTimeIsSet) {
  ClockBench clock({}, utc(2026, 11, 23, 12, 34, 56));
  EXPECT_EQ(clock.set("F3", "FF 00 FF FF"), "");
  EXPECT_EQ(clock.time(), "0C 00 E0 15") << "12:00:56";
  EXPECT_EQ(clock.set("F3", "17 FF FF FF"), "");
  EXPECT_EQ(clock.time(), "17 00 E0 15");
  EXPECT_EQ(clock.set("F3", "FF FF 00 00"), "");
  EXPECT_EQ(clock.time(), "17 00 00 00");
  EXPECT_EQ(clock.set("F3", "FF FF FF FF"), "");
  EXPECT_EQ(clock.time(), "17 00 00 00");
}

TEST(RealTimeClock, TheDateIsReset) {
  for (const char* command : {"00 00 00 F0", "00 00 FF FF", "FF FF F0 FF", "FF FF 0F F0"}) {
    ClockBench clock({.zone = berlin}, utc(2026, 7, 23, 10, 34, 56));
    EXPECT_EQ(clock.set("F1", command), "") << command;
    EXPECT_EQ(clock.date(), "00 00 00 F0") << command;
    EXPECT_EQ(clock.time(), "0C 22 E0 15") << "the time goes on as it was shown";
    EXPECT_FALSE(clock.unit->is_valid());
    EXPECT_FALSE(clock.was_written->has_date);
  }
}

TEST(RealTimeClock, ReservedCodesAreRefused) {
  ClockBench clock({}, utc(2026, 11, 23, 12));
  for (const char* command :
       {"FE FF 7B F1", "EA 07 7D F1", "EA 07 7E F1", "EA 07 0B F2", "EA 07 EB FF"}) {
    EXPECT_EQ(clock.set("F1", command), value_range) << command;
  }
  for (const char* command :
       {"18 00 00 00", "FE 00 00 00", "00 3C 00 00", "00 FE 00 00", "00 00 70 17", "00 00 FE FF"}) {
    EXPECT_EQ(clock.set("F3", command), value_range) << command;
  }
  EXPECT_EQ(clock.date(), "EA 07 7B F1");
  EXPECT_EQ(clock.time(), "0C 00 00 00");
}

TEST(RealTimeClock, DaysThatThereAreNotAreRefused) {
  ClockBench clock({}, utc(2025, 1, 31, 12));
  EXPECT_EQ(clock.set("F1", "FF FF F2 FF"), value_range) << "the 31st of February";
  EXPECT_EQ(clock.set("F1", "E9 07 D2 F1"), value_range) << "2025-02-29";
  EXPECT_EQ(clock.set("F1", "E8 07 D2 F1"), "") << "2024-02-29";
  EXPECT_EQ(clock.set("F1", "E9 07 FF FF"), value_range) << "the same day of 2025";
}

TEST(RealTimeClock, APartOfADateThatIsNotSetIsRefused) {
  ClockBench clock;
  EXPECT_EQ(clock.set("F1", "EA 07 FF FF"), device_state);
  EXPECT_EQ(clock.date(), "00 00 00 F0");
}

TEST(RealTimeClock, WhatAnAuthorityHasAcceptedNobodySets) {
  ClockBench clock({.trustability = RtcTrustability::accepted_by_authority}, utc(2026, 11, 23, 12));
  EXPECT_EQ(clock.set("F1", "EA 07 5B F1"), device_state);
  EXPECT_EQ(clock.set("F3", "00 00 00 00"), device_state);
  EXPECT_EQ(clock.set("F3", "FF FF FF FF"), "") << "nothing is wanted";
}

TEST(RealTimeClock, AnNmtResetSetsNothingBack) {
  ClockBench clock;
  clock.set("F1", "EA 07 7B F1");
  clock.set("F3", "0C 1E D0 07");
  clock.bench->cable.send("000#81 05");
  clock.run_for(1s);
  EXPECT_EQ(clock.date(), "EA 07 7B F1");
  EXPECT_EQ(clock.time(), "0C 1E 34 08");
  EXPECT_EQ(clock.bench->ask("40 F1 60 00 00 00 00 00"), "43 F1 60 00 FF FF FF FF");
}

TEST(RealTimeClock, KeepsToItsChip) {
  ClockBench clock({}, utc(2026, 11, 23, 12));
  clock.run_for(59s);
  clock.chip = utc(2026, 11, 23, 12, 1, 2);
  clock.run_for(1s);
  EXPECT_EQ(clock.time(), "0C 01 C8 00") << "2 s ahead";
  clock.chip = std::nullopt;
  clock.run_for(1min);
  EXPECT_EQ(clock.time(), "0C 02 C8 00") << "without it, it goes on";
}

TEST(RealTimeClock, StatusesAreReadOnly) {
  ClockBench clock;
  for (const char* object : {"F0", "F2", "F4"}) {
    EXPECT_EQ(clock.set(object, "00 00 00 00"), "02 00 01 06");
  }
}

TEST(RealTimeClock, IsSetByGps) {
  ClockBench clock;
  clock.unit->set(utc(2026, 7, 1, 12).since_1970);
  EXPECT_EQ(clock.date(), "EA 07 17 F0");
  EXPECT_EQ(clock.time(), "0E 00 00 00") << "in summer two hours ahead";
}

}  // namespace
}  // namespace canvoy::cia447::real_time_clock_unit_test
