// The sound of a roof bar at the wire (CiA 447-3, 4.2.21). 613Ah:01h from bit 0: sound (8), double
// speed (2), reserved (6), city, readiness, test, night (2 each), volume (6), by velocity (2). PDO
// 76 is 395h of node 5; PDO 17 of the gateway is 187h.
#include "canvoy/devices/cia447/roof_bar_sound/roof_bar_sound_unit.hpp"

#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "canvoy/devices/cia447/kit/car_bench_test.hpp"

namespace canvoy::cia447::roof_bar_sound_unit_test {
namespace {

class RoofBarSoundTest : public testing::Test {
 protected:
  std::string command(const std::string& bytes) { return bench.ask("23 3A 61 01 " + bytes); }
  std::string country(const std::string& byte) {
    return bench.ask("2F 38 61 00 " + byte + " 00 00 00");
  }
  std::string status() { return bench.ask("40 3B 61 01 00 00 00 00").substr(12); }
  void settle() { cable.run_for(50ms); }

  RoofBarSoundHardware hardware() { return {.play = callback<&RoofBarSoundTest::play>(*this)}; }
  void play(const RoofBarSound& sound) { heard.push_back(sound); }

  std::vector<RoofBarSound> heard;
  RoofBarSoundUnit* unit_ = nullptr;
  CarBench bench{only_unit<RoofBarSoundKind>, [this](Environment& environment) {
                   environment.watch(unit_);
                   environment.provide(callback<&RoofBarSoundTest::hardware>(*this));
                 }};
  Cable& cable = bench.cable;
};

TEST_F(RoofBarSoundTest, ItIsSilentAtFirst) {
  // Volume step 31 is raw 1Eh (errata Z09); the speaker is OK (1).
  EXPECT_EQ(cable.last(0x395), "395#00 FC 00 1E C4 FF FF FF");
  EXPECT_EQ(bench.ask("40 39 61 00 00 00 00 00"), "4F 39 61 00 00 00 00 00");
  EXPECT_TRUE(heard.empty());
}

TEST_F(RoofBarSoundTest, AnAdditionalSoundIsPlayed) {
  command("06 FF FF FF");
  settle();
  EXPECT_EQ(cable.last(0x395), "395#06 FC 00 1E C4 FF FF FF");
  ASSERT_EQ(heard.size(), 1u);
  EXPECT_EQ(heard[0], (RoofBarSound{.sound = AdditionalSound::wail, .volume = 31}));
  command("00 FF FF FF");
  settle();
  EXPECT_EQ(heard.back(), RoofBarSound{.volume = 31});
}

TEST_F(RoofBarSoundTest, TheSoundOfACountryIsChosenAndThenPlayed) {
  EXPECT_EQ(country("01"), "60 38 61 00 00 00 00 00");
  EXPECT_EQ(bench.ask("40 39 61 00 00 00 00 00"), "4F 39 61 00 01 00 00 00");
  EXPECT_TRUE(heard.empty());
  command("01 FD FC FF");  // country-specific, double speed, land
  settle();
  ASSERT_FALSE(heard.empty());
  EXPECT_EQ(heard.back(), (RoofBarSound{.sound = AdditionalSound::country_specific,
                                        .country = CountrySound::din,
                                        .is_fast = true,
                                        .volume = 31}));
  EXPECT_EQ(status(), "01 FD 00 1E") << "errata Z10";
  country("16");
  EXPECT_EQ(heard.back().country, CountrySound::usa);
}

TEST_F(RoofBarSoundTest, EachPartOfTheCommandHasItsOwn) {
  // City, readiness, test, night: 1 each, and the others are left alone.
  const std::pair<const char*, const char*> alone[] = {
      {"FD", "01"}, {"F7", "05"}, {"DF", "15"}, {"7F", "55"}};
  for (const auto& [wanted, told] : alone) {
    command("FF FF " + std::string(wanted) + " FF");
    settle();
    EXPECT_EQ(status(), "00 FC " + std::string(told) + " 1E");
  }
  EXPECT_TRUE(unit_->output().is_city);
  EXPECT_TRUE(unit_->output().is_test);
  command("FF FF 54 FF");
  settle();
  EXPECT_EQ(status(), "00 FC 54 1E");
}

TEST_F(RoofBarSoundTest, SoundsOfTheManufacturerBeginAt40) {
  EXPECT_EQ(country("17"), "80 38 61 00 30 00 09 06");
  EXPECT_EQ(country("3F"), "80 38 61 00 30 00 09 06");
  EXPECT_EQ(country("40"), "60 38 61 00 00 00 00 00") << "errata Z08";
  EXPECT_EQ(country("FD"), "60 38 61 00 00 00 00 00");
  EXPECT_EQ(country("FE"), "80 38 61 00 30 00 09 06");
  EXPECT_EQ(command("09 FF FF FF"), "80 3A 61 01 30 00 09 06");
  EXPECT_EQ(command("4F FF FF FF"), "60 3A 61 01 00 00 00 00");
  EXPECT_EQ(command("FC FF FF FF"), "60 3A 61 01 00 00 00 00");
  EXPECT_EQ(command("FD FF FF FF"), "80 3A 61 01 30 00 09 06") << "not in the command";
}

TEST_F(RoofBarSoundTest, TheVolumeHas61StepsInTheCommand) {
  EXPECT_EQ(command("FF FF FF FC"), "60 3A 61 01 00 00 00 00");  // 3Ch
  settle();
  EXPECT_EQ(status(), "00 FC 00 3C");
  EXPECT_EQ(unit_->output().volume, 61u);
  EXPECT_EQ(command("FF FF FF FD"), "80 3A 61 01 30 00 09 06") << "errata Z09";
  EXPECT_EQ(command("FF FF FF FE"), "80 3A 61 01 30 00 09 06");
  command("FF FF FF C0");
  settle();
  EXPECT_EQ(unit_->output().volume, 1u);
}

TEST_F(RoofBarSoundTest, ItIsNotLouderByNightThanItMayBe) {
  command("FF FF 7F FC");
  settle();
  EXPECT_EQ(unit_->output().volume, 31u);
  EXPECT_EQ(status(), "00 FC 40 3C") << "the step that was wanted";
  command("FF FF 3F FF");
  settle();
  EXPECT_EQ(unit_->output().volume, 61u);
}

TEST_F(RoofBarSoundTest, ItIsLouderTheFasterTheCarDrives) {
  command("FF FF FF 7F");
  settle();
  EXPECT_EQ(unit_->output().volume, 31u) << "nobody knows how fast";
  cable.send("187#20 43 83 06 00 00 FD");  // 833.5/min of 2 m: 100 km/h
  EXPECT_EQ(unit_->output().volume, 51u);
  cable.send("187#20 43 00 0E 00 00 FD");  // 1792/min: 215 km/h
  EXPECT_EQ(unit_->output().volume, 62u) << "as loud as can be";
  cable.send("187#20 43 FE FF 00 00 FD");
  EXPECT_EQ(unit_->output().volume, 31u) << "a wheel sensor that fails";
  cable.send("187#20 43 83 06 00 00 FD");
  command("FF FF FF 3F");
  settle();
  EXPECT_EQ(unit_->output().volume, 31u) << "not wanted any more";
}

TEST_F(RoofBarSoundTest, AGatewayThatFallsSilentIsForgotten) {
  command("FF FF FF 7F");
  settle();
  cable.send("187#20 43 83 06 00 00 FD");
  cable.run_for(2s);
  cable.send("701#05");
  cable.run_for(2s);
  EXPECT_EQ(unit_->output().volume, 51u);
  cable.run_for(1s);
  EXPECT_EQ(unit_->output().volume, 31u);
  cable.send("187#20 43 83 06 00 00 FD");
  EXPECT_EQ(unit_->output().volume, 51u);
}

TEST_F(RoofBarSoundTest, AudioSpeakerAndVoltageAreApart) {
  EXPECT_EQ(bench.ask("23 3A 61 02 FD FF FF FF"), "60 3A 61 02 00 00 00 00");
  settle();
  EXPECT_EQ(cable.last(0x395), "395#00 FC 00 1E C5 FF FF FF");
  EXPECT_EQ(bench.ask("23 3A 61 02 FE FF FF FF"), "80 3A 61 02 30 00 09 06");
  unit_->switching().report(sound_status_roof_bar_local_voltage, LocalVoltage::over_voltage);
  unit_->switching().sense(sound_status_roof_bar_speaker, Sensing::failure);
  cable.run_for(0s);
  EXPECT_EQ(cable.last(0x395), "395#00 FC 00 1E E9 FF FF FF");
}

}  // namespace
}  // namespace canvoy::cia447::roof_bar_sound_unit_test
