// The light of a roof bar at the wire (CiA 447-3, 4.2.20). Fields of two bits; PDO 73 (392h of node
// 5) has sub-indices 01h and 02h, PDO 74 (393h) 03h and 04h, PDO 75 (394h) 05h.
#include "canvoy/devices/cia447/roof_bar_light/roof_bar_light_unit.hpp"

#include <gtest/gtest.h>

#include "canvoy/devices/cia447/kit/car_bench_test.hpp"

namespace canvoy::cia447::roof_bar_light_unit_test {
namespace {

class RoofBarLight : public testing::Test {
 protected:
  std::string command(unsigned sub, const std::string& bytes) {
    return bench.ask("23 30 61 0" + std::to_string(sub) + " " + bytes);
  }
  std::string status(unsigned sub) {
    return bench.ask("40 31 61 0" + std::to_string(sub) + " 00 00 00 00").substr(12);
  }

  RoofBarLightUnit* unit_ = nullptr;
  CarBench bench{only_unit<RoofBarLightKind>,
                 [this](Environment& environment) { environment.watch(unit_); }};
  Cable& cable = bench.cable;
};

TEST_F(RoofBarLight, AllIsOffAtFirstAndTheSearchLampInPosition1) {
  EXPECT_EQ(cable.last(0x392), "392#00 00 00 00 00 00 00 00");
  EXPECT_EQ(cable.last(0x393), "393#00 00 00 00 00 00 00 00");
  EXPECT_EQ(cable.last(0x394), "394#00 00 00 00");
  EXPECT_EQ(bench.ask("40 31 61 00 00 00 00 00"), "4F 31 61 00 05 00 00 00");
  EXPECT_EQ(bench.ask("40 30 61 03 00 00 00 00"), "43 30 61 03 FF FF FF FF");
}

TEST_F(RoofBarLight, EachSubIndexHasLightsOfItsOwn) {
  command(1, "FD FF FF 7F");  // main light beacon 1 (bits 1 and 0), rear flasher 2 (31 and 30)
  command(2, "FF FF DF FF");  // alley light right 2 (21 and 20)
  command(3, "FF FC FF FD");  // rear warning flasher 1 (9 and 8) off, search lamp (25 and 24) on
  command(4, "FF F7 FF FF");  // additional light beacon 14 (11 and 10)
  command(5, "FF FF FF 7F");  // additional function 16
  cable.clear();
  cable.run_for(49ms);
  EXPECT_EQ(cable.count(0x392), 0u);
  cable.run_for(1ms);
  EXPECT_EQ(cable.last(0x392), "392#01 00 00 40 00 00 10 00");
  EXPECT_EQ(status(3), "00 00 00 01");
  EXPECT_EQ(status(4), "00 04 00 00");
  EXPECT_EQ(status(5), "00 00 00 40");
}

// Figures 105 to 116: a light has the same bits in command and status. Beside lights there are the
// motion of the search lamp (sub-index 03h, bits 26 to 31) and reserved bits (04h, 30 and 31).
TEST_F(RoofBarLight, EachLightIsTurnedOnAndOffByItself) {
  constexpr unsigned lights[] = {16, 16, 13, 15, 16};
  const auto bytes = [](std::uint32_t word) {
    char text[16];
    std::snprintf(text, sizeof text, "%02X %02X %02X %02X", word & 0xFF, word >> 8 & 0xFF,
                  word >> 16 & 0xFF, word >> 24);
    return std::string(text);
  };
  for (unsigned sub = 1; sub <= 5; ++sub) {
    for (unsigned light = 0; light < lights[sub - 1]; ++light) {
      const std::uint32_t others = ~(std::uint32_t{3} << 2 * light);
      command(sub, bytes(others | std::uint32_t{1} << 2 * light));
      cable.run_for(50ms);
      EXPECT_EQ(status(sub), bytes(std::uint32_t{1} << 2 * light)) << sub << " " << light;
      command(sub, bytes(others));
      cable.run_for(50ms);
      EXPECT_EQ(status(sub), "00 00 00 00") << sub << " " << light;
    }
  }
}

TEST_F(RoofBarLight, TheSearchLampSwingsToItsEnd) {
  command(3, "FF FF FF F7");  // right: bits 27 and 26
  // Moving right; its position (31 and 30) is not available.
  EXPECT_EQ(cable.last(0x393), "393#00 00 00 C4 00 00 00 00");
  cable.run_for(5999ms);
  EXPECT_EQ(status(3), "00 00 00 C4");
  cable.run_for(1ms);
  EXPECT_EQ(status(3), "00 00 00 C0");
}

TEST_F(RoofBarLight, TheSearchLampStopsWhereItIs) {
  command(3, "FF FF FF EB");  // left (2), and down (29 and 28: 2)
  EXPECT_EQ(status(3), "00 00 00 E8");
  cable.run_for(1s);
  command(3, "FF FF FF F3");  // stop swinging right/left
  EXPECT_EQ(status(3), "00 00 00 E0");
  command(3, "FF FF FF CF");
  EXPECT_EQ(status(3), "00 00 00 C0");
}

TEST_F(RoofBarLight, TheSearchLampGoesToAPosition) {
  command(3, "FF FF FF BF");  // position 3: code 2 (errata Z35)
  EXPECT_EQ(status(3), "00 00 00 C0") << "on its way";
  cable.run_for(3999ms);
  EXPECT_EQ(status(3), "00 00 00 C0");
  cable.run_for(1ms);
  EXPECT_EQ(status(3), "00 00 00 80");
  command(3, "FF FF FF BF");
  EXPECT_EQ(status(3), "00 00 00 80") << "it is there";
}

TEST_F(RoofBarLight, WhoSwingsTheSearchLampOnItsWayHasIt) {
  command(3, "FF FF FF BF");
  cable.run_for(1s);
  command(3, "FF FF FF F7");
  EXPECT_EQ(status(3), "00 00 00 C4");
  cable.run_for(10s);
  EXPECT_EQ(status(3), "00 00 00 C0") << "it did not come to position 3";
  command(3, "FF FF FF F7");
  command(3, "FF FF FF 3F");  // position 1 while it swings
  EXPECT_EQ(status(3), "00 00 00 C0");
  cable.run_for(4s);
  EXPECT_EQ(status(3), "00 00 00 00");
}

TEST_F(RoofBarLight, ReservedCodesAreRefusedWhereThereAreSome) {
  EXPECT_EQ(command(1, "FE FF FF FF"), "80 30 61 01 30 00 09 06");
  EXPECT_EQ(command(3, "FF FF FF FE"), "80 30 61 03 30 00 09 06") << "search lamp: 2";
  EXPECT_EQ(command(5, "FF FF FF BF"), "80 30 61 05 30 00 09 06");
  EXPECT_EQ(command(4, "FF FF FF BF"), "60 30 61 04 00 00 00 00") << "bits without a meaning";
  EXPECT_EQ(command(4, "FF FF FF 3F"), "60 30 61 04 00 00 00 00") << "errata Z06";
  EXPECT_EQ(bench.ask("2F 30 61 00 03 00 00 00"), "80 30 61 00 02 00 01 06");
  EXPECT_EQ(command(6, "FF FF FF FF"), "80 30 61 06 11 00 09 06");
}

TEST_F(RoofBarLight, TheVoltageOfTheBarIsTold) {
  unit_->switching().report(light_status_roof_bar_local_voltage, LocalVoltage::under_voltage);
  cable.run_for(0s);
  EXPECT_EQ(cable.last(0x393), "393#00 00 00 00 00 00 00 40");
  unit_->switching().report(light_status_roof_bar_local_voltage, LocalVoltage::over_voltage);
  EXPECT_EQ(status(4), "00 00 00 80") << "code 2 is no failure (errata Z35)";
  unit_->switching().sense(light_status_roof_bar_local_voltage, Sensing::failure);
  EXPECT_EQ(status(4), "00 00 00 C0") << "there is no code for a failure";
}

TEST_F(RoofBarLight, AnNmtResetLeavesTheLightsOn) {
  command(1, "FD FF FF FF");
  cable.run_for(50ms);
  cable.send("000#81 05");
  cable.clear();
  cable.send("000#01 05");
  EXPECT_EQ(cable.last(0x392), "392#01 00 00 00 00 00 00 00");
}

}  // namespace
}  // namespace canvoy::cia447::roof_bar_light_unit_test
