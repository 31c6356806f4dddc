// A program that the network downloads to an operator environment (CiA 852, 8.4 and 11.7; CiA
// 302-3, 1F50h to 1F57h), at the wire.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "canvoy/canopen/storage/testing/simulated_flash.hpp"
#include "canvoy/canopen/testing/cable.hpp"
#include "canvoy/devices/catalogue.hpp"
#include "canvoy/devices/cia852/kinds.hpp"
#include "canvoy/devices/kit/program_place.hpp"

namespace canvoy::cia852::operator_program_test {
namespace {

constexpr SimulatedFlash::Geometry program_memory{.sector_size = 128, .sectors = 2, .unit = 8};

/// Node 5 of the catalogue, in pre-operational.
class OperatorProgram : public testing::Test {
 protected:
  OperatorProgram() {
    environment.provide(callback<&OperatorProgram::elements>(*this));
    environment.provide(callback<&OperatorProgram::place>(*this));
    begin();
  }
  void begin() {
    device =
        std::make_unique<CatalogueDevice>(operator_kind, cable.port(0), NodeId{5}, environment);
    cable.connect(0, device->node());
    cable.start_all();
  }
  std::string ask(std::string_view request) {
    cable.send("605#" + std::string(request));
    cable.run_for(10ms);
    return cable.last(0x585).substr(4);
  }
  std::vector<std::uint8_t> kept(std::size_t count) const {
    return {memory.bytes.begin() + 32,
            memory.bytes.begin() + 32 + static_cast<std::ptrdiff_t>(count)};
  }

  OperatorEnvironment has{.joysticks = 1, .program_download = true};
  SimulatedFlash memory{program_memory};
  std::vector<std::string> told;
  Cable cable;
  Environment environment;
  std::unique_ptr<CatalogueDevice> device;

 private:
  OperatorEnvironment elements() { return has; }
  ProgramPlace place() {
    return {
        .flash = &memory.flash,
        .size = program_memory.sector_size * program_memory.sectors,
        .hooks = {
            .control = callback<&OperatorProgram::control>(*this), .check = {}, .under_way = {}}};
  }
  AbortCode control(std::uint8_t number, ProgramCommand command) {
    told.push_back(std::to_string(number) + ": " + std::to_string(static_cast<int>(command)));
    return AbortCode::none;
  }
};

/// The CRC-32 of "123456789" is CBF43926h (1F56h).
TEST_F(OperatorProgram, IsDownloadedInSegmentsAndStarted) {
  EXPECT_EQ(ask("40 50 1F 00 00 00 00 00"), "4F 50 1F 00 01 00 00 00") << "one program";
  EXPECT_EQ(ask("40 57 1F 01 00 00 00 00"), "43 57 1F 01 02 00 00 00") << "no valid program";
  EXPECT_EQ(ask("2F 51 1F 01 01 00 00 00"), "80 51 1F 01 22 00 00 08") << "nothing to start";
  EXPECT_EQ(ask("2F 51 1F 01 00 00 00 00"), "60 51 1F 01 00 00 00 00");
  EXPECT_EQ(ask("2F 51 1F 01 03 00 00 00"), "60 51 1F 01 00 00 00 00");
  cable.run_for(1s);
  EXPECT_EQ(ask("21 50 1F 01 09 00 00 00"), "60 50 1F 01 00 00 00 00");
  EXPECT_EQ(ask("00 31 32 33 34 35 36 37"), "20 00 00 00 00 00 00 00");
  EXPECT_EQ(ask("1B 38 39 00 00 00 00 00"), "30 00 00 00 00 00 00 00");
  EXPECT_EQ(ask("40 57 1F 01 00 00 00 00"), "43 57 1F 01 00 00 00 00");
  EXPECT_EQ(ask("40 56 1F 01 00 00 00 00"), "43 56 1F 01 26 39 F4 CB");
  EXPECT_EQ(ask("2F 51 1F 01 01 00 00 00"), "60 51 1F 01 00 00 00 00");
  EXPECT_EQ(ask("40 51 1F 01 00 00 00 00"), "4F 51 1F 01 01 00 00 00");
  EXPECT_EQ(told, (std::vector<std::string>{"1: 0", "1: 1"})) << "stop, start";
  EXPECT_EQ(kept(9), (std::vector<std::uint8_t>{'1', '2', '3', '4', '5', '6', '7', '8', '9'}));
  EXPECT_EQ(memory.violations, 0u);

  begin();  // power-on
  EXPECT_EQ(ask("40 56 1F 01 00 00 00 00"), "43 56 1F 01 26 39 F4 CB");
}

/// Nine bytes in a block: their CRC is 31C3h.
TEST_F(OperatorProgram, IsDownloadedInABlock) {
  EXPECT_EQ(ask("2F 51 1F 01 03 00 00 00"), "60 51 1F 01 00 00 00 00");
  cable.run_for(1s);
  EXPECT_EQ(ask("C6 50 1F 01 09 00 00 00").substr(0, 11), "A4 50 1F 01");
  cable.clear();
  cable.send("605#01 31 32 33 34 35 36 37");
  cable.send("605#82 38 39 00 00 00 00 00");
  cable.run_for(10ms);
  EXPECT_EQ(cable.last(0x585).substr(0, 9), "585#A2 02");
  EXPECT_EQ(ask("D5 C3 31 00 00 00 00 00"), "A1 00 00 00 00 00 00 00");
  EXPECT_EQ(ask("40 56 1F 01 00 00 00 00"), "43 56 1F 01 26 39 F4 CB");
  EXPECT_EQ(kept(9), (std::vector<std::uint8_t>{'1', '2', '3', '4', '5', '6', '7', '8', '9'}));
}

/// The element works on: a download is none of its business.
TEST_F(OperatorProgram, IsRefusedWhereItDoesNotFitOrTheFlashWasNotCleared) {
  for (std::uint8_t& byte : memory.bytes) byte = 0x5A;  // of some earlier life
  begin();
  EXPECT_EQ(ask("21 50 1F 01 09 00 00 00"), "80 50 1F 01 22 00 00 08");
  EXPECT_EQ(ask("40 57 1F 01 00 00 00 00"), "43 57 1F 01 08 00 00 00") << "not cleared";
  EXPECT_EQ(ask("2F 51 1F 01 03 00 00 00"), "60 51 1F 01 00 00 00 00");
  cable.run_for(1s);
  EXPECT_EQ(ask("21 50 1F 01 E1 00 00 00"), "80 50 1F 01 12 00 07 06") << "225 of 224 bytes";
  EXPECT_EQ(ask("40 01 64 01 00 00 00 00"), "4B 01 64 01 00 00 00 00");
}

/// Not selected, so it does not exist.
TEST(OperatorUnitWithoutProgram, HasNoObjectsOfIt) {
  Cable cable;
  const Environment environment;
  CatalogueDevice device(operator_kind, cable.port(0), NodeId{5}, environment);
  for (const std::uint16_t index :
       std::to_array<std::uint16_t>({0x1F50, 0x1F51, 0x1F52, 0x1F56, 0x1F57})) {
    EXPECT_FALSE(device.node().dictionary().find(index, 0)) << index;
  }
}

}  // namespace
}  // namespace canvoy::cia852::operator_program_test
