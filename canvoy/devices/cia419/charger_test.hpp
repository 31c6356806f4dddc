// The hardware of a charger and a battery as plain numbers, for tests.
//
//     Bench bench;
//     ChargerDevice<> charger(cable.port(0), 5, bench.charger_hardware());
//     EXPECT_EQ(bench.delivered, 40);
#pragma once

#include <optional>

#include "canvoy/devices/cia418/battery_hardware.hpp"
#include "canvoy/devices/cia419/charger_hardware.hpp"

namespace canvoy::cia419 {

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

}  // namespace canvoy::cia419
