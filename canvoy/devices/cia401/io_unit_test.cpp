// An input and output module of CiA 401 at its wire: contacts and voltages in, frames out, and the
// other way round. Indices, types and defaults are those of public sources (facts 6.1).
#include "canvoy/devices/cia401/io_unit.hpp"

#include <gtest/gtest.h>

#include "canvoy/devices/cia401/io_bench_test.hpp"
#include "canvoy/profiles/cia852/inputs.hpp"

namespace canvoy::cia401::io_unit_test {
namespace {

constexpr std::uint32_t digital_pdo = 0x1A1;
constexpr std::uint32_t analogue_pdo = 0x2A1;
constexpr std::uint32_t emergency = 0x0A1;

struct Module : IoBench<default_io> {};
struct WideModule : IoBench<IoOptions{.digital_inputs = 40,
                                      .digital_outputs = 40,
                                      .analogue_inputs = 2,
                                      .analogue_outputs = 2,
                                      .all_widths = true}> {};

/// 6020h has the first 128, 6021h the others.
struct ModuleOfBits : IoBench<IoOptions{.digital_inputs = 144, .single_bits = true}> {};

TEST_F(Module, SaysWhatItHas) {
  // 401 = 0191h, and bits 16 to 19: all four.
  EXPECT_EQ(ask("40 00 10 00 00 00 00 00"), "43 00 10 00 91 01 0F 00");
  EXPECT_EQ(device_type_of({.analogue_inputs = 1}), 0x0004'0191u);
}

// Digital inputs.

TEST_F(Module, AnInputThatChangesIsTold) {
  switch_contacts(0x05);
  EXPECT_EQ(cable.last(digital_pdo), "1A1#05 00 00 00 00 00 00 00");
  EXPECT_EQ(ask("40 00 60 01 00 00 00 00"), "4F 00 60 01 05 00 00 00");
  EXPECT_EQ(ask("40 00 60 00 00 00 00 00"), "4F 00 60 00 08 00 00 00");
  change();
  EXPECT_EQ(cable.count(digital_pdo), 1u) << "nothing has changed";
}

TEST_F(Module, PolarityInvertsWithoutAnEvent) {
  write("2F 02 60 01 81 00 00 00");
  EXPECT_EQ(ask("40 00 60 01 00 00 00 00"), "4F 00 60 01 81 00 00 00");
  EXPECT_EQ(cable.count(digital_pdo), 0u);
  switch_contacts(0x01);
  EXPECT_EQ(cable.last(digital_pdo), "1A1#80 00 00 00 00 00 00 00");
}

TEST_F(Module, EventsOfAllDigitalInputsAreSwitchedOff) {
  EXPECT_EQ(ask("40 05 60 00 00 00 00 00"), "4F 05 60 00 01 00 00 00") << "on by default";
  write("2F 05 60 00 00 00 00 00");
  switch_contacts(0xFF);
  EXPECT_EQ(cable.count(digital_pdo), 0u);
  write("2F 05 60 00 01 00 00 00");
  switch_contacts(0xFE);
  EXPECT_EQ(cable.count(digital_pdo), 1u);
}

TEST_F(Module, AFilteredInputHasToStay) {
  write("2F 03 60 01 01 00 00 00");
  switch_contacts(0x03);
  EXPECT_EQ(cable.last(digital_pdo), "1A1#02 00 00 00 00 00 00 00") << "input 2 is not filtered";
  cable.run_for(4ms);
  switch_contacts(0x02);  // it bounces
  cable.run_for(1ms);
  switch_contacts(0x03);
  cable.run_for(4999us);
  EXPECT_EQ(cable.count(digital_pdo), 1u);
  cable.run_for(1us);
  EXPECT_EQ(cable.last(digital_pdo), "1A1#03 00 00 00 00 00 00 00");
}

/// The first of them changes later: each is counted separately.
TEST_F(Module, FilteredInputsHaveToStayEachForItsOwnTime) {
  write("2F 03 60 01 03 00 00 00");
  switch_contacts(0x02);
  cable.run_for(3ms);
  switch_contacts(0x03);
  cable.run_for(1999us);
  EXPECT_EQ(cable.count(digital_pdo), 0u);
  cable.run_for(1us);
  EXPECT_EQ(cable.last(digital_pdo), "1A1#02 00 00 00 00 00 00 00");
  cable.run_for(2999us);
  EXPECT_EQ(cable.count(digital_pdo), 1u);
  cable.run_for(1us);
  EXPECT_EQ(cable.last(digital_pdo), "1A1#03 00 00 00 00 00 00 00");
}

TEST_F(Module, TheStateAtAResetIsNoEvent) {
  board.contacts[0] = 0x11;
  cable.send("000#81 21");
  cable.run_for(0s);
  EXPECT_EQ(ask("40 00 60 01 00 00 00 00"), "4F 00 60 01 11 00 00 00");
  EXPECT_EQ(cable.count(digital_pdo), 0u);
}

TEST_F(ModuleOfBits, InputsAreReadOneByOne) {
  board.contacts[0] = 0x04;   // input 3
  board.contacts[15] = 0x80;  // input 128
  board.contacts[16] = 0x01;  // input 129
  change();
  EXPECT_EQ(ask("40 20 60 00 00 00 00 00"), "4F 20 60 00 80 00 00 00");
  EXPECT_EQ(ask("40 20 60 03 00 00 00 00"), "4F 20 60 03 01 00 00 00");
  EXPECT_EQ(ask("40 20 60 04 00 00 00 00"), "4F 20 60 04 00 00 00 00");
  EXPECT_EQ(ask("40 20 60 80 00 00 00 00"), "4F 20 60 80 01 00 00 00");
  EXPECT_EQ(ask("40 21 60 01 00 00 00 00"), "4F 21 60 01 01 00 00 00");
  EXPECT_EQ(ask("40 21 60 00 00 00 00 00"), "4F 21 60 00 10 00 00 00") << "16 are left";
  EXPECT_EQ(ask("40 21 60 11 00 00 00 00"), "80 21 60 11 11 00 09 06");
  EXPECT_EQ(ask("40 22 60 00 00 00 00 00"), "80 22 60 00 00 00 02 06");
}

TEST_F(ModuleOfBits, AnInputOfOneBitIsMappedAndInverted) {
  write("23 00 18 01 A1 01 00 80");  // TPDO 1 is off
  write("2F 00 1A 00 00 00 00 00");
  write("23 00 1A 01 01 03 20 60");  // 6020h:03h, one bit
  write("2F 00 1A 00 01 00 00 00");
  write("23 00 18 01 A1 01 00 00");
  cable.clear();
  switch_contacts(0x03);
  EXPECT_EQ(cable.count(digital_pdo), 0u) << "inputs 1 and 2 are not mapped";
  switch_contacts(0x07);
  EXPECT_EQ(cable.last(digital_pdo), "1A1#01");
  write("2F 02 60 01 04 00 00 00");  // polarity of input 3
  EXPECT_EQ(ask("40 20 60 03 00 00 00 00"), "4F 20 60 03 00 00 00 00");
}

TEST_F(ModuleOfBits, AnInputOfOneBitThatCausesNoEventIsReadAllTheSame) {
  write("2F 06 60 01 FB FF 00 00");  // any change, but of input 3
  switch_contacts(0x04);
  EXPECT_EQ(cable.count(digital_pdo), 0u);
  EXPECT_EQ(ask("40 20 60 03 00 00 00 00"), "4F 20 60 03 01 00 00 00");
}

/// An array may have gaps, as that of CiA 852 (9.2 to 9.6): here 6000h:02h is missing, and half of
/// 6100h:01h.
struct GapKind : IoKind<IoOptions{}> {
  static constexpr auto description =
      describe(Part(cia301::device_type_object).initial(0x0001'0191), cia301::error_register_object,
               cia301::identity({}), cia301::heartbeat_producer(0), cia301::emergency(),
               Part(cia852::read_input_8_bit_object).keeping([](unsigned sub) {
                 return sub != 2 && sub <= 3;
               }),
               Part(read_input_16_bit_object).up_to(2));
};
TEST(IoUnitWithGaps, EachElementHasItsOwnInputs) {
  IoBoard board;
  Cable cable;
  Device<GapKind> device(cable.port(0), 33, board.hardware(),
                         IoSettings{.sensing_period = Duration(1ms)});
  cable.connect(0, device.node());
  cable.start_all();
  const auto ask = [&cable](const std::string& request) {
    cable.send("621#" + request);
    return cable.last(0x5A1).substr(4);
  };
  board.contacts = {0x11, 0x22, 0x33};
  cable.run_for(1ms);
  EXPECT_EQ(ask("40 00 60 01 00 00 00 00"), "4F 00 60 01 11 00 00 00");
  EXPECT_EQ(ask("40 00 60 02 00 00 00 00"), "80 00 60 02 11 00 09 06");
  EXPECT_EQ(ask("40 00 60 03 00 00 00 00"), "4F 00 60 03 33 00 00 00");
  EXPECT_EQ(ask("40 00 61 01 00 00 00 00"), "4B 00 61 01 11 00 00 00");
  EXPECT_EQ(ask("40 00 61 02 00 00 00 00"), "4B 00 61 02 33 00 00 00");
}

// Digital outputs.

TEST_F(Module, OutputsFollowTheirPdo) {
  cable.send("221#01 02 03 04 05 06 07 80");
  EXPECT_EQ(board.valves, (std::array<std::uint8_t, 8>{1, 2, 3, 4, 5, 6, 7, 0x80}));
  EXPECT_EQ(ask("40 00 62 08 00 00 00 00"), "4F 00 62 08 80 00 00 00");
}

TEST_F(Module, OutputsAreInvertedAndSomeAreNotWritten) {
  write("2F 02 62 01 F0 00 00 00");
  EXPECT_EQ(board.valves[0], 0xF0) << "at once";
  write("2F 08 62 01 0F 00 00 00");
  write("2F 00 62 01 FF 00 00 00");
  EXPECT_EQ(board.valves[0], 0xFF) << "of 0Fh the upper half is inverted";
  EXPECT_EQ(ask("40 00 62 01 00 00 00 00"), "4F 00 62 01 0F 00 00 00") << "what they are";
}

TEST_F(Module, OutputsTakeTheirErrorValuesWhenTheNodeIsStopped) {
  write("2F 06 62 01 0F 00 00 00");  // error mode: the lower half
  write("2F 07 62 01 05 00 00 00");  // error value
  cable.send("221#FF 00 00 00 00 00 00 00");
  cable.send("000#02 21");
  EXPECT_EQ(board.valves[0], 0xF5);
  cable.send("000#01 21");
  EXPECT_EQ(board.valves[0], 0xF5) << "until somebody writes them";
  cable.send("221#01 00 00 00 00 00 00 00");
  EXPECT_EQ(board.valves[0], 0x01);
}

/// 1029h:01h leaves the state as it is: the outputs are safe all the same.
TEST_F(Module, OutputsTakeTheirErrorValuesWhenAHeartbeatIsLost) {
  write("2F 29 10 01 01 00 00 00");
  write("23 16 10 01 64 00 01 00");  // node 1 within 100 ms
  cable.send("221#FF FF 00 00 00 00 00 00");
  cable.send("701#05");
  cable.run_for(99ms);
  EXPECT_EQ(board.valves[0], 0xFF);
  cable.run_for(1ms);
  EXPECT_EQ(board.valves[0], 0x00) << "all bits of 6206h are 1 by default, of 6207h 0";
  EXPECT_EQ(device.node().state(), NmtState::operational);
}

/// Bus-off is a communication error of 1029h; what is less than that is none.
TEST_F(Module, OutputsTakeTheirErrorValuesAtBusOffAndNotBefore) {
  cable.send("221#FF 00 00 00 00 00 00 00");
  cable.send("321#05 00 00 00 00 00 00 00");
  device.node().bus_state(BusState::error_passive, cable.now);
  EXPECT_EQ(board.valves[0], 0xFF);
  EXPECT_EQ(board.driven[0], 0x0005'0000);
  device.node().bus_state(BusState::bus_off, cable.now);
  EXPECT_EQ(board.valves[0], 0x00);
  EXPECT_EQ(board.driven[0], 0);
  cable.send("221#0F 00 00 00 00 00 00 00");
  device.node().bus_state(BusState::error_active, cable.now);
  EXPECT_NE(board.valves[0], 0xFF) << "they do not come back";
}

/// An error of the device itself.
TEST_F(Module, OutputsTakeTheirErrorValuesWhenTheDeviceFails) {
  write("2F 07 62 01 A0 00 00 00");
  write("23 44 64 01 FF FF FF FF");  // -1
  cable.send("221#FF 00 00 00 00 00 00 00");
  device.unit().fail();
  EXPECT_EQ(board.valves[0], 0xA0);
  EXPECT_EQ(board.driven[0], -0x0001'0000);
}

// Analogue inputs.

TEST_F(Module, AnalogueInputsCauseNoEventUntilTheyAreAllowedTo) {
  cable.send("000#80 21");
  cable.clear();
  cable.send("000#01 21");
  EXPECT_EQ(cable.last(emergency).substr(0, 9), "0A1#80 00") << "emergency 0080h";
  cable.clear();
  turn(1000);
  EXPECT_EQ(cable.count(analogue_pdo), 0u);
  EXPECT_EQ(ask("40 01 64 01 00 00 00 00"), "4B 01 64 01 E8 03 00 00");
  write("2F 23 64 00 01 00 00 00");
  EXPECT_EQ(cable.last(emergency).substr(0, 9), "0A1#00 00");
  turn(1001);
  EXPECT_EQ(cable.last(analogue_pdo), "2A1#E9 03 00 00 00 00 00 00");
}

/// TPDO 1 has digital inputs, 2 to 4 analogue ones alone.
TEST_F(Module, AnalogueInputsAreNotSentAtTheStartUntilTheyAreAllowedTo) {
  const auto restart = [this] {
    cable.send("000#80 21");
    cable.clear();
    cable.send("000#01 21");
  };
  restart();
  EXPECT_EQ(cable.count(digital_pdo), 1u);
  EXPECT_EQ(cable.count(analogue_pdo), 0u);
  EXPECT_EQ(cable.count(0x3A1), 0u);
  write("2F 23 64 00 01 00 00 00");
  EXPECT_EQ(cable.count(analogue_pdo), 0u) << "nothing has changed";
  restart();
  EXPECT_EQ(cable.count(analogue_pdo), 1u);
  EXPECT_EQ(cable.count(0x4A1), 1u);
}

TEST_F(Module, ATpdoOfOneAnalogueInputIsNotSentAtTheStartEither) {
  write("23 01 18 01 A1 02 00 80");
  write("2F 01 1A 00 01 00 00 00");
  write("23 01 18 01 A1 02 00 00");
  EXPECT_EQ(cable.count(analogue_pdo), 0u);
}

TEST_F(ModuleOfBits, WithoutAnalogueInputsNoEmergencySaysThatTheyAreDisabled) {
  cable.send("000#80 21");
  cable.clear();
  cable.send("000#01 21");
  EXPECT_EQ(cable.count(emergency), 0u);
}

TEST(IoUnit, AMakerMayDoWithoutTheEmergency) {
  IoBoard board;
  Cable cable;
  IoDevice<> quiet(cable.port(0), 33, board.hardware(), {.warns_of_disabled_inputs = false});
  cable.connect(0, quiet.node());
  cable.start_all();
  cable.send("000#01 21");
  EXPECT_EQ(cable.count(emergency), 0u);
}

TEST_F(Module, ATpdoWithDigitalInputsBesideIsSentAtTheStart) {
  write("23 01 18 01 A1 02 00 80");
  write("2F 01 1A 00 00 00 00 00");
  write("23 01 1A 02 08 01 00 60");  // 6000h:01h
  write("2F 01 1A 00 02 00 00 00");
  write("23 01 18 01 A1 02 00 00");
  EXPECT_EQ(cable.last(analogue_pdo), "2A1#00 00 00");
}

TEST_F(Module, AnInputIsToldWhenItHasChangedByMoreThanItsDelta) {
  write("2F 23 64 00 01 00 00 00");
  write("2F 21 64 01 04 00 00 00");  // delta alone
  write("23 26 64 01 0A 00 00 00");  // of 10
  turn(10);
  EXPECT_EQ(cable.count(analogue_pdo), 0u);
  turn(11);
  EXPECT_EQ(cable.last(analogue_pdo), "2A1#0B 00 00 00 00 00 00 00");
  turn(2);
  turn(1);
  EXPECT_EQ(cable.count(analogue_pdo), 1u) << "from 11, by 10";
  turn(0);
  EXPECT_EQ(cable.count(analogue_pdo), 2u);
}

/// It drifts: each step is small, their sum is not.
TEST_F(Module, DeltasCountFromTheLastEvent) {
  write("2F 23 64 00 01 00 00 00");
  write("2F 21 64 01 04 00 00 00");
  write("23 26 64 01 0A 00 00 00");
  for (std::int16_t value = 1; value <= 22; ++value) turn(value);
  EXPECT_EQ(cable.count(analogue_pdo), 2u) << "at 11 and 22";
  EXPECT_EQ(cable.last(analogue_pdo), "2A1#16 00 00 00 00 00 00 00");
}

TEST_F(Module, ValuesThatRiseAndFallHaveDeltasOfTheirOwn) {
  write("2F 23 64 00 01 00 00 00");
  write("2F 21 64 01 18 00 00 00");  // negative and positive
  write("23 27 64 01 05 00 00 00");
  write("23 28 64 01 64 00 00 00");
  turn(100);
  EXPECT_EQ(cable.count(analogue_pdo), 0u);
  turn(101);
  EXPECT_EQ(cable.count(analogue_pdo), 1u);
  turn(96);
  EXPECT_EQ(cable.count(analogue_pdo), 1u);
  turn(95);
  EXPECT_EQ(cable.count(analogue_pdo), 2u);
}

TEST_F(Module, LimitsLetChangesThroughBeyondThem) {
  write("2F 23 64 00 01 00 00 00");
  write("2F 21 64 01 03 00 00 00");  // both limits
  write("23 24 64 01 64 00 00 00");  // 100
  write("23 25 64 01 9C FF FF FF");  // -100
  turn(99);
  turn(-100);
  EXPECT_EQ(cable.count(analogue_pdo), 0u) << "below the upper, not below the lower one";
  turn(100);
  EXPECT_EQ(cable.count(analogue_pdo), 1u) << "at the upper one";
  turn(-101);
  EXPECT_EQ(cable.count(analogue_pdo), 2u);
  change();
  EXPECT_EQ(cable.count(analogue_pdo), 2u) << "no change, no event";
}

TEST_F(Module, ReadingTheSourceClearsIt) {
  write("2F 23 64 00 01 00 00 00");
  turn(5);
  board.set_volts(3, 7);
  change();
  EXPECT_EQ(ask("40 22 64 01 00 00 00 00"), "43 22 64 01 05 00 00 00") << "inputs 1 and 3";
  EXPECT_EQ(ask("40 22 64 01 00 00 00 00"), "43 22 64 01 00 00 00 00");
  turn(6);
  EXPECT_EQ(ask("40 22 64 01 00 00 00 00"), "43 22 64 01 01 00 00 00");
}

TEST_F(Module, InputsAreScaledAndStayWithinTheirType) {
  write("23 32 64 01 03 00 00 00");  // times 3
  write("23 31 64 01 9C FF FF FF");  // less 100
  turn(1000);
  EXPECT_EQ(ask("40 01 64 01 00 00 00 00"), "4B 01 64 01 54 0B 00 00") << "2900";
  turn(20000);
  EXPECT_EQ(ask("40 01 64 01 00 00 00 00"), "4B 01 64 01 FF 7F 00 00");
  turn(-20000);
  EXPECT_EQ(ask("40 01 64 01 00 00 00 00"), "4B 01 64 01 00 80 00 00");
}

// Analogue outputs.

TEST_F(Module, AnalogueOutputsFollowTheirPdos) {
  cable.send("321#01 00 FF FF 00 80 FF 7F");
  EXPECT_EQ(board.driven[0], 0x0001'0000);
  EXPECT_EQ(board.driven[1], -0x0001'0000);
  EXPECT_EQ(board.driven[2], INT32_MIN);
  EXPECT_EQ(board.driven[3], 0x7FFF'0000);
  cable.send("521#00 00 00 00 00 00 02 00");
  EXPECT_EQ(board.driven[11], 0x0002'0000);
}

TEST_F(Module, AnalogueOutputsTakeTheirErrorValues) {
  write("2F 43 64 02 00 00 00 00");  // the second keeps its value; 1 is the default
  write("23 44 64 01 10 00 00 00");
  cable.send("321#05 00 06 00 07 00 00 00");
  cable.send("000#02 21");
  EXPECT_EQ(board.driven[0], 0x0010'0000);
  EXPECT_EQ(board.driven[1], 0x0006'0000);
  EXPECT_EQ(board.driven[2], 0) << "0 by default";
}

TEST_F(Module, AScaledOutputFollowsItsScaleAtOnce) {
  cable.send("321#05 00 00 00 00 00 00 00");
  write("23 47 64 01 02 00 00 00");
  EXPECT_EQ(board.driven[0], 0x000A'0000);
  write("23 46 64 01 FF FF FF FF");
  EXPECT_EQ(board.driven[0], 0x0009'0000);
}

// Other widths.

TEST_F(WideModule, TheSameInputsAreReadInEachWidth) {
  board.contacts = {0x01, 0x02, 0x03, 0x04, 0x85, 0xFF, 0xFF, 0xFF};
  change();
  EXPECT_EQ(ask("40 00 61 02 00 00 00 00"), "4B 00 61 02 03 04 00 00");
  EXPECT_EQ(ask("40 00 61 03 00 00 00 00"), "4B 00 61 03 85 00 00 00") << "there are 40 inputs";
  EXPECT_EQ(ask("40 20 61 01 00 00 00 00"), "43 20 61 01 01 02 03 04");
  EXPECT_EQ(ask("40 20 61 02 00 00 00 00"), "43 20 61 02 85 00 00 00");
}

TEST_F(WideModule, OutputsAreWrittenInAnyWidth) {
  write("23 20 63 01 11 22 33 44");
  EXPECT_EQ(board.valves[3], 0x44);
  EXPECT_EQ(ask("40 00 62 03 00 00 00 00"), "4F 00 62 03 33 00 00 00");
  write("2B 00 63 01 55 66 00 00");
  EXPECT_EQ(ask("40 20 63 01 00 00 00 00"), "43 20 63 01 55 66 33 44");
}

/// An output has one polarity, in whichever width it is written.
TEST_F(WideModule, ParametersOfOutputsAreTheSameInEachWidth) {
  write("2B 02 63 01 F0 0F 00 00");
  EXPECT_EQ(board.valves[0], 0xF0) << "at once";
  EXPECT_EQ(board.valves[1], 0x0F);
  EXPECT_EQ(ask("40 02 62 02 00 00 00 00"), "4F 02 62 02 0F 00 00 00");
  EXPECT_EQ(ask("40 22 63 01 00 00 00 00"), "43 22 63 01 F0 0F 00 00");
  write("2F 02 62 03 01 00 00 00");
  EXPECT_EQ(ask("40 22 63 01 00 00 00 00"), "43 22 63 01 F0 0F 01 00");
  EXPECT_EQ(ask("40 02 63 02 00 00 00 00"), "4B 02 63 02 01 00 00 00");
}

TEST_F(WideModule, ErrorValuesOfWideOutputsAreTaken) {
  write("23 26 63 01 00 FF 00 FF");  // the second and fourth eight
  write("23 27 63 01 11 22 33 44");
  EXPECT_EQ(ask("40 06 62 02 00 00 00 00"), "4F 06 62 02 FF 00 00 00");
  EXPECT_EQ(ask("40 07 63 02 00 00 00 00"), "4B 07 63 02 33 44 00 00");
  write("23 20 63 01 55 55 55 55");
  cable.send("000#02 21");
  EXPECT_EQ((std::array{board.valves[0], board.valves[1], board.valves[2], board.valves[3]}),
            (std::array<std::uint8_t, 4>{0x55, 0x22, 0x55, 0x44}));
}

/// A TPDO is notified of an output that was written in another width.
TEST_F(WideModule, AnOutputThatIsWrittenInOneWidthIsToldInAnother) {
  write("23 00 18 01 A1 01 00 80");
  write("2F 00 1A 00 00 00 00 00");
  write("23 00 1A 01 10 01 00 63");  // 6300h:01h
  write("2F 00 1A 00 01 00 00 00");
  write("23 00 18 01 A1 01 00 00");
  cable.clear();
  write("2F 00 62 02 7F 00 00 00");
  EXPECT_EQ(cable.last(digital_pdo), "1A1#00 7F");
}

TEST_F(WideModule, AnalogueInputsAreReadInEachWidth) {
  board.volts[0] = 0x1234'5678;
  change();
  EXPECT_EQ(ask("40 00 64 01 00 00 00 00"), "4F 00 64 01 12 00 00 00");
  EXPECT_EQ(ask("40 01 64 01 00 00 00 00"), "4B 01 64 01 34 12 00 00");
  EXPECT_EQ(ask("40 02 64 01 00 00 00 00"), "43 02 64 01 78 56 34 12");
  board.volts[0] = 0x4000'0000;
  change();
  // 0.5
  EXPECT_EQ(ask("40 03 64 01 00 00 00 00"), "43 03 64 01 00 00 00 3F");
  write("23 2F 64 01 00 00 20 41");  // times 10
  write("23 2E 64 01 00 00 80 BF");  // less 1
  // 4.0
  EXPECT_EQ(ask("40 03 64 01 00 00 00 00"), "43 03 64 01 00 00 80 40");
}

TEST_F(WideModule, FloatingPointOutputsAreWrittenAndNoNumberIsZero) {
  write("23 13 64 01 00 00 00 BF");  // -0.5
  EXPECT_EQ(board.driven[0], -0x4000'0000);
  write("23 13 64 01 00 00 00 40");  // 2.0
  EXPECT_EQ(board.driven[0], INT32_MAX);
  write("23 13 64 01 00 00 C0 7F");  // not a number
  EXPECT_EQ(board.driven[0], 0);
}

/// 6443h is 1 by default: the output takes 6445h where 6413h was written last, else 6444h.
TEST_F(WideModule, FloatingPointOutputsTakeTheirErrorValues) {
  write("23 44 64 01 10 00 00 00");
  write("23 45 64 01 00 00 00 BF");  // -0.5
  write("23 44 64 02 10 00 00 00");
  write("23 45 64 02 00 00 00 BF");
  write("23 13 64 01 00 00 80 3E");  // 0.25
  EXPECT_EQ(board.driven[0], 0x2000'0000);
  write("23 13 64 02 00 00 80 3E");
  write("2B 11 64 02 05 00 00 00");
  cable.send("000#02 21");
  EXPECT_EQ(board.driven[0], -0x4000'0000);
  EXPECT_EQ(board.driven[1], 0x0010'0000);
  cable.send("000#80 21");
  EXPECT_EQ(ask("40 13 64 01 00 00 00 00"), "43 13 64 01 00 00 00 BF");
  cable.send("000#81 21");
  EXPECT_EQ(board.driven[0], 0) << "6411h again, which is 0";
}

TEST_F(WideModule, AResetOfCommunicationMovesNoOutput) {
  write("2B 11 64 01 E8 03 00 00");
  write("23 13 64 01 00 00 80 3E");  // 0.25
  cable.send("000#82 21");
  EXPECT_EQ(board.driven[0], 0x2000'0000);
}

}  // namespace
}  // namespace canvoy::cia401::io_unit_test
