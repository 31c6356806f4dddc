// A car position unit at the wire: expectations typed from CiA 417-4, 4.9 and 4.10, and from CiA
// 406. By default a count is 0.1 mm, 1 mm/s, 1 mm/s2.
#include "canvoy/devices/cia417/position/car_position_unit.hpp"

#include "canvoy/devices/cia417/position/car_position_unit_test.hpp"

namespace canvoy::cia417::car_position_unit_test {
namespace {

using CarPosition = CarPositionTest;

TEST_F(CarPosition, SendsThePositionByPdo18cWhenItChanges) {
  encoders.readings[0].position_millimetre = 1234.56;
  run_for(50ms);
  EXPECT_TRUE(has_sent("18C#3A 30 00 00")) << "12346 tenths of a millimetre";
  sent.clear();
  run_for(1s);
  EXPECT_FALSE(has_sent("18C#3A 30 00 00")) << "once";
}

TEST_F(CarPosition, IsBelowZeroAsASignedNumber) {
  encoders.readings[0].position_millimetre = -1;
  run_for(50ms);
  EXPECT_TRUE(has_sent("18C#F6 FF FF FF"));
}

TEST_F(CarPosition, SamplesEach20MillisecondsWhileTheCarMoves) {
  encoders.readings[0].velocity_millimetre_per_second = 1600;
  run_for(50ms);
  sent.clear();
  for (int i = 1; i <= 5; ++i) {
    encoders.readings[0].position_millimetre = i * 32;
    run_for(20ms);
  }
  EXPECT_EQ(std::ranges::count_if(sent, [](const Frame& f) { return f.id == 0x18C; }), 5);
}

TEST_F(CarPosition, IsSampledWhenTheEventTimerSendsIt) {
  EXPECT_EQ(ask("2B 06 19 05 07 00 00 00"), 0U) << "7 ms";
  sent.clear();
  run_for(8ms);
  encoders.readings[0].position_millimetre = 1;
  sent.clear();
  run_for(7ms);
  EXPECT_TRUE(has_sent("18C#0A 00 00 00")) << "before the next sample is due";
}

TEST_F(CarPosition, CountsInTheStepsOf6384) {
  encoders.readings[0] = {.position_millimetre = 100,
                          .velocity_millimetre_per_second = 500,
                          .acceleration_millimetre_per_second_squared = -800};
  run_for(50ms);
  EXPECT_EQ(read(0x6383, 1), 1000U);
  EXPECT_EQ(read(0x6390, 1), 500U);
  EXPECT_EQ(read(0x6391, 1), 0xFCE0U);
  EXPECT_EQ(ask("23 84 63 01 32 00 00 00"), 0U) << "50 x 10 um";
  EXPECT_EQ(ask("23 84 63 02 05 00 00 00"), 0U) << "5 x 0.1 mm/s";
  EXPECT_EQ(ask("23 84 63 03 0A 00 00 00"), 0U) << "10 mm/s2";
  EXPECT_EQ(read(0x6383, 1), 200U);
  EXPECT_EQ(read(0x6390, 1), 1000U);
  EXPECT_EQ(read(0x6391, 1), 0xFFB0U);
  EXPECT_EQ(ask("23 84 63 01 00 00 00 00"), 0x0609'0032U);
  EXPECT_EQ(ask("23 84 63 01 00 00 01 00"), 0x0609'0031U) << "of 16 bits (errata A13)";
}

TEST_F(CarPosition, ASpeedThatDoesNotFitIsTheHighest) {
  EXPECT_EQ(ask("23 84 63 02 01 00 00 00"), 0U);
  encoders.readings[0].velocity_millimetre_per_second = -9000;
  run_for(50ms);
  EXPECT_EQ(read(0x6390, 1), 0x8000U);
}

TEST_F(CarPosition, EachUnitHasItsOwnStepsAndPreset) {
  encoders.readings[2].position_millimetre = 100;
  EXPECT_EQ(ask("23 86 63 01 64 00 00 00"), 0U) << "unit 3: 1 mm";
  run_for(50ms);
  EXPECT_EQ(read(0x6383, 3), 100U);
  EXPECT_EQ(ask("23 82 63 03 10 27 00 00"), 0U);
  EXPECT_EQ(read(0x6383, 3), 10'000U);
  EXPECT_EQ(read(0x63C9, 3), 9'900U) << "the offset that the preset has made";
  EXPECT_EQ(read(0x6383, 1), 0U);
  encoders.readings[2].position_millimetre = 101;
  run_for(50ms);
  EXPECT_EQ(read(0x6383, 3), 10'001U);
}

TEST_F(CarPosition, KeepsThePresetThroughAReset) {
  EXPECT_EQ(ask("23 82 63 01 E8 03 00 00"), 0U);
  send("000#81 04");
  EXPECT_EQ(read(0x6383, 1), 1000U);
}

TEST_F(CarPosition, TakesNoPresetWhileTheCarMoves) {
  encoders.readings[0].velocity_millimetre_per_second = 100;
  run_for(50ms);
  EXPECT_EQ(ask("23 82 63 01 E8 03 00 00"), 0x0800'0022U);
}

TEST_F(CarPosition, CountsTheOtherWayWhereTheMeasuringDirectionIsReversed) {
  EXPECT_EQ(ask("2B 80 63 01 08 00 00 00"), 0U);
  encoders.readings[0] = {.position_millimetre = 10, .velocity_millimetre_per_second = 50};
  run_for(50ms);
  EXPECT_EQ(read(0x6383, 1), 0xFFFF'FF9CU);
  EXPECT_EQ(read(0x6390, 1), 0xFFCEU);
  EXPECT_EQ(read(0x63C0, 1), 0x0008U) << "the operating status says so";
  EXPECT_EQ(ask("2B 80 63 01 10 00 00 00"), 0x0609'0030U) << "reserved";
}

TEST_F(CarPosition, TellsOfEachWorkAreaWhetherThePositionIsInIt) {
  const auto areas = [&] { return std::pair(read(0x63B0, 1), read(0x63B0, 2)); };
  EXPECT_EQ(ask("23 B4 63 01 E8 03 00 00"), 0U) << "100 mm";
  EXPECT_EQ(ask("23 B8 63 01 D0 07 00 00"), 0U) << "to 200 mm";
  run_for(50ms);
  EXPECT_EQ(areas(), std::pair(5U, 0U)) << "out of range, underflow; channel 2 has no area";
  encoders.readings[0].position_millimetre = 100;
  run_for(50ms);
  EXPECT_EQ(areas(), std::pair(0U, 0U));
  encoders.readings[0].position_millimetre = 200.1;
  run_for(50ms);
  EXPECT_EQ(areas(), std::pair(3U, 0U)) << "out of range, overflow";
}

TEST_F(CarPosition, AnAlarmIsShownAndToldByEmergencyWithItsUnit) {
  encoders.readings[1].alarms = 0x0001;
  run_for(50ms);
  EXPECT_TRUE(has_sent("084#00 50 01 02 00 00 00 00"));
  EXPECT_EQ(read(0x63C7, 2), 1U);
  EXPECT_EQ(read(0x63C7, 1), 0U);
  encoders.readings[1].alarms = 0;
  run_for(50ms);
  EXPECT_TRUE(has_sent("084#00 00 00 00 00 00 00 00"));
}

TEST_F(CarPosition, ShowsTheAlarmsAndWarningsThatItSupports) {
  encoders.readings[0].alarms = 0x0002;
  encoders.readings[0].warnings = 0xF005;
  run_for(50ms);
  EXPECT_EQ(read(0x63C6, 1), 1U);
  EXPECT_EQ(read(0x63C7, 1), 0U);
  EXPECT_EQ(read(0x63C4, 1), 0x3FU);
  EXPECT_EQ(read(0x63C5, 1), 5U);
}

TEST_F(CarPosition, TellsOfCommissioningDiagnosticsWhileTheyAreAskedFor) {
  CarPositionSettings settings;
  settings.encoders[0].supported_alarms = 0x0003;
  CarPositionDevice<four_units_layout> other(port(), 4, encoders.hardware(), settings);
  start(other.node());
  encoders.readings[0].alarms = 0x0002;
  run_for(50ms);
  EXPECT_EQ(read(0x63C7, 1), 0U);
  EXPECT_EQ(ask("2B 80 63 01 02 00 00 00"), 0U);
  EXPECT_EQ(read(0x63C0, 1), 2U) << "6500h of CiA 406 shows it";
  EXPECT_EQ(read(0x63C7, 1), 2U);
  EXPECT_EQ(ask("2B 80 63 01 00 00 00 00"), 0U);
  EXPECT_TRUE(has_sent("084#00 00 00 00 00 00 00 00"));
  EXPECT_EQ(read(0x63C7, 1), 0U);
}

TEST_F(CarPosition, SaysWhatItIs) {
  EXPECT_EQ(read(0x1000, 0), 0x060001A1U);
  EXPECT_EQ(read(0x63C1, 1), 100'000U);
  EXPECT_EQ(read(0x63C2, 1), 1U);
  EXPECT_EQ(read(0x63D0, 1), 0U);
  EXPECT_EQ(read(0x63D0, 3), 0x7FFF'FFFFU);
  run_for(12min);
  EXPECT_EQ(read(0x63C8, 1), 2U) << "tenths of an hour";
}

TEST_F(CarPosition, TellsOfOverspeedUntilTheCarStands) {
  encoders.readings[0].velocity_millimetre_per_second = 1840;
  run_for(50ms);
  EXPECT_FALSE(has_sent("084#05 FF 01 00 00 00 00 00"));
  encoders.readings[0].velocity_millimetre_per_second = -1841;
  run_for(50ms);
  EXPECT_TRUE(has_sent("084#05 FF 01 00 00 00 00 00"));
  encoders.readings[0].velocity_millimetre_per_second = -1000;
  sent.clear();
  run_for(50ms);
  EXPECT_FALSE(has_sent("084#00 00 00 00 00 00 00 00"));
  encoders.readings[0].velocity_millimetre_per_second = 0;
  run_for(50ms);
  EXPECT_TRUE(has_sent("084#00 00 00 00 00 00 00 00"));
}

// The position CAM unit.

TEST_F(CarPosition, AnEnabledCamIsActiveWhereTheCarIsOnIt) {
  EXPECT_EQ(read(0x63A0, 1), 0U) << "none is enabled";
  EXPECT_EQ(ask("2F A1 63 01 03 00 00 00"), 0U);
  EXPECT_EQ(read(0x63A0, 1), 1U);
  encoders.readings[0].position_millimetre = 3000;
  run_for(50ms);
  EXPECT_EQ(read(0x63A0, 1), 2U);
  encoders.readings[0].position_millimetre = 3109;
  run_for(50ms);
  EXPECT_EQ(read(0x63A0, 1), 2U) << "within the hysteresis";
  encoders.readings[0].position_millimetre = 3111;
  run_for(50ms);
  EXPECT_EQ(read(0x63A0, 1), 0U);
  encoders.readings[0].position_millimetre = 3109;
  run_for(50ms);
  EXPECT_EQ(read(0x63A0, 1), 0U);
}

TEST_F(CarPosition, ThePolarityInvertsACamThatIsEnabled) {
  EXPECT_EQ(ask("2F A2 63 01 03 00 00 00"), 0U);
  EXPECT_EQ(read(0x63A0, 1), 0U);
  EXPECT_EQ(ask("2F A1 63 01 03 00 00 00"), 0U);
  EXPECT_EQ(read(0x63A0, 1), 2U);
}

TEST_F(CarPosition, ACamBelongsToItsChannelAndItsUnit) {
  EXPECT_EQ(ask("2F A1 63 02 FF 00 00 00"), 0U);
  EXPECT_EQ(read(0x63A0, 2), 0x80U);
  encoders.readings[0].position_millimetre = 600;
  run_for(50ms);
  EXPECT_EQ(read(0x63A0, 2), 0x80U);
  encoders.readings[1].position_millimetre = 600;
  run_for(50ms);
  EXPECT_EQ(read(0x63A0, 2), 0U);
}

TEST_F(CarPosition, OfACamThatIsNowhereThePolaritySpeaks) {
  CarPositionDevice<> bare(port(), 4, encoders.hardware());
  start(bare.node());
  EXPECT_EQ(ask("2F A1 63 01 84 00 00 00"), 0U) << "3 and 8";
  EXPECT_EQ(read(0x63A0, 1), 0U);
  EXPECT_EQ(ask("2F A2 63 01 80 00 00 00"), 0U);
  EXPECT_EQ(read(0x63A0, 1), 0x80U);
}

TEST(PositionCamUnit, ACamMayHaveSeveralStretches) {
  constexpr Cam door_zones[] = {{.low = -200, .high = 200}, {.low = 2800, .high = 3200}};
  Encoders encoders;
  CarPositionDevice<> device({nullptr, [](void*, const Frame&) { return true; }, nullptr}, 4,
                             encoders.hardware(), {.cams = door_zones});
  device.node().start(Time{});
  const Values values(device.node().dictionary());
  values[cam_enable(1)] = 1;
  struct Sample {
    double position;
    unsigned state;
  };
  Time now{};
  for (const auto& [position, state] :
       {Sample{0, 1}, Sample{201, 0}, Sample{2800, 1}, Sample{3200, 1}, Sample{3201, 0}}) {
    encoders.readings[0].position_millimetre = position;
    now += 60ms;
    device.node().advance(now);
    EXPECT_EQ(values[cam_state(1)].raw(), state) << position;
  }
}

constexpr auto many_cams_layout = layout_of<CarPositionKind<LiftDeviceOptions{}, 1, 254>>;

TEST(PositionCamUnit, Has254Channels) {
  constexpr Cam last[] = {{.channel = 254, .number = 1, .low = -1, .high = 1}};
  Encoders encoders;
  CarPositionDevice<many_cams_layout> device(
      {nullptr, [](void*, const Frame&) { return true; }, nullptr}, 4, encoders.hardware(),
      {.cams = last});
  device.node().start(Time{});
  const Values values(device.node().dictionary());
  EXPECT_EQ(device.node().dictionary().number(0x63A0, 0), 254U);
  values[cam_enable(254)] = 1;
  device.node().advance(Time(60ms));
  encoders.readings[0].position_millimetre = 2;
  device.node().advance(Time(120ms));
  EXPECT_EQ(values[cam_state(254)].raw(), 0);
  encoders.readings[0].position_millimetre = 0;
  device.node().advance(Time(180ms));
  EXPECT_EQ(values[cam_state(254)].raw(), 1);
}

// Lifts 2 to 8, and rotary encoders.

constexpr auto lift_2_layout = layout_of<CarPositionKind<LiftDeviceOptions{.lift = 2}>>;

TEST_F(CarPosition, BelongsToOneLiftAtATime) {
  EXPECT_EQ(ask("2F 01 60 00 03 00 00 00"), 0x0609'0030U);
  EXPECT_EQ(ask("2F 01 60 00 02 00 00 00"), 0U);
  EXPECT_EQ(ask("40 83 63 00 00 00 00 00"), 0x0602'0000U);
  EXPECT_EQ(ask("40 83 6B 00 00 00 00 00"), 4U) << "position units";
}

TEST_F(CarPosition, OfLift2HasItsPositionABlockAboveAndItsPdoTenHexAbove) {
  CarPositionDevice<lift_2_layout> second(port(), 4, encoders.hardware(), {.lift = 2});
  start(second.node());
  encoders.readings[0].position_millimetre = 1;
  run_for(50ms);
  EXPECT_TRUE(has_sent("19C#0A 00 00 00"));
  EXPECT_EQ(read(0x6B83, 1), 10U);
  EXPECT_EQ(ask("23 82 6B 01 64 00 00 00"), 0U);
  EXPECT_EQ(read(0x6B83, 1), 100U);
}

TEST_F(CarPosition, OfARotaryEncoderCountsItsUnitsPerRevolutionWhereScalingIsEnabled) {
  CarPositionSettings settings;
  settings.encoders[0].revolution_micrometre = 400'000;
  CarPositionDevice<> rotary(port(), 4, encoders.hardware(), settings);
  start(rotary.node());
  encoders.readings[0].position_millimetre = 1000;  // two and a half turns
  EXPECT_EQ(ask("23 81 63 01 00 10 00 00"), 0U) << "4096";
  EXPECT_EQ(read(0x6383, 1), 10'000U);
  EXPECT_EQ(ask("2B 80 63 01 04 00 00 00"), 0U);
  EXPECT_EQ(read(0x6383, 1), 10'240U);
  EXPECT_EQ(ask("2B 80 63 01 05 00 00 00"), 0U) << "and counter-clockwise";
  EXPECT_EQ(read(0x6383, 1), 0xFFFF'D800U);
}

}  // namespace
}  // namespace canvoy::cia417::car_position_unit_test
