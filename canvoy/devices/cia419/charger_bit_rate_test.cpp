// A charger that is connected to a vehicle detects the bit rate before it sends a frame (CiA 419,
// 4.2.2).
#include <gtest/gtest.h>

#include "canvoy/canopen/lss/bit_rate_detection.hpp"
#include "canvoy/canopen/testing/cable.hpp"
#include "canvoy/devices/cia418/battery_device.hpp"
#include "canvoy/devices/cia419/charger_device.hpp"
#include "canvoy/devices/cia419/charger_test.hpp"

namespace canvoy::cia419::charger_bit_rate_test {
namespace {

/// A controller on a vehicle's bus of 250 kbit/s: traffic at another bit rate is no frame.
class Vehicle {
 public:
  Vehicle() {
    cable.connect(1, battery.node());
    detection.on_found(callback<&Vehicle::found>(*this));
    battery.node().start(cable.now);
    detection.start(cable.now);
  }
  /// The charger's controller receives the traffic of the other nodes.
  void run_for(Duration duration) {
    for (const Time until = cable.now + duration; cable.now < until;) {
      const std::size_t heard = cable.heard.size();
      cable.run_for(1ms);
      if (!listening) continue;
      for (std::size_t i = heard; i < cable.heard.size() && listening; ++i) listen(i);
      if (detection.deadline() <= cable.now) detection.advance(cable.now);
    }
  }

  Bench bench;
  Cable cable;
  ChargerDevice<> charger{cable.port(0), 5, bench.charger_hardware()};
  cia418::BatteryDevice<> battery{cable.port(1), 10, bench.battery_hardware()};
  BitRateDetection detection{BitRateDetection::Restart::to<&Vehicle::restart>(*this)};
  std::uint32_t bit_rate = 0;
  bool listening = false;

 private:
  void listen(std::size_t position) {
    if (bit_rate == 250'000) {
      detection.receive(cable.heard[position].frame, cable.now);
    } else {
      detection.bus_error(cable.now);
    }
  }
  bool restart(std::uint32_t wanted, bool listen_only) {
    bit_rate = wanted;
    listening = listen_only;
    return true;
  }
  void found(std::uint32_t) {
    cable.connect(0, charger.node());
    charger.node().start(cable.now);
  }
};

TEST(ChargerBitRate, IsFoundBeforeTheChargerSendsAFrame) {
  Vehicle vehicle;
  vehicle.run_for(500ms);
  EXPECT_EQ(vehicle.cable.count(0x705), 0u);
  vehicle.run_for(10s);
  EXPECT_EQ(vehicle.detection.bit_rate(), 250'000u);
  EXPECT_FALSE(vehicle.listening);
  EXPECT_GE(vehicle.cable.count(0x705), 1u) << "its boot-up message, and heartbeats";
  EXPECT_EQ(vehicle.bench.delivered, 40) << "and charges";
}

}  // namespace
}  // namespace canvoy::cia419::charger_bit_rate_test
