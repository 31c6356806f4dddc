// A sensor unit at its wire: levels and values in, records of six bytes out.
#include "canvoy/devices/cia417/sensor/sensor_unit.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "canvoy/canopen/testing/cable.hpp"
#include "canvoy/devices/cia417/sensor/sensor_place.hpp"
#include "canvoy/devices/cia417/sensor/sensor_unit_device.hpp"

namespace canvoy::cia417::sensor_unit_test {
namespace {

constexpr VirtualSensor bench_sensors[] = {
    {.function = SensorFunction::smoke, .lifts = lift_bit(1), .floor = 3, .position = 0x80},
    {.function = SensorFunction::glass, .lifts = lift_bit(1), .floor = floor_of_car},
    {.function = SensorFunction::temperature, .lifts = lift_bit(1), .floor = 0xFE},
    {.function = SensorFunction::damage, .lifts = lift_bit(1), .floor = 1}};

class Sensors : public testing::Test {
 protected:
  Sensors() {
    cable.connect(0, device.node());
    cable.start_all();
    cable.send("61E#23 81 19 01 9E 03 00 00");
    cable.send("000#01 1E");
    cable.run_for(10ms);
    cable.clear();
  }
  void level(std::uint32_t sensor, bool high) {
    device.unit().set_level(sensor, high, cable.now);
    cable.run_for(0s);
  }
  void value(std::int16_t celsius) {
    device.unit().set_value(2, celsius, cable.now);
    cable.run_for(0s);
  }
  void report(std::uint32_t sensor, SensorSignal condition, std::uint8_t error_code = 0xFF) {
    device.unit().report(sensor, condition, cable.now, error_code);
    cable.run_for(0s);
  }
  std::string ask(std::string_view request) {
    cable.send(request);
    return cable.last(0x59E);
  }
  std::vector<std::string> told() {
    std::vector<std::string> records;
    for (const Cable::Heard& heard : cable.heard) {
      if (heard.frame.id == 0x39E) records.push_back(wire_text(heard.frame).substr(4));
    }
    cable.clear();
    return records;
  }
  using Records = std::vector<std::string>;
  /// Sets the inhibit time of the PDO, which accepts it only while it is invalid. The PDO has just
  /// been sent.
  void inhibit_100_ms() {
    ask("61E#23 81 19 01 9E 03 00 80");
    EXPECT_EQ(ask("61E#2B 81 19 03 E8 03 00 00"), "59E#60 81 19 03 00 00 00 00");
    ask("61E#23 81 19 01 9E 03 00 00");
    cable.clear();
  }

  Cable cable;
  SensorUnitDevice<4> device{cable.port(0), 30, {.sensors = bench_sensors}};
};

TEST_F(Sensors, TellsASignalThatComesAndGoes) {
  level(0, true);
  EXPECT_EQ(told(), (Records{"03 01 03 80 FD FF"})) << "reserved bits are 1";
  level(0, false);
  EXPECT_EQ(told(), (Records{"03 01 03 80 FC FF"}));
  level(0, false);
  EXPECT_EQ(told(), Records{});
}

TEST_F(Sensors, TheRecordStandsInItsGroup) {
  level(3, true);
  EXPECT_EQ(device.node().dictionary().number(0x6500, 4), 0xFFFD'80'01'01'04U);
  EXPECT_EQ(device.unit().sensor(3).signal(), SensorSignal::set);
  EXPECT_EQ(device.node().dictionary().number(0x6012, 0), 0xFFFD'80'01'01'04U);
}

TEST_F(Sensors, AValueIsSignedAndLeftAdjustedIn14Bits) {
  value(21);
  EXPECT_EQ(told(), (Records{"06 01 FE 80 54 00"}));
  value(-40);
  EXPECT_EQ(told(), (Records{"06 01 FE 80 60 FF"}));
  value(8191);
  EXPECT_EQ(told(), (Records{"06 01 FE 80 FC 7F"}));
  value(32767);
  EXPECT_EQ(told(), Records{}) << "no more can be told";
  value(-8192);
  EXPECT_EQ(told(), (Records{"06 01 FE 80 00 80"}));
  level(2, true);
  EXPECT_EQ(told(), (Records{"06 01 FE 80 01 80"})) << "its signal, beside the value";
  EXPECT_EQ(device.unit().sensor(2).value(), -8192);
}

TEST_F(Sensors, ADefectIsAnEmergencyAndAgainAfterAReset) {
  report(1, SensorSignal::defective);
  EXPECT_EQ(cable.last(0x09E), "09E#04 FF 21 02 00 00 00 00");
  report(1, SensorSignal::defective, 0x17);
  report(0, SensorSignal::not_installed);
  EXPECT_EQ(std::ranges::count(cable.heard, 0x09EU, [](auto& heard) { return heard.frame.id; }), 1);
  cable.clear();
  cable.send("000#81 1E");
  cable.run_for(0s);
  EXPECT_EQ(cable.last(0x09E), "09E#04 FF 21 02 00 00 00 00");
  report(1, SensorSignal::not_set);
  EXPECT_EQ(cable.last(0x09E), "09E#00 00 00 00 00 00 00 00");
}

TEST_F(Sensors, DefectsAndAbsenceAreSignals) {
  report(1, SensorSignal::defective, 0x17);
  EXPECT_EQ(told(), (Records{"02 01 00 80 FE FF"}));
  EXPECT_EQ(ask("61E#40 20 65 02 00 00 00 00"), "59E#43 20 65 02 FF 17 FF FF");
  report(1, SensorSignal::not_installed);
  EXPECT_EQ(told(), (Records{"02 01 00 80 FF FF"}));
  level(1, true);
  EXPECT_EQ(told(), Records{}) << "what it says does not count";
  report(1, SensorSignal::not_set);
  EXPECT_EQ(told(), (Records{"02 01 00 80 FD FF"}));
}

TEST_F(Sensors, ManyThatChangeAtOnceAreToldOneAfterTheOther) {
  inhibit_100_ms();
  level(3, true);
  level(0, true);
  value(5);
  level(1, true);
  cable.run_for(1s);
  EXPECT_EQ(told(), (Records{"04 01 01 80 FD FF", "03 01 03 80 FD FF", "06 01 FE 80 14 00",
                             "02 01 00 80 FD FF"}));
}

TEST_F(Sensors, ASignalThatHasGoneBeforeItWasToldIsToldAllTheSame) {
  inhibit_100_ms();
  level(0, true);
  level(1, true);
  level(1, false);
  level(1, true);
  level(1, false);
  cable.run_for(1s);
  EXPECT_EQ(told(), (Records{"03 01 03 80 FD FF", "02 01 00 80 FD FF", "02 01 00 80 FC FF"}));
  EXPECT_EQ(device.unit().waiting(), 0u);
}

TEST_F(Sensors, WhatIsThereIsToldWhenTheNodeBecomesOperational) {
  cable.send("000#80 1E");
  level(0, true);
  level(1, true);
  level(1, false);
  EXPECT_EQ(told(), Records{});
  cable.send("000#01 1E");
  cable.run_for(10ms);
  EXPECT_EQ(told(), (Records{"03 01 03 80 FD FF", "06 01 FE 80 00 00"}));
}

TEST_F(Sensors, ADisabledSensorHasNoSignal) {
  level(0, true);
  told();
  ask("61E#23 20 65 01 FE FF FF FF");
  EXPECT_EQ(told(), (Records{"03 01 03 80 FC FF"}));
  level(0, false);
  level(0, true);
  EXPECT_EQ(told(), Records{});
  ask("61E#23 20 65 01 FF FF FF FF");
  EXPECT_EQ(told(), (Records{"03 01 03 80 FD FF"}));
}

TEST_F(Sensors, ALevelCountsAfterItsDebounceTime) {
  ask("61E#23 60 65 01 32 FF FF FF");
  told();
  level(0, true);
  cable.run_for(49ms);
  level(0, false);
  cable.run_for(1s);
  EXPECT_EQ(told(), Records{}) << "a bounce";
  level(0, true);
  cable.run_for(49ms);
  EXPECT_EQ(told(), Records{});
  cable.run_for(1ms);
  EXPECT_EQ(told(), (Records{"03 01 03 80 FD FF"}));
}

TEST_F(Sensors, EdgesAndPolarityOfEveryKind) {
  for (const unsigned edges : {0x7CU, 0x7DU, 0x7EU, 0x7FU, 0xFCU, 0xFDU, 0xFEU, 0xFFU}) {
    SCOPED_TRACE(edges);
    level(0, false);
    char text[40];
    std::snprintf(text, sizeof text, "61E#23 60 65 01 00 %02X FF FF", edges);
    ask(text);
    // FFh is not used: both edges, not inverted.
    const bool is_inverted = edges != 0xFF && (edges & 0x80) != 0;
    told();
    level(0, true);
    const unsigned up = is_inverted ? 2 : 1;
    EXPECT_EQ(told().size(), (edges & up) != 0 ? 1u : 0u);
    EXPECT_EQ(device.unit().sensor(0).signal() == SensorSignal::set, !is_inverted)
        << "it is stored";
    level(0, false);
    EXPECT_EQ(told().size(), (edges & (3 - up)) != 0 ? 1u : 0u);
  }
}

TEST_F(Sensors, MoreEventsThanTheLimitationWaitForTheEndOfTheSecond) {
  ask("61E#23 40 65 03 FF 02 FF FF");
  told();
  for (std::int16_t celsius = 1; celsius <= 9; ++celsius) value(celsius);
  EXPECT_EQ(told(), (Records{"06 01 FE 80 04 00", "06 01 FE 80 08 00"}));
  cable.run_for(999ms);
  EXPECT_EQ(told(), Records{});
  cable.run_for(1ms);
  EXPECT_EQ(told(), (Records{"06 01 FE 80 24 00"}));
}

TEST_F(Sensors, SoManyEventsStartAMessage) {
  ask("61E#23 40 65 03 FF FF 03 FF");
  told();
  for (std::int16_t celsius = 1; celsius <= 7; ++celsius) value(celsius);
  EXPECT_EQ(told(), (Records{"06 01 FE 80 0C 00", "06 01 FE 80 18 00"}));
  cable.run_for(2s);
  value(8);
  EXPECT_EQ(told(), Records{}) << "in another second";
}

TEST_F(Sensors, LimitationsOfZeroAreReserved) {
  EXPECT_EQ(ask("61E#23 40 65 01 FF 00 FF FF"), "59E#80 40 65 01 30 00 09 06");
  EXPECT_EQ(ask("61E#23 40 65 01 FF FF 00 FF"), "59E#80 40 65 01 30 00 09 06");
  EXPECT_EQ(ask("61E#23 40 65 01 FF 01 01 FF"), "59E#60 40 65 01 00 00 00 00");
}

/// 4.13.1: basic function 00h and source positions 00h to 7Fh are reserved.
TEST_F(Sensors, NoneTellsWhatIsReserved) {
  Cable other;
  SensorUnitDevice<2> bare(other.port(0), 31, {});
  other.connect(0, bare.node());
  other.start_all();
  for (std::uint8_t sub = 1; sub <= 2; ++sub) {
    EXPECT_EQ(bare.node().dictionary().number(0x6500, sub), 0xFFFC'80'00'00'01U)
        << "a generic sensor, which has no data";
  }
  for (const VirtualSensor& each : sensors_at(1, 3)) EXPECT_GE(each.position, 0x80);
}

TEST_F(Sensors, ASensorThatIsNotThereIsIgnored) {
  level(4, true);
  device.unit().set_value(0xFFFF'FFFF, 3, cable.now);
  report(99, SensorSignal::defective);
  EXPECT_EQ(told(), Records{});
}

TEST_F(Sensors, GroupsStandWhereTheirLiftHasThem) {
  static constexpr LiftDeviceOptions lift_3 = {.lift = 3};
  Cable other;
  SensorUnitDevice<2, lift_3> third(other.port(0), 30, {.sensors = bench_sensors});
  other.connect(0, third.node());
  other.start_all();
  other.send("61E#23 81 19 01 9E 03 00 00");
  other.send("000#01 1E");
  third.unit().set_level(1, true, other.now);
  other.run_for(0s);
  EXPECT_EQ(other.last(0x39E), "39E#02 01 00 80 FD FF");
  EXPECT_EQ(third.node().dictionary().number(0x7500, 2), 0xFFFD'80'00'01'02U);
  other.send("61E#23 40 75 01 FF 00 FF FF");
  EXPECT_EQ(other.last(0x59E), "59E#80 40 75 01 30 00 09 06");
}

}  // namespace
}  // namespace canvoy::cia417::sensor_unit_test
