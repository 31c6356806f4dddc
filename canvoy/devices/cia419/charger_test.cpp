// The charger with a battery at the other end of a cable: frames and currents, at exact virtual
// times.
#include "canvoy/devices/cia419/charger.hpp"

#include <gtest/gtest.h>

#include "canvoy/canopen/testing/cable.hpp"
#include "canvoy/devices/cia418/battery_device.hpp"
#include "canvoy/devices/cia419/charger_device.hpp"

namespace canvoy::cia419 {
namespace {

/// The hardware of both, as plain numbers.
struct Bench {
  double delivered = 0;
  bool plugged = true;
  cia418::BatteryReadings readings{.temperature_celsius = 25,
                                   .voltage_volt = 50,
                                   .requested_current_ampere = 40,
                                   .state_of_charge_percent = 30,
                                   .ready = true};

  void deliver(double ampere) { delivered = ampere; }
  double current() { return delivered; }
  bool pilot_signal() { return plugged; }
  cia418::BatteryReadings sense() { return readings; }

  ChargerHardware charger_hardware() {
    return {.deliver = Callback<void(double)>::to<&Bench::deliver>(*this),
            .current = Callback<double()>::to<&Bench::current>(*this),
            .pilot_signal = Callback<bool()>::to<&Bench::pilot_signal>(*this)};
  }
  cia418::BatteryHardware battery_hardware() {
    return {.sense = Callback<cia418::BatteryReadings()>::to<&Bench::sense>(*this)};
  }
};

class ChargerTest : public testing::Test {
 protected:
  ChargerTest() {
    cable.connect(0, charger.node());
    cable.connect(1, battery.node());
  }
  void run_until_charging() {
    cable.start_all();
    cable.run_for(5s);
    ASSERT_EQ(charger.charger().reason(), StopReason::none);
    ASSERT_EQ(bench.delivered, 40);
    cable.clear();
  }

  Bench bench;
  Cable cable;
  ChargerDevice<> charger{cable.port(0), 5, bench.charger_hardware(), {}};
  cia418::BatteryDevice<> battery{cable.port(1), 10, bench.battery_hardware(), {}};
};

TEST_F(ChargerTest, FindsTheBatteryLinksItsPdosAndCharges) {
  cable.start_all();
  cable.run_for(5s);
  EXPECT_EQ(charger.charger().phase(), ChargerPhase::linked);
  EXPECT_EQ(charger.charger().battery(), 10);
  EXPECT_EQ(charger.charger().reason(), StopReason::none);
  EXPECT_EQ(bench.delivered, 40);
  Dictionary& dictionary = charger.node().dictionary();
  EXPECT_EQ(dictionary.number(0x1400, 1) & 0x8000'0000, 0x8000'0000) << "6.2.5.1: RPDO 2 instead";
  EXPECT_EQ(dictionary.number(0x1401, 1), 0x28Au);
  EXPECT_EQ(dictionary.number(0x1402, 1), 0x38Au);
  EXPECT_EQ(dictionary.number(0x1800, 1), 0x20Au);
  EXPECT_EQ(dictionary.number(0x1801, 1), 0x30Au);
  EXPECT_EQ(dictionary.number(0x1802, 1), 0x40Au);
}

}  // namespace
}  // namespace canvoy::cia419
