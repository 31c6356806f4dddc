// Reactions of the car to commands, at the wire (CiA 447-3, 4.2.2 and 4.2.3): doors, windows,
// flaps, seats, lights, the alarm. Of node 5 PDO 2 is 381h, PDO 5 is 384h, PDO 6 is 385h, PDO 19 is
// 389h.
#include <gtest/gtest.h>

#include "canvoy/devices/cia447/ivn_gateway/car_on_bench_test.hpp"

namespace canvoy::cia447::car_commands_test {
namespace {

constexpr std::string_view done_window = "60 0C 60 00 00 00 00 00";

struct CarCommands : testing::Test, CarOnBench {
  /// Writes a value of this number of bytes, least significant first, to an object's sub-index 00h.
  std::string write(const std::string& index, const std::string& value) {
    static constexpr const char* specifiers[] = {"", "2F", "2B", "27", "23"};
    const std::size_t bytes = (value.size() + 1) / 3;
    std::string padded = value;
    for (std::size_t i = bytes; i < 4; ++i) padded += " 00";
    return ask(std::string(specifiers[bytes]) + " " + index + " 00 " + padded);
  }
  /// The value of sub-index 00h, with zeros behind it.
  std::string read(const std::string& index) {
    return ask("40 " + index + " 00 00 00 00 00").substr(12);
  }

  Cable& cable = bench.cable;
};

TEST_F(CarCommands, ACarIsParkedAtFirst) {
  EXPECT_EQ(cable.last(0x380), "380#00") << "no key, ignition off";
  // Flaps closed (0), illumination 0 %, wipers off.
  EXPECT_EQ(cable.last(0x381), "381#00 00 C0 00 00 80");
  // Seats free, belts open, locked from outside (2).
  EXPECT_EQ(cable.last(0x383), "383#00 00 00 00 F2");
  // Windows and doors closed (1, errata C2), no indicator reset, day.
  EXPECT_EQ(cable.last(0x384), "384#49 92 FC 49 F2 F0 FC");
  // Both seats at rest: 3 six times (errata C1), no memories; reserved bits 1.
  EXPECT_EQ(cable.last(0x385), "385#FF 0F FC FF 0F FC");
  EXPECT_EQ(cable.last(0x386), "386#00 FF") << "no accident";
  EXPECT_EQ(cable.last(0x389), "389#00 00 00 00 F8 FC") << "no lights, no alarm, no horn";
}

TEST_F(CarCommands, AWindowIsGettingOpenAndThenOpen) {
  EXPECT_EQ(write("0C 60", "FC FF"), done_window);
  EXPECT_EQ(cable.last(0x384), "384#4A 92 FC 49 F2 F0 FC") << "is getting open: 2";
  cable.clear();
  cable.run_for(2999ms);
  EXPECT_EQ(cable.count(0x384), 0u);
  cable.run_for(1ms);
  EXPECT_EQ(cable.last(0x384), "384#48 92 FC 49 F2 F0 FC");
}

TEST_F(CarCommands, AWindowThatIsToldToGoBackTakesAsLongAsItHasCome) {
  write("0C 60", "FC FF");
  cable.run_for(1s);
  write("0C 60", "FD FF");
  EXPECT_EQ(read("0B 60"), "4B 92 FC 00") << "is getting closed: 3";
  cable.run_for(999ms);
  EXPECT_EQ(read("0B 60"), "4B 92 FC 00");
  cable.run_for(1ms);
  EXPECT_EQ(read("0B 60"), "49 92 FC 00");
  // And back and forth: 1 s open, 400 ms back, then the remaining 2.4 s.
  write("0C 60", "FC FF");
  cable.run_for(1s);
  write("0C 60", "FD FF");
  cable.run_for(400ms);
  write("0C 60", "FC FF");
  cable.run_for(2399ms);
  EXPECT_EQ(read("0B 60"), "4A 92 FC 00");
  cable.run_for(1ms);
  EXPECT_EQ(read("0B 60"), "48 92 FC 00");
}

TEST_F(CarCommands, WhatIsOpenIsNotOpenedAgain) {
  write("0C 60", "FD FF");
  EXPECT_EQ(read("0B 60"), "49 92 FC 00") << "closed already";
  write("0C 60", "FC FF");
  cable.run_for(2s);
  write("0C 60", "FC FF");
  cable.run_for(1s);
  EXPECT_EQ(read("0B 60"), "48 92 FC 00") << "told twice it does not take longer";
}

TEST_F(CarCommands, EachWindowGoesByItself) {
  write("0C 60", "FC FF");
  cable.run_for(1s);
  write("0C 60", "FF F3");  // 3rd row left: bits 11 and 10
  // 17..15: 2 is getting open.
  EXPECT_EQ(read("0B 60"), "4A 12 FD 00");
  cable.run_for(2s);
  EXPECT_EQ(read("0B 60"), "48 12 FD 00");
  cable.run_for(1s);
  EXPECT_EQ(read("0B 60"), "48 12 FC 00");
}

TEST_F(CarCommands, TheWindowOfOneThatIsOpenedByHandStaysSo) {
  write("0C 60", "FC FF");
  cable.run_for(1s);
  gateway().report(window_status_driver, Opening::closed);
  EXPECT_EQ(read("0B 60"), "49 92 FC 00");
  cable.run_for(10s);
  EXPECT_EQ(read("0B 60"), "49 92 FC 00");
}

TEST_F(CarCommands, ADoorOpens) {
  EXPECT_EQ(write("0E 60", "CF"), "60 0E 60 00 00 00 00 00") << "rear right: bits 5 and 4";
  EXPECT_EQ(read("0D 60"), "89 F2 00 00");
  cable.run_for(4s);
  EXPECT_EQ(read("0D 60"), "09 F2 00 00");
  EXPECT_EQ(write("0E 60", "EF"), "80 0E 60 00 30 00 09 06");
}

TEST_F(CarCommands, FlapsCountTheOtherWayRound) {
  write("11 60", "FD FF");  // open the engine hood
  EXPECT_EQ(read("10 60"), "03 00 C0 00") << "is getting open: 3 (errata C2)";
  cable.run_for(1s);
  EXPECT_EQ(read("10 60"), "01 00 C0 00");
  write("11 60", "FC FF");
  EXPECT_EQ(read("10 60"), "02 00 C0 00");
  EXPECT_EQ(write("11 60", "FE FF"), "80 11 60 00 30 00 09 06") << "an engine hood has no stop";
}

TEST_F(CarCommands, TheConvertibleTopStopsAndGoesOn) {
  write("11 60", "7F FF");  // open: bits 7 and 6
  EXPECT_EQ(read("10 60"), "00 06 C0 00") << "bits 11 to 9: 3";
  cable.run_for(3s);
  EXPECT_EQ(write("11 60", "BF FF"), "60 11 60 00 00 00 00 00") << "stop (errata A8)";
  EXPECT_EQ(read("10 60"), "00 08 C0 00");
  cable.run_for(1h);
  EXPECT_EQ(read("10 60"), "00 08 C0 00");
  write("11 60", "7F FF");
  cable.run_for(8999ms);
  EXPECT_EQ(read("10 60"), "00 06 C0 00");
  cable.run_for(1ms);
  EXPECT_EQ(read("10 60"), "00 02 C0 00") << "12 s in all";
  write("11 60", "BF FF");
  EXPECT_EQ(read("10 60"), "00 02 C0 00") << "what does not move cannot be stopped";
}

TEST_F(CarCommands, AStoppedTopClosesFromWhereItIs) {
  write("11 60", "7F FF");
  cable.run_for(3s);
  write("11 60", "BF FF");
  write("11 60", "3F FF");
  EXPECT_EQ(read("10 60"), "00 04 C0 00") << "is getting closed: 2";
  cable.run_for(2999ms);
  EXPECT_EQ(read("10 60"), "00 04 C0 00");
  cable.run_for(1ms);
  EXPECT_EQ(read("10 60"), "00 00 C0 00");
}

TEST_F(CarCommands, TheSlidingRoofTiltsAndSlides) {
  // Command bits 14 to 12, status bits 21 to 18; they do not share their codes (errata C3).
  write("11 60", "FF BF");  // open (slide): 3
  EXPECT_EQ(read("10 60"), "00 00 D8 00") << "6";
  cable.run_for(1s);
  write("11 60", "FF CF");  // stop: 4
  EXPECT_EQ(read("10 60"), "00 00 E0 00") << "8";
  write("11 60", "FF BF");
  cable.run_for(3s);
  EXPECT_EQ(read("10 60"), "00 00 C8 00") << "2";
  write("11 60", "FF AF");  // open (tilt)
  write("11 60", "FF 8F");  // close (tilt)
  EXPECT_EQ(read("10 60"), "00 00 C8 00") << "it is not tilted";
  write("11 60", "FF 9F");  // close (slide): 1
  EXPECT_EQ(read("10 60"), "00 00 D0 00") << "4";
  cable.run_for(4s);
  EXPECT_EQ(read("10 60"), "00 00 C0 00");
  write("11 60", "FF AF");
  EXPECT_EQ(read("10 60"), "00 00 D4 00") << "5";
  cable.run_for(2s);
  EXPECT_EQ(read("10 60"), "00 00 C4 00") << "1";
  write("11 60", "FF 8F");
  EXPECT_EQ(read("10 60"), "00 00 CC 00") << "3";
  cable.run_for(1s);
  write("11 60", "FF CF");
  EXPECT_EQ(read("10 60"), "00 00 DC 00") << "7";
  for (const char* reserved : {"FF DF", "FF EF"}) {
    EXPECT_EQ(write("11 60", reserved), "80 11 60 00 30 00 09 06");
  }
}

TEST_F(CarCommands, LocksTakeAThirdOfASecond) {
  write("0A 60", "F0");
  EXPECT_EQ(read("09 60"), "F2 00 00 00");
  cable.run_for(300ms);
  EXPECT_EQ(read("09 60"), "F0 00 00 00");
  EXPECT_EQ(write("0A 60", "F4"), "80 0A 60 00 30 00 09 06");
}

TEST_F(CarCommands, TheDashboardIsLitAsSomebodyWants) {
  write("06 60", "64");
  EXPECT_EQ(read("05 60"), "64 00 00 00");
  EXPECT_EQ(write("06 60", "65"), "80 06 60 00 30 00 09 06");
  EXPECT_EQ(write("06 60", "FE"), "80 06 60 00 30 00 09 06");
  EXPECT_EQ(write("06 60", "FF"), "60 06 60 00 00 00 00 00");
  EXPECT_EQ(read("05 60"), "64 00 00 00");
}

TEST_F(CarCommands, TipWipingIsOneStroke) {
  write("1B 60", "FD FF");
  EXPECT_EQ(read("1A 60"), "01 80 00 00");
  cable.run_for(1s);
  EXPECT_EQ(read("1A 60"), "00 80 00 00");
  write("1B 60", "CF FF");  // stage 0 to automatic: bits 6 to 4; 4: automatic
  cable.run_for(100ms);
  EXPECT_EQ(read("1A 60"), "00 81 00 00") << "bits 8 to 6";
  EXPECT_EQ(write("1B 60", "DF FF"), "80 1B 60 00 30 00 09 06") << "5 is reserved";
}

TEST_F(CarCommands, TheStepsOfTheHeatingMakeItActive) {
  write("25 60", "FF FE");  // colder: bits 9 and 8 are 2 (errata A8)
  cable.run_for(100ms);
  EXPECT_EQ(read("26 60"), "00 F1 00 00");
  write("25 60", "FD FC");  // heat the front window; deactivate the temperature control
  cable.run_for(100ms);
  EXPECT_EQ(read("26 60"), "01 F0 00 00");
}

TEST_F(CarCommands, TheLanguageThatNobodyHasIsRefused) {
  EXPECT_EQ(read("2D 60"), "E1 00 00 00");
  write("2C 60", "E0");
  EXPECT_EQ(read("2D 60"), "E0 00 00 00");
  EXPECT_EQ(write("2C 60", "E6"), "80 2C 60 00 30 00 09 06") << "errata C13";
  EXPECT_EQ(write("2C 60", "ED"), "80 2C 60 00 30 00 09 06");
}

TEST_F(CarCommands, LightsShineAfter50Ms) {
  write("44 60", "7F FF FF FF");  // high beam: bits 7 and 6
  cable.run_for(50ms);
  EXPECT_EQ(cable.last(0x389), "389#40 00 00 00 F8 FC");
  write("44 60", "FF FF DF FF");  // tip left: bits 21 and 20
  EXPECT_EQ(read("40 60"), "40 00 10 00");
  cable.run_for(2s);
  EXPECT_EQ(read("40 60"), "40 00 00 00");
}

TEST_F(CarCommands, TheAlarmIsPreActiveForTenSeconds) {
  // Code 1 is "do not trigger" of the command and "pre-active" of the status (errata C4).
  write("48 60", "F9");
  EXPECT_EQ(read("47 60"), "F8 00 00 00");
  write("48 60", "FA");
  EXPECT_EQ(read("47 60"), "F9 00 00 00");
  cable.run_for(10s);
  EXPECT_EQ(read("47 60"), "FA 00 00 00");
  write("48 60", "FB");
  EXPECT_EQ(cable.last(0x389), "389#00 00 00 00 FB FC");
  write("48 60", "F9");
  EXPECT_EQ(read("47 60"), "FA 00 00 00");
  write("48 60", "F8");
  cable.run_for(200ms);
  EXPECT_EQ(read("47 60"), "F8 00 00 00");
}

TEST_F(CarCommands, TheHornSounds) {
  write("4B 60", "FD");
  cable.run_for(50ms);
  EXPECT_EQ(cable.last(0x389), "389#00 00 00 00 F8 FD");
  write("4B 60", "FC");
  cable.run_for(50ms);
  EXPECT_EQ(cable.last(0x389), "389#00 00 00 00 F8 FC");
}

TEST_F(CarCommands, FlashingLightsAreEnabled) {
  write("4C 60", "FF FF FD FF");  // day time running light, night: bits 17 and 16
  cable.run_for(50ms);
  EXPECT_EQ(read("4D 60"), "00 00 FD FF");
}

TEST_F(CarCommands, CruiseControlAcceleratesForASecond) {
  // Neither of them has no code except 3 (errata C1); the stored speed is released (2).
  EXPECT_EQ(read("61 60"), "2C FE 00 00");
  write("60 60", "F1 FF");  // on; accelerate
  EXPECT_EQ(read("61 60"), "21 FE 00 00");
  cable.run_for(1s);
  EXPECT_EQ(read("61 60"), "2D FE 00 00");
  write("62 60", "FD");
  cable.run_for(500ms);
  EXPECT_EQ(read("63 60"), "FD 00 00 00");
}

TEST_F(CarCommands, AnNmtResetLeavesADoorMoving) {
  write("0E 60", "FC");
  cable.run_for(1s);
  cable.send("000#81 05");
  cable.send("000#01 05");
  EXPECT_EQ(read("0D 60"), "4A F2 00 00");
  cable.run_for(3s);
  EXPECT_EQ(read("0D 60"), "48 F2 00 00");
}

/// Hardware with real motors executes commands itself, and reports the results.
TEST(CarCommandsDriven, TheHardwareIsToldAndReports) {
  struct Motors {
    std::vector<Commanded> told;
    std::vector<std::uint32_t> became;
    bool drive(const Commanded& wanted) {
      told.push_back(wanted);
      return wanted.is_for(window_command_driver);
    }
    void thing_became(const FieldPlace&, std::uint32_t code) { became.push_back(code); }
    CarHardware hardware() {
      CarHardware car;
      car.switched.drive = callback<&Motors::drive>(*this);
      car.switched.became = callback<&Motors::thing_became>(*this);
      return car;
    }
  } motors;
  CarBench bench(only_unit<IvnGatewayKind>, [&](Environment& environment) {
    environment.provide(callback<&Motors::hardware>(motors));
  });
  bench.ask_as(7, "2B 0C 60 00 F0 FF 00 00");  // driver and front passenger
  ASSERT_EQ(motors.told.size(), 2u);
  EXPECT_TRUE(motors.told[0].is_for(window_command_driver));
  EXPECT_EQ(motors.told[0].client, 7);
  EXPECT_EQ(bench.ask("40 0B 60 00 00 00 00 00"), "47 0B 60 00 51 92 FC 00");
  bench.cable.run_for(10s);
  EXPECT_EQ(bench.ask("40 0B 60 00 00 00 00 00"), "47 0B 60 00 41 92 FC 00");
  EXPECT_EQ(motors.became, (std::vector<std::uint32_t>{2, 0})) << "the passenger's";
}

TEST(CarCommandsLacking, ACarWithoutAThirdRowSaysSo) {
  static constexpr FieldPlace lacking[] = {place_of(window_command_3rd_row_left),
                                           place_of(seat_adjustment_command_up_down)};
  CarOnBench sut({.switched = {.lacking = lacking}});
  EXPECT_EQ(sut.ask("40 0C 60 00 00 00 00 00"), "4B 0C 60 00 FF FB 00 00");
  EXPECT_EQ(sut.ask("40 18 60 01 00 00 00 00"), "47 18 60 01 FB FF FF 00");
}

}  // namespace
}  // namespace canvoy::cia447::car_commands_test
