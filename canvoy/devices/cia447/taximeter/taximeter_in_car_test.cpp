// A taximeter in a car: the IVN gateway's own wheel pulses, a real time clock that is read, a loss
// of power on the way (CiA 447-3, 4.2.4, 4.2.12 and 4.2.14).
#include <gtest/gtest.h>

#include "canvoy/canopen/testing/cable.hpp"
#include "canvoy/devices/cia447/ivn_gateway/ivn_gateway_unit.hpp"
#include "canvoy/devices/cia447/kit/car_bench_test.hpp"
#include "canvoy/devices/cia447/real_time_clock/real_time_clock_unit.hpp"
#include "canvoy/devices/cia447/taximeter/taximeter_unit.hpp"

namespace canvoy::cia447::taximeter_in_car_test {
namespace {

/// 24 pulses per metre, in a counter that overruns after 5000 of them.
constexpr CarSettings car_settings = {
    .pulses_per_rotation = 48, .wheel_circumference_m = 2.0, .pulse_counter_max = 4999};
constexpr TaximeterSettings meter_settings = {.k = 24'000, .clock_node = 7};
constexpr TimeZone berlin = {.name = "CET", .offset_minutes = 60, .summer = european_summer};

class TaxiOnCable : public testing::Test {
 protected:
  TaxiOnCable() {
    environment.provide(callback<&TaxiOnCable::car_hardware>(*this));
    environment.provide(Callback<CarSettings()>([](void*) { return car_settings; }, nullptr));
    environment.provide(
        Callback<TaximeterSettings()>([](void*) { return meter_settings; }, nullptr));
    environment.provide(Callback<RealTimeClockSettings()>(
        [](void*) { return RealTimeClockSettings{.zone = berlin}; }, nullptr));
    environment.provide(callback<&TaxiOnCable::clock_hardware>(*this));
    environment.watch(meter);
    gateway.emplace(only_unit<IvnGatewayKind>, cable.port(0), 1, environment);
    clock.emplace(only_unit<RealTimeClockKind>, cable.port(1), 7, environment);
    meter_device.emplace(only_unit<TaximeterKind>, cable.port(2), 5, environment);
    cable.connect(0, gateway->node());
    cable.connect(1, clock->node());
    cable.connect(2, meter_device->node());
    cable.start_all();
    cable.send("000#01 00");
    cable.run_for(2s);
    EXPECT_TRUE(meter->sign_on());
  }
  std::uint32_t told(std::uint16_t index, std::uint8_t sub = 0) {
    return static_cast<std::uint32_t>(meter_device->node().dictionary().number(index, sub));
  }
  void drive(Duration time, double metres_a_second) {
    speed = metres_a_second;
    const Duration step = 10ms;
    for (Duration driven{}; driven < time; driven += step) {
      metres += metres_a_second * 0.01;
      cable.run_for(step);
    }
    speed = 0;
    cable.run_for(200ms);
  }

  double speed = 0;
  double metres = 0;
  Cable cable;
  Environment environment;
  TaximeterUnit* meter = nullptr;
  std::optional<CarDevice> gateway;
  std::optional<CarDevice> clock;
  std::optional<CarDevice> meter_device;

 private:
  CarHardware car_hardware() {
    CarHardware car = parked_car();
    car.speed = Sensor::to<&TaxiOnCable::sensed_speed>(*this);
    car.distance = Sensor::to<&TaxiOnCable::sensed_distance>(*this);
    return car;
  }
  RealTimeClockHardware clock_hardware() { return {.read = callback<&TaxiOnCable::chip>(*this)}; }
  std::optional<double> sensed_speed() { return speed; }
  std::optional<double> sensed_distance() { return metres; }
  /// 2026-11-23 21:00:00 in Berlin at the start.
  std::optional<ChipTime> chip() {
    const Duration begin = std::chrono::seconds(
        seconds_since_1970({.year = 2026, .month = 11, .day = 23, .hour = 20}));
    return ChipTime{.since_1970 = begin + cable.now.time_since_epoch()};
  }
};

TEST_F(TaxiOnCable, MeasuresWhatTheCarDrives) {
  EXPECT_TRUE(meter->hire());
  drive(100s, 10);  // 1 km: 2,30
  EXPECT_TRUE(meter->stop());
  EXPECT_NEAR(told(0x60D1), 1000, 4) << "4 m are allowed";
  // The time after it is 0,2 s, 0,0018.
  EXPECT_GE(told(0x60D0, 1), 3900u + 2200u);
  EXPECT_LE(told(0x60D0, 1), 3900u + 2300u);
  EXPECT_EQ(cable.count(0x085), 0u) << "no error";
}

TEST_F(TaxiOnCable, KnowsTheTimeOfItsClock) {
  meter->hire();
  const std::int64_t utc =
      seconds_since_1970({.year = 2026, .month = 11, .day = 23, .hour = 20, .second = 2});
  EXPECT_NEAR(told(0x60D2, 3), static_cast<double>(utc), 1);
  EXPECT_EQ(told(0x60D3), 0x31u);
  cable.run_for(1h);
  EXPECT_EQ(told(0x60D3), 0x32u) << "ten at night";
}

TEST_F(TaxiOnCable, FramesThatAreLostLoseNoDistance) {
  unsigned wheel_frames = 0;
  cable.filter = [&wheel_frames](const Frame& frame) {
    return frame.id != 0x187 || ++wheel_frames % 3 == 0;
  };
  meter->hire();
  drive(100s, 10);
  cable.filter = [](const Frame&) { return true; };
  cable.run_for(200ms);
  meter->stop();
  EXPECT_NEAR(told(0x60D1), 1000, 4);
}

TEST_F(TaxiOnCable, AGatewayThatBootsAnewLosesLittle) {
  meter->hire();
  drive(50s, 10);
  cable.send("000#81 01");
  cable.send("000#01 01");
  drive(50s, 10);
  meter->stop();
  EXPECT_NEAR(told(0x60D1), 1000, 16) << "what 4.2.4.6 allows";
  EXPECT_LE(told(0x60D1), 1000u) << "nothing is made up";
  EXPECT_EQ(cable.count(0x085), 0u) << "it is the same source";
}

/// A meter and a clock that are one device: the meter consumes what the other one provides.
TEST(TaximeterWithAClockInside, GoesByIt) {
  static constexpr const CarUnit* units[] = {&car_unit<TaximeterKind>,
                                             &car_unit<RealTimeClockKind>};
  struct Watcher {
    TaximeterUnit* meter = nullptr;
  } watcher;
  CarBench bench(units, [&watcher](Environment& environment) { environment.watch(watcher.meter); });
  // Tuesday 2026-11-24, 21:59:00.
  EXPECT_EQ(bench.ask("23 F1 60 00 EA 07 8B F1"), "60 F1 60 00 00 00 00 00");
  EXPECT_EQ(bench.ask("23 F3 60 00 15 3B 00 00"), "60 F3 60 00 00 00 00 00");
  bench.cable.run_for(1s);
  watcher.meter->sign_on();
  watcher.meter->hire();
  EXPECT_EQ(bench.ask("40 D3 60 00 00 00 00 00"), "4B D3 60 00 31 00 00 00");
  bench.cable.run_for(57s);
  EXPECT_EQ(bench.ask("40 D3 60 00 00 00 00 00"), "4B D3 60 00 31 00 00 00");
  bench.cable.run_for(4s);
  EXPECT_EQ(bench.ask("40 D3 60 00 00 00 00 00"), "4B D3 60 00 32 00 00 00");
}

}  // namespace
}  // namespace canvoy::cia447::taximeter_in_car_test
