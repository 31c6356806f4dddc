#include "canvoy/sim/plants/charging.hpp"

#include <gtest/gtest.h>

namespace canvoy::charging_test {
namespace {

/// Charges like a perfect charger: with the requested current, while the battery is ready.
void charge_for(ChargingPlant& plant, Duration time) {
  const auto battery = plant.battery.hardware();
  const auto stage = plant.stage.hardware();
  for (Duration done{0}; done < time; done += ChargingPlant::step_time) {
    const cia418::BatteryReadings readings = battery.sense();
    stage.deliver(readings.ready ? readings.requested_current_ampere.value_or(0) : 0);
    plant.step();
  }
}

void run_for(ChargingPlant& plant, Duration time) {
  for (Duration done{0}; done < time; done += ChargingPlant::step_time) plant.step();
}

struct Kind {
  const char* name;
  BatteryDesign design;
};

class BatteryKindTest : public testing::TestWithParam<Kind> {};

TEST_P(BatteryKindTest, IsChargedWithConstantCurrentThenTapersThenIsFull) {
  ChargingPlant sut(GetParam().design, 0.2);
  charge_for(sut, 1h);
  EXPECT_NEAR(sut.ampere(), 60, 1e-9);
  double last = sut.battery.requested_ampere();
  bool has_tapered = false;
  for (int minute = 0; minute < 11 * 60 && !sut.battery.is_full(); ++minute) {
    charge_for(sut, 1min);
    const double wanted = sut.battery.requested_ampere();
    EXPECT_LE(wanted, last + 0.1) << "a battery that grows full never asks for more";
    has_tapered = has_tapered || (wanted > 10 && wanted < 50);
    last = wanted;
  }
  EXPECT_TRUE(has_tapered);
  EXPECT_TRUE(sut.battery.is_full());
  EXPECT_GT(sut.battery.state_of_charge(), 0.95);
  charge_for(sut, 1min);
  EXPECT_EQ(sut.ampere(), 0);
}

TEST_P(BatteryKindTest, IsFullInTheHeatTooWithoutMoreThanItsCharge) {
  const BatteryDesign& design = GetParam().design;
  BatteryPlant sut(design, 0.2, 35);
  for (int minute = 0; minute < 24 * 60; ++minute) sut.step(sut.requested_ampere(), 1min);
  EXPECT_TRUE(sut.is_full());
  constexpr double two_minutes_ah = 60 * 2 / 60.0;
  EXPECT_LE(sut.truth().ampere_hours_in * design.chemistry->charge_efficiency,
            0.8 * design.capacity_ampere_hour + two_minutes_ah);
}

TEST_P(BatteryKindTest, NeverRisesAboveItsChargeVoltage) {
  ChargingPlant sut(GetParam().design, 0.5);
  const double limit = GetParam().design.cells * GetParam().design.chemistry->charge_voltage_volt;
  for (int minute = 0; minute < 600; ++minute) {
    charge_for(sut, 1min);
    ASSERT_LE(sut.battery.terminal_volt(), limit * 1.001);
  }
}

TEST_P(BatteryKindTest, WhatGoesInIsStoredOrBecomesHeat) {
  ChargingPlant sut(GetParam().design, 0.2);
  charge_for(sut, 6h);
  const BatteryTruth& truth = sut.battery.truth();
  EXPECT_GT(truth.energy_in_joule, 0);
  EXPECT_NEAR(truth.energy_stored_joule + truth.heat_joule, truth.energy_in_joule,
              1e-9 * truth.energy_in_joule);
  EXPECT_GT(truth.heat_joule, 0);
}

TEST_P(BatteryKindTest, TheStateOfChargeIsWhatWentInTimesTheEfficiency) {
  ChargingPlant sut(GetParam().design, 0.2);
  charge_for(sut, 3h);
  const double gained = sut.ampere_hours() * GetParam().design.chemistry->charge_efficiency;
  EXPECT_NEAR(sut.battery.state_of_charge(), 0.2 + gained / 400, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(AllKinds, BatteryKindTest,
                         testing::Values(Kind{"LeadAcid", BatteryPlant::lead_acid_48v()},
                                         Kind{"Lithium", BatteryPlant::lithium_48v()}),
                         [](const auto& kind) { return kind.param.name; });

TEST(BatteryPlantTest, ALeadAcidBatteryTakesMostOfANightFromAFifth) {
  ChargingPlant sut(BatteryPlant::lead_acid_48v(), 0.2);
  charge_for(sut, 5h);
  EXPECT_FALSE(sut.battery.is_full());
  charge_for(sut, 3h);
  EXPECT_TRUE(sut.battery.is_full());
}

TEST(BatteryPlantTest, RestsAtItsOpenCircuitVoltage) {
  BatteryPlant sut(BatteryPlant::lead_acid_48v(), 0.6);
  sut.step(0, 1s);
  EXPECT_NEAR(sut.terminal_volt(), 24 * 2.07, 1e-9);
}

TEST(BatteryPlantTest, AColdBatteryResistsMore) {
  BatteryPlant warm(BatteryPlant::lead_acid_48v(), 0.5, 25);
  BatteryPlant cold(BatteryPlant::lead_acid_48v(), 0.5, -10);
  warm.step(60, 1s);
  cold.step(60, 1s);
  EXPECT_GT(cold.terminal_volt(), warm.terminal_volt());
}

TEST(BatteryPlantTest, WarmsUpByItsLossesAndCoolsDownToTheAmbience) {
  BatteryPlant sut(BatteryPlant::lithium_48v(), 0.5, 20);
  sut.step(60, 1h);
  const double warm = sut.celsius();
  EXPECT_GT(warm, 20);
  for (int hour = 0; hour < 100; ++hour) sut.step(0, 1h);
  EXPECT_NEAR(sut.celsius(), 20, 0.1);
  EXPECT_NEAR(sut.truth().celsius_max, warm, 1e-9);
}

TEST(BatteryPlantTest, AFullBatteryAsksForNothingSaysHundredPercentAndIsNotReady) {
  ChargingPlant plant(BatteryPlant::lithium_48v(), 0.99);
  charge_for(plant, 2h);
  const cia418::BatteryReadings readings = plant.battery.hardware().sense();
  EXPECT_EQ(readings.requested_current_ampere, 0.0);
  EXPECT_EQ(readings.state_of_charge_percent, 100.0);
  EXPECT_FALSE(readings.ready);
  EXPECT_EQ(readings.ampere_hours_since_charge, 0.0);
}

TEST(BatteryPlantTest, AFullBatteryIsReadyAgainWhenItWasUsed) {
  ChargingPlant plant(BatteryPlant::lithium_48v(), 0.99);
  charge_for(plant, 2h);
  for (int minute = 0; minute < 60; ++minute) plant.battery.step(-40, 1min);
  const cia418::BatteryReadings readings = plant.battery.hardware().sense();
  EXPECT_TRUE(readings.ready);
  EXPECT_NEAR(readings.ampere_hours_since_charge, 40, 1e-6);
  EXPECT_GT(readings.requested_current_ampere.value_or(0), 0);
}

TEST(BatteryPlantTest, BeforeItIsFullItNeverSaysHundredPercent) {
  BatteryPlant sut(BatteryPlant::lithium_48v(), 1.0);
  EXPECT_EQ(sut.hardware().sense().state_of_charge_percent, 99.0);
}

TEST(BatteryPlantTest, AFaultOfASensorLeavesTheReadingOut) {
  BatteryPlant sut(BatteryPlant::lead_acid_48v(), 0.5);
  const cia418::BatteryHardware hardware = sut.hardware();
  EXPECT_TRUE(hardware.sense().temperature_celsius);
  EXPECT_TRUE(hardware.sense().voltage_volt);
  sut.faults.temperature_is_invalid = true;
  EXPECT_FALSE(hardware.sense().temperature_celsius);
  EXPECT_TRUE(hardware.sense().voltage_volt);
  sut.faults = {.voltage_is_invalid = true};
  EXPECT_TRUE(hardware.sense().temperature_celsius);
  EXPECT_FALSE(hardware.sense().voltage_volt);
}

TEST(BatteryPlantTest, IsNotReadyWhereItMayNotBeCharged) {
  BatteryPlant sut(BatteryPlant::lead_acid_48v(), 0.5);
  const cia418::BatteryHardware hardware = sut.hardware();
  EXPECT_TRUE(hardware.sense().ready);
  sut.faults = {.is_not_ready = true};
  EXPECT_FALSE(hardware.sense().ready);
  sut.faults = {.shown_celsius = 60.5};
  EXPECT_FALSE(hardware.sense().ready);
  EXPECT_EQ(hardware.sense().temperature_celsius, 60.5);
  sut.faults = {.shown_celsius = -20.5};
  EXPECT_FALSE(hardware.sense().ready);
  sut.faults = {.shown_celsius = 52};
  EXPECT_TRUE(hardware.sense().ready);
}

TEST(PowerStagePlantTest, RisesAndFallsWithItsSlopesFromTheStepAfterTheSetPoint) {
  PowerStagePlant sut({.rise_ampere_per_second = 20, .fall_ampere_per_second = 400});
  sut.hardware().deliver(60);
  EXPECT_DOUBLE_EQ(sut.step(1s, 50), 0);
  EXPECT_DOUBLE_EQ(sut.step(1s, 50), 10) << "the average of 0 and 20 A";
  EXPECT_DOUBLE_EQ(sut.step(1s, 50), 30);
  EXPECT_DOUBLE_EQ(sut.step(1s, 50), 50);
  EXPECT_DOUBLE_EQ(sut.step(1s, 50), 60);
  sut.hardware().deliver(0);
  EXPECT_DOUBLE_EQ(sut.step(100ms, 50), 60);
  EXPECT_DOUBLE_EQ(sut.step(100ms, 50), 40) << "60 A to 20 A";
  EXPECT_DOUBLE_EQ(sut.step(100ms, 50), 5) << "20 A to nothing in half of the step";
  EXPECT_DOUBLE_EQ(sut.step(100ms, 50), 0);
}

TEST(PowerStagePlantTest, DeliversNoMoreThanItsLimitAndNothingNegative) {
  PowerStagePlant sut({.current_max_ampere = 80});
  sut.hardware().deliver(4095);
  for (int i = 0; i < 10; ++i) sut.step(1s, 50);
  EXPECT_EQ(sut.ampere(), 80);
  sut.hardware().deliver(-10);
  for (int i = 0; i < 10; ++i) sut.step(1s, 50);
  EXPECT_EQ(sut.ampere(), 0);
}

TEST(PowerStagePlantTest, ItsMeterIsOffByGainAndOffset) {
  PowerStagePlant sut({.meter_gain = 1.05, .meter_offset_ampere = 0.5});
  EXPECT_EQ(sut.hardware().current(), 0);
  sut.hardware().deliver(40);
  for (int i = 0; i < 10; ++i) sut.step(1s, 50);
  EXPECT_DOUBLE_EQ(sut.hardware().current(), 42.5);
}

TEST(PowerStagePlantTest, TakesFromTheMainsWhatItDeliversAndLoses) {
  PowerStagePlant sut({.rise_ampere_per_second = 1e9, .efficiency = 0.5});
  sut.hardware().deliver(10);
  sut.step(1s, 50);
  sut.step(1s, 50);
  EXPECT_NEAR(sut.mains_energy_joule(), 1000, 0.1);
}

TEST(PowerStagePlantTest, AWeldedContactorDeliversWhateverItIsTold) {
  PowerStagePlant sut;
  sut.faults.stuck_ampere = 30;
  for (int i = 0; i < 10; ++i) sut.step(1s, 50);
  EXPECT_EQ(sut.ampere(), 30);
}

TEST(ChargingPlantTest, WithoutThePlugNothingFlowsAndThePilotSignalIsGone) {
  ChargingPlant sut(BatteryPlant::lead_acid_48v(), 0.5);
  charge_for(sut, 1min);
  EXPECT_TRUE(sut.stage.hardware().pilot_signal());
  EXPECT_GT(sut.ampere(), 0);
  sut.is_plugged = false;
  run_for(sut, 1s);
  EXPECT_EQ(sut.ampere(), 0);
  EXPECT_FALSE(sut.stage.hardware().pilot_signal());
  EXPECT_EQ(sut.stage.hardware().current(), 0);
}

TEST(ChargingPlantTest, APilotSignalThatIsLostDoesNotStopTheCurrentByItself) {
  ChargingPlant sut(BatteryPlant::lead_acid_48v(), 0.5);
  charge_for(sut, 1min);
  sut.stage.faults.pilot_signal_is_lost = true;
  run_for(sut, 1s);
  EXPECT_FALSE(sut.stage.hardware().pilot_signal());
  EXPECT_GT(sut.ampere(), 0);
}

TEST(ChargingPlantTest, EnergyIsVoltageTimesCurrentTimesTime) {
  ChargingPlant sut(BatteryPlant::lithium_48v(), 0.5);
  charge_for(sut, 1h);
  EXPECT_NEAR(sut.ampere_hours(), 60, 0.1);
  EXPECT_NEAR(sut.energy_watt_hour(), 60 * sut.battery.terminal_volt(), 20);
}

}  // namespace
}  // namespace canvoy::charging_test
