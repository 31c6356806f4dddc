// Commands that are repeated until another device takes them, at the wire: this is node 5, and
// writes to node 3 on 342h, which answers on 2C2h (facts 2.2).
#include "canvoy/devices/cia447/kit/command_keeper.hpp"

#include <gtest/gtest.h>

#include "canvoy/devices/cia447/blue_light/blue_light_unit.hpp"
#include "canvoy/devices/cia447/kit/car_bench_test.hpp"

namespace canvoy::cia447::command_keeper_test {
namespace {

class Keeper : public testing::Test {
 protected:
  /// Its client has a timer of the node.
  ~Keeper() override { keeper_.reset(); }

  void network(CarNetwork& network, Node& /*node*/) {
    keeper_.emplace(network, CommandKeeperSettings{.server = 3});
  }
  CommandKeeper& keeper() { return *keeper_; }
  std::string asked() {
    cable.run_for(0s);
    return cable.last(0x342);
  }
  void answer(const std::string& answer) {
    cable.clear();
    cable.send("2C2#" + answer);
    cable.run_for(0s);
  }
  bool is_told_within(Duration time, std::string_view what) {
    cable.clear();
    cable.run_for(time);
    return std::ranges::any_of(cable.heard,
                               [&](const Cable::Heard& it) { return wire_text(it.frame) == what; });
  }

  void hear_node_3_for(int seconds) {
    for (int second = 0; second < seconds; ++second) {
      cable.send("703#05");
      cable.run_for(1s);
    }
  }

  std::optional<CommandKeeper> keeper_;
  CarBench bench{only_unit<BlueLightKind>, [this](Environment& environment) {
                   environment.watch(callback<&Keeper::network>(*this));
                 }};
  Cable& cable = bench.cable;

  static constexpr KeptCommand on = {0x6130, 1, 0xFFFF'FFFD, 4};
  static constexpr KeptCommand off = {0x6130, 1, 0xFFFF'FFFC, 4};
  static constexpr KeptCommand unlock = {0x600A, 0, 0xF2, 1, true};
  const std::string told_unlock = "342#2F 0A 60 00 F2 00 00 00";
  const std::string told_on = "342#23 30 61 01 FD FF FF FF";
  const std::string told_off = "342#23 30 61 01 FC FF FF FF";
  const std::string taken = "60 30 61 01 00 00 00 00";
};

TEST_F(Keeper, ACommandIsToldOnceWhereItIsTaken) {
  keeper().want(0, on);
  EXPECT_EQ(asked(), told_on);
  answer(taken);
  EXPECT_TRUE(keeper().is_done());
  keeper().want(0, on);
  hear_node_3_for(9);
  EXPECT_EQ(cable.last(0x342), "") << "nothing has changed";
}

TEST_F(Keeper, WhatIsNotTakenIsToldAgain) {
  keeper().want(0, on);
  asked();
  answer("80 30 61 01 22 00 00 08");
  EXPECT_FALSE(keeper().is_done());
  cable.run_for(499ms);
  EXPECT_EQ(cable.last(0x342), "");
  cable.run_for(1ms);
  EXPECT_EQ(cable.last(0x342), told_on);
}

TEST_F(Keeper, WhatIsWantedMeanwhileIsToldAfterIt) {
  keeper().want(0, on);
  asked();
  keeper().want(0, off);
  answer(taken);
  EXPECT_EQ(cable.last(0x342), told_off);
  answer(taken);
  EXPECT_TRUE(keeper().is_done());
}

TEST_F(Keeper, ADeviceThatBootsIsToldAllAnewButWhatWasForOnce) {
  keeper().want(0, off);
  asked();
  answer(taken);
  keeper().want(1, unlock);
  EXPECT_EQ(asked(), told_unlock);
  answer("60 0A 60 00 00 00 00 00");
  cable.send("703#00");
  cable.clear();
  cable.run_for(500ms);
  EXPECT_EQ(cable.last(0x342), told_off) << "off as well";
  answer(taken);
  cable.run_for(1s);
  EXPECT_EQ(cable.last(0x342), "");
  EXPECT_TRUE(keeper().is_done());
}

TEST_F(Keeper, WhatIsForOnceIsDroppedWhereItIsNotTakenInTime) {
  keeper().want(0, unlock);
  cable.run_for(2400ms);
  EXPECT_EQ(cable.last(0x342), told_unlock) << "nobody answers: again and again";
  cable.run_for(1s);
  cable.clear();
  cable.send("703#00");
  cable.run_for(60s);
  EXPECT_EQ(cable.last(0x342), "") << "who wanted it may have gone";
  EXPECT_TRUE(keeper().is_done());
}

TEST_F(Keeper, WhatIsForOnceAndWantedAgainIsAsNew) {
  keeper().want(0, unlock);
  cable.run_for(2900ms);
  keeper().want(0, unlock);
  cable.run_for(500ms);
  EXPECT_TRUE(is_told_within(2s, told_unlock));
}

TEST_F(Keeper, WhatIsToHoldIsNeverTooOld) {
  keeper().want(0, on);
  keeper().want(1, unlock);
  cable.run_for(60s);
  EXPECT_TRUE(is_told_within(2s, told_on));
  EXPECT_FALSE(is_told_within(2s, told_unlock));
}

TEST_F(Keeper, AllIsToldAgainNowAndThen) {
  keeper().want(0, on);
  asked();
  answer(taken);
  hear_node_3_for(10);
  EXPECT_EQ(cable.last(0x342), told_on);
}

}  // namespace
}  // namespace canvoy::cia447::command_keeper_test
