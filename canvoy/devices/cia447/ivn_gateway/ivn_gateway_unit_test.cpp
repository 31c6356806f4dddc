// Measured values of the gateway, at the wire (CiA 447-3, 4.2.2 to 4.2.4). PDO 17 (387h of node 5)
// is engine revolutions, wheel rpm, wheel pulse counter.
#include "canvoy/devices/cia447/ivn_gateway/ivn_gateway_unit.hpp"

#include <gtest/gtest.h>

#include "canvoy/devices/cia447/ivn_gateway/car_on_bench_test.hpp"

namespace canvoy::cia447::ivn_gateway_unit_test {
namespace {

constexpr std::uint32_t ignition_pdo = 0x380;  ///< PDO 1
constexpr std::uint32_t wheel_pdo = 0x387;     ///< PDO 17, the eighth of the list
constexpr std::uint32_t engine_pdo = 0x388;

struct IvnGateway : testing::Test, CarOnBench {
  Cable& cable = bench.cable;
};

TEST_F(IvnGateway, AtFirstNothingIsKnownOfTheWheels) {
  // 3FFFh "signal not available", terminal 61 off; FFFFh; no pulses, pcvalid 3, reserved bits 1.
  EXPECT_EQ(cable.last(wheel_pdo), "387#FF 3F FF FF 00 00 FF");
  EXPECT_EQ(ask("40 56 60 00 00 00 00 00"), "47 56 60 00 FF FF FF 00") << "valid: 3 (4.2.4.7)";
}

TEST_F(IvnGateway, WheelsAreToldEach100MsFromWhatTheCarSenses) {
  car.rpm = 800;
  car.speed = 10;  // of 2 m a rotation: 300/min, in halves
  cable.run_for(98ms);
  EXPECT_EQ(cable.last(wheel_pdo), "387#FF 3F FF FF 00 00 FF");
  cable.run_for(1ms);
  // 0320h with terminal 61 (500/min and more) in bit 14; 0258h; pcvalid 1.
  EXPECT_EQ(cable.last(wheel_pdo), "387#20 43 58 02 00 00 FD");
  car.distance = 1;
  cable.run_for(99ms);
  EXPECT_EQ(cable.last(wheel_pdo), "387#20 43 58 02 00 00 FD");
  cable.run_for(1ms);
  EXPECT_EQ(cable.last(wheel_pdo), "387#20 43 58 02 18 00 FD") << "48 pulses in 2 m";
  EXPECT_EQ(ask("40 56 60 00 00 00 00 00"), "47 56 60 00 FF FF FD 00");
  EXPECT_EQ(ask("40 57 60 00 00 00 00 00"), "4F 57 60 00 30 00 00 00");
  EXPECT_EQ(ask("40 54 60 00 00 00 00 00"), "4F 54 60 00 05 00 00 00") << "average rear wheels";
}

TEST_F(IvnGateway, OneFrameEach100MsWhetherTheCarStandsOrDrives) {
  for (const double speed : {0.0, 25.0}) {
    car.speed = speed;
    cable.run_for(100ms);
    cable.clear();
    const Time begin = cable.now;
    for (int i = 0; i < 10; ++i) {
      *car.distance += speed / 10;
      cable.run_for(100ms);
    }
    std::vector<Time> at;
    for (const Cable::Heard& heard : cable.heard) {
      if (heard.frame.id == wheel_pdo) at.push_back(heard.at);
    }
    ASSERT_EQ(at.size(), 10u) << speed;
    for (std::size_t i = 0; i < at.size(); ++i) {
      EXPECT_EQ(at[i] - begin, (i + 1) * 100ms - 1ms) << speed;
    }
  }
}

TEST_F(IvnGateway, ASensorThatFailsIsTold) {
  cable.run_for(100ms);
  car.speed = car.distance = car.rpm = std::nullopt;
  cable.run_for(100ms);
  // 3FFEh with terminal 61 as it was; FFFEh; pcvalid 2 beside the count.
  EXPECT_EQ(cable.last(wheel_pdo), "387#FE 3F FE FF 00 00 FE");
  EXPECT_EQ(ask("40 5A 60 00 00 00 00 00"), "4B 5A 60 00 FE FF 00 00");
  EXPECT_EQ(ask("40 5B 60 00 00 00 00 00"), "47 5B 60 00 FE FF FF 00") << "errata A13";
  car.distance = 2;
  cable.run_for(100ms);
  EXPECT_EQ(cable.last(wheel_pdo).substr(4 + 12), "30 00 FD") << "what was driven meanwhile counts";
}

TEST_F(IvnGateway, WhatTheCarHasNoSensorForIsNotAvailable) {
  cable.run_for(100ms);
  EXPECT_EQ(ask("40 21 60 00 00 00 00 00"), "4F 21 60 00 FF 00 00 00") << "inside temperature";
  EXPECT_EQ(ask("40 49 60 00 00 00 00 00"), "4F 49 60 00 FF 00 00 00") << "mirror";
  EXPECT_EQ(ask("40 31 60 00 00 00 00 00"), "4F 31 60 00 FF 00 00 00") << "light";
  // FFFFh; fco 3; fsu 0, litres; reserved bits 1.
  EXPECT_EQ(ask("40 5D 60 00 00 00 00 00"), "43 5D 60 00 FF FF F3 FF");
}

TEST_F(IvnGateway, AnNmtResetTakesTheCountAsItIsButSaysThatItIsNotAvailable) {
  cable.run_for(100ms);
  car.distance = 10;
  cable.run_for(100ms);
  EXPECT_EQ(cable.last(wheel_pdo), "387#00 00 00 00 F0 00 FD");
  cable.clear();
  cable.send("000#82 05");
  cable.send("000#01 05");
  EXPECT_EQ(cable.last(wheel_pdo), "387#FF 3F FF FF F0 00 FF") << "4.2.4.6";
  car.distance = 11;
  cable.run_for(100ms);
  EXPECT_EQ(cable.last(wheel_pdo), "387#00 00 00 00 08 01 FD");
}

TEST_F(IvnGateway, SpeedIsThatOfTheWheelsBackwardsToo) {
  car.speed = -13.9;  // 50.04 km/h
  cable.run_for(100ms);
  EXPECT_EQ(ask("40 5A 60 00 00 00 00 00"), "4B 5A 60 00 F4 01 00 00");
  EXPECT_EQ(ask("40 53 60 00 00 00 00 00"), "4B 53 60 00 42 03 00 00") << "417/min in halves";
}

TEST_F(IvnGateway, TemperaturesBeginAtMinus50) {
  car.outside = -7.5;
  cable.run_for(100ms);
  EXPECT_EQ(ask("40 20 60 00 00 00 00 00"), "4F 20 60 00 55 00 00 00") << "(55h - 100) / 2";
}

TEST_F(IvnGateway, TheSteeringWheelHasASignOfItsOwn) {
  car.steering = 90;
  cable.run_for(100ms);
  EXPECT_EQ(ask("40 1C 60 00 00 00 00 00"), "4B 1C 60 00 84 03 00 00") << "900 tenths to the left";
  car.steering = -90;
  cable.run_for(100ms);
  EXPECT_EQ(ask("40 1C 60 00 00 00 00 00"), "4B 1C 60 00 84 43 00 00");
  car.steering = std::nullopt;
  cable.run_for(100ms);
  EXPECT_EQ(ask("40 1C 60 00 00 00 00 00"), "4B 1C 60 00 FE BF 00 00") << "errata A1";
}

TEST_F(IvnGateway, TheTankWarnsAtItsMinimum) {
  car.fuel = 7.2;
  cable.run_for(100ms);
  EXPECT_EQ(ask("40 5C 60 00 00 00 00 00"), "4B 5C 60 00 07 FC 00 00");
  car.fuel = 6.9;
  cable.run_for(100ms);
  EXPECT_EQ(ask("40 5C 60 00 00 00 00 00"), "4B 5C 60 00 07 FD 00 00");
}

TEST_F(IvnGateway, TheVinIsSeventeenZerosWhileItIsNotKnown) {
  cable.run_for(100ms);
  EXPECT_EQ(ask("40 2B 60 00 00 00 00 00"), "41 2B 60 00 11 00 00 00");
  EXPECT_EQ(ask("60 00 00 00 00 00 00 00"), "00 00 00 00 00 00 00 00");
  bench.ask("80 2B 60 00 00 00 00 00");
  car.vin = "WDB12345678901234";
  cable.run_for(100ms);
  EXPECT_EQ(ask("40 2B 60 00 00 00 00 00"), "41 2B 60 00 11 00 00 00");
  EXPECT_EQ(ask("60 00 00 00 00 00 00 00"), "00 57 44 42 31 32 33 34");
  EXPECT_EQ(ask("70 00 00 00 00 00 00 00"), "10 35 36 37 38 39 30 31");
  EXPECT_EQ(ask("60 00 00 00 00 00 00 00"), "09 32 33 34 00 00 00 00");
}

/// ISO 3779: 17 digits and capitals, without I, O and Q.
TEST(ParkedCar, HasAVinThatThereCanBe) {
  const CarHardware car = parked_car();
  const std::string_view vin = car.vin();
  EXPECT_EQ(vin.size(), 17u);
  EXPECT_EQ(vin.find_first_not_of("0123456789ABCDEFGHJKLMNPRSTUVWXYZ"), std::string_view::npos);
}

TEST_F(IvnGateway, StatesAreReported) {
  gateway().report(ignition_switch_status_lock, Signal::yes);
  gateway().report(ignition_switch_status_on, Signal::yes);
  gateway().report(engine_status, Engine::running);
  car.gear = Gear::third;
  cable.run_for(100ms);
  EXPECT_EQ(cable.last(ignition_pdo), "380#11");
  EXPECT_EQ(cable.last(engine_pdo), "388#03");
  // Lever P (8), mode comfort (2), parking brake 1, coupling 0, gear 3, reserved bit 1.
  EXPECT_EQ(ask("40 52 60 00 00 00 00 00"), "4B 52 60 00 A8 98 00 00");
}

TEST_F(IvnGateway, ABrokenSwitchSaysSoUntilItIsMended) {
  gateway().sense(ignition_switch_status_on, Sensing::failure);
  cable.run_for(0s);
  EXPECT_EQ(cable.last(ignition_pdo), "380#20");
  gateway().report(ignition_switch_status_on, Signal::yes);
  gateway().sense(ignition_switch_status_on, Sensing::not_available);
  cable.run_for(0s);
  EXPECT_EQ(cable.last(ignition_pdo), "380#30");
  gateway().sense(ignition_switch_status_on, Sensing::working);
  cable.run_for(0s);
  EXPECT_EQ(cable.last(ignition_pdo), "380#10");
}

TEST(IvnGatewaySettings, MilesAndACounterThatOverrunsEarly) {
  CarOnBench sut({.pulses_per_rotation = 25,
                  .wheel_circumference_m = 2.5,
                  .pulse_counter_max = 999,
                  .local_distance_m = 1609.344,
                  .mileage_at_start_m = 1'609'344});
  sut.bench.cable.run_for(100ms);
  sut.car.distance = 320;   // 0.19 miles
  sut.car.speed = 13.4112;  // 30 miles an hour
  sut.bench.cable.run_for(100ms);
  // 321.9/min in halves; 3200 pulses are three times 1000, and 200.
  EXPECT_EQ(sut.bench.cable.last(wheel_pdo), "387#00 00 84 02 C8 00 FD");
  EXPECT_EQ(sut.ask("40 56 60 00 00 00 00 00"), "47 56 60 00 E7 03 FD 00");
  EXPECT_EQ(sut.ask("40 5A 60 00 00 00 00 00"), "4B 5A 60 00 2C 01 00 00");
  EXPECT_EQ(sut.ask("40 5B 60 00 00 00 00 00"), "47 5B 60 00 11 27 00 00") << "1000.1 miles";
}

}  // namespace
}  // namespace canvoy::cia447::ivn_gateway_unit_test
