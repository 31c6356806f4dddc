// The indicators of a node during LSS, a program download or bit-rate detection, each reported by
// the service itself (CiA 303-3).
#include <gtest/gtest.h>

#include "canvoy/canopen/device/indicators.hpp"
#include "canvoy/canopen/dictionary/dictionary_layout.hpp"
#include "canvoy/canopen/lss/bit_rate_detection.hpp"
#include "canvoy/canopen/lss/lss_slave.hpp"
#include "canvoy/canopen/testing/program_objects.hpp"
#include "canvoy/canopen/testing/wire.hpp"

namespace canvoy::indicators_services_test {
namespace {

using enum Indication;

constexpr auto layout = lay_out(
    std::to_array<ObjectRow>({{.index = 0x1018, .entry_count = 2}}),
    std::to_array<EntryRow>(
        {{.access = Access::const_, .initial = 4},
         {.sub_first = 1, .sub_last = 4, .type = DataType::unsigned32, .access = Access::ro}}));

TEST(IndicatorsOfServices, FlickerInLssStateConfiguration) {
  WireNode wire(layout.tables(), node_id_unconfigured);
  Indicators sut(wire.node);
  LssSlaveHooks hooks;
  hooks.state_entered = callback<&Indicators::lss_state_entered>(sut);
  const LssSlave lss(wire.node, hooks);
  wire.boot();
  EXPECT_EQ(sut.run(), off) << "it waits for a node-ID";
  wire.receive("7E5#04 01 00 00 00 00 00 00");
  EXPECT_EQ(sut.run(), flickering);
  EXPECT_EQ(sut.error(), flickering);
  wire.receive("7E5#11 05 00 00 00 00 00 00");
  wire.receive("7E5#04 00 00 00 00 00 00 00");
  EXPECT_EQ(sut.run(), blinking) << "pre-operational";
  EXPECT_EQ(sut.error(), off);
}

TEST(IndicatorsOfServices, StopToFlickerWhenAResetEndsLss) {
  WireNode wire(layout.tables(), 5);
  Indicators sut(wire.node);
  LssSlaveHooks hooks;
  hooks.state_entered = callback<&Indicators::lss_state_entered>(sut);
  const LssSlave lss(wire.node, hooks);
  wire.boot();
  wire.receive("7E5#04 01 00 00 00 00 00 00");
  EXPECT_EQ(sut.run(), flickering);
  wire.receive("000#82 05");
  EXPECT_EQ(sut.run(), blinking);
}

TEST(IndicatorsOfServices, FlashThreeTimesWhileAProgramIsClearedOrDownloaded) {
  SimulatedFlash memory(program_geometry);
  memory.busy_polls = 3;
  WireNode wire(program_layout.tables(), 5);
  Indicators sut(wire.node);
  std::array<ProgramSlot, 2> slots{{{.address = 0, .size = 256}, {.address = 256, .size = 256}}};
  const ProgramServer programs(
      wire.node, memory.flash, slots,
      {.control = {}, .check = {}, .under_way = callback<&Indicators::program_under_way>(sut)});
  std::array<std::uint8_t, 16> buffer{};
  const SdoServer server(wire.node, 0, buffer);
  wire.boot();
  EXPECT_EQ(sut.run(), blinking);
  wire.receive("605#2F 51 1F 01 03 00 00 00");
  EXPECT_EQ(sut.run(), triple_flash) << "clearing";
  wire.run_for(1s);
  EXPECT_EQ(sut.run(), blinking);
  wire.receive("605#21 50 1F 01 09 00 00 00");
  wire.receive("605#00 31 32 33 34 35 36 37");
  EXPECT_EQ(sut.run(), triple_flash) << "downloading";
  wire.receive("605#1B 38 39 00 00 00 00 00");
  wire.run_for(1s);
  EXPECT_EQ(sut.run(), blinking);
}

TEST(IndicatorsOfServices, FlickerWhileTheBitRateIsLookedFor) {
  WireNode wire(layout.tables(), 5);
  Indicators sut(wire.node);
  auto restart = [](std::uint32_t, bool) { return true; };
  BitRateDetection detection(BitRateDetection::Restart::of(restart));
  detection.on_under_way(callback<&Indicators::bit_rate_detected>(sut));
  detection.start(Time{});
  EXPECT_EQ(sut.run(), flickering);
  EXPECT_EQ(sut.error(), flickering);
  detection.receive(Frame::data_frame(0x705, {0x05}), Time(1ms));
  EXPECT_EQ(sut.run(), off);
  wire.boot();
  EXPECT_EQ(sut.run(), blinking);
}

}  // namespace
}  // namespace canvoy::indicators_services_test
