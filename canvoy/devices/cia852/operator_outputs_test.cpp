// Indications and reports of an operator environment at its wire: indicators and displays (9.7,
// 9.8), their error values, and the emergencies of 8.6 and Table 37.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <string>

#include "canvoy/devices/cia852/operator_unit_test.hpp"

namespace canvoy::cia852::operator_outputs_test {
namespace {

// Emergency 0080h (8.6).

TEST_F(OperatorSeat, WarnsThatAnalogueInputsAreDisabledEachTimeItBecomesOperational) {
  cable.send("000#80 05");
  cable.clear();
  cable.send("000#01 05");
  EXPECT_EQ(cable.last(emergency).substr(0, 9), "085#80 00");
  EXPECT_EQ(cable.count(emergency), 1u);
  cable.run_for(1s);
  EXPECT_EQ(device->node().state(), NmtState::operational) << "it shall not leave the state";
  enable_analogue();
  EXPECT_EQ(cable.last(emergency).substr(0, 12), "085#00 00 00");
  cable.send("000#80 05");
  cable.clear();
  cable.send("000#01 05");
  EXPECT_EQ(cable.count(emergency), 0u);
}

TEST_F(OperatorRemote, WithoutAnalogueInputsDoesNotWarn) {
  cable.send("000#80 05");
  cable.clear();
  cable.send("000#01 05");
  EXPECT_EQ(cable.count(emergency), 0u);
}

// Outputs.

TEST_F(OperatorSeat, IndicatorsAndDisplaysFollowTheirPdos) {
  write("23 00 14 01 05 02 00 00");
  write("23 01 14 01 05 03 00 00");
  cable.send("205#01 00 00 00 00 00 00 80");
  EXPECT_EQ((seat.lit[{1, 1}]), 0x01);
  EXPECT_EQ((seat.lit[{1, 8}]), 0x80);
  cable.send("305#01 00 FF FF 00 80 FF 7F");
  EXPECT_EQ((seat.shown[{1, 1}]), 1);
  EXPECT_EQ((seat.shown[{1, 2}]), -1);
  EXPECT_EQ((seat.shown[{1, 3}]), -32768);
  EXPECT_EQ((seat.shown[{1, 4}]), 32767);
}

TEST_F(OperatorEverything, TheLastIndicatorAndTheLastParameterAreReached) {
  write("2F 00 62 40 80 00 00 00");
  EXPECT_EQ((seat.lit[{8, 8}]), 0x80);
  write("2B 11 64 60 34 12 00 00");
  EXPECT_EQ((seat.shown[{8, 12}]), 0x1234);
}

/// 6206h is 01h by default, as it is printed (errata 12): the first of eight goes out.
TEST_F(OperatorSeat, OutputsTakeTheirErrorValuesWhenTheHostIsLost) {
  enable_analogue();
  write("2F 07 62 02 FF 00 00 00");
  write("2F 06 62 02 0F 00 00 00");
  write("23 44 64 01 64 00 00 00");  // 100
  write("2F 43 64 02 00 00 00 00");  // the second keeps its value
  write("2F 00 62 01 FF 00 00 00");
  write("2F 00 62 02 00 00 00 00");
  write("2B 11 64 01 05 00 00 00");
  write("2B 11 64 02 06 00 00 00");
  write("23 16 10 01 64 00 01 00");  // node 1 within 100 ms
  cable.send("701#05");
  cable.run_for(99ms);
  EXPECT_EQ((seat.lit[{1, 1}]), 0xFF);
  cable.run_for(1ms);
  EXPECT_EQ((seat.lit[{1, 1}]), 0xFE);
  EXPECT_EQ((seat.lit[{1, 2}]), 0x0F);
  EXPECT_EQ((seat.shown[{1, 1}]), 100);
  EXPECT_EQ((seat.shown[{1, 2}]), 6);
  EXPECT_EQ(cable.last(emergency).substr(0, 9), "085#30 81");
  EXPECT_EQ(device->node().state(), NmtState::pre_operational) << "1029h:01h is 0 by default";
}

TEST_F(OperatorSeat, OutputsTakeTheirErrorValuesInNmtStateStoppedAndAtBusOff) {
  write("2F 00 62 01 01 00 00 00");
  cable.send("000#02 05");
  EXPECT_EQ((seat.lit[{1, 1}]), 0x00);
  cable.send("000#80 05");
  write("2F 00 62 01 01 00 00 00");
  device->node().bus_state(BusState::bus_off, cable.now);
  EXPECT_EQ((seat.lit[{1, 1}]), 0x00);
}

/// Table A 8: 6413h and 6445h at the sub-indices of 6411h and 6444h (errata 6). Full scale is 1.
TEST(OperatorUnit, DisplaysTakeFloatingPointNumbersWhereTheyHaveThem) {
  OperatorBench bench({.displays = 1, .display_parameters = 2, .display_floats = true});
  EXPECT_EQ(bench.ask("40 13 64 00 00 00 00 00"), "4F 13 64 00 02 00 00 00");
  bench.write("23 13 64 02 00 00 00 3F");  // 0.5
  EXPECT_EQ((bench.seat.shown[{1, 2}]), 0x4000);
  EXPECT_EQ(bench.ask("40 11 64 02 00 00 00 00"), "4B 11 64 02 00 40 00 00") << "what it shows";
  bench.write("23 13 64 02 00 00 80 BF");  // -1.0
  EXPECT_EQ((bench.seat.shown[{1, 2}]), -32768);
  bench.write("2B 11 64 02 05 00 00 00");
  EXPECT_EQ((bench.seat.shown[{1, 2}]), 5) << "what was written last";
  // By RPDO 2, mapped again.
  bench.write("2F 01 16 00 00 00 00 00");
  bench.write("23 01 16 01 20 01 13 64");
  bench.write("2F 01 16 00 01 00 00 00");
  bench.write("23 01 14 01 05 03 00 00");
  bench.cable.send("305#00 00 80 3E");  // 0.25
  EXPECT_EQ((bench.seat.shown[{1, 1}]), 0x2000);
  EXPECT_EQ(OperatorBench({.displays = 1}).ask("40 13 64 00 00 00 00 00"),
            "80 13 64 00 00 00 02 06");
}

/// The error value is that of the object which was written last.
TEST(OperatorUnit, ADisplayTakesTheErrorValueOfTheObjectThatWasWrittenLast) {
  OperatorBench bench({.displays = 1, .display_parameters = 3, .display_floats = true});
  for (const char* const each : {"01", "02", "03"}) {
    bench.write(std::string("23 44 64 ") + each + " 64 00 00 00");  // 100
    bench.write(std::string("23 45 64 ") + each + " 00 00 80 3D");  // 1/16
  }
  bench.write("23 13 64 01 00 00 00 3F");
  bench.write("23 13 64 02 00 00 00 3F");
  bench.write("2B 11 64 02 07 00 00 00");
  bench.cable.send("000#02 05");
  EXPECT_EQ((bench.seat.shown[{1, 1}]), 0x0800);
  EXPECT_EQ((bench.seat.shown[{1, 2}]), 100);
  EXPECT_EQ((bench.seat.shown[{1, 3}]), 100) << "nothing was written";
  bench.cable.send("000#80 05");
  EXPECT_EQ(bench.ask("40 13 64 01 00 00 00 00"), "43 13 64 01 00 00 80 3D");
  EXPECT_EQ(bench.ask("40 11 64 02 00 00 00 00"), "4B 11 64 02 64 00 00 00");
}

// Other emergencies of Table 37.

TEST_F(OperatorSeat, ASyncOfAnotherLengthIsToldAs8240h) {
  enable_analogue();
  cable.clear();
  cable.send("080#01 02");
  EXPECT_EQ(cable.last(emergency).substr(0, 9), "085#40 82");
}

/// All 38 of 12.2 are on: TPDO n has the CAN-ID 180h + n.
TEST_F(OperatorEverything, AForeignFrameWithTheCobIdOfAnyTpdoIsToldAs8150h) {
  for (unsigned number = 1; number <= 41; ++number) {
    if (number > 1 && number < 5) continue;
    char request[40];
    std::snprintf(request, sizeof request, "23 %02X 18 01 %02X 01 00 00", number - 1,
                  0x80 + number);
    write(request);
  }
  for (const char* const foreign : {"181#00", "185#00", "193#00", "1A9#00"}) {
    cable.run_for(4s);
    cable.clear();
    cable.send(foreign);
    EXPECT_EQ(cable.last(emergency).substr(0, 9), "085#50 81") << foreign;
  }
}

/// 8110h: the driver has lost a frame.
TEST_F(OperatorSeat, AnOverrunIsToldAs8110h) {
  enable_analogue();
  cable.clear();
  device->node().overrun(cable.now);
  cable.run_for(0s);
  EXPECT_EQ(cable.last(emergency), "085#10 81 11 00 00 00 00 00");
  cable.clear();
  cable.run_for(2s);
  EXPECT_EQ(cable.last(emergency), "085#00 00 00 00 00 00 00 00");
}

TEST_F(OperatorSeat, TroubleOfTheControllerIsTold) {
  enable_analogue();
  cable.clear();
  device->node().bus_state(BusState::error_passive, cable.now);
  cable.run_for(0s);
  EXPECT_EQ(cable.last(emergency).substr(0, 9), "085#20 81");
  device->node().bus_state(BusState::bus_off, cable.now);
  device->node().bus_state(BusState::error_active, cable.now);
  cable.run_for(1ms);
  bool is_told = false;
  for (const Cable::Heard& heard : cable.heard) {
    is_told = is_told || wire_text(heard.frame).substr(0, 9) == "085#40 81";
  }
  EXPECT_TRUE(is_told) << "8140h";
}

// Objects of the device, not of its elements.

/// 1028h has room for each node-ID.
TEST_F(OperatorSeat, EmergenciesOfEachNodeMayBeConsumed) {
  EXPECT_EQ(ask("40 28 10 00 00 00 00 00"), "4F 28 10 00 7F 00 00 00");
  EXPECT_EQ(ask("40 28 10 80 00 00 00 00"), "80 28 10 80 11 00 09 06");
}

TEST(OperatorUnit, IsTheSameAtEachDoorAndStoresWhereItHasAMemory) {
  for (const unsigned door : {1U, 2U}) {
    for (const bool keeps : {false, true}) {
      Cable cable;
      Environment environment;
      environment.door = door;
      environment.keeps_parameters = keeps;
      CatalogueDevice device(operator_kind, cable.port(0), NodeId{5}, environment);
      const Dictionary& dictionary = device.node().dictionary();
      EXPECT_TRUE(dictionary.find(0x6401, 1)) << door;
      EXPECT_EQ(bool(dictionary.find(0x1010, 1)), keeps) << door;
      EXPECT_EQ(bool(dictionary.find(0x1011, 1)), keeps) << door;
      // So do its data sheets.
      const auto has_storage = [](const Part& part) { return part.index() == 0x1010; };
      EXPECT_EQ(std::ranges::any_of(operator_kind.form(environment).parts(), has_storage), keeps)
          << door;
    }
  }
}

}  // namespace
}  // namespace canvoy::cia852::operator_outputs_test
