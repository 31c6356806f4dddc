// A tariff display at its wire (CiA 447-3, 4.2.16). Lamps have four bits each, taxi light lowest;
// off, on, dimmed, blinking are 0 to 3. 6100h: power down in bits 1..0, input 3..2, dldi 5..4,
// lamps 10..6, characters 13..11, reserved bits 1.
#include "canvoy/devices/cia447/tariff_display/tariff_display_unit.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "canvoy/devices/cia447/kit/car_bench_test.hpp"

namespace canvoy::cia447::tariff_display_unit_test {
namespace {

/// PDO 78 is the 24th of the list: 380h + 23 of node 5.
constexpr std::uint32_t inputs_pdo = 0x397;
constexpr const char* device_state = "22 00 00 08";
constexpr const char* value_range = "30 00 09 06";

class DisplayBench {
 public:
  explicit DisplayBench(const TariffDisplaySettings& wanted = {.lamps = 16}) : settings(wanted) {
    bench.emplace(only_unit<TariffDisplayKind>, [this](Environment& environment) {
      environment.provide(callback<&DisplayBench::offered>(*this));
      environment.provide(callback<&DisplayBench::hardware>(*this));
      environment.watch(unit);
    });
  }
  DisplayBench(const DisplayBench&) = delete;
  DisplayBench& operator=(const DisplayBench&) = delete;

  std::string get(const char* index) {
    return bench->ask("40 " + std::string(index) + " 61 00 00 00 00 00").substr(12);
  }
  /// The answer: "" for done, or the abort code's bytes.
  std::string set(const char* index, const std::string& value) {
    const std::string answer = bench->ask("23 " + std::string(index) + " 61 00 " + value);
    return answer.substr(0, 2) == "60" ? "" : answer.substr(12);
  }
  std::string configure(const std::string& value) {
    const std::string answer = bench->ask("2F 09 61 00 " + value + " 00 00 00");
    return answer.substr(0, 2) == "60" ? "" : answer.substr(12);
  }

  TariffDisplaySettings settings;
  std::vector<std::pair<unsigned, Lamp>> driven;
  std::vector<std::array<std::uint8_t, 2>> levels;
  TariffDisplayUnit* unit = nullptr;
  std::optional<CarBench> bench;

 private:
  TariffDisplaySettings offered() { return settings; }
  TariffDisplayHardware hardware() {
    return {.drive = callback<&DisplayBench::drive>(*this),
            .show_level = callback<&DisplayBench::show_level>(*this)};
  }
  void show_level(const std::array<std::uint8_t, 2>& level) { levels.push_back(level); }
  void drive(unsigned lamp, Lamp wanted) { driven.emplace_back(lamp, wanted); }
};

TEST(TariffDisplay, SaysWhatItHas) {
  DisplayBench display;
  // No power down, CAN used, inputs available, 16 lamps (10h << 6), two characters (2 << 11).
  EXPECT_EQ(display.get("00"), "10 D4 00 00");
  EXPECT_EQ(display.get("01"), "00 00 00 00") << "no lamp failure";
  EXPECT_EQ(display.get("02"), "00 00 00 00");
  EXPECT_EQ(display.get("03"), "00 00 00 00") << "no input is active";
  EXPECT_EQ(display.get("04"), "00 00 00 00") << "all lamps are off";
  EXPECT_EQ(display.get("05"), "00 00 00 00");
  EXPECT_EQ(display.get("0A"), "FF FF 00 00") << "nobody has told a level";
}

TEST(TariffDisplay, WhatItDoesNotHaveIsNotAvailable) {
  DisplayBench display({.lamps = 3, .level_characters = 1, .has_inputs = false});
  // Three lamps (3 << 6), one character (1 << 11), no discrete inputs.
  EXPECT_EQ(display.get("00"), "C0 C8 00 00");
  EXPECT_EQ(display.get("01"), "00 F0 FF FF");
  EXPECT_EQ(display.get("02"), "FF FF FF FF");
  EXPECT_EQ(display.get("03"), "FF FF FF FF");
  EXPECT_EQ(display.get("04"), "00 F0 FF FF");
  EXPECT_EQ(display.get("05"), "FF FF FF FF");
  EXPECT_EQ(display.get("06"), "FF EF EE EE") << "functions that are not implemented";
  EXPECT_EQ(display.get("07"), "EE EE EE EE");
  EXPECT_EQ(display.set("06", "11 11 11 11"), "");
  EXPECT_EQ(display.get("04"), "11 F1 FF FF");
  EXPECT_EQ(display.get("06"), "11 E1 EE EE");
  EXPECT_EQ(display.driven.size(), 3u);
  EXPECT_EQ(display.configure("FB"), device_state) << "there are no inputs";
}

TEST(TariffDisplay, LampsDoWhatTheyAreTold) {
  DisplayBench display;
  EXPECT_EQ(display.set("06", "21 F3 FF FF"), "") << "taxi on, vacant dimmed, emergency blinking";
  EXPECT_EQ(display.get("04"), "21 03 00 00");
  EXPECT_EQ(display.driven, (std::vector<std::pair<unsigned, Lamp>>{
                                {1, Lamp::on}, {2, Lamp::dimmed}, {3, Lamp::blinking}}));
  EXPECT_EQ(display.set("06", "F0 FF FF 1F"), "") << "taxi off, lamp 8 on";
  EXPECT_EQ(display.get("04"), "20 03 00 10");
  EXPECT_EQ(display.set("07", "F1 FF FF 3F"), "") << "lamp 9 on, lamp 16 blinking";
  EXPECT_EQ(display.get("05"), "01 00 00 30");
}

TEST(TariffDisplay, ReservedCodesAreRefusedAndNothingOfTheCommandIsDone) {
  DisplayBench display;
  for (const char* command : {"41 FF FF FF", "D1 FF FF FF", "E1 FF FF FF", "11 FF FF 4F"}) {
    EXPECT_EQ(display.set("06", command), value_range) << command;
    EXPECT_EQ(display.set("07", command), value_range) << command;
  }
  EXPECT_EQ(display.configure("FE"), value_range) << "power down 2";
  EXPECT_EQ(display.get("04"), "00 00 00 00");
  EXPECT_TRUE(display.driven.empty());
}

TEST(TariffDisplay, InputsAreToldAndDriveTheLampsWhereTheyAreConfigured) {
  DisplayBench display;
  display.unit->set_input(1, true);
  display.unit->set_input(16, true);
  display.bench->cable.run_for(0s);
  EXPECT_EQ(display.bench->cable.last(inputs_pdo), "397#01 00 00 40");
  EXPECT_EQ(display.get("04"), "00 00 00 00") << "CAN operation";
  EXPECT_EQ(display.configure("FB"), "") << "discrete operation";
  EXPECT_EQ(display.get("00"), "14 D4 00 00");
  EXPECT_EQ(display.get("04"), "01 00 00 00");
  EXPECT_EQ(display.get("05"), "00 00 00 10");
  EXPECT_EQ(display.set("06", "F1 FF FF FF"), device_state) << "the bus does not set them now";
  EXPECT_EQ(display.set("06", "FF FF FF FF"), "") << "nothing is wanted";
  display.unit->set_input(1, false);
  EXPECT_EQ(display.get("04"), "00 00 00 00");
  EXPECT_EQ(display.configure("F3"), "") << "no configuration command";
  EXPECT_EQ(display.get("00"), "14 D4 00 00");
  EXPECT_EQ(display.configure("F7"), "") << "CAN operation";
  EXPECT_EQ(display.get("00"), "10 D4 00 00");
  EXPECT_EQ(display.get("05"), "00 00 00 00");
  EXPECT_EQ(display.set("06", "F1 FF FF FF"), "");
  EXPECT_EQ(display.get("04"), "01 00 00 00");
}

TEST(TariffDisplay, AnInputMayFail) {
  DisplayBench display;
  display.unit->set_input(2, Signal::failure);
  display.unit->set_input(3, Signal::not_available);
  EXPECT_EQ(display.get("03"), "38 00 00 00");
}

TEST(TariffDisplay, PoweredDownItsLampsAreOffUntilItIsNot) {
  DisplayBench display;
  display.set("06", "31 FF FF FF");
  EXPECT_EQ(display.configure("FD"), "");
  EXPECT_EQ(display.get("00"), "11 D4 00 00");
  EXPECT_EQ(display.get("04"), "00 00 00 00");
  EXPECT_EQ(display.set("06", "FF F1 FF FF"), "") << "for later";
  EXPECT_EQ(display.get("04"), "00 00 00 00");
  EXPECT_EQ(display.configure("FC"), "");
  EXPECT_EQ(display.get("00"), "10 D4 00 00");
  EXPECT_EQ(display.get("04"), "31 01 00 00");
  EXPECT_EQ(display.configure("FF"), "");
  EXPECT_EQ(display.get("04"), "31 01 00 00");
}

TEST(TariffDisplay, ALampThatIsBrokenSaysSo) {
  DisplayBench display;
  display.set("06", "11 FF FF FF");
  display.unit->lamp_failed(1, LampFailure::open_load);
  display.unit->lamp_failed(16, LampFailure::over_load);
  EXPECT_EQ(display.get("01"), "01 00 00 00");
  EXPECT_EQ(display.get("02"), "00 00 00 20");
  EXPECT_EQ(display.get("04"), "1E 00 00 00");
  EXPECT_EQ(display.get("05"), "00 00 00 E0");
  display.set("06", "F0 FF FF FF");
  EXPECT_EQ(display.get("04"), "1E 00 00 00");
  display.unit->lamp_failed(1, LampFailure::none);
  EXPECT_EQ(display.get("01"), "00 00 00 00");
  EXPECT_EQ(display.get("04"), "10 00 00 00") << "it has gone off meanwhile";
}

TEST(TariffDisplay, ShowsTheLevelThatATaximeterWrites) {
  DisplayBench display;
  EXPECT_EQ(display.bench->ask("2B D3 60 00 32 41 00 00"), "60 D3 60 00 00 00 00 00");
  EXPECT_EQ(display.get("0A"), "32 41 00 00") << "\"2A\"";
  display.bench->ask("2B D3 60 00 07 80 00 00");
  EXPECT_EQ(display.get("0A"), "FF FF 00 00") << "no characters (errata Z12)";
  display.unit->show_level({'T', 0});
  EXPECT_EQ(display.get("0A"), "54 00 00 00");
}

TEST(TariffDisplay, DrivesItsCharactersWhenTheyChange) {
  DisplayBench display({.level_characters = 1});
  for (const char* level : {"31 00", "31 00", "31 41", "32 41"}) {
    display.bench->ask("2B D3 60 00 " + std::string(level) + " 00 00");
  }
  const std::vector<std::array<std::uint8_t, 2>> shown = {{0x31, 0xFF}, {0x32, 0xFF}};
  EXPECT_EQ(display.levels, shown);
}

TEST(TariffDisplay, ShowsAsManyCharactersAsItHas) {
  DisplayBench display({.level_characters = 1});
  display.bench->ask("2B D3 60 00 32 41 00 00");
  EXPECT_EQ(display.get("0A"), "32 FF 00 00");
}

TEST(TariffDisplay, HasTwoCharactersAtMost) {
  DisplayBench display({.lamps = 16, .level_characters = 3});
  EXPECT_EQ(display.get("00"), "10 D4 00 00") << "two: 2 << 11";
}

TEST(TariffDisplay, AnNmtResetChangesNoLamp) {
  DisplayBench display;
  display.set("06", "31 FF FF FF");
  display.configure("FD");
  display.configure("FC");
  display.driven.clear();
  display.bench->cable.send("000#81 05");
  EXPECT_EQ(display.get("04"), "31 00 00 00");
  EXPECT_TRUE(display.driven.empty());
  EXPECT_EQ(display.get("06"), "FF FF FF FF");
}

}  // namespace
}  // namespace canvoy::cia447::tariff_display_unit_test
