// Outputs of a panel at the wire: which record lights what. Bytes are typed from CiA 417-4, 4.4.1.
#include "canvoy/devices/cia417/panel/output_panel_unit.hpp"

#include <gtest/gtest.h>

#include <cstdio>

#include "canvoy/devices/cia417/panel/output_panel_test.hpp"

namespace canvoy::cia417::output_panel_unit_test {
namespace {

class OutputPanelUnitTest : public testing::Test {
 protected:
  OutputBench bench;
};

TEST_F(OutputPanelUnitTest, ARecordLightsTheLampThatItAddresses) {
  bench.start();
  bench.tell("02 01 01 03 10 01");
  EXPECT_EQ(bench.on(), 0b0000001u);
  EXPECT_EQ(bench.shown, (std::vector<std::uint32_t>{0}));
  EXPECT_EQ(bench.stored(0x6200, 1), 0x0110'0301'0102u);
  EXPECT_EQ(bench.stored(0x6011, 0), 0x0110'0301'0102u);
  bench.tell("02 01 01 03 10 00");
  EXPECT_EQ(bench.on(), 0u);
  EXPECT_EQ(bench.stored(0x6200, 1), 0x0010'0301'0102u);
}

TEST_F(OutputPanelUnitTest, ARecordForBothDirectionsLightsBoth) {
  bench.start();
  bench.tell("02 03 01 03 10 01");
  EXPECT_EQ(bench.on(), 0b0000011u);
  EXPECT_EQ(bench.stored(0x6200, 1) & 0xFFFF, 0x0102u) << "each keeps what it is";
  EXPECT_EQ(bench.stored(0x6200, 2) & 0xFFFF, 0x0202u);
}

TEST_F(OutputPanelUnitTest, AnotherLiftFloorOrDoorIsNotAddressed) {
  bench.start();
  bench.tell("02 03 02 03 10 01");
  bench.tell("02 03 01 04 10 01");
  bench.tell("02 03 01 00 10 01");
  bench.tell("02 03 01 03 20 01");
  bench.tell("03 03 01 03 10 01");
  EXPECT_EQ(bench.on(), 0u);
  EXPECT_EQ(bench.shown, std::vector<std::uint32_t>{});
  bench.tell("02 03 FF FF F0 01");
  EXPECT_EQ(bench.on(), 0b0000011u) << "all lifts, floors and doors";
}

TEST_F(OutputPanelUnitTest, NothingIsLitBeforeTheNodeIsOperational) {
  bench.cable.start_all();
  bench.tell("02 01 01 03 10 01");
  EXPECT_EQ(bench.on(), 0u);
  EXPECT_TRUE(bench.write_record("11 60 00", "02 01 01 03 10 01")) << "but by SDO";
  EXPECT_EQ(bench.on(), 0b0000001u);
}

TEST_F(OutputPanelUnitTest, ARecordThatIsTooShortIsNotTaken) {
  bench.start();
  bench.tell("02 01 01 03 10");
  EXPECT_EQ(bench.on(), 0u);
  bench.tell("02 01 01 03 10 01 FF FF");
  EXPECT_EQ(bench.on(), 0b0000001u) << "a longer one is";
}

TEST_F(OutputPanelUnitTest, APositionIndicatorShowsTheFloorOrNone) {
  bench.start();
  bench.tell("40 0C 01 FF 00 01");
  EXPECT_TRUE(bench.is_on(2));
  EXPECT_EQ(bench.view(2).sub_function, 12);
  EXPECT_EQ(bench.stored(0x6200, 3), 0x0100'0301'0C40u) << "place and function stay";
  bench.tell("40 00 01 03 00 01");
  EXPECT_EQ(bench.view(2).sub_function, 0);
  bench.tell("40 FE 01 03 00 01");
  bench.tell("40 FF 01 03 00 01");
  EXPECT_EQ(bench.view(2).sub_function, 254) << "255 is reserved";
}

TEST_F(OutputPanelUnitTest, ALanternShowsItsArrows) {
  bench.start();
  bench.tell("41 11 01 03 00 01");
  EXPECT_TRUE(bench.is_on(3));
  EXPECT_EQ(bench.view(3).sub_function, arrow_up | arrow_moving);
  bench.tell("42 02 01 03 00 01");
  EXPECT_EQ(bench.view(3).sub_function, arrow_up | arrow_moving) << "a direction is none";
}

TEST_F(OutputPanelUnitTest, ADisplayShowsEachSpecialIndicationAndALampItsOwn) {
  bench.start();
  bench.tell("43 02 01 03 00 01");
  EXPECT_EQ(bench.on(), 0b0010000u);
  EXPECT_EQ(bench.view(4).sub_function, 0x02);
  bench.tell("43 03 01 03 00 01");
  EXPECT_EQ(bench.on(), 0b0110000u);
  EXPECT_EQ(bench.view(4).sub_function, 0x03);
  EXPECT_EQ(bench.view(5).sub_function, 0x03);
  bench.tell("43 00 01 03 00 01");
  EXPECT_EQ(bench.on(), 0u) << "all displays off, whatever the status says";
  bench.tell("43 0A 01 03 00 01");
  EXPECT_EQ(bench.on(), 0b0010000u) << "the lamp is still that of overload";
}

/// The profile leaves their meaning to the makers (4.4.1): the display gets the value unchanged.
TEST_F(OutputPanelUnitTest, OperationDataAndPublicityAreShownAsTheyCome) {
  constexpr VirtualOutput displays[] = {
      {.function = BasicFunction::operation_data, .lifts = lift_bit(1), .floor = 3},
      {.function = BasicFunction::publicity_indication, .lifts = lift_bit(1), .floor = 3}};
  Cable cable;
  OutputPanelDevice<bench_lamps_layout> panel(cable.port(0), 21, {}, {.outputs = displays});
  cable.connect(0, panel.node());
  cable.start_all();
  cable.send("000#01 15");
  for (unsigned output = 0; output < 2; ++output) {
    for (unsigned content = 0; content <= 0xFF; ++content) {
      char record[32];
      std::snprintf(record, sizeof record, "400#%02X %02X 01 03 00 01", 0x45 + output, content);
      cable.send(record);
      EXPECT_EQ(panel.unit().view(output).sub_function, content);
      EXPECT_TRUE(panel.unit().view(output).on);
      EXPECT_EQ(panel.node().dictionary().number(0x6200, static_cast<std::uint8_t>(output + 1)),
                0x0100'0301'0045U + output + content * 0x100U);
    }
  }
}

TEST_F(OutputPanelUnitTest, AGongSoundsEachTimeButNotForBothDirections) {
  bench.start();
  bench.tell("44 01 01 03 00 01");
  bench.tell("44 01 01 03 00 01");
  EXPECT_EQ(bench.shown, (std::vector<std::uint32_t>{6, 6}));
  bench.tell("44 03 01 03 00 01");
  EXPECT_EQ(bench.shown.size(), 2u);
  bench.tell("44 02 01 03 00 01");
  EXPECT_EQ(bench.view(6).sub_function, arrow_down);
}

TEST_F(OutputPanelUnitTest, WhoWritesIntoTheGroupAssignsTheOutput) {
  bench.start();
  EXPECT_TRUE(bench.write_record("00 62 01", "05 09 01 00 00 01"));
  EXPECT_EQ(bench.on(), 0b0000001u);
  bench.tell("02 01 01 03 10 00");
  EXPECT_EQ(bench.on(), 0b0000001u) << "it is no hall call any more";
  bench.tell("05 09 01 00 00 00");
  EXPECT_EQ(bench.on(), 0u);
  bench.tell("05 FF 01 00 00 01");
  EXPECT_EQ(bench.on(), 0b0000001u) << "all target stops";
}

TEST_F(OutputPanelUnitTest, AResetOfTheCommunicationChangesNoLampAndOneOfTheNodeAll) {
  bench.start();
  bench.tell("02 01 01 03 10 01");
  bench.cable.send("000#82 15");
  EXPECT_EQ(bench.on(), 0b0000001u);
  EXPECT_EQ(bench.stored(0x6200, 1), 0x0110'0301'0102u);
  bench.cable.send("000#81 15");
  EXPECT_EQ(bench.on(), 0u);
  EXPECT_EQ(bench.stored(0x6200, 1), 0x0010'0301'0102u);
}

/// All function data: status, property, its parameter, predicate.
TEST_F(OutputPanelUnitTest, EveryFunctionDataIsShownAsItSays) {
  constexpr unsigned flashing[] = {10'000, 7500, 5000, 2000, 1500, 1000, 500, 250};
  constexpr unsigned volume[] = {1, 37, 73, 109, 145, 181, 217, 254};
  for (unsigned data = 0; data <= 0xFF; ++data) {
    OutputBench fresh;
    fresh.start();
    char record[24];
    std::snprintf(record, sizeof record, "02 01 01 03 10 %02X", data);
    fresh.tell(record);
    const unsigned property = data >> 1 & 7;
    const unsigned parameter = data >> 4 & 7;
    const OutputView& view = fresh.view(0);
    EXPECT_EQ(view.on, data % 2 == 1) << data;
    EXPECT_EQ(view.affirmed, data >= 128) << data;
    EXPECT_EQ(view.flash_millihertz, property == 3 ? flashing[parameter] : 0) << data;
    EXPECT_EQ(view.color.value_or(99), property == 4 ? parameter : 99) << data;
    EXPECT_EQ(view.intensity.value_or(0), property == 5 ? volume[parameter] : 0) << data;
    EXPECT_EQ(view.scroll_rate.value_or(0), property == 6 ? parameter : 0) << data;
    if (parameter == 0) {
      EXPECT_FALSE(view.scroll_rate.has_value()) << "automatic";
    }
    EXPECT_EQ(fresh.stored(0x6200, 1) >> 40, data);
  }
}

TEST_F(OutputPanelUnitTest, AnImpulseHasEightTimesAndTakesNoMessageMeanwhile) {
  constexpr unsigned milliseconds[] = {500, 1000, 1500, 2000, 3000, 5000, 10'000, 15'000};
  bench.start();
  for (unsigned parameter = 0; parameter < 8; ++parameter) {
    char record[24];
    std::snprintf(record, sizeof record, "02 01 01 03 10 %02X", 0x05 | parameter << 4);
    bench.tell(record);
    EXPECT_TRUE(bench.is_on(0));
    bench.tell("02 01 01 03 10 00");
    bench.run_for(std::chrono::milliseconds(milliseconds[parameter]) - 1us);
    EXPECT_TRUE(bench.is_on(0)) << parameter;
    bench.run_for(1us);
    EXPECT_FALSE(bench.is_on(0)) << parameter;
    EXPECT_EQ(bench.stored(0x6200, 1) >> 40 & 1, 0u) << "6200h tells the state";
  }
  bench.tell("02 01 01 03 10 04");
  EXPECT_FALSE(bench.is_on(0)) << "an impulse that indicates nothing";
  bench.tell("02 01 01 03 10 01");
  bench.run_for(60s);
  EXPECT_TRUE(bench.is_on(0)) << "and the next message is taken at once";
}

}  // namespace
}  // namespace canvoy::cia417::output_panel_unit_test
