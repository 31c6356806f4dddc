// Simple simulated hardware of a charger and a battery, and both on one cable, for tests.
//
//     Bench bench;
//     ChargerDevice<> charger(cable.port(0), 5, bench.charger_hardware());
//     EXPECT_EQ(bench.delivered, 40);
#pragma once

#include <gtest/gtest.h>

#include "canvoy/canopen/testing/cable.hpp"
#include "canvoy/devices/cia418/battery_device.hpp"
#include "canvoy/devices/cia418/battery_hardware.hpp"
#include "canvoy/devices/cia419/charger_device.hpp"
#include "canvoy/devices/cia419/charger_hardware.hpp"

namespace canvoy::cia419 {

/// The simulated hardware of both.
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
    return {.deliver = callback<&Bench::deliver>(*this),
            .current = callback<&Bench::current>(*this),
            .pilot_signal = callback<&Bench::pilot_signal>(*this)};
  }
  cia418::BatteryHardware battery_hardware() { return {.sense = callback<&Bench::sense>(*this)}; }
};

/// The charger is node 5, the battery node 10.
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
  bool asked(std::uint32_t id) const {
    return std::ranges::any_of(cable.heard, [id](const Cable::Heard& heard) {
      return heard.frame.is_remote() && heard.frame.id == id;
    });
  }
  void expect_pdos_invalid() {
    for (const std::uint16_t index :
         std::to_array<std::uint16_t>({0x1400, 0x1401, 0x1402, 0x1800, 0x1801, 0x1802})) {
      EXPECT_EQ(charger.node().dictionary().number(index, 1), 0x8000'0000u) << "clause 6.1";
    }
  }

  Bench bench;
  Cable cable;
  ChargerDevice<> charger{cable.port(0), 5, bench.charger_hardware(), {}};
  cia418::BatteryDevice<> battery{cable.port(1), 10, bench.battery_hardware(), {}};
};

}  // namespace canvoy::cia419
