// Hand-free conversation at the wire (CiA 447-3, 4.2.23). PDO 65 is 38Ah of node 5.
#include "canvoy/devices/cia447/hands_free/hands_free_unit.hpp"

#include <gtest/gtest.h>

#include "canvoy/devices/cia447/kit/car_bench_test.hpp"

namespace canvoy::cia447::hands_free_unit_test {
namespace {

class HandsFree : public testing::Test {
 protected:
  std::string command(const std::string& byte) {
    return bench.ask("2F 51 61 00 " + byte + " 00 00 00");
  }
  HandsFreeHardware hardware() {
    return {.show_led = callback<&HandsFree::show_led>(*this),
            .mute = callback<&HandsFree::mute>(*this)};
  }
  void show_led(bool is_on) { told += is_on ? "LED " : "no LED "; }
  void mute(bool is_on) { told += is_on ? "mute " : "no mute "; }

  std::string told;
  HandsFreeUnit* unit_ = nullptr;
  CarBench bench{only_unit<HandsFreeKind>, [this](Environment& environment) {
                   environment.watch(unit_);
                   environment.provide(callback<&HandsFree::hardware>(*this));
                 }};
};

TEST_F(HandsFree, TheKeyIsTold) {
  EXPECT_EQ(bench.cable.last(0x38A), "38A#FC");
  unit_->press_key(true);
  bench.cable.run_for(0s);
  EXPECT_EQ(bench.cable.last(0x38A), "38A#FD");
  unit_->press_key(false);
  bench.cable.run_for(0s);
  EXPECT_EQ(bench.cable.last(0x38A), "38A#FC");
  unit_->switching().sense(radio_hand_free_status_key, Sensing::failure);
  bench.cable.run_for(0s);
  EXPECT_EQ(bench.cable.last(0x38A), "38A#FE");
}

TEST_F(HandsFree, LedAndMuteAreTurnedEachByItself) {
  command("FD");
  EXPECT_EQ(told, "LED ");
  EXPECT_TRUE(unit_->shows_led());
  command("F7");
  EXPECT_EQ(told, "LED mute ");
  command("FD");
  command("FF");
  EXPECT_EQ(told, "LED mute ") << "it is on already";
  command("F0");
  EXPECT_EQ(told, "LED mute no LED no mute ");
  EXPECT_FALSE(unit_->is_muted());
}

TEST_F(HandsFree, ReservedCodesAreRefused) {
  EXPECT_EQ(command("FE"), "80 51 61 00 30 00 09 06");
  EXPECT_EQ(command("F9"), "80 51 61 00 30 00 09 06") << "the LED is not turned on either";
  EXPECT_EQ(told, "");
}

}  // namespace
}  // namespace canvoy::cia447::hands_free_unit_test
