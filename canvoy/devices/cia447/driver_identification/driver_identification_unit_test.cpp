// Driver identification at its wire (CiA 447-3, 4.2.15). 60FAh: logged in in bits 1..0, data
// state 3..2, ID system failure 5..4, reserved bits 1.
#include "canvoy/devices/cia447/driver_identification/driver_identification_unit.hpp"

#include <gtest/gtest.h>

#include "canvoy/devices/cia447/kit/car_bench_test.hpp"

namespace canvoy::cia447::driver_identification_unit_test {
namespace {

/// PDO 67 is the 13th of the list: 380h + 12 of node 5.
constexpr std::uint32_t status_pdo = 0x38C;

class Drivers : public testing::Test {
 protected:
  Drivers() {
    bench.emplace(only_unit<DriverIdentificationKind>, [this](Environment& environment) {
      environment.provide(Callback<DriverIdentificationSettings()>(
          [](void*) { return DriverIdentificationSettings{.clock_node = 7}; }, nullptr));
      environment.provide(callback<&Drivers::hardware>(*this));
      environment.watch(unit);
    });
  }
  std::string status() {
    bench->cable.run_for(0s);
    return bench->cable.last(status_pdo);
  }

  /// 2026-11-23 12:00:00, an hour ahead of UTC.
  std::optional<LocalTime> local = LocalTime{1'795'435'200, 3600};
  DriverIdentificationUnit* unit = nullptr;
  std::optional<CarBench> bench;

 private:
  DriverIdentificationHardware hardware() {
    return {.clock = callback<&Drivers::clock>(*this), .knows = callback<&Drivers::knows>(*this)};
  }
  std::optional<LocalTime> clock() { return local; }
  bool knows(std::uint64_t id) { return id != 666; }
};

TEST_F(Drivers, NobodyIsLoggedInAtFirst) {
  EXPECT_EQ(status(), "38C#C0");
  EXPECT_EQ(bench->ask("40 FC 60 00 00 00 00 00"), "4F FC 60 00 02 00 00 00");
  EXPECT_EQ(bench->ask("40 FC 60 01 00 00 00 00"), "43 FC 60 01 FF FF FF FF");
  EXPECT_EQ(bench->ask("40 FC 60 02 00 00 00 00"), "43 FC 60 02 FF FF FF FF");
}

TEST_F(Drivers, ADriverLogsInAndOut) {
  EXPECT_TRUE(unit->log_in({.id = 0x1122'3344'5566'7788, .name = "Eva"}));
  EXPECT_EQ(status(), "38C#C5") << "logged in, valid";
  EXPECT_EQ(bench->ask("40 F9 60 00 00 00 00 00"), "41 F9 60 00 08 00 00 00");
  EXPECT_EQ(bench->ask("60 00 00 00 00 00 00 00"), "00 88 77 66 55 44 33 22");
  EXPECT_EQ(bench->ask("70 00 00 00 00 00 00 00"), "1D 11 00 00 00 00 00 00");
  EXPECT_EQ(bench->ask("40 FB 60 00 00 00 00 00"), "47 FB 60 00 45 76 61 00");
  // 1795431600: 6B04 1CB0h.
  EXPECT_EQ(bench->ask("40 FC 60 01 00 00 00 00"), "43 FC 60 01 B0 1C 04 6B");
  EXPECT_EQ(bench->ask("40 FC 60 02 00 00 00 00"), "43 FC 60 02 FF FF FF FF");
  local->seconds += 16;
  EXPECT_TRUE(unit->log_out());
  EXPECT_EQ(status(), "38C#C0");
  EXPECT_EQ(bench->ask("40 FC 60 01 00 00 00 00"), "43 FC 60 01 B0 1C 04 6B")
      << "the last driver's";
  EXPECT_EQ(bench->ask("40 FC 60 02 00 00 00 00"), "43 FC 60 02 C0 1C 04 6B");
  EXPECT_FALSE(unit->log_out());
  unit->log_in({.id = 1});
  EXPECT_EQ(bench->ask("40 FC 60 02 00 00 00 00"), "43 FC 60 02 FF FF FF FF");
}

TEST_F(Drivers, OnlyOneIsLoggedIn) {
  unit->log_in({.id = 1, .name = "Eva"});
  EXPECT_FALSE(unit->log_in({.id = 2, .name = "Bob"}));
  EXPECT_EQ(bench->ask("40 FB 60 00 00 00 00 00"), "47 FB 60 00 45 76 61 00");
}

TEST_F(Drivers, ACardThatIsNotKnownIsAnIdentificationFailure) {
  EXPECT_FALSE(unit->log_in({.id = 666}));
  EXPECT_EQ(status(), "38C#D0");
  EXPECT_TRUE(unit->log_in({.id = 1}));
  EXPECT_EQ(status(), "38C#C5");
  unit->card_is_unreadable();
  EXPECT_EQ(status(), "38C#D5") << "who is logged in stays so";
  unit->forget_failure();
  EXPECT_EQ(status(), "38C#C5");
}

TEST_F(Drivers, TheReaderMayFail) {
  unit->reader_is(CardReader::failed);
  EXPECT_EQ(status(), "38C#E8");
  EXPECT_FALSE(unit->log_in({.id = 1}));
  unit->reader_is(CardReader::not_available);
  EXPECT_EQ(status(), "38C#FC");
  unit->reader_is(CardReader::working);
  EXPECT_EQ(status(), "38C#C0");
}

TEST_F(Drivers, WithoutAClockTimesAreNotAvailable) {
  local.reset();
  EXPECT_TRUE(unit->log_in({.id = 1}));
  EXPECT_EQ(bench->ask("40 FC 60 01 00 00 00 00"), "43 FC 60 01 FF FF FF FF");
}

TEST_F(Drivers, TheClockOnTheBusGoesBeforeTheirOwn) {
  // 1970-01-02, 0:00:05, without zone or status.
  bench->ask_as(7, "23 F0 60 00 B2 07 21 F0");
  bench->ask_as(7, "23 F2 60 00 00 00 F4 01");
  unit->log_in({.id = 1});
  EXPECT_EQ(bench->ask("40 FC 60 01 00 00 00 00"), "43 FC 60 01 85 51 01 00") << "86405";
}

TEST_F(Drivers, NobodyElseSetsTheirClock) {
  // Node 6, the gateway, and a client on the default channel: 0800 0021h.
  EXPECT_EQ(bench->ask_as(6, "23 F0 60 00 B2 07 21 F0"), "80 F0 60 00 21 00 00 08");
  EXPECT_EQ(bench->ask_as(1, "23 F2 60 00 00 00 F4 01"), "80 F2 60 00 21 00 00 08");
  EXPECT_EQ(bench->ask("23 F4 60 00 11 01 CE FF"), "80 F4 60 00 21 00 00 08");
  EXPECT_EQ(bench->ask_as(7, "23 F0 60 00 EA 07 F2 F1"), "80 F0 60 00 30 00 09 06")
      << "31 February 2026";
  unit->log_in({.id = 1});
  EXPECT_EQ(bench->node().dictionary().number(0x60FC, 1), 1'795'435'200u - 3600);
}

TEST_F(Drivers, ANameThatIsTooLongIsCutBetweenTwoCharacters) {
  std::string name(63, 'x');
  name += "\xC3\xA9";
  unit->log_in({.id = 1, .name = name});
  EXPECT_EQ(bench->ask("40 FB 60 00 00 00 00 00"), "41 FB 60 00 3F 00 00 00") << "63 bytes";
}

TEST_F(Drivers, AnNmtResetLogsNobodyOut) {
  unit->log_in({.id = 1, .name = "Eva"});
  bench->cable.send("000#81 05");
  bench->cable.clear();
  bench->cable.send("000#01 05");
  EXPECT_EQ(status(), "38C#C5");
  EXPECT_EQ(bench->ask("40 FB 60 00 00 00 00 00"), "47 FB 60 00 45 76 61 00");
}

}  // namespace
}  // namespace canvoy::cia447::driver_identification_unit_test
