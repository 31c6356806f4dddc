// States that the car reports without commands, at the wire (CiA 447-3, 4.2.2): each source may
// fail or be absent. Of node 5 PDO 3 is 382h, PDO 4 is 383h, PDO 5 is 384h, PDO 7 is 386h; reserved
// bits are 1. Also the light in the car (4.2.3.3, 4.2.3.4), which no PDO carries.
#include <gtest/gtest.h>

#include "canvoy/devices/cia447/ivn_gateway/car_on_bench_test.hpp"

namespace canvoy::cia447::car_states_test {
namespace {

struct CarStates : testing::Test, CarOnBench {
  std::string told(std::uint32_t pdo) {
    bench.cable.run_for(0s);
    const std::string frame = bench.cable.last(pdo);
    return frame.substr(frame.find('#') + 1);
  }
};

TEST_F(CarStates, WhoSitsWhereAndHasABelt) {
  gateway().report(occupant_classification_status_driver, Signal::yes);
  gateway().report(occupant_classification_status_rear_middle_passenger, Signal::yes);
  gateway().report(buckle_switch_status_driver, Signal::yes);
  gateway().report(buckle_switch_status_3rd_row_middle, Signal::yes);
  // 6027h: docs 1..0, rmpocs 9..8; 6028h: bsd 1..0, 3rm 15..14; 6009h.
  EXPECT_EQ(told(0x383), "01 01 01 40 F2");
  gateway().sense(occupant_classification_status_front_passenger, Sensing::failure);
  gateway().sense(buckle_switch_status_rear_left, Sensing::not_available);
  EXPECT_EQ(told(0x383), "09 01 C1 40 F2") << "fpocs 3..2, bsrl 7..6";
  gateway().report(buckle_switch_status_rear_left, Signal::yes);
  gateway().sense(buckle_switch_status_rear_left, Sensing::working);
  EXPECT_EQ(told(0x383), "09 01 41 40 F2") << "it was fastened meanwhile";
}

TEST_F(CarStates, TheLeverOfTheTurnIndicatorAndTheDaylight) {
  gateway().report(turn_indicator_reset_status_left, Signal::yes);
  gateway().report(day_night_detection, DayNight::night);
  // Windows, doors; 601Dh: left 3..2; 6030h.
  EXPECT_EQ(told(0x384), "49 92 FC 49 F2 F4 FD");
  gateway().sense(turn_indicator_reset_status_right, Sensing::failure);
  gateway().sense(day_night_detection, Sensing::not_available);
  EXPECT_EQ(told(0x384), "49 92 FC 49 F2 F6 FF");
}

TEST_F(CarStates, AnAccident) {
  gateway().report(accident_detection_airbag_released, Signal::yes);
  gateway().report(accident_detection_motor_stop, Signal::yes);
  gateway().report(accident_detection, Signal::yes);
  // airrel 1..0, pate 3..2, ams 5..4, accident 7..6.
  EXPECT_EQ(told(0x386), "51 FF");
  gateway().sense(accident_detection_presafe_acceleration_threshold_exceeded, Sensing::failure);
  gateway().sense(accident_detection_airbag_released, Sensing::not_available);
  EXPECT_EQ(told(0x386), "5B FF");
}

TEST_F(CarStates, ATesterThatIsThere) {
  gateway().report(tester_present_uds_diagnose_session, Signal::yes);
  EXPECT_EQ(told(0x382), "FD");
  gateway().sense(tester_present_uds_diagnose_session, Sensing::failure);
  EXPECT_EQ(told(0x382), "FE");
}

TEST_F(CarStates, TheLightInTheCarShinesAfter50Ms) {
  EXPECT_EQ(ask("40 45 60 00 00 00 00 00"), "4B 45 60 00 00 E0 00 00") << "all off";
  // ii (2..0) undimmed, bli (12..11) on, all others between them unchanged.
  EXPECT_EQ(ask("2B 46 60 00 FA EF 00 00"), "60 46 60 00 00 00 00 00");
  bench.cable.run_for(49ms);
  EXPECT_EQ(ask("40 45 60 00 00 00 00 00"), "4B 45 60 00 00 E0 00 00");
  bench.cable.run_for(1ms);
  EXPECT_EQ(ask("40 45 60 00 00 00 00 00"), "4B 45 60 00 02 E8 00 00");
  ask("2B 46 60 00 E9 FF 00 00");  // dimmed; lrid (4..3) on
  bench.cable.run_for(50ms);
  EXPECT_EQ(ask("40 45 60 00 00 00 00 00"), "4B 45 60 00 09 E8 00 00");
  gateway().sense(car_interior_light_status_illumination, Sensing::failure);
  EXPECT_EQ(ask("40 45 60 00 00 00 00 00"), "4B 45 60 00 0E E8 00 00");
}

std::optional<double> sensed(void* value) {
  return *static_cast<std::optional<double>*>(value);
}

TEST(CarSensors, TellWhatTheySenseWhereTheFigureHasRoom) {
  std::optional<double> inside = 21.5;
  std::optional<double> light = 80;
  std::optional<double> mirror = 40;
  std::optional<double> used = 8.5;
  CarHardware car = parked_car();
  car.inside_temperature = {sensed, &inside};
  car.light_intensity = {sensed, &light};
  car.mirror_dimming = {sensed, &mirror};
  car.fuel_consumption = {sensed, &used};
  struct Offered {
    CarHardware car;
    CarHardware hardware() { return car; }
  } offered{car};
  CarBench bench(only_unit<IvnGatewayKind>, [&](Environment& environment) {
    environment.manages_network = false;
    environment.provide(callback<&Offered::hardware>(offered));
  });
  bench.cable.run_for(100ms);
  EXPECT_EQ(bench.ask("40 21 60 00 00 00 00 00"), "4F 21 60 00 8F 00 00 00") << "(8Fh - 100) / 2";
  EXPECT_EQ(bench.ask("40 31 60 00 00 00 00 00"), "4F 31 60 00 50 00 00 00");
  EXPECT_EQ(bench.ask("40 49 60 00 00 00 00 00"), "4F 49 60 00 28 00 00 00");
  // Thousandths; no overflow, litres; reserved bits 1.
  EXPECT_EQ(bench.ask("40 5D 60 00 00 00 00 00"), "43 5D 60 00 34 21 F0 FF");
  used = 40;  // above 7F00h
  inside = light = mirror = std::nullopt;
  bench.cable.run_for(100ms);
  EXPECT_EQ(bench.ask("40 5D 60 00 00 00 00 00"), "43 5D 60 00 00 7F F1 FF");
  EXPECT_EQ(bench.ask("40 21 60 00 00 00 00 00"), "4F 21 60 00 FE 00 00 00");
  EXPECT_EQ(bench.ask("40 31 60 00 00 00 00 00"), "4F 31 60 00 FE 00 00 00");
  EXPECT_EQ(bench.ask("40 49 60 00 00 00 00 00"), "4F 49 60 00 FE 00 00 00");
  used = std::nullopt;
  bench.cable.run_for(100ms);
  EXPECT_EQ(bench.ask("40 5D 60 00 00 00 00 00"), "43 5D 60 00 FE FF F2 FF");
}

}  // namespace
}  // namespace canvoy::cia447::car_states_test
