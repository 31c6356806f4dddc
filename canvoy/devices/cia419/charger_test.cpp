// The charger with a battery at the other end of a cable: frames and currents, at exact virtual
// times.
#include "canvoy/devices/cia419/charger.hpp"

#include <gtest/gtest.h>

#include "canvoy/canopen/testing/cable.hpp"
#include "canvoy/devices/cia418/battery_device.hpp"
#include "canvoy/devices/cia419/charger_device.hpp"
#include "canvoy/devices/cia419/charger_test.hpp"

namespace canvoy::cia419::charger_test {
namespace {

TEST_F(ChargerTest, ItsPdosAreInvalidAtStart) {
  expect_pdos_invalid();
}

TEST_F(ChargerTest, FindsTheBatteryLinksItsPdosAndCharges) {
  cable.start_all();
  cable.run_for(5s);
  EXPECT_EQ(charger.charger().phase(), ChargerPhase::linked);
  EXPECT_EQ(charger.charger().battery(), 10);
  EXPECT_EQ(charger.charger().reason(), StopReason::none);
  EXPECT_EQ(bench.delivered, 40);
  Dictionary& dictionary = charger.node().dictionary();
  EXPECT_EQ(dictionary.number(0x1400, 1), 0x8000'0000u) << "6.2.5.1: RPDO 2 in its place";
  EXPECT_EQ(dictionary.number(0x1401, 1), 0x28Au);
  EXPECT_EQ(dictionary.number(0x1402, 1), 0x38Au);
  EXPECT_EQ(dictionary.number(0x1800, 1), 0x20Au);
  EXPECT_EQ(dictionary.number(0x1801, 1), 0x30Au);
  EXPECT_EQ(dictionary.number(0x1802, 1), 0x40Au);
  EXPECT_EQ(dictionary.number(0x1016, 1), 0x000A'07D0u) << "two periods of the battery's 1000 ms";
}

TEST_F(ChargerTest, AsksForFirstValuesByRemoteFrameWhereTheBatteryAllowsIt) {
  cable.start_all();
  cable.run_for(5s);
  EXPECT_TRUE(asked(0x28A));
  EXPECT_TRUE(asked(0x38A));
  EXPECT_FALSE(asked(0x18A)) << "RPDO 1 is not linked";
}

TEST_F(ChargerTest, DoesNotAskByRemoteFrameWhereTheBatteryForbidsIt) {
  battery.node().start(cable.now);
  for (const std::uint16_t index : std::to_array<std::uint16_t>({0x1800, 0x1801, 0x1802})) {
    // A value stored by a configuration tool: bit 30, no RTR.
    const std::uint32_t cob_id = 0xC000'0000U | (0x180U + 0x100U * (index & 0xFU) + 10U);
    std::uint8_t bytes[4];
    store(bytes, 0x8000'0000U);
    ASSERT_EQ(battery.node().dictionary().write(index, 1, bytes, Source::sdo), AbortCode::none);
    store(bytes, cob_id & 0x7FFF'FFFFU);
    ASSERT_EQ(battery.node().dictionary().write(index, 1, bytes, Source::sdo), AbortCode::none);
  }
  charger.node().start(cable.now);
  cable.run_for(5s);
  EXPECT_EQ(charger.charger().reason(), StopReason::none);
  for (const Cable::Heard& heard : cable.heard) EXPECT_FALSE(heard.frame.is_remote());
}

TEST_F(ChargerTest, ABatteryWithoutVoltageIsLinkedByTheFirstRpdo) {
  battery.node().start(cable.now);
  std::uint8_t bytes[4];
  store(bytes, 0x8000'0000U);
  ASSERT_EQ(battery.node().dictionary().write(0x1801, 1, bytes, Source::sdo), AbortCode::none);
  charger.node().start(cable.now);
  cable.run_for(5s);
  EXPECT_EQ(charger.charger().reason(), StopReason::none);
  EXPECT_EQ(charger.node().dictionary().number(0x1400, 1), 0x18Au);
  EXPECT_EQ(charger.node().dictionary().number(0x1401, 1), 0x8000'0000u);
  EXPECT_TRUE(asked(0x18A)) << "6.2.3.1";
}

TEST_F(ChargerTest, ABatteryThatWantsNoStatusIsChargedWithoutOne) {
  battery.node().start(cable.now);
  std::uint8_t bytes[4];
  store(bytes, 0x8000'0000U);
  for (const std::uint16_t index : std::to_array<std::uint16_t>({0x1400, 0x1401, 0x1402})) {
    ASSERT_EQ(battery.node().dictionary().write(index, 1, bytes, Source::sdo), AbortCode::none);
  }
  charger.node().start(cable.now);
  cable.run_for(5s);
  for (const std::uint16_t index : std::to_array<std::uint16_t>({0x1800, 0x1801, 0x1802})) {
    EXPECT_EQ(charger.node().dictionary().number(index, 1), 0x8000'0000u);
  }
  EXPECT_EQ(bench.delivered, 40);
}

TEST_F(ChargerTest, ScansWithoutFloodingAndWithoutWaitingLong) {
  // Alone: 125 absent nodes below 127 and the charger's own are passed over in one round.
  Cable alone;
  ChargerDevice<> lonely(alone.port(0), 5, bench.charger_hardware(), {});
  alone.connect(0, lonely.node());
  alone.start_all();
  alone.run_for(4s);
  std::size_t asked = 0;
  Time last{};
  for (const Cable::Heard& heard : alone.heard) {
    if (heard.frame.id < 0x601 || heard.frame.id > 0x67F || heard.frame.data[0] != 0x40) continue;
    EXPECT_NE(heard.frame.id, 0x605u) << "it knows itself";
    if (asked > 0) {
      EXPECT_GE(heard.at - last, Duration(10ms));
    }
    last = heard.at;
    ++asked;
  }
  EXPECT_EQ(asked, 126u) << "one round in under 4 s: four at a time, 100 ms each";
}

TEST_F(ChargerTest, StatusIsSentBeforeCurrentFlows) {
  cable.start_all();
  cable.run_for(5s);
  // Each time: the first current of all, and that after each stop.
  for (int charge = 0; charge < 3; ++charge) {
    bench.readings.ready = false;
    cable.run_for(1s);
    ASSERT_EQ(bench.delivered, 0);
    ASSERT_EQ(cable.last(0x20A), "20A#00");
    cable.clear();
    bench.readings.ready = true;
    const auto told = [&] {
      return std::ranges::find_if(cable.heard, [](const Cable::Heard& heard) {
        return wire_text(heard.frame) == "20A#01";
      });
    };
    while (told() == cable.heard.end() && cable.now < Time(20s)) {
      EXPECT_EQ(bench.delivered, 0);
      cable.run_for(1ms);
    }
    ASSERT_NE(told(), cable.heard.end());
    while (bench.delivered == 0 && cable.now < Time(20s)) cable.run_for(1ms);
    EXPECT_EQ(bench.delivered, 40);
    const Duration since = cable.now - told()->at;
    EXPECT_GE(since, 100ms) << "clause 7.2.2: ready, with time for the frame to find the bus free";
    EXPECT_LE(since, 201ms) << "and the charger looks each 100 ms";
  }
}

TEST_F(ChargerTest, WhatTheBatterySaysMeanwhileBringsTheCurrentNoSooner) {
  run_until_charging();
  bench.readings.ready = false;
  cable.run_for(1s);
  ASSERT_EQ(bench.delivered, 0);
  bench.readings.ready = true;
  cable.clear();
  while (cable.last(0x20A) != "20A#01") cable.run_for(1ms);
  for (int ms = 0; ms < 99; ++ms) {
    cable.run_for(1ms);
    cable.send("38A#R8");
    EXPECT_EQ(bench.delivered, 0) << ms;
  }
  cable.run_for(102ms);
  EXPECT_EQ(bench.delivered, 40);
}

TEST_F(ChargerTest, ABatteryThatIsHeardIsAskedBeforeItsTurn) {
  Cable late;
  ChargerDevice<> sut(late.port(0), 5, bench.charger_hardware(), {});
  cia418::BatteryDevice<> partner(late.port(1), 120, bench.battery_hardware(), {});
  late.connect(0, sut.node());
  late.connect(1, partner.node());
  sut.node().start(late.now);
  late.run_for(1s);
  partner.node().start(late.now);
  late.run_for(1s);  // its turn would come after 3 s
  EXPECT_EQ(sut.charger().battery(), 120);
}

TEST_F(ChargerTest, EachPhaseIsToldOnce) {
  std::vector<ChargerPhase> phases;
  auto note = [&](Charger::Event event) {
    if (event == Charger::Event::phase_changed) phases.push_back(charger.charger().phase());
  };
  charger.charger().on_event(Callback<void(Charger::Event)>::of(note));
  bench.plugged = false;
  cable.start_all();
  cable.run_for(1s);
  EXPECT_EQ(phases, std::vector<ChargerPhase>{});
  bench.plugged = true;
  cable.run_for(5s);
  bench.plugged = false;
  cable.run_for(1s);
  using enum ChargerPhase;
  EXPECT_EQ(phases, (std::vector{searching, linking, linked, unplugged}));
}

TEST_F(ChargerTest, TheDeadlineOfAnRpdoIsThreePeriodsOfTheBatterysTpdo) {
  battery.node().start(cable.now);
  battery.node().dictionary().set_number(0x1801, 5, 250);
  battery.node().dictionary().set_number(0x1802, 5, 21'846);
  charger.node().start(cable.now);
  cable.run_for(5s);
  EXPECT_EQ(charger.node().dictionary().number(0x1401, 5), 750u);
  EXPECT_EQ(charger.node().dictionary().number(0x1402, 5), 65'535u) << "no more can be said";
}

TEST_F(ChargerTest, TheConsumerHeartbeatTimeIsTwoPeriodsOfTheBatterys) {
  battery.node().start(cable.now);
  battery.node().dictionary().set_number(0x1017, 0, 40'000);
  charger.node().start(cable.now);
  cable.run_for(5s);
  EXPECT_EQ(charger.node().dictionary().number(0x1016, 1), 0x000A'FFFFu) << "no more can be said";
}

TEST_F(ChargerTest, LearnsWhatTheBatteryBears) {
  cable.start_all();
  cable.run_for(5s);
  EXPECT_EQ(charger.charger().provide().capacity_ampere_hours, 400);
  EXPECT_EQ(charger.charger().provide().current_max_ampere, 60);
  EXPECT_EQ(charger.charger().provide().heartbeat_ms, 1000);
}

TEST_F(ChargerTest, SendsItsStatusEach200Milliseconds) {
  run_until_charging();
  cable.run_for(2s);
  EXPECT_EQ(cable.count(0x20A), 10u) << "6.2.4.2: event timer 200";
}

TEST_F(ChargerTest, DeliversNoMoreThanItsOwnLimit) {
  run_until_charging();
  bench.readings.requested_current_ampere = 100;
  cable.run_for(500ms);
  EXPECT_EQ(bench.delivered, 60);
}

/// The effect of each cause on the charge, which continues when the cause is gone.
struct Stop {
  const char* name;
  void (*begin)(Bench&, Cable&);
  void (*end)(Bench&, Cable&);
  StopReason reason;
  Duration within;
  const char* emergency;  ///< the first one, or nothing
  NmtState state;         ///< of the charger meanwhile
};

class ChargerStopTest : public ChargerTest, public testing::WithParamInterface<Stop> {};

TEST_P(ChargerStopTest, StopsTellsAndTakesUpAgain) {
  const Stop& stop = GetParam();
  run_until_charging();
  stop.begin(bench, cable);
  const Time begun = cable.now;
  while (bench.delivered > 0 && cable.now < begun + 10s) cable.run_for(1ms);
  EXPECT_EQ(bench.delivered, 0);
  EXPECT_LE(cable.now - begun, stop.within);
  cable.run_for(1s);
  EXPECT_EQ(charger.charger().reason(), stop.reason);
  EXPECT_EQ(charger.node().state(), stop.state);
  if (stop.emergency == nullptr) {
    EXPECT_EQ(cable.count(0x085), 0u);
  } else {
    EXPECT_EQ(cable.last(0x085), stop.emergency);
  }
  stop.end(bench, cable);
  cable.run_for(10s);
  EXPECT_EQ(charger.charger().reason(), StopReason::none);
  EXPECT_EQ(bench.delivered, 40);
  EXPECT_EQ(charger.node().dictionary().number(0x1001, 0), 0u);
  if (stop.emergency != nullptr) {
    EXPECT_EQ(cable.last(0x085), "085#00 00 00 00 00 00 00 00") << "error reset";
  }
}

INSTANTIATE_TEST_SUITE_P(
    All, ChargerStopTest,
    testing::Values(
        Stop{"NotReady", [](Bench& b, Cable&) { b.readings.ready = false; },
             [](Bench& b, Cable&) { b.readings.ready = true; }, StopReason::battery_not_ready,
             101ms, nullptr, NmtState::operational},
        Stop{"Full",
             [](Bench& b, Cable&) {
               b.readings.ready = false;
               b.readings.requested_current_ampere = 0;
               b.readings.state_of_charge_percent = 100;
             },
             [](Bench& b, Cable&) {
               b.readings.ready = true;
               b.readings.requested_current_ampere = 40;
               b.readings.state_of_charge_percent = 80;
             },
             StopReason::battery_full, 101ms, nullptr, NmtState::operational},
        Stop{"TooHot", [](Bench& b, Cable&) { b.readings.temperature_celsius = 50.5; },
             [](Bench& b, Cable&) { b.readings.temperature_celsius = 40; }, StopReason::too_hot,
             101ms, "085#00 40 09 00 00 00 00 00", NmtState::operational},
        Stop{"TooCold", [](Bench& b, Cable&) { b.readings.temperature_celsius = -10; },
             [](Bench& b, Cable&) { b.readings.temperature_celsius = 10; }, StopReason::too_cold,
             101ms, "085#00 40 09 00 00 00 00 00", NmtState::operational},
        Stop{"InvalidTemperature", [](Bench& b, Cable&) { b.readings.temperature_celsius.reset(); },
             [](Bench& b, Cable&) { b.readings.temperature_celsius = 25; },
             StopReason::invalid_temperature, 101ms, "085#00 90 01 00 00 00 00 00",
             NmtState::operational},
        Stop{"InvalidVoltage", [](Bench& b, Cable&) { b.readings.voltage_volt.reset(); },
             [](Bench& b, Cable&) { b.readings.voltage_volt = 50; }, StopReason::invalid_voltage,
             101ms, "085#00 90 01 00 00 00 00 00", NmtState::operational},
        Stop{"VoltageTooHigh", [](Bench& b, Cable&) { b.readings.voltage_volt = 66; },
             [](Bench& b, Cable&) { b.readings.voltage_volt = 50; }, StopReason::voltage_too_high,
             101ms, "085#00 33 05 00 00 00 00 00", NmtState::operational},
        // With 24 cells, as the battery reports (CiA 418, 6020h).
        Stop{"VoltageTooLow", [](Bench& b, Cable&) { b.readings.voltage_volt = 10; },
             [](Bench& b, Cable&) { b.readings.voltage_volt = 50; }, StopReason::voltage_too_low,
             101ms, "085#00 33 05 00 00 00 00 00", NmtState::operational},
        Stop{"NoRequest", [](Bench& b, Cable&) { b.readings.requested_current_ampere = 0; },
             [](Bench& b, Cable&) { b.readings.requested_current_ampere = 40; },
             StopReason::no_request, 101ms, nullptr, NmtState::operational},
        Stop{"HeartbeatLost",
             [](Bench&, Cable& c) { c.filter = [](const Frame& f) { return f.id != 0x70A; }; },
             [](Bench&, Cable& c) { c.filter = [](const Frame&) { return true; }; },
             StopReason::heartbeat_lost, 2001ms, "085#30 81 11 0A 00 00 00 00",
             NmtState::pre_operational},
        Stop{"RpdoMissed",
             [](Bench&, Cable& c) { c.filter = [](const Frame& f) { return f.id != 0x28A; }; },
             [](Bench&, Cable& c) { c.filter = [](const Frame&) { return true; }; },
             StopReason::battery_data_missed, 601ms, "085#50 82 11 02 00 00 00 00",
             NmtState::operational},
        Stop{"PilotLost", [](Bench& b, Cable&) { b.plugged = false; },
             [](Bench& b, Cable&) { b.plugged = true; }, StopReason::no_pilot_signal, 101ms,
             "085#00 50 01 00 00 00 00 00", NmtState::pre_operational}),
    [](const testing::TestParamInfo<Stop>& stop) { return stop.param.name; });

TEST_F(ChargerTest, AFailureFollows1029h) {
  run_until_charging();
  const std::uint8_t no_change = 1;
  ASSERT_EQ(charger.node().dictionary().write(0x1029, 1, {&no_change, 1}, Source::sdo),
            AbortCode::none);
  bench.plugged = false;
  cable.run_for(1s);
  EXPECT_EQ(charger.node().state(), NmtState::operational);
  EXPECT_EQ(bench.delivered, 0);
}

TEST_F(ChargerTest, ABatteryThatWasUnpluggedIsNotMissed) {
  run_until_charging();
  bench.plugged = false;
  cable.run_for(200ms);
  cable.cut(1);
  cable.clear();
  cable.run_for(5s);
  EXPECT_EQ(charger.node().dictionary().number(0x1016, 1), 0u);
  EXPECT_EQ(cable.count(0x085), 0u) << "no heartbeat event (5.2)";
  expect_pdos_invalid();
}

TEST_F(ChargerTest, AResetTakesTheCurrentAwayBeforeAnythingIsTold) {
  run_until_charging();
  std::vector<double> set;
  std::vector<double> delivered;
  auto note = [&](Charger::Event) {
    set.push_back(charger.charger().set_point_ampere());
    delivered.push_back(bench.delivered);
  };
  charger.charger().on_event(Callback<void(Charger::Event)>::of(note));
  cable.send("000#82 05");
  ASSERT_FALSE(set.empty());
  EXPECT_EQ(set.front(), 0);
  EXPECT_EQ(delivered.front(), 0);
  cable.run_for(5s);
  EXPECT_EQ(bench.delivered, 40) << "the battery is found again";
}

TEST_F(ChargerTest, BusOffStopsTheChargeAndItGoesOnAfterRecovery) {
  run_until_charging();
  cable.cut(0);
  charger.node().bus_state(BusState::bus_off, cable.now);
  cable.run_for(1ms);
  EXPECT_EQ(bench.delivered, 0);
  EXPECT_EQ(charger.charger().reason(), StopReason::bus_off);
  EXPECT_EQ(charger.node().state(), NmtState::pre_operational);
  cable.run_for(5s);
  cable.cut(0, false);
  charger.node().bus_state(BusState::error_active, cable.now);
  cable.run_for(10s);
  EXPECT_EQ(bench.delivered, 40);
}

TEST_F(ChargerTest, ABatteryThatStartsAgainIsLinkedAgain) {
  run_until_charging();
  battery.node().start(cable.now);
  cable.run_for(1ms);
  EXPECT_EQ(bench.delivered, 0);
  cable.run_for(10s);
  EXPECT_EQ(charger.charger().battery(), 10);
  EXPECT_EQ(bench.delivered, 40);
}

TEST_F(ChargerTest, AnotherNodeThatStartsAgainIsNotTakenForTheBattery) {
  run_until_charging();
  cable.send("605#23 16 10 02 64 00 14 00");  // node 20: 100 ms
  ASSERT_EQ(cable.last(0x585), "585#60 16 10 02 00 00 00 00");
  std::vector<Charger::Event> events;
  auto note = [&](Charger::Event event) { events.push_back(event); };
  charger.charger().on_event(Callback<void(Charger::Event)>::of(note));
  cable.send("714#05");
  cable.send("714#00");
  cable.run_for(50ms);
  EXPECT_TRUE(events.empty());
  EXPECT_EQ(bench.delivered, 40);
}

TEST_F(ChargerTest, AsksForFirstValuesWhenALostBatteryIsHeardAgain) {
  const std::uint8_t no_change = 1;
  run_until_charging();
  ASSERT_EQ(charger.node().dictionary().write(0x1029, 1, {&no_change, 1}, Source::sdo),
            AbortCode::none);
  cable.filter = [](const Frame& frame) { return frame.id != 0x70A; };
  cable.run_for(3s);
  ASSERT_EQ(charger.charger().reason(), StopReason::heartbeat_lost);
  cable.clear();
  cable.filter = [](const Frame&) { return true; };
  cable.send("70A#05");
  EXPECT_TRUE(asked(0x28A));
  EXPECT_TRUE(asked(0x38A));
}

/// 1017h of the battery becomes 5 s: 1016h of the charger was 2 s, two of its periods of 1 s.
TEST_F(ChargerTest, FollowsABatteryWhoseHeartbeatWasMadeSlower) {
  run_until_charging();
  ASSERT_EQ(charger.node().dictionary().number(0x1016, 1), 0x000A'07D0u);
  cable.send("60A#2B 17 10 00 88 13 00 00");
  cable.run_for(6s);
  EXPECT_EQ(charger.node().dictionary().number(0x1016, 1), 0x000A'2710u);
  cable.run_for(1s);
  EXPECT_EQ(cable.count(0x000), 0u) << "it is known to be operational";
  cable.clear();
  cable.run_for(60s);
  EXPECT_EQ(cable.count(0x085), 0u) << "no heartbeat error any more";
  EXPECT_EQ(bench.delivered, 40);
}

/// 1017h of the battery becomes 0: it is silent, though it answers.
TEST_F(ChargerTest, HasALostBatteryThatSendsNoHeartbeatAnyMoreSendOne) {
  run_until_charging();
  cable.send("60A#2B 17 10 00 00 00 00 00");
  cable.run_for(3s);
  ASSERT_EQ(charger.charger().reason(), StopReason::heartbeat_lost);
  cable.clear();
  cable.run_for(12s);
  EXPECT_EQ(cable.count(0x60A), 0u);
  cable.run_for(4s);
  EXPECT_EQ(battery.node().dictionary().number(0x1017, 0), 1000u);
  EXPECT_EQ(bench.delivered, 40);
  cable.clear();
  cable.run_for(60s);
  EXPECT_EQ(cable.count(0x085), 0u);
  EXPECT_EQ(cable.count(0x60A), 0u);
}

/// Read every 15 s, and nothing else: the first request of those made during linking.
TEST_F(ChargerTest, AsksALostBatteryRarely) {
  run_until_charging();
  cable.cut(1);
  cable.run_for(60s);
  const auto questions = std::ranges::count_if(cable.heard, [](const Cable::Heard& heard) {
    return heard.frame.id == 0x60A && heard.frame.data[0] == 0x40;
  });
  EXPECT_EQ(questions, 3);
  EXPECT_EQ(cable.count(0x000), 0u) << "nobody is started that is lost";
  EXPECT_EQ(bench.delivered, 0);
}

/// Its boot-up message was lost, and TPDO 2 has another CAN-ID since.
TEST_F(ChargerTest, LinksABatteryAnewThatHasStartedAgainUnheard) {
  run_until_charging();
  cable.filter = [](const Frame& frame) { return frame.id != 0x70A; };
  cable.send("60A#23 01 18 01 8A 02 00 80");
  cable.send("60A#23 01 18 01 8B 02 00 40");
  cable.run_for(3s);
  ASSERT_EQ(charger.charger().reason(), StopReason::heartbeat_lost);
  cable.filter = [](const Frame&) { return true; };
  cable.run_for(5s);
  EXPECT_EQ(charger.node().dictionary().number(0x1401, 1) & 0x7FFu, 0x28Bu);
  EXPECT_EQ(bench.delivered, 40);
}

TEST_F(ChargerTest, StartsABatteryThatDoesNotFollowAgainEachSecond) {
  cable.filter = [](const Frame& frame) { return frame.id != 0x000; };
  cable.start_all();
  while (charger.charger().phase() != ChargerPhase::linked) cable.run_for(1ms);
  const Time linked = cable.now;
  cable.run_for(5s);
  std::vector<Time> commands;
  for (const Cable::Heard& heard : cable.heard) {
    if (wire_text(heard.frame) == "000#01 0A") commands.push_back(heard.at);
  }
  ASSERT_GE(commands.size(), 4u);
  EXPECT_LE(commands[0] - linked, 100ms) << "the first one at once";
  for (std::size_t i = 1; i < commands.size(); ++i) EXPECT_EQ(commands[i] - commands[i - 1], 1s);
}

TEST_F(ChargerTest, WithoutManagingTheNetworkItWaitsForAnNmtMaster) {
  ChargerSettings settings;
  settings.manage_network = false;
  Cable managed;
  ChargerDevice<> sut(managed.port(0), 5, bench.charger_hardware(), settings);
  cia418::BatteryDevice<> partner(managed.port(1), 10, bench.battery_hardware(), {});
  managed.connect(0, sut.node());
  managed.connect(1, partner.node());
  managed.start_all();
  managed.run_for(5s);
  EXPECT_EQ(sut.charger().phase(), ChargerPhase::linked);
  EXPECT_EQ(managed.count(0x000), 0u);
  EXPECT_EQ(bench.delivered, 0);
  managed.send("000#01 00");
  managed.run_for(1s);     // until the battery's heartbeat shows that it is operational
  managed.run_for(200ms);  // and the charger has reported that it is ready
  EXPECT_EQ(bench.delivered, 40);
  managed.send("000#80 05");
  EXPECT_EQ(bench.delivered, 0);
  EXPECT_EQ(sut.charger().reason(), StopReason::not_operational);
}

TEST_F(ChargerTest, GarbageOnTheBusChangesNothing) {
  run_until_charging();
  for (const char* frame : {"28A#", "28A#00", "38A#FF", "00012345#1122", "605#R8", "605#40",
                            "605#E0 00 00 00 00 00 00 00", "000#01", "000#FF 05", "705#05",
                            "080#01 02", "7FF#FF FF FF FF FF FF FF FF"}) {
    cable.send(frame);
  }
  cable.run_for(1s);
  EXPECT_EQ(bench.delivered, 40);
}

}  // namespace
}  // namespace canvoy::cia419::charger_test
