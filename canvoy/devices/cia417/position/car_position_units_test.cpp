// The four position units of a car, each of which has settings and values of its own (CiA 417-4,
// 4.9): what is set for one is not that of the others.
#include "canvoy/devices/cia417/position/car_position_unit_test.hpp"

namespace canvoy::cia417::car_position_units_test {
namespace {

class PositionUnits : public CarPositionTest, public testing::WithParamInterface<unsigned> {
 protected:
  /// All at 300 mm, with 500 mm/s and -800 mm/s2.
  void move() {
    encoders.readings.fill({.position_millimetre = 300,
                            .velocity_millimetre_per_second = 500,
                            .acceleration_millimetre_per_second_squared = -800});
    run_for(100ms);
  }
  /// All at 300 mm.
  void stand() {
    encoders.readings.fill({.position_millimetre = 300});
    run_for(100ms);
  }
  /// A value of 16 or 32 bits by SDO; the abort code.
  std::uint32_t write(unsigned index, unsigned sub, std::uint32_t value, unsigned bytes = 4) {
    char request[40];
    std::snprintf(request, sizeof request, "%02X %02X %02X %02X %02X %02X %02X %02X",
                  bytes == 4 ? 0x23U : 0x2BU, index & 0xFF, index >> 8, sub, value & 0xFF,
                  value >> 8 & 0xFF, value >> 16 & 0xFF, value >> 24);
    return ask(request);
  }
  /// An entry for each unit: what it has here, and what elsewhere.
  void expect(unsigned index, std::uint32_t here, std::uint32_t elsewhere) {
    for (unsigned unit = 1; unit <= 4; ++unit) {
      EXPECT_EQ(read(index, unit), unit == GetParam() ? here : elsewhere)
          << std::hex << index << ":" << unit;
    }
  }

  unsigned offset = GetParam() - 1;
};

TEST_P(PositionUnits, HaveStepsOfTheirOwnForPositionSpeedAndAcceleration) {
  EXPECT_EQ(write(0x6384 + offset, 1, 100), 0U) << "1 mm";
  EXPECT_EQ(write(0x6384 + offset, 2, 25), 0U) << "2.5 mm/s";
  EXPECT_EQ(write(0x6384 + offset, 3, 4), 0U) << "4 mm/s2";
  move();
  expect(0x6383, 300, 3'000);
  expect(0x6390, 200, 500);
  expect(0x6391, 0xFF38, 0xFCE0);  // -200, -800
}

TEST_P(PositionUnits, HaveAnOperatingParameterOfTheirOwn) {
  EXPECT_EQ(write(0x6380, GetParam(), 0x0008, 2), 0U) << "the measuring direction";
  move();
  expect(0x6383, 0xFFFF'F448, 3'000);
  expect(0x6390, 0xFE0C, 500);
  expect(0x6391, 800, 0xFCE0);
  expect(0x63C0, 0x0008, 0);
}

TEST_P(PositionUnits, HaveAPresetAndAnOffsetOfTheirOwn) {
  stand();
  EXPECT_EQ(write(0x6382, GetParam(), 12'000), 0U);
  expect(0x6383, 12'000, 3'000);
  expect(0x63C9, 9'000, 0);
}

TEST_P(PositionUnits, HaveWorkAreasOfTheirOwn) {
  stand();
  for (unsigned channel = 1; channel <= 2; ++channel) {
    const std::uint32_t low = channel == 1 ? 1'000 : 4'000;
    EXPECT_EQ(write(0x63B4 + offset, channel, low), 0U);
    EXPECT_EQ(write(0x63B8 + offset, channel, low + 1'000), 0U);
  }
  run_for(50ms);
  for (unsigned unit = 1; unit <= 4; ++unit) {
    const bool is_here = unit == GetParam();
    EXPECT_EQ(read(0x63B0 + unit - 1, 1), is_here ? 3U : 0U) << "300 mm is above 200 mm";
    EXPECT_EQ(read(0x63B0 + unit - 1, 2), is_here ? 5U : 0U) << "and below 400 mm";
  }
}

TEST_P(PositionUnits, HaveWarningsAndAlarmsOfTheirOwn) {
  encoders.readings[offset] = {.alarms = 0x0001, .warnings = 0x0004};
  run_for(50ms);
  expect(0x63C5, 4, 0);
  expect(0x63C7, 1, 0);
  encoders.readings[offset] = {};
  sent.clear();
  run_for(50ms);
  EXPECT_TRUE(has_sent("084#00 00 00 00 00 00 00 00"));
  encoders.readings[offset].alarms = 0x0001;
  run_for(50ms);
  const std::string unit = std::to_string(GetParam());
  EXPECT_TRUE(has_sent("084#00 50 01 0" + unit + " 00 00 00 00"));
}

TEST_P(PositionUnits, SayWhatTheyAre) {
  CarPositionSettings settings;
  EncoderProperties& encoder = settings.encoders[offset];
  encoder.single_turn_resolution = 8192;
  encoder.revolutions = 4096;
  encoder.manufacturer_offset = -1;
  encoder.position_min = 17;
  encoder.position_max = 0x0200'0000;
  encoder.supported_alarms = 0x0003;
  encoder.supported_warnings = 0x0015;
  encoder.operating_time = 1'000;
  CarPositionDevice<four_units_layout> other(port(), 4, encoders.hardware(), settings);
  start(other.node());
  expect(0x63C1, 8192, 100'000);
  expect(0x63C2, 4096, 1);
  expect(0x63C4, 0x0015, 0x003F);
  expect(0x63C6, 0x0003, 0x0001);
  expect(0x63C8, 1'000, 0);
  for (unsigned unit = 1; unit <= 4; ++unit) {
    const bool is_here = unit == GetParam();
    EXPECT_EQ(read(0x63D0 + unit - 1, 1), is_here ? 0xFFFF'FFFF : 0);
    EXPECT_EQ(read(0x63D0 + unit - 1, 2), is_here ? 17U : 0U);
    EXPECT_EQ(read(0x63D0 + unit - 1, 3), is_here ? 0x0200'0000U : 0x7FFF'FFFFU);
  }
}

TEST_P(PositionUnits, TellWhatNobodyWrites) {
  for (const unsigned index : {0x6383U, 0x63C1U, 0x63C8U}) {
    EXPECT_EQ(write(index, GetParam(), 1), 0x0601'0002U) << std::hex << index;
  }
  for (const unsigned index :
       {0x6390U, 0x6391U, 0x63C0U, 0x63C2U, 0x63C4U, 0x63C5U, 0x63C6U, 0x63C7U, 0x63C9U}) {
    EXPECT_EQ(write(index, GetParam(), 1, 2), 0x0601'0002U) << std::hex << index;
  }
  for (unsigned sub = 1; sub <= 3; ++sub) {
    EXPECT_EQ(write(0x63D0 + offset, sub, 1), 0x0601'0002U);
  }
}

INSTANTIATE_TEST_SUITE_P(Unit, PositionUnits, testing::Values(1, 2, 3, 4));

}  // namespace
}  // namespace canvoy::cia417::car_position_units_test
