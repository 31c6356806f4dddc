// A charger's own curve: IUoU. Currents and voltages are computed by hand from the settings.
#include "canvoy/devices/cia419/charge_curve.hpp"

#include <gtest/gtest.h>

#include "canvoy/devices/cia419/charger_test.hpp"

namespace canvoy::cia419::charge_curve_test {
namespace {

/// 24 cells: 57.6 V.
constexpr ChargeCurveSettings lead = {.current_ampere = 60,
                                      .cell_voltage_volt = 2.4,
                                      .tail_ampere = 12,
                                      .equalising_ampere = 8,
                                      .equalising_time = 2h};

TEST(ChargeCurve, OfWhichNothingIsSetGivesNoCurrent) {
  ChargeCurve curve({});
  EXPECT_FALSE(curve.is_used());
  EXPECT_EQ(curve.ampere(), 0);
}

TEST(ChargeCurve, IsConstantCurrentUntilTheVoltageIsReached) {
  ChargeCurve curve(lead);
  curve.begin();
  for (int second = 0; second < 3600; ++second) curve.advance(1s, {.volt = 57.59, .cells = 24});
  EXPECT_EQ(curve.ampere(), 60);
  curve.advance(1s, {.volt = 57.6, .cells = 24});
  EXPECT_EQ(curve.phase(), ChargeCurve::Phase::voltage);
}

/// Cells of 0.12 ohm in all behind 53.4 V take 35 A at 57.6 V.
TEST(ChargeCurve, ThenHoldsTheVoltage) {
  ChargeCurve curve(lead);
  curve.begin();
  double volt = 53.4 + 60 * 0.12;
  for (int i = 0; i < 6000; ++i) {
    curve.advance(100ms, {.volt = volt, .cells = 24});
    volt = 53.4 + curve.ampere() * 0.12;
  }
  EXPECT_NEAR(curve.ampere(), 35, 0.1);
  EXPECT_NEAR(volt, 57.6, 0.01);
}

TEST(ChargeCurve, EqualisesWhenLittleHasFlownForAMinuteAndEnds) {
  ChargeCurve curve(lead);
  curve.begin();
  curve.advance(1s, {.volt = 57.6, .cells = 24});
  while (curve.ampere() > 12) curve.advance(1s, {.volt = 58.2, .cells = 24});
  for (int i = 0; i < 58; ++i) curve.advance(1s, {.volt = 57.6, .cells = 24});
  EXPECT_EQ(curve.phase(), ChargeCurve::Phase::voltage);
  curve.advance(1s, {.volt = 57.6, .cells = 24});
  EXPECT_EQ(curve.phase(), ChargeCurve::Phase::equalising);
  EXPECT_EQ(curve.ampere(), 8);
  for (int i = 1; i < 7200; ++i) curve.advance(1s, {.volt = 62, .cells = 24});
  EXPECT_EQ(curve.ampere(), 8);
  curve.advance(1s, {.volt = 62, .cells = 24});
  EXPECT_EQ(curve.phase(), ChargeCurve::Phase::finished);
  EXPECT_EQ(curve.ampere(), 0);
  curve.begin();
  EXPECT_EQ(curve.ampere(), 60) << "another battery";
}

/// A shorted cell takes all current for ever.
TEST(ChargeCurve, EndsAVoltagePhaseThatWouldNot) {
  ChargeCurve curve({.current_ampere = 60, .voltage_time_max = 3h});
  curve.begin();
  curve.advance(1s, {.volt = 57.6, .cells = 24});
  for (int i = 1; i < 3 * 3600; ++i) curve.advance(1s, {.volt = 56, .cells = 24});
  EXPECT_EQ(curve.ampere(), 60);
  curve.advance(1s, {.volt = 56, .cells = 24});
  EXPECT_EQ(curve.ampere(), 0);
}

/// A battery of 24 cells (6020h:04) that offers no TPDO 3.
class ChargerWithACurve : public testing::Test {
 protected:
  ChargerWithACurve() {
    cable.connect(0, charger.node());
    cable.connect(1, battery.node());
    battery.node().start(cable.now);
    const std::uint8_t invalid[] = {0x8A, 0x03, 0x00, 0x80};
    EXPECT_EQ(battery.node().dictionary().write(0x1802, 1, invalid, Source::sdo), AbortCode::none);
    charger.node().start(cable.now);
    cable.run_for(5s);
  }

  Bench bench{.readings = {.temperature_celsius = 25,
                           .voltage_volt = 50,
                           .requested_current_ampere = 40,
                           .ready = true}};
  Cable cable;
  ChargerDevice<> charger{
      cable.port(0), 5, bench.charger_hardware(), {.curve = {.current_ampere = 50}}};
  cia418::BatteryDevice<> battery{cable.port(1), 10, bench.battery_hardware(), {}};
};

TEST_F(ChargerWithACurve, ChargesABatteryThatRequestsNothing) {
  ASSERT_EQ(charger.charger().battery(), 10);
  EXPECT_EQ(bench.delivered, 50);
  bench.readings.voltage_volt = 58;  // above 57.6 V
  cable.run_for(10min);
  EXPECT_EQ(bench.delivered, 0);
  EXPECT_EQ(charger.charger().reason(), StopReason::no_request) << "finished, and still ready";
}

TEST_F(ChargerWithACurve, MakesAPauseWhileTheBatteryIsNotReady) {
  bench.readings.ready = false;
  cable.run_for(1s);
  EXPECT_EQ(bench.delivered, 0);
  bench.readings.ready = true;
  cable.run_for(1s);
  EXPECT_EQ(bench.delivered, 50);
}

TEST_F(ChargerWithACurve, BeginsAnewWithTheNextBattery) {
  bench.readings.voltage_volt = 58;
  cable.run_for(10min);
  ASSERT_EQ(bench.delivered, 0);
  bench.plugged = false;
  cable.run_for(1s);
  bench.plugged = true;
  bench.readings.voltage_volt = 50;
  cable.run_for(10s);
  EXPECT_EQ(bench.delivered, 50);
}

}  // namespace
}  // namespace canvoy::cia419::charge_curve_test
