// "Blue" light flashers at their wire: commands in, statuses out (CiA 447-3, 4.2.22). Fields of two
// bits, front right lowest; FFFF FFFFh is "don't care" and "signal not available".
#include "canvoy/devices/cia447/blue_light/blue_light_unit.hpp"

#include <gtest/gtest.h>

#include "canvoy/devices/cia447/kit/car_bench_test.hpp"
#include "canvoy/profiles/cia447/roof_bar_handles.hpp"

namespace canvoy::cia447::blue_light_unit_test {
namespace {

/// PDO 66 is the twelfth of the list: 380h + 11 of node 5.
constexpr std::uint32_t status_pdo = 0x38B;

class BlueLight : public testing::Test {
 protected:
  BlueLightUnit* unit_ = nullptr;
  CarBench bench{only_unit<BlueLightKind>,
                 [this](Environment& environment) { environment.watch(unit_); }};
};

TEST_F(BlueLight, AllAreOffAtFirstAndReservedBitsAreOne) {
  // ffr ffl rfr rfl sfr sfl tlfr tlfl mfr mfl, each 0; then six reserved fields of two bits.
  EXPECT_EQ(bench.cable.last(status_pdo), "38B#00 00 F0 FF");
  EXPECT_EQ(bench.ask("40 41 61 00 00 00 00 00"), "43 41 61 00 00 00 F0 FF");
}

TEST_F(BlueLight, ACommandActsAfterTheTimeThatTheStageTakes) {
  // Front right on, front left off, the others as they are.
  EXPECT_EQ(bench.ask("23 40 61 00 F1 FF FF FF"), "60 40 61 00 00 00 00 00");
  bench.cable.clear();
  bench.cable.run_for(49ms);
  EXPECT_EQ(bench.cable.count(status_pdo), 0u);
  bench.cable.run_for(1ms);
  EXPECT_EQ(bench.cable.last(status_pdo), "38B#01 00 F0 FF");
  bench.ask("23 40 61 00 FC FF FF FF");
  bench.cable.run_for(50ms);
  EXPECT_EQ(bench.cable.last(status_pdo), "38B#00 00 F0 FF");
}

TEST_F(BlueLight, DoNotCareChangesNothing) {
  bench.ask("23 40 61 00 FD FF FF FF");
  bench.cable.run_for(50ms);
  bench.ask("23 40 61 00 FF FF FF FF");
  bench.cable.clear();
  bench.cable.run_for(1s);
  EXPECT_EQ(bench.cable.count(status_pdo), 0u);
  EXPECT_EQ(bench.ask("40 41 61 00 00 00 00 00"), "43 41 61 00 01 00 F0 FF");
}

TEST_F(BlueLight, TheCodeOfNotImplementedIsReservedForWhoWrites) {
  EXPECT_EQ(bench.ask("23 40 61 00 FE FF FF FF"), "80 40 61 00 30 00 09 06");
  EXPECT_EQ(bench.ask("40 40 61 00 00 00 00 00"), "43 40 61 00 FF FF FF FF") << "nothing changed";
  bench.cable.run_for(1s);
  EXPECT_EQ(bench.ask("40 41 61 00 00 00 00 00"), "43 41 61 00 00 00 F0 FF");
}

TEST_F(BlueLight, ReservedBitsSayNothing) {
  EXPECT_EQ(bench.ask("23 40 61 00 FD FF 0F 00"), "60 40 61 00 00 00 00 00");
}

TEST_F(BlueLight, TheStatusIsReadOnly) {
  EXPECT_EQ(bench.ask("23 41 61 00 00 00 00 00"), "80 41 61 00 02 00 01 06");
}

TEST_F(BlueLight, ABrokenFlasherSaysSoAndIsWhatItIsWhenItIsMended) {
  unit_->switching().sense(blue_light_flasher_status_front_right, Sensing::failure);
  bench.cable.run_for(0s);
  EXPECT_EQ(bench.cable.last(status_pdo), "38B#02 00 F0 FF");
  bench.ask("23 40 61 00 FD FF FF FF");
  bench.cable.run_for(50ms);
  EXPECT_EQ(bench.ask("40 41 61 00 00 00 00 00"), "43 41 61 00 02 00 F0 FF");
  unit_->switching().sense(blue_light_flasher_status_front_right, Sensing::not_available);
  EXPECT_EQ(bench.ask("40 41 61 00 00 00 00 00"), "43 41 61 00 03 00 F0 FF");
  unit_->switching().sense(blue_light_flasher_status_front_right, Sensing::working);
  EXPECT_EQ(bench.ask("40 41 61 00 00 00 00 00"), "43 41 61 00 01 00 F0 FF");
}

TEST_F(BlueLight, AnNmtResetLeavesTheFlashersOn) {
  bench.ask("23 40 61 00 FD FF FF FF");
  bench.cable.run_for(50ms);
  bench.cable.send("000#81 05");
  bench.cable.clear();
  bench.cable.send("000#01 05");
  EXPECT_EQ(bench.cable.last(status_pdo), "38B#01 00 F0 FF");
  EXPECT_EQ(bench.ask("40 40 61 00 00 00 00 00"), "43 40 61 00 FF FF FF FF");
}

TEST_F(BlueLight, EachClientHasItsOwnChannelAndTheChannelOfItselfIsNone) {
  for (unsigned client = 1; client <= 16; ++client) {
    const std::string answer = bench.ask_as(client, "40 00 10 00 00 00 00 00");
    EXPECT_EQ(answer, client == 5 ? "" : "43 00 10 00 BF 01 00 00") << client;
    if (client != 5) {
      EXPECT_EQ(bench.device().network().client(), client);
    }
  }
  bench.ask("40 00 10 00 00 00 00 00");
  EXPECT_EQ(bench.device().network().client(), 1) << "the default channel is the gateway's";
}

TEST(BlueLightLacking, AFunctionThatItLacksReadsAsNotImplementedAndIsNotSwitched) {
  static constexpr FieldPlace lacking[] = {place_of(blue_light_flasher_command_front_left)};
  const auto settings = [](void*) { return SwitchedSettings{.lacking = lacking}; };
  CarBench bench(only_unit<BlueLightKind>, [&](Environment& environment) {
    environment.provide(Callback<SwitchedSettings()>(settings, nullptr));
  });
  EXPECT_EQ(bench.ask("40 40 61 00 00 00 00 00"), "43 40 61 00 FB FF FF FF");
  EXPECT_EQ(bench.ask("23 40 61 00 F5 FF FF FF"), "60 40 61 00 00 00 00 00");
  bench.cable.run_for(1s);
  EXPECT_EQ(bench.ask("40 41 61 00 00 00 00 00"), "43 41 61 00 01 00 F0 FF");
  EXPECT_EQ(bench.ask("40 40 61 00 00 00 00 00"), "43 40 61 00 F9 FF FF FF");
}

}  // namespace
}  // namespace canvoy::cia447::blue_light_unit_test
