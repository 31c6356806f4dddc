// Announcer and acoustic control manager at their wire.
#include <gtest/gtest.h>

#include "canvoy/devices/cia407/acoustic/acoustic_announcer_unit.hpp"
#include "canvoy/devices/cia407/acoustic/acoustic_control_manager_unit.hpp"
#include "canvoy/devices/cia407/kit/bus_bench_test.hpp"

namespace canvoy::cia407::acoustic_test {
namespace {

class Announcer : public testing::Test {
 protected:
  static constexpr const BusUnit* units[] = {&bus_unit<AcousticAnnouncerKind>};
  bool announce(std::uint32_t stop, std::string_view text) {
    said.emplace_back(stop, text);
    return stop != 13;
  }
  AcousticAnnouncerHardware hardware() {
    return {.announce = callback<&Announcer::announce>(*this)};
  }
  std::vector<std::pair<std::uint32_t, std::string>> said;
  BusBench bench{units, [this](Environment& environment) {
                   environment.provide(callback<&Announcer::hardware>(*this));
                 }};
};

TEST_F(Announcer, AnotherStopIsItsCue) {
  bench.ask("23 20 61 00 5A 6F 6F 2E");
  bench.cable.send("401#07 00 00 00 00 00 00 00");
  ASSERT_EQ(said.size(), 1u);
  EXPECT_EQ(said[0].first, 7u);
  EXPECT_EQ(said[0].second, "Zoo.");
  bench.cable.send("401#07 00 00 00 02 00 00 00");
  EXPECT_EQ(said.size(), 1u) << "an event of another device is no cue";
  bench.cable.send("401#00 00 00 00 00 00 00 00");
  bench.cable.send("401#07 00 00 00 00 00 00 00");
  EXPECT_EQ(said.size(), 2u);
}

/// 6.9: writing the object triggers it.
TEST_F(Announcer, TheSameStopBySdoIsACueAgain) {
  bench.ask("23 09 61 00 07 00 00 00");
  bench.ask("23 09 61 00 07 00 00 00");
  EXPECT_EQ(said.size(), 2u);
  bench.cable.send("401#07 00 00 00 02 00 00 00");
  EXPECT_EQ(said.size(), 2u) << "a message that leaves for an event says it again, and means none";
  bench.ask("23 09 61 00 00 00 00 00");
  EXPECT_EQ(said.size(), 2u) << "0 is no stop";
}

TEST_F(Announcer, WithoutAnAnnouncementItSaysSo) {
  bench.ask("23 09 61 00 0D 00 00 00");
  EXPECT_EQ(bench.cable.last(0x085), "085#05 FF 01 01 00 00 00 00");
  bench.ask("23 09 61 00 0E 00 00 00");
  EXPECT_EQ(bench.cable.last(0x085), "085#00 00 00 00 00 00 00 00");
}

TEST_F(Announcer, SaysThatItLivesWhenItIsAsked) {
  bench.ask("23 02 60 01 01 00 00 07");
  EXPECT_EQ(bench.cable.last(0x185), "185#01 00 00 00 01 00 00 07");
}

class Acoustic : public testing::Test {
 protected:
  static constexpr const BusUnit* units[] = {&bus_unit<AcousticControlManagerKind>};
  AudioPaths switch_paths(const AudioPaths& wanted) {
    paths = wanted;
    if (radio_is_broken) paths.radio_to_indoor = false;
    return paths;
  }
  std::uint16_t state() { return 0xBEEF; }
  AcousticControlManagerHardware hardware() {
    return {.switch_paths = callback<&Acoustic::switch_paths>(*this),
            .state = callback<&Acoustic::state>(*this)};
  }
  AudioPaths paths;
  bool radio_is_broken = false;
  BusBench bench{units, [this](Environment& environment) {
                   environment.provide(callback<&Acoustic::hardware>(*this));
                 }};
};

TEST_F(Acoustic, SwitchesAsItIsToldAndTellsWhatIsSwitched) {
  const bool AudioPaths::*all[] = {&AudioPaths::driver_to_indoor, &AudioPaths::driver_to_outdoor,
                                   &AudioPaths::driver_to_radio, &AudioPaths::attendant_to_indoor,
                                   &AudioPaths::radio_to_indoor};
  const char* flags[] = {"02", "04", "08", "10", "20"};
  for (std::size_t i = 0; i < 5; ++i) {
    bench.ask(std::string("23 02 60 01 ") + flags[i] + " 00 00 08");
    for (std::size_t k = 0; k < 5; ++k) EXPECT_EQ(paths.*all[k], i == k) << i << k;
    EXPECT_EQ(bench.cable.last(0x185), std::string("185#01 00 00 00 ") + flags[i] + " 00 00 08");
  }
  bench.ask("23 02 60 01 00 00 00 08");
  EXPECT_EQ(paths, AudioPaths{});
  EXPECT_EQ(bench.cable.last(0x185), "185#00 00 00 00 00 00 00 00");
}

TEST_F(Acoustic, APathThatCannotBeSwitchedIsNotSaidToBe) {
  radio_is_broken = true;
  bench.ask("23 02 60 01 22 00 00 08");
  EXPECT_EQ(bench.ask("40 01 60 02 00 00 00 00"), "43 01 60 02 02 00 00 08");
}

TEST_F(Acoustic, StateInformationIsFlag6) {
  bench.ask("23 02 60 01 40 00 00 08");
  EXPECT_EQ(bench.ask("40 01 60 02 00 00 00 00"), "43 01 60 02 40 EF BE 08");
}

TEST_F(Acoustic, NobodySpeaksAfterAReset) {
  bench.ask("23 02 60 01 02 00 00 08");
  bench.cable.send("000#81 05");
  EXPECT_EQ(paths, AudioPaths{});
}

}  // namespace
}  // namespace canvoy::cia407::acoustic_test
