// A taxi alarm system at its wire (CiA 447-3, 4.2.17). 6110h: saa in bits 1..0, faa 3..2, akp 5..4,
// rakp 7..6, recr 9..8, reserved bits 1.
#include "canvoy/devices/cia447/taxi_alarm/taxi_alarm_unit.hpp"

#include <gtest/gtest.h>

#include "canvoy/devices/cia447/kit/car_bench_test.hpp"

namespace canvoy::cia447::taxi_alarm_unit_test {
namespace {

/// PDO 71 is the 17th of the list: 380h + 16 of node 5.
constexpr std::uint32_t status_pdo = 0x390;

class AlarmBench {
 public:
  explicit AlarmBench(const TaxiAlarmSettings& wanted = {}) : settings(wanted) {
    bench.emplace(only_unit<TaxiAlarmKind>, [this](Environment& environment) {
      environment.provide(callback<&AlarmBench::offered>(*this));
      environment.provide(callback<&AlarmBench::hardware>(*this));
      environment.watch(unit);
    });
  }
  AlarmBench(const AlarmBench&) = delete;
  AlarmBench& operator=(const AlarmBench&) = delete;

  std::string status() {
    bench->cable.run_for(0s);
    return bench->cable.last(status_pdo);
  }

  TaxiAlarmSettings settings;
  bool is_silent = false;
  bool is_full = false;
  TaxiAlarmUnit* unit = nullptr;
  std::optional<CarBench> bench;

 private:
  TaxiAlarmSettings offered() { return settings; }
  TaxiAlarmHardware hardware() { return {.alarm = callback<&AlarmBench::alarm>(*this)}; }
  void alarm(bool silent, bool full) {
    is_silent = silent;
    is_full = full;
  }
};

TEST(TaxiAlarm, IsQuietAtFirst) {
  AlarmBench alarm;
  EXPECT_EQ(alarm.status(), "390#00 FC");
  EXPECT_EQ(alarm.bench->ask("40 10 61 00 00 00 00 00"), "4B 10 61 00 00 FC 00 00");
  EXPECT_EQ(alarm.bench->ask("2B 10 61 00 00 00 00 00"), "80 10 61 00 02 00 01 06");
}

TEST(TaxiAlarm, AKeySetsOffASilentAlarmThatStays) {
  AlarmBench alarm;
  alarm.unit->press_key(true);
  EXPECT_EQ(alarm.status(), "390#11 FD") << "silent alarm, key pressed, radio is to call";
  EXPECT_TRUE(alarm.is_silent);
  EXPECT_FALSE(alarm.is_full);
  alarm.unit->press_key(false);
  EXPECT_EQ(alarm.status(), "390#01 FD");
  alarm.unit->radio_has_called();
  EXPECT_EQ(alarm.status(), "390#01 FC");
  alarm.unit->reset_alarm();
  EXPECT_EQ(alarm.status(), "390#00 FC");
  EXPECT_FALSE(alarm.is_silent);
}

TEST(TaxiAlarm, TheRemoteKeySetsOffAFullOne) {
  AlarmBench alarm;
  alarm.unit->press_remote_key(true);
  EXPECT_EQ(alarm.status(), "390#44 FD");
  EXPECT_TRUE(alarm.is_full);
  alarm.unit->press_key(true);
  EXPECT_EQ(alarm.status(), "390#55 FD") << "and the other one too";
}

TEST(TaxiAlarm, AKeyThatIsHeldSetsOffNothingAnew) {
  AlarmBench alarm;
  alarm.unit->press_key(true);
  alarm.unit->reset_alarm();
  alarm.unit->press_key(true);
  EXPECT_EQ(alarm.status(), "390#10 FC");
  alarm.unit->press_key(false);
  alarm.unit->press_key(true);
  EXPECT_EQ(alarm.status(), "390#11 FD");
}

TEST(TaxiAlarm, KeysMayFail) {
  AlarmBench alarm;
  alarm.unit->press_key(Signal::failure);
  EXPECT_EQ(alarm.status(), "390#20 FC");
  alarm.unit->press_remote_key(Signal::not_available);
  EXPECT_EQ(alarm.status(), "390#E0 FC");
  alarm.unit->press_key(Signal::yes);
  EXPECT_EQ(alarm.status(), "390#D1 FD") << "mended, and pressed";
}

TEST(TaxiAlarm, WhatAKeySetsOffIsChosen) {
  AlarmBench alarm(
      {.by_key = AlarmKind::both, .by_remote_key = AlarmKind::none, .calls_by_radio = false});
  alarm.unit->press_remote_key(true);
  EXPECT_EQ(alarm.status(), "390#40 FC");
  alarm.unit->press_key(true);
  EXPECT_EQ(alarm.status(), "390#55 FC");
}

TEST(TaxiAlarm, WithoutARemoteKeyItIsNotAvailable) {
  AlarmBench alarm({.has_remote_key = false});
  EXPECT_EQ(alarm.status(), "390#C0 FC");
}

TEST(TaxiAlarm, NoNmtResetEndsAnAlarm) {
  AlarmBench alarm;
  alarm.unit->press_key(true);
  alarm.bench->cable.send("000#81 05");
  alarm.bench->cable.clear();
  alarm.bench->cable.send("000#01 05");
  EXPECT_EQ(alarm.status(), "390#11 FD");
  EXPECT_TRUE(alarm.is_silent);
}

}  // namespace
}  // namespace canvoy::cia447::taxi_alarm_unit_test
