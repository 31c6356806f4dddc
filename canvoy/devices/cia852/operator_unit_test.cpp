// An operator environment interface module at its wire: sticks, pedals and buttons in, frames out.
// Sub-indices are those of Tables 1 to 7, PDOs those of clause 12, with the errata.
#include "canvoy/devices/cia852/operator_unit.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "canvoy/devices/cia852/operator_device.hpp"
#include "canvoy/devices/cia852/operator_unit_test.hpp"

namespace canvoy::cia852::operator_unit_test {
namespace {

// What there is.

TEST_F(OperatorEverything, SaysWhatItHas) {
  // Table 8: profile 0191h, all four of I/O, M, and a bit for each of the seven and the highest.
  EXPECT_EQ(ask("40 00 10 00 00 00 00 00"), "43 00 10 00 91 01 8F FF");
  EXPECT_EQ(ask("40 00 60 00 00 00 00 00"), "4F 00 60 00 70 00 00 00");
  EXPECT_EQ(ask("40 01 64 00 00 00 00 00"), "4F 01 64 00 48 00 00 00");
  EXPECT_EQ(ask("40 20 61 00 00 00 00 00"), "4F 20 61 00 88 00 00 00");
  EXPECT_EQ(ask("40 00 62 00 00 00 00 00"), "4F 00 62 00 40 00 00 00");
  EXPECT_EQ(ask("40 11 64 00 00 00 00 00"), "4F 11 64 00 60 00 00 00");
}

/// X1X0b with joysticks that only move is not reachable here, since 6000h exists (11.2).
TEST_F(OperatorRemote, SaysWhatItHas) {
  EXPECT_EQ(ask("40 00 10 00 00 00 00 00"), "43 00 10 00 91 01 81 90");
  EXPECT_EQ(ask("40 01 64 00 00 00 00 00"), "80 01 64 00 00 00 02 06");
  EXPECT_EQ(ask("40 23 64 00 00 00 00 00"), "80 23 64 00 00 00 02 06");
  EXPECT_EQ(ask("40 16 10 00 00 00 00 00"), "80 16 10 00 00 00 02 06") << "it has no outputs";
  EXPECT_EQ(ask("40 28 10 00 00 00 00 00"), "80 28 10 00 00 00 02 06");
}

TEST_F(OperatorSeat, ElementsThatAreNotThereHaveNoEntries) {
  EXPECT_EQ(ask("40 00 60 05 00 00 00 00"), "80 00 60 05 11 00 09 06") << "of a third joystick";
  EXPECT_EQ(ask("40 01 64 07 00 00 00 00"), "80 01 64 07 11 00 09 06");
  EXPECT_EQ(ask("40 01 64 32 00 00 00 00"), "80 01 64 32 11 00 09 06") << "of a second pedal";
  EXPECT_EQ(ask("40 11 64 07 00 00 00 00"), "80 11 64 07 11 00 09 06") << "of six parameters";
  // Parameters of CiA 401 are there for the same inputs.
  EXPECT_EQ(ask("40 26 64 06 00 00 00 00").substr(0, 11), "43 26 64 06");
  EXPECT_EQ(ask("40 26 64 07 00 00 00 00"), "80 26 64 07 11 00 09 06");
  EXPECT_EQ(ask("40 26 64 31 00 00 00 00").substr(0, 11), "43 26 64 31");
  EXPECT_EQ(ask("40 26 64 41 00 00 00 00").substr(0, 11), "43 26 64 41");
  EXPECT_EQ(ask("40 26 64 42 00 00 00 00"), "80 26 64 42 11 00 09 06");
  EXPECT_EQ(ask("40 06 60 31 00 00 00 00"), "4F 06 60 31 FF 00 00 00");
  EXPECT_EQ(ask("40 06 60 22 00 00 00 00"), "80 06 60 22 11 00 09 06");
}

// PDOs are off, and their mapped objects exist (clause 12).

TEST_F(OperatorEverything, AllPdosAreOffAtTheStart) {
  seat.axes[{1, 1}] = 100;
  seat.push_buttons[{1, 1}] = 1;
  change();
  for (const Cable::Heard& heard : cable.heard) {
    EXPECT_TRUE(heard.frame.id < 0x180 || heard.frame.id >= 0x580) << std::hex << heard.frame.id;
  }
  EXPECT_EQ(ask("40 00 18 01 00 00 00 00"), "43 00 18 01 85 01 00 80") << "80000180h + node-ID";
  EXPECT_EQ(ask("40 04 18 01 00 00 00 00"), "43 04 18 01 00 00 00 80") << "TPDO 5, joystick 2";
  EXPECT_EQ(ask("40 28 18 01 00 00 00 00"), "43 28 18 01 00 00 00 80") << "TPDO 41";
  EXPECT_EQ(ask("40 28 18 02 00 00 00 00"), "4F 28 18 02 FF 00 00 00");
  EXPECT_EQ(ask("40 20 14 01 00 00 00 00"), "43 20 14 01 00 00 00 80") << "RPDO 33";
  EXPECT_EQ(ask("40 02 14 00 00 00 00 00"), "80 02 14 00 00 00 02 06") << "RPDO 3 is not used";
}

struct MappedBy {
  const char* read;  ///< SDO upload of a mapping entry
  const char* answer;
};
/// By hand from Tables 12, 16, 20, 24, 28, 32 and 36, and 12.2.2 to 12.2.14.
constexpr MappedBy last_mappings[] = {
    {"40 00 1A 03 00 00 00 00", "43 00 1A 03 10 03 01 64"},  // joystick 1, z
    {"40 00 1A 05 00 00 00 00", "43 00 1A 05 08 02 00 60"},  // its buttons
    {"40 12 1A 03 00 00 00 00", "43 12 1A 03 10 30 01 64"},  // TPDO 19: joystick 16, z
    {"40 12 1A 04 00 00 00 00", "43 12 1A 04 08 1F 00 60"},  // its memory
    {"40 13 1A 02 00 00 00 00", "43 13 1A 02 10 31 01 64"},  // TPDO 20: pedal 1
    {"40 1A 1A 03 00 00 00 00", "43 1A 1A 03 08 30 00 60"},  // TPDO 27: pedal 16, memory
    {"40 1A 1A 04 00 00 00 00", "43 1A 1A 04 10 40 01 64"},
    {"40 1B 1A 01 00 00 00 00", "43 1B 1A 01 20 81 20 61"},  // TPDO 28: encoder 1
    {"40 1E 1A 02 00 00 00 00", "43 1E 1A 02 20 88 20 61"},  // TPDO 31: encoder 8
    {"40 1F 1A 01 00 00 00 00", "43 1F 1A 01 10 41 01 64"},  // TPDO 32: wheel 1
    {"40 20 1A 04 00 00 00 00", "43 20 1A 04 10 48 01 64"},  // TPDO 33: wheel 8
    {"40 21 1A 01 00 00 00 00", "43 21 1A 01 08 31 00 60"},  // TPDO 34: cluster 1
    {"40 28 1A 08 00 00 00 00", "43 28 1A 08 08 70 00 60"},  // TPDO 41: cluster 8
    {"40 00 16 01 00 00 00 00", "43 00 16 01 08 01 00 62"},  // RPDO 1: indicators 1
    {"40 0A 16 08 00 00 00 00", "43 0A 16 08 08 40 00 62"},  // RPDO 11: indicators 8
    {"40 01 16 04 00 00 00 00", "43 01 16 04 10 04 11 64"},  // RPDO 2: display 1
    {"40 03 16 01 00 00 00 00", "43 03 16 01 10 05 11 64"},  // RPDO 4
    {"40 0B 16 04 00 00 00 00", "43 0B 16 04 10 0C 11 64"},  // RPDO 12
    {"40 20 16 04 00 00 00 00", "43 20 16 04 10 60 11 64"},  // RPDO 33: display 8
};
TEST_F(OperatorEverything, PdosMapWhatClause12Says) {
  for (const MappedBy& mapped : last_mappings) EXPECT_EQ(ask(mapped.read), mapped.answer);
}

TEST_F(OperatorEverything, EachPdoCanBeSwitchedOnAndCarriesItsElement) {
  write("23 28 18 01 C5 01 00 00");  // TPDO 41: push-button cluster 8
  cable.clear();
  seat.push_buttons[{8, 1}] = 0x01;
  seat.push_buttons[{8, 8}] = 0x80;
  change();
  EXPECT_EQ(cable.last(0x1C5), "1C5#01 00 00 00 00 00 00 80");
  write("23 1E 18 01 C6 01 00 00");  // TPDO 31: encoders 7 and 8
  seat.encoders[7] = 0x01020304;
  seat.encoders[8] = 0xFFFF'FFFF;
  change();
  EXPECT_EQ(cable.last(0x1C6), "1C6#04 03 02 01 FF FF FF FF");
}

// Inputs.

TEST_F(OperatorSeat, AJoystickIsToldInItsPdo) {
  enable_tpdo_1();
  enable_analogue();
  cable.clear();
  seat.axes[{1, 1}] = 0x0102;
  seat.axes[{1, 2}] = -2;
  seat.axes[{1, 3}] = 0x7FFF;
  seat.memory[1] = 0xFF;
  seat.buttons[1] = 0x81;
  change();
  EXPECT_EQ(cable.last(0x185), "185#02 01 FE FF FF 7F 07 81") << "Figure 5: bits 3 to 7 are 0";
  EXPECT_EQ(cable.count(0x185), 1u);
  seat.axes[{2, 1}] = 55;  // of another joystick
  change();
  EXPECT_EQ(cable.count(0x185), 1u);
  EXPECT_EQ(ask("40 01 64 04 00 00 00 00"), "4B 01 64 04 37 00 00 00");
}

TEST_F(OperatorSeat, PedalsWheelsAndButtonsAreReadAtTheirPlaces) {
  seat.pedals[1] = 1000;
  seat.pedal_memory[1] = true;
  seat.wheels[1] = -1;
  seat.push_buttons[{1, 1}] = 0x10;
  seat.push_buttons[{1, 8}] = 0x01;
  change();
  EXPECT_EQ(ask("40 00 60 21 00 00 00 00"), "4F 00 60 21 01 00 00 00");
  EXPECT_EQ(ask("40 01 64 31 00 00 00 00"), "4B 01 64 31 E8 03 00 00");
  EXPECT_EQ(ask("40 01 64 41 00 00 00 00"), "4B 01 64 41 FF FF 00 00");
  EXPECT_EQ(ask("40 00 60 31 00 00 00 00"), "4F 00 60 31 10 00 00 00");
  EXPECT_EQ(ask("40 00 60 38 00 00 00 00"), "4F 00 60 38 01 00 00 00");
}

/// 6423h is for analogue inputs; a button takes the position of its joystick along.
TEST_F(OperatorSeat, WithoutAnalogueEventsButtonsAreToldAllTheSame) {
  enable_tpdo_1();
  cable.clear();
  seat.axes[{1, 1}] = 7;
  change();
  EXPECT_EQ(cable.count(0x185), 0u);
  seat.buttons[1] = 0x02;
  change();
  EXPECT_EQ(cable.last(0x185), "185#07 00 00 00 00 00 00 02");
}

TEST_F(OperatorSeat, DeltasOfCiA401HoldForAxes) {
  enable_tpdo_1();
  enable_analogue();
  write("2F 21 64 01 04 00 00 00");  // delta alone
  write("23 26 64 01 0A 00 00 00");
  cable.clear();
  seat.axes[{1, 1}] = 10;
  change();
  EXPECT_EQ(cable.count(0x185), 0u);
  seat.axes[{1, 1}] = 11;
  change();
  EXPECT_EQ(cable.last(0x185), "185#0B 00 00 00 00 00 00 00");
}

/// Elements without these objects: each change is an event.
TEST(OperatorUnit, WithoutConfigurationEachChangeIsTold) {
  OperatorBench bench({.joysticks = 1});
  EXPECT_EQ(bench.ask("40 21 64 01 00 00 00 00"), "80 21 64 01 00 00 02 06");
  bench.enable_tpdo_1();
  bench.enable_analogue();
  bench.cable.clear();
  bench.seat.axes[{1, 2}] = 1;
  bench.change();
  EXPECT_EQ(bench.cable.last(0x185), "185#00 00 01 00 00 00 00 00");
  bench.seat.buttons[1] = 1;
  bench.change();
  EXPECT_EQ(bench.cable.count(0x185), 2u);
}

TEST(OperatorUnit, WithoutConfigurationIndicatorsAreWritten) {
  OperatorBench bench({.indicator_clusters = 1});
  EXPECT_EQ(bench.ask("40 08 62 01 00 00 00 00"), "80 08 62 01 00 00 02 06");
  bench.write("2F 00 62 01 05 00 00 00");
  EXPECT_EQ((bench.seat.lit[{1, 1}]), 0x05);
  EXPECT_EQ(bench.ask("40 00 62 01 00 00 00 00"), "4F 00 62 01 05 00 00 00");
}

/// All valid ones are sent once, whatever 6423h says (12.1).
TEST_F(OperatorSeat, PdosAreSentWhenItBecomesOperational) {
  enable_tpdo_1();
  cable.send("000#80 05");
  seat.axes[{1, 1}] = 3;
  change();
  cable.clear();
  cable.send("000#01 05");
  EXPECT_EQ(cable.last(0x185), "185#03 00 00 00 00 00 00 00");
}

TEST_F(OperatorEverything, EncodersCauseNoEventsWhereDigitalInputsDoNot) {
  write("23 1B 18 01 C6 01 00 00");
  write("2F 05 60 00 00 00 00 00");
  cable.clear();
  seat.encoders[1] = 9;
  change();
  EXPECT_EQ(cable.count(0x1C6), 0u);
  EXPECT_EQ(ask("40 20 61 81 00 00 00 00"), "43 20 61 81 09 00 00 00");
}

/// The state at the start is no event, also for the first.
TEST_F(OperatorEverything, EncodersAreReadAtAReset) {
  seat.encoders[1] = 5;
  seat.encoders[8] = 7;
  cable.send("000#82 05");
  EXPECT_EQ(ask("40 20 61 81 00 00 00 00"), "43 20 61 81 05 00 00 00");
  EXPECT_EQ(ask("40 20 61 88 00 00 00 00"), "43 20 61 88 07 00 00 00");
}

/// Clause 15 with CiA 401: 6122h inverts at once, and is no event.
TEST_F(OperatorEverything, PolarityOfAnEncoderInvertsItsBits) {
  write("23 1B 18 01 C6 01 00 00");
  seat.encoders[1] = 0x01020304;
  change();
  EXPECT_EQ(cable.last(0x1C6), "1C6#04 03 02 01 00 00 00 00");
  cable.clear();
  EXPECT_EQ(ask("40 22 61 81 00 00 00 00"), "43 22 61 81 00 00 00 00");
  write("23 22 61 81 FF FF FF FF");
  EXPECT_EQ(ask("40 20 61 81 00 00 00 00"), "43 20 61 81 FB FC FD FE");
  EXPECT_EQ(cable.count(0x1C6), 0u);
  seat.encoders[1] = 0x01020305;
  change();
  EXPECT_EQ(cable.last(0x1C6), "1C6#FA FC FD FE 00 00 00 00");
  EXPECT_EQ(ask("40 22 61 80 00 00 00 00"), "80 22 61 80 11 00 09 06") << "no encoder";
  EXPECT_EQ(ask("40 23 61 81 00 00 00 00"), "80 23 61 81 00 00 02 06") << "no filter";
}

/// 6126h: the lowest four bits cause no event; what they are goes along with the next one.
TEST_F(OperatorEverything, MasksOfAnEncoderSayWhichBitsAreEvents) {
  write("23 1B 18 01 C6 01 00 00");
  EXPECT_EQ(ask("40 26 61 88 00 00 00 00"), "43 26 61 88 FF FF FF FF") << "all by default";
  write("23 26 61 81 F0 FF FF FF");
  cable.clear();
  seat.encoders[1] = 0x0F;
  change();
  EXPECT_EQ(cable.count(0x1C6), 0u);
  EXPECT_EQ(ask("40 20 61 81 00 00 00 00"), "43 20 61 81 0F 00 00 00");
  seat.encoders[1] = 0x11;
  change();
  EXPECT_EQ(cable.last(0x1C6), "1C6#11 00 00 00 00 00 00 00");
  write("23 26 61 81 00 00 00 00");
  write("23 27 61 81 01 00 00 00");  // bit 0 switched on
  write("23 28 61 81 02 00 00 00");  // bit 1 switched off
  cable.clear();
  for (const std::uint32_t position : {0x10u, 0x12u}) {
    seat.encoders[1] = position;
    change();
    EXPECT_EQ(cable.count(0x1C6), 0u) << position;
  }
  seat.encoders[1] = 0x13;
  change();
  EXPECT_EQ(cable.count(0x1C6), 1u);
  seat.encoders[1] = 0x11;
  change();
  EXPECT_EQ(cable.count(0x1C6), 2u);
}

/// 6127h: bit 0 is sent each time that it is switched on, even if the TPDO last carried the same
/// value.
TEST_F(OperatorEverything, EachEventOfAnEncoderIsTold) {
  write("23 1B 18 01 C6 01 00 00");
  write("23 26 61 81 00 00 00 00");
  write("23 27 61 81 01 00 00 00");
  cable.clear();
  for (unsigned i = 1; i <= 3; ++i) {
    seat.encoders[1] = 1;
    change();
    EXPECT_EQ(cable.count(0x1C6), i);
    seat.encoders[1] = 0;
    change();
    EXPECT_EQ(cable.count(0x1C6), i);
  }
}

// By the period of sensing alone.

/// A push-button of a device that reads it every 2 ms.
struct PolledButton : testing::Test {
  PolledButton() {
    cable.connect(0, device.node());
    cable.start_all();
    cable.send("000#01 05");
    cable.send("605#23 21 18 01 C5 01 00 00");
    cable.run_for(1s);
    cable.clear();
  }
  std::uint8_t read(unsigned, unsigned group) { return group == 1 ? state : 0; }
  /// All messages of a press.
  std::vector<std::string> press(Duration down) {
    cable.clear();
    state = 0x04;
    cable.run_for(down);
    state = 0;
    cable.run_for(5ms);
    std::vector<std::string> told;
    for (const Cable::Heard& heard : cable.heard) {
      if (heard.frame.id == 0x1C5) told.push_back(wire_text(heard.frame));
    }
    return told;
  }

  std::uint8_t state = 0;
  Cable cable;
  OperatorDevice<OperatorEnvironment{.push_button_clusters = 1}> device{
      cable.port(0), 5, {.push_buttons = callback<&PolledButton::read>(*this)}};
};
const std::vector<std::string> down_and_up = {"1C5#04 00 00 00 00 00 00 00",
                                              "1C5#00 00 00 00 00 00 00 00"};

TEST_F(PolledButton, APressOfFiveMillisecondsIsToldByTheDefaultPeriod) {
  EXPECT_EQ(press(5ms), down_and_up);
}

/// At any moment between two readings, and with any duration.
TEST_F(PolledButton, EachPressFromFiveMillisecondsOnIsToldExactlyOnce) {
  for (const Duration down : {Duration(5ms), Duration(5900us), Duration(6ms), Duration(50ms)}) {
    for (Duration phase{}; phase < Duration(2ms); phase += Duration(100us)) {
      ASSERT_EQ(press(down), down_and_up) << down.count() << " us, " << phase.count();
      cable.run_for(Duration(2ms) - cable.now.time_since_epoch() % Duration(2ms) + phase);
    }
  }
}

// A maker's own, known when the program is compiled, is the same device.

constexpr OperatorEnvironment all_of_seat = {.joysticks = 2,
                                             .foot_pedals = 2,
                                             .encoders = 1,
                                             .wheels = 2,
                                             .push_button_clusters = 1,
                                             .indicator_clusters = 1,
                                             .displays = 1,
                                             .configuration = true};
TEST(OperatorUnit, ADeviceThatIsCompiledHasTheEntriesOfTheCatalogue) {
  static_assert(all_of_seat == usual_elements);
  Cable cable;
  OperatorDevice<all_of_seat> compiled(cable.port(0), 5, {});
  const Environment environment;
  CatalogueDevice listed(operator_kind, cable.port(1), 5, environment);
  const Dictionary& dictionary = compiled.node().dictionary();
  unsigned found = 0;
  for (unsigned index = 0x1400; index <= 0x6FFF; ++index) {
    for (unsigned sub = 0; sub <= 0xFE; ++sub) {
      const auto at = static_cast<std::uint16_t>(index);
      const auto entry = static_cast<std::uint8_t>(sub);
      const bool is_there = bool(dictionary.find(at, entry));
      found += is_there ? 1 : 0;
      ASSERT_EQ(is_there, bool(listed.node().dictionary().find(at, entry)))
          << std::hex << index << ':' << sub;
      if (!is_there && sub == 0) break;
    }
  }
  EXPECT_GT(found, 200u);
}

}  // namespace
}  // namespace canvoy::cia852::operator_unit_test
