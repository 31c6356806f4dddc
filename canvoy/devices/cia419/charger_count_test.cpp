// Counts and estimates of a charger: ampere-hours (7.2.4) and the state of charge (7.2.7).
#include "canvoy/devices/cia419/charger_test.hpp"

namespace canvoy::cia419::charger_count_test {
namespace {

class ChargerCount : public ChargerTest {};

TEST_F(ChargerCount, CountsFromItsStartOn) {
  ChargerHardware hardware = bench.charger_hardware();
  auto one = [] { return 1.0; };
  hardware.current = Callback<double()>::of(one);
  ChargerDevice<> sut(cable.port(0), 5, hardware);
  cable.connect(0, sut.node());
  cable.now = Time(10h);
  cable.start_all();
  cable.run_for(1h);
  EXPECT_NEAR(sut.charger().ampere_hours_total(), 1, 0.001);
}

TEST_F(ChargerCount, AChargeWithALowCurrentIsAChargeToo) {
  bench.readings.requested_current_ampere = 0.5;
  std::vector<Charger::Event> events;
  auto note = [&](Charger::Event event) { events.push_back(event); };
  charger.charger().on_event(Callback<void(Charger::Event)>::of(note));
  cable.start_all();
  cable.run_for(1h);
  EXPECT_EQ(bench.delivered, 0.5);
  EXPECT_EQ(std::ranges::count(events, Charger::Event::charge_began), 1);
  EXPECT_NEAR(static_cast<double>(charger.node().dictionary().number(0x6052, 0)), 4, 1)
      << "0.5 Ah in 0.125 Ah";
}

TEST_F(ChargerCount, WhatABatteryGotThatWasUnpluggedJustBeforeAResetIsNotCountedForTheNextOne) {
  cable.start_all();
  while (bench.delivered == 0) cable.run_for(1ms);
  cable.run_for(30min);
  bench.plugged = false;
  cable.send("000#82 05");
  cable.run_for(1s);
  std::vector<Charger::Event> events;
  auto note = [&](Charger::Event event) { events.push_back(event); };
  charger.charger().on_event(Callback<void(Charger::Event)>::of(note));
  bench.plugged = true;
  cable.run_for(10s);
  EXPECT_GT(bench.delivered, 0);
  EXPECT_EQ(std::ranges::count(events, Charger::Event::charge_began), 1);
  EXPECT_LT(charger.node().dictionary().number(0x6052, 0), 8u) << "less than 1 Ah";
}

TEST_F(ChargerCount, CountsAmpereHoursAndWritesThemBackAtTheEnd) {
  battery.node().start(cable.now);
  battery.node().dictionary().set_number(0x6052, 0, 800);  // 100 Ah of the last charge
  charger.node().start(cable.now);
  while (bench.delivered == 0) cable.run_for(1ms);
  EXPECT_EQ(charger.node().dictionary().number(0x6052, 0), 0u) << "a new charge begins";
  const auto asked = [&] { return cable.last(0x58A); };
  cable.run_for(30min);  // 20 Ah
  EXPECT_NEAR(charger.charger().ampere_hours_total(), 20, 0.01);
  EXPECT_NEAR(charger.charger().energy_total_watt_hours(), 1000, 1) << "at 50 V";
  std::vector<Charger::Event> events;
  auto note = [&](Charger::Event event) { events.push_back(event); };
  charger.charger().on_event(Callback<void(Charger::Event)>::of(note));
  cable.clear();
  // Full, by its state of charge alone: the battery stays ready, and nothing else ends the charge.
  bench.readings.state_of_charge_percent = 100;
  cable.run_for(1s);
  EXPECT_EQ(bench.delivered, 0);
  EXPECT_EQ(std::ranges::count(events, Charger::Event::charge_ended), 1);
  EXPECT_EQ(cable.last(0x60A), "60A#2B 52 60 00 A0 00 00 00") << "160 x 0.125 Ah";
  EXPECT_EQ(asked(), "58A#60 52 60 00 00 00 00 00");
  EXPECT_EQ(battery.node().dictionary().number(0x6052, 0), 160u);
  // A charge after the end is another one, and counts from 0.
  bench.readings.state_of_charge_percent = 80;
  cable.run_for(1s);
  ASSERT_EQ(bench.delivered, 40);
  EXPECT_EQ(charger.node().dictionary().number(0x6052, 0), 0u);
  EXPECT_EQ(std::ranges::count(events, Charger::Event::charge_began), 1);
}

TEST_F(ChargerCount, AChargeThatABatterysRestartInterruptsGoesOnCounting) {
  run_until_charging();
  cable.run_for(30min);
  battery.node().start(cable.now);
  battery.node().dictionary().set_number(0x6052, 0, 800);
  std::vector<std::uint64_t> counted;
  auto note = [&](Charger::Event) {
    counted.push_back(charger.node().dictionary().number(0x6052, 0));
  };
  charger.charger().on_event(Callback<void(Charger::Event)>::of(note));
  cable.run_for(10s);
  ASSERT_EQ(bench.delivered, 40);
  for (const std::uint64_t units : counted)
    EXPECT_NEAR(static_cast<double>(units), 160, 1) << "20 Ah in 0.125 Ah";
}

TEST_F(ChargerCount, ShowsWhatTheBatteryRememberedUntilAChargeBegins) {
  bench.readings.ready = false;
  battery.node().start(cable.now);
  battery.node().dictionary().set_number(0x6052, 0, 800);
  charger.node().start(cable.now);
  cable.run_for(5s);
  EXPECT_EQ(charger.node().dictionary().number(0x6052, 0), 800u);
}

// 7.2.7: 6080h, from the state of charge at the start, the ampere-hours and the capacity
TEST_F(ChargerCount, EstimatesTheStateOfChargeByWhatItDelivered) {
  run_until_charging();
  cable.run_for(390min);  // 260 of 400 Ah
  EXPECT_EQ(charger.node().dictionary().number(0x6080, 0), 95u);
  cable.run_for(2h);
  EXPECT_EQ(charger.node().dictionary().number(0x6080, 0), 100u) << "no more than full";
}

TEST_F(ChargerCount, EstimatesTheStateOfChargeOfTheSmallestBatteryFromEmptyOn) {
  bench.readings.state_of_charge_percent = 0;
  battery.node().start(cable.now);
  battery.node().dictionary().set_number(0x6020, 2, 1);
  charger.node().start(cable.now);
  while (bench.delivered == 0) cable.run_for(1ms);
  cable.run_for(36s);  // 0.4 of 1 Ah
  EXPECT_EQ(charger.node().dictionary().number(0x6080, 0), 40u);
}

TEST_F(ChargerCount, EstimatesNothingWhereTheBatteryDoesNotKnowItsCapacity) {
  battery.node().start(cable.now);
  battery.node().dictionary().set_number(0x6020, 2, 0);
  charger.node().start(cable.now);
  cable.run_for(1min);
  EXPECT_EQ(bench.delivered, 40);
  EXPECT_EQ(charger.node().dictionary().number(0x6080, 0), 0xFFu) << "invalid";
}

class ChargerNextBattery : public ChargerTest {
 protected:
  std::string ask(std::string_view request) {
    cable.send("605#" + std::string(request));
    return cable.last(0x585).substr(4);
  }
  void expect_nothing_known() {
    EXPECT_EQ(ask("40 60 60 00 00 00 00 00"), "43 60 60 00 FF FF FF FF");
    EXPECT_EQ(ask("40 70 60 00 00 00 00 00"), "4B 70 60 00 FF FF 00 00");
    EXPECT_EQ(ask("40 10 60 00 00 00 00 00"), "4B 10 60 00 FF FF 00 00");
    EXPECT_EQ(ask("40 00 60 00 00 00 00 00"), "4F 00 60 00 00 00 00 00") << "not ready";
    EXPECT_EQ(ask("40 80 60 00 00 00 00 00"), "4F 80 60 00 FF 00 00 00") << "7.2.7: invalid";
    EXPECT_EQ(ask("40 81 60 00 00 00 00 00"), "4F 81 60 00 FF 00 00 00");
  }
  /// Its TPDO 3 is not valid: it sends neither a request nor a state of charge.
  void plug_next_without_request() {
    bench.plugged = false;
    cable.run_for(2s);
    battery.node().dictionary().set_number(0x1802, 1, 0x8000'038A);
    bench.plugged = true;
    cable.run_for(10s);
    cable.clear();
  }
};

TEST_F(ChargerNextBattery, WhatABatteryToldIsGoneWithIt) {
  run_until_charging();
  cable.run_for(10min);
  ASSERT_EQ(ask("40 81 60 00 00 00 00 00"), "4F 81 60 00 1E 00 00 00");
  ASSERT_EQ(ask("40 80 60 00 00 00 00 00"), "4F 80 60 00 20 00 00 00") << "30 %, and 6.7 of 400 Ah";
  bench.plugged = false;
  cable.run_for(2s);
  expect_nothing_known();
}

/// Reset of communication leaves objects of the profile as they are (CiA 301); unplugged meanwhile.
TEST_F(ChargerNextBattery, WhatABatteryToldIsGoneWithAReset) {
  run_until_charging();
  cable.run_for(10min);
  bench.plugged = false;
  cable.send("000#82 05");
  cable.run_for(1s);
  expect_nothing_known();
}

/// 6080h stands in TPDO 3 (6.2.8).
TEST_F(ChargerNextBattery, IsNotToldTheStateOfChargeOfTheOneBefore) {
  ChargerDevice<> sut(cable.port(0), 5, bench.charger_hardware(),
                      {.limits = {.current_without_request_ampere = 40}});
  cable.connect(0, sut.node());
  bench.readings.state_of_charge_percent = 80;
  cable.start_all();
  cable.run_for(10min);
  ASSERT_EQ(cable.last(0x40A).substr(13), "52") << "80 %, and 6.7 of 400 Ah";
  plug_next_without_request();
  cable.run_for(5min);
  EXPECT_EQ(bench.delivered, 40);
  EXPECT_EQ(cable.last(0x40A).substr(13), "FF");
}

/// 6052h is what the battery remembers (7.2.4); the next one does not have the object.
TEST_F(ChargerNextBattery, IsNotToldTheAmpereHoursOfTheOneBefore) {
  run_until_charging();
  cable.run_for(30min);
  ASSERT_EQ(ask("40 52 60 00 00 00 00 00"), "4B 52 60 00 A0 00 00 00") << "20 Ah";
  bench.plugged = false;
  cable.run_for(2s);
  bench.readings.ready = false;
  cable.filter = [this](const Frame& frame) {
    if (wire_text(frame) != "60A#40 52 60 00 00 00 00 00") return true;
    cable.send("58A#80 52 60 00 00 00 02 06");
    return false;
  };
  bench.plugged = true;
  cable.run_for(10s);
  ASSERT_EQ(charger.charger().battery(), 10);
  EXPECT_EQ(ask("40 52 60 00 00 00 00 00"), "4B 52 60 00 FF FF 00 00") << "invalid";
}

}  // namespace
}  // namespace canvoy::cia419::charger_count_test
