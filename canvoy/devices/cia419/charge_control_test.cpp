#include "canvoy/devices/cia419/charge_control.hpp"

#include <gtest/gtest.h>

namespace canvoy::cia419::charge_control_test {
namespace {

/// No fault: a battery at 25 degrees requests 40 A.
ChargeInputs all_well() {
  return {.pilot_signal = true,
          .bus_off = false,
          .linked = true,
          .heartbeat_alive = true,
          .operational = true,
          .data_fresh = true,
          .battery_ready = true,
          .temperature_celsius = 25,
          .has_voltage = true,
          .voltage_volt = 50,
          .has_request = true,
          .requested_ampere = 40,
          .state_of_charge_percent = 30,
          .battery_cells = 24};
}

class ChargeControlTest : public testing::Test {
 protected:
  void expect_stop(const ChargeInputs& given, StopReason reason) {
    const ChargeDecision decision = sut.decide(given);
    EXPECT_EQ(decision.reason, reason);
    EXPECT_EQ(decision.ampere, 0);
  }
  void expect_current(const ChargeInputs& given, double ampere) {
    const ChargeDecision decision = sut.decide(given);
    EXPECT_EQ(decision.reason, StopReason::none);
    EXPECT_EQ(decision.ampere, ampere);
  }

  ChargeControl sut{ChargeLimits{}};
  ChargeInputs inputs = all_well();
};

TEST_F(ChargeControlTest, DeliversTheRequestedCurrent) {
  expect_current(inputs, 40);
}

TEST_F(ChargeControlTest, DeliversNoMoreThanItsOwnLimit) {
  inputs.requested_ampere = 4095;
  expect_current(inputs, 60);
}

TEST_F(ChargeControlTest, EachMissingConditionAloneStopsTheCharge) {
  struct Case {
    void (*break_it)(ChargeInputs&);
    StopReason reason;
  };
  using enum StopReason;
  const Case cases[] = {
      {[](ChargeInputs& in) { in.pilot_signal = false; }, no_pilot_signal},
      {[](ChargeInputs& in) { in.bus_off = true; }, bus_off},
      {[](ChargeInputs& in) { in.linked = false; }, no_battery},
      {[](ChargeInputs& in) { in.heartbeat_alive = false; }, heartbeat_lost},
      {[](ChargeInputs& in) { in.operational = false; }, not_operational},
      {[](ChargeInputs& in) { in.data_fresh = false; }, battery_data_missed},
      {[](ChargeInputs& in) { in.battery_ready = false; }, battery_not_ready},
      {[](ChargeInputs& in) { in.state_of_charge_percent = 100; }, battery_full},
      {[](ChargeInputs& in) { in.temperature_celsius.reset(); }, invalid_temperature},
      {[](ChargeInputs& in) { in.voltage_volt.reset(); }, invalid_voltage},
      {[](ChargeInputs& in) { in.temperature_celsius = 50.125; }, too_hot},
      {[](ChargeInputs& in) { in.temperature_celsius = 50; }, too_hot},  // 50.06 is read so
      {[](ChargeInputs& in) { in.temperature_celsius = -0.125; }, too_cold},
      {[](ChargeInputs& in) { in.temperature_celsius = 0; }, too_cold},
      {[](ChargeInputs& in) { in.voltage_volt = 65.1; }, voltage_too_high},
      {[](ChargeInputs& in) { in.voltage_volt = 10; }, voltage_too_low},  // of 24 cells: 12 V
      {[](ChargeInputs& in) { in.requested_ampere.reset(); }, no_request},
      {[](ChargeInputs& in) { in.requested_ampere = 0; }, no_request},
  };
  for (const Case& broken : cases) {
    ChargeInputs in = all_well();
    broken.break_it(in);
    expect_stop(in, broken.reason);
    expect_current(all_well(), 40);
  }
}

TEST_F(ChargeControlTest, ALimitItselfIsAllowedIfNotOfTheRoundedTemperature) {
  for (const double celsius : {0.125, 49.875}) {
    inputs.temperature_celsius = celsius;
    expect_current(inputs, 40);
  }
  inputs.voltage_volt = 65;
  expect_current(inputs, 40);
  inputs.state_of_charge_percent = 99;
  expect_current(inputs, 40);
  inputs.requested_ampere = 60;
  expect_current(inputs, 60);
  inputs.requested_ampere = 0.0625;
  expect_current(inputs, 0.0625);
}

TEST_F(ChargeControlTest, OfSeveralReasonsTheMostSeriousIsGiven) {
  inputs.battery_ready = false;
  inputs.heartbeat_alive = false;
  expect_stop(inputs, StopReason::heartbeat_lost);
  inputs.pilot_signal = false;
  expect_stop(inputs, StopReason::no_pilot_signal);
}

TEST_F(ChargeControlTest, AFullBatteryIsFullAlthoughItIsNotReadyAnyMore) {
  inputs.battery_ready = false;
  inputs.state_of_charge_percent = 100;
  expect_stop(inputs, StopReason::battery_full);
}

TEST_F(ChargeControlTest, GoesOnOnlyWhenTheTemperatureHasComeBackByTheHysteresis) {
  inputs.temperature_celsius = 50.125;
  expect_stop(inputs, StopReason::too_hot);
  inputs.temperature_celsius = 48.125;
  expect_stop(inputs, StopReason::too_hot);
  inputs.temperature_celsius = 48;
  expect_current(inputs, 40);
  inputs.temperature_celsius = -0.125;
  expect_stop(inputs, StopReason::too_cold);
  inputs.temperature_celsius = 1.875;
  expect_stop(inputs, StopReason::too_cold);
  inputs.temperature_celsius = 2;
  expect_current(inputs, 40);
}

TEST_F(ChargeControlTest, WithoutAVoltageFromTheBatteryNoneIsAskedFor) {
  inputs.has_voltage = false;
  inputs.voltage_volt.reset();
  expect_current(inputs, 40);
}

TEST_F(ChargeControlTest, WithoutARequestFromTheBatteryTheConfiguredCurrentIsDelivered) {
  inputs.has_request = false;
  inputs.requested_ampere.reset();
  expect_stop(inputs, StopReason::no_request);
  ChargeControl configured(ChargeLimits{.current_without_request_ampere = 5});
  EXPECT_EQ(configured.decide(inputs).ampere, 5);
}

TEST_F(ChargeControlTest, CellsThatAreNotToldAreNotLookedAt) {
  ChargeInputs in = all_well();
  in.voltage_volt = 10;
  in.battery_cells.reset();
  expect_current(in, 40);
}

TEST(ChargeControl, HasALowerLimitOfItsOwn) {
  ChargeControl sut({.voltage_min_volt = 20});
  ChargeInputs in = all_well();
  in.voltage_volt = 19.9;
  EXPECT_EQ(sut.decide(in).reason, StopReason::voltage_too_low);
  in.voltage_volt = 20;
  EXPECT_EQ(sut.decide(in).ampere, 40);
}

/// From 40 to 50 °C in a line.
TEST(ChargeControl, GivesLessCurrentToABatteryThatGetsHot) {
  ChargeControl sut({.temperature_max_celsius = 50, .temperature_derating_kelvin = 10});
  ChargeInputs in = all_well();
  for (const auto& [celsius, ampere] : {std::pair{25, 40}, {40, 40}, {45, 20}, {49, 4}, {50, 0}}) {
    in.temperature_celsius = celsius;
    EXPECT_NEAR(sut.decide(in).ampere, ampere, 1e-9) << celsius;
  }
}

/// The maximum charge current, whatever the request (CiA 418, 6020h).
TEST_F(ChargeControlTest, DeliversNoMoreThanTheBatteryBears) {
  inputs.battery_max_ampere = 20;
  expect_current(inputs, 20);
  inputs.battery_max_ampere = 50;
  expect_current(inputs, 40);
}

}  // namespace
}  // namespace canvoy::cia419::charge_control_test
