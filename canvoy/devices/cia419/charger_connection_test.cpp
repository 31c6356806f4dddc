// Access of a charger to its battery (CiA 419, 6.1): on an SDO connection that the SDO manager of
// the vehicle assigns, or on the default channel; the values that it writes there; and the time of
// day (4.1).
#include <gtest/gtest.h>

#include "canvoy/canopen/testing/cable.hpp"
#include "canvoy/canopen/testing/dynamic_sdo_nodes.hpp"
#include "canvoy/devices/cia418/battery_device.hpp"
#include "canvoy/devices/cia419/charger_device.hpp"
#include "canvoy/devices/cia419/charger_test.hpp"

namespace canvoy::cia419::charger_connection_test {
namespace {

class ChargerConnection : public testing::Test {
 protected:
  ChargerConnection() {
    cable.connect(0, charger.node());
    cable.connect(1, battery.node());
  }
  /// The in-vehicle CANopen manager: node 1.
  void add_manager() {
    cable.connect(2, manager.node);
    cable.start_all();
    for (const NodeId id : {NodeId{5}, NodeId{10}}) {
      manager.manager.remote_changed(id, RemoteState::pre_operational);
    }
  }
  std::size_t count(std::uint32_t id, std::uint8_t command, std::uint16_t index) const {
    return static_cast<std::size_t>(
        std::ranges::count_if(cable.heard, [&](const Cable::Heard& heard) {
          return heard.frame.id == id && heard.frame.data[0] == command &&
                 load<std::uint16_t>(&heard.frame.data[1]) == index;
        }));
  }
  std::size_t writes_of_6052h() const {
    return count(0x60A, 0x2B, 0x6052) + count(0x682, 0x2B, 0x6052);
  }
  void become_full() {
    bench.readings.ready = false;
    bench.readings.requested_current_ampere = 0;
    bench.readings.state_of_charge_percent = 100;
  }
  /// The battery shows another mapping than that of its profile.
  void show_mapping(std::uint16_t index, std::uint32_t first_entry) {
    ASSERT_TRUE(battery.node().dictionary().set_number(index, 1, first_entry));
  }

  Bench bench;
  Cable cable;
  ChargerDevice<> charger{cable.port(0), 5, bench.charger_hardware(), {}};
  cia418::BatteryDevice<> battery{cable.port(1), 10, bench.battery_hardware(), {}};
  ManagingNode manager{cable.port(2), 1};
};

TEST_F(ChargerConnection, IsRequestedFromTheSdoManagerAndUsed) {
  add_manager();
  cable.run_for(5s);
  EXPECT_EQ(bench.delivered, 40);
  EXPECT_EQ(cable.count(0x6E0), 1u);
  EXPECT_EQ(count(0x680, 0x23, 0x1F00), 1u) << "request of a connection, on the manager's channel";
  EXPECT_EQ(count(0x682, 0x40, 0x1800), 2u) << "COB-ID and event timer of the battery's TPDO";
  EXPECT_EQ(count(0x60A, 0x40, 0x1800), 0u) << "not on the default channel";
  Dictionary& dictionary = charger.node().dictionary();
  EXPECT_EQ(dictionary.number(0x1281, 1), 0x4000'0682u);
  EXPECT_EQ(dictionary.number(0x1281, 3), 10u);
  EXPECT_EQ(battery.node().dictionary().number(0x1201, 1), 0x4000'0682u);
}

TEST_F(ChargerConnection, WithoutAnSdoManagerTheDefaultChannelIsUsedAfterTheTimeOut) {
  cable.start_all();
  cable.run_for(5s);
  EXPECT_EQ(bench.delivered, 40);
  std::vector<Time> calls;
  Time asked{};
  for (const Cable::Heard& heard : cable.heard) {
    if (heard.frame.id == 0x6E0) calls.push_back(heard.at);
    const bool is_question =
        heard.frame.id == 0x60A && load<std::uint16_t>(&heard.frame.data[1]) == 0x1800;
    if (is_question && asked == Time{}) asked = heard.at;
  }
  ASSERT_EQ(calls.size(), 2u);
  EXPECT_EQ(calls[1] - calls[0], 250ms);
  EXPECT_EQ(asked - calls[0], 500ms);
}

TEST_F(ChargerConnection, TheAmpereHoursAreWrittenBackOnItAlone) {
  add_manager();
  cable.run_for(5s);
  cable.clear();
  become_full();
  cable.run_for(1s);
  EXPECT_EQ(count(0x682, 0x2B, 0x6052), 1u);
  EXPECT_EQ(count(0x60A, 0x2B, 0x6052), 0u);
}

TEST_F(ChargerConnection, WithoutANumberOfItsOwnTheDefaultChannelIsUsed) {
  for (std::uint8_t sub = 3; sub <= 6; ++sub) {
    manager.node.dictionary().set_number(0x1F02, sub, 0x8000'0000);
  }
  cable.connect(2, manager.node);
  charger.node().start(cable.now);
  battery.node().start(cable.now);
  cable.run_for(5s);
  EXPECT_EQ(bench.delivered, 40);
}

TEST_F(ChargerConnection, IsGivenBackWhenTheBatteryIsUnplugged) {
  add_manager();
  cable.run_for(5s);
  cable.clear();
  bench.plugged = false;
  cable.run_for(1s);
  EXPECT_EQ(count(0x680, 0x23, 0x1F01), 1u);
  EXPECT_EQ(battery.node().dictionary().number(0x1201, 1), 0xC000'0000u);
  bench.plugged = true;
  cable.run_for(5s);
  EXPECT_EQ(bench.delivered, 40);
  EXPECT_EQ(charger.node().dictionary().number(0x1281, 1), 0x4000'0682u) << "and taken again";
  bench.plugged = false;
  cable.run_for(1s);
  cable.cut(1);
  bench.plugged = true;
  cable.run_for(5s);
  bench.plugged = false;
  cable.run_for(1s);
  EXPECT_EQ(count(0x680, 0x23, 0x1F01), 2u) << "where there was none, none is given back";
}

TEST_F(ChargerConnection, ThatTheSdoManagerTakesAwayIsReplacedByTheDefaultChannel) {
  add_manager();
  cable.run_for(5s);
  cable.clear();
  // The manager believes that the battery is lost.
  manager.manager.remote_changed(10, RemoteState::lost);
  cable.run_for(1s);
  EXPECT_EQ(bench.delivered, 40) << "the charge goes on";
  become_full();
  cable.run_for(1s);
  EXPECT_EQ(count(0x60A, 0x2B, 0x6052), 1u);
  EXPECT_EQ(battery.node().dictionary().number(0x6052, 0),
            charger.node().dictionary().number(0x6052, 0));
  EXPECT_EQ(cable.last(0x58A), "58A#60 52 60 00 00 00 00 00");
}

TEST_F(ChargerConnection, ABatteryThatStartsAgainGetsAnotherOne) {
  add_manager();
  cable.run_for(5s);
  battery.node().start(cable.now);
  manager.manager.remote_changed(10, RemoteState::boot_up);
  cable.run_for(10s);
  EXPECT_EQ(bench.delivered, 40);
  EXPECT_EQ(charger.charger().battery(), 10);
  EXPECT_EQ(battery.node().dictionary().number(0x1201, 1) >> 31, 0u);
  EXPECT_EQ(charger.node().dictionary().number(0x1281, 3), 10u);
  EXPECT_EQ(charger.node().dictionary().number(0x1281, 1) >> 31, 0u);
}

TEST_F(ChargerConnection, ThatComesAfterTheBatteryIsUnpluggedIsGivenBack) {
  add_manager();
  // The last frame of the SDO manager is late by one of its retries: the pilot signal is gone.
  bool was_lost = false;
  cable.filter = [&](const Frame& frame) {
    const bool is_first = !was_lost && wire_text(frame) == "605#23 10 1F 00 06 00 81 12";
    if (is_first) bench.plugged = false;
    was_lost = was_lost || is_first;
    return !is_first;
  };
  cable.run_for(5s);
  ASSERT_TRUE(was_lost);
  EXPECT_EQ(count(0x680, 0x23, 0x1F01), 1u);
  EXPECT_EQ(battery.node().dictionary().number(0x1201, 1), 0xC000'0000u);
  EXPECT_EQ(charger.charger().phase(), ChargerPhase::unplugged);
  EXPECT_EQ(charger.node().dictionary().number(0x1401, 1), 0x8000'0000u);
}

TEST_F(ChargerConnection, ThatComesWhenTheBatteryIsAskedOnTheDefaultChannelIsGivenBack) {
  ChargerSettings settings;
  settings.sdo_manager_time_out = 10s;
  ChargerDevice<> patient(cable.port(0), 5, bench.charger_hardware(), settings);
  cable.connect(0, patient.node());
  add_manager();
  // The SDO manager's last frame comes with its third try. The pilot signal is away meanwhile, but
  // not for long.
  unsigned tries = 0;
  cable.filter = [&](const Frame& frame) {
    return wire_text(frame) != "605#23 10 1F 00 06 00 81 12" || ++tries > 2;
  };
  while (tries == 0) cable.run_for(1ms);
  bench.plugged = false;
  cable.run_for(150ms);
  ASSERT_EQ(patient.charger().phase(), ChargerPhase::unplugged);
  bench.plugged = true;
  cable.run_for(5s);
  EXPECT_EQ(tries, 3u);
  EXPECT_EQ(count(0x680, 0x23, 0x1F01), 1u);
  EXPECT_EQ(battery.node().dictionary().number(0x1201, 1), 0xC000'0000u);
  EXPECT_EQ(patient.charger().battery(), 10);
  EXPECT_EQ(bench.delivered, 40);
}

// 4.1

TEST_F(ChargerConnection, ABatteryWithoutAHeartbeatIsToldToSendOneEachSecond) {
  battery.node().start(cable.now);
  battery.node().dictionary().set_number(0x1017, 0, 0);
  charger.node().start(cable.now);
  cable.run_for(5s);
  EXPECT_EQ(count(0x60A, 0x2B, 0x1017), 1u);
  EXPECT_EQ(battery.node().dictionary().number(0x1017, 0), 1000u);
  EXPECT_EQ(charger.node().dictionary().number(0x1016, 1), 0x000A'07D0u) << "two periods of it";
  EXPECT_EQ(bench.delivered, 40);
}

TEST_F(ChargerConnection, ABatteryThatDoesNotAnswerIsToldOfItsHeartbeatThreeTimes) {
  cable.filter = [](const Frame& frame) { return frame.id != 0x60A || frame.data[0] != 0x2B; };
  battery.node().start(cable.now);
  battery.node().dictionary().set_number(0x1017, 0, 0);
  charger.node().start(cable.now);
  cable.run_for(10s);
  EXPECT_EQ(count(0x60A, 0x2B, 0x1017), 3u);
}

TEST_F(ChargerConnection, ABatteryThatHasMissedThemAllIsToldAgainAndIsCharged) {
  cable.filter = [](const Frame& frame) { return frame.id != 0x60A || frame.data[0] != 0x2B; };
  battery.node().start(cable.now);
  battery.node().dictionary().set_number(0x1017, 0, 0);
  charger.node().start(cable.now);
  cable.run_for(10s);
  EXPECT_EQ(bench.delivered, 0);
  cable.filter = [](const Frame&) { return true; };
  cable.run_for(15s);
  EXPECT_GT(bench.delivered, 0);
  cable.clear();
  cable.run_for(1min);
  EXPECT_EQ(count(0x60A, 0x2B, 0x1017), 0u) << "it has heard it";
}

// 7.2.4

TEST_F(ChargerConnection, TheAmpereHoursOfABatteryAreNotForTheNextOne) {
  cable.start_all();
  cable.run_for(5s);
  cable.clear();
  bench.readings.ready = false;
  cable.filter = [](const Frame& frame) { return frame.id != 0x60A && frame.id != 0x58A; };
  cable.run_for(1s);
  ASSERT_EQ(writes_of_6052h(), 1u) << "and two tries are left";
  bench.plugged = false;
  cable.run_for(200ms);
  cable.filter = [](const Frame&) { return true; };
  cable.clear();
  bench.plugged = true;
  cable.run_for(5s);
  EXPECT_EQ(charger.charger().battery(), 10);
  EXPECT_EQ(writes_of_6052h(), 0u);
}

TEST_F(ChargerConnection, TheAmpereHoursAreWrittenBackOnce) {
  cable.start_all();
  cable.run_for(5s);
  // TPDO 2 reports that it is not ready before TPDO 3 reports that it is full.
  cable.clear();
  become_full();
  cable.run_for(1s);
  EXPECT_EQ(charger.charger().reason(), StopReason::battery_full);
  EXPECT_EQ(writes_of_6052h(), 1u);
}

TEST_F(ChargerConnection, AmpereHoursThatTheBatteryKnowsAreNotWrittenAgainAtTheEnd) {
  cable.start_all();
  cable.run_for(5s);
  cable.clear();
  bench.readings.ready = false;
  cable.run_for(1s);
  EXPECT_EQ(writes_of_6052h(), 1u);
  become_full();
  cable.run_for(1s);
  EXPECT_EQ(charger.charger().reason(), StopReason::battery_full);
  EXPECT_EQ(writes_of_6052h(), 1u);
}

TEST_F(ChargerConnection, AmpereHoursThatTheBatteryNeverAnsweredToAreWrittenAtTheEnd) {
  cable.start_all();
  cable.run_for(5s);
  cable.clear();
  bench.readings.ready = false;
  cable.filter = [](const Frame& frame) { return frame.id != 0x60A && frame.id != 0x58A; };
  cable.run_for(10s);
  EXPECT_EQ(writes_of_6052h(), 3u) << "so often it is tried";
  cable.filter = [](const Frame&) { return true; };
  become_full();
  cable.run_for(1s);
  EXPECT_EQ(writes_of_6052h(), 4u);
  EXPECT_EQ(cable.last(0x58A), "58A#60 52 60 00 00 00 00 00");
}

TEST_F(ChargerConnection, AmpereHoursThatAreNewAreWrittenBackAgain) {
  cable.start_all();
  cable.run_for(5s);
  cable.clear();
  bench.readings.ready = false;
  cable.run_for(1s);
  EXPECT_EQ(writes_of_6052h(), 1u);
  bench.readings.ready = true;
  cable.run_for(10min);
  become_full();
  cable.run_for(1s);
  EXPECT_EQ(writes_of_6052h(), 2u);
}

// The mapping of both ends

TEST_F(ChargerConnection, ATpdoWithAnotherMappingIsNotLinkedAndTold) {
  battery.node().start(cable.now);
  show_mapping(0x1A01, 0x6000'0008);  // the status where the charger expects the temperature
  charger.node().start(cable.now);
  cable.run_for(5s);
  EXPECT_EQ(charger.node().dictionary().number(0x1401, 1), 0x8000'0000u);
  EXPECT_EQ(charger.node().dictionary().number(0x1400, 1), 0x18Au) << "TPDO 1 in its place";
  EXPECT_EQ(cable.last(0x085), "085#00 63 11 00 00 00 00 00");
  EXPECT_TRUE(charger.charger().provide().misfit_tpdos[1]);
  EXPECT_EQ(bench.delivered, 40);
  bench.plugged = false;
  cable.run_for(1s);
  EXPECT_EQ(charger.node().dictionary().number(0x1001, 0) & 0x10, 0) << "the error is gone";
  show_mapping(0x1A01, 0x6010'0010);
  bench.plugged = true;
  cable.run_for(5s);
  EXPECT_EQ(charger.node().dictionary().number(0x1401, 1), 0x28Au) << "what was is forgotten";
  EXPECT_TRUE(charger.charger().provide().misfit_tpdos.none());
}

TEST_F(ChargerConnection, EachEntryOfAMappingIsAskedForOnce) {
  cable.start_all();
  cable.run_for(5s);
  EXPECT_EQ(count(0x60A, 0x40, 0x1A00), 3u) << "sub-indices 0 to 2";
  EXPECT_EQ(count(0x60A, 0x40, 0x1A01), 4u);
}

TEST_F(ChargerConnection, AMisfitDoesNotHideThatOfTheNextPdo) {
  battery.node().start(cable.now);
  show_mapping(0x1A01, 0x6000'0008);
  ASSERT_TRUE(battery.node().dictionary().set_number(0x1A02, 0, 1));  // 6070h alone
  charger.node().start(cable.now);
  cable.run_for(5s);
  EXPECT_TRUE(charger.charger().provide().misfit_tpdos[1]);
  EXPECT_TRUE(charger.charger().provide().misfit_tpdos[2]);
  EXPECT_TRUE(charger.charger().provide().misfit_rpdos.none());
}

class ChargerSilence : public ChargerConnection, public testing::WithParamInterface<unsigned> {};

TEST_P(ChargerSilence, InTheMiddleOfItsQuestionsIsNoAnswer) {
  cable.filter = [](const Frame& frame) {
    return frame.id != 0x60A || load<std::uint16_t>(&frame.data[1]) != GetParam();
  };
  cable.start_all();
  cable.run_for(5s);
  ASSERT_GT(count(0x60A, 0x40, static_cast<std::uint16_t>(GetParam())), 0u);
  EXPECT_EQ(charger.charger().battery(), 0);
  EXPECT_EQ(bench.delivered, 0);
  cable.filter = [](const Frame&) { return true; };
  cable.run_for(5s);
  EXPECT_EQ(charger.charger().battery(), 10);
  EXPECT_EQ(bench.delivered, 40);
}

INSTANTIATE_TEST_SUITE_P(Objects, ChargerSilence, testing::Values(0x1800U, 0x6020U, 0x1A01U));

TEST_F(ChargerConnection, AnRpdoWithAnotherMappingGetsNothing) {
  battery.node().start(cable.now);
  show_mapping(0x1602, 0x6052'0010);
  charger.node().start(cable.now);
  cable.run_for(5s);
  EXPECT_EQ(charger.node().dictionary().number(0x1802, 1), 0x8000'0000u);
  EXPECT_EQ(charger.node().dictionary().number(0x1800, 1), 0x20Au);
  EXPECT_TRUE(charger.charger().provide().misfit_rpdos[2]);
  EXPECT_EQ(cable.count(0x085), 1u);
}

// 4.1

class ChargerClock : public Bench {
 public:
  ChargerHardware hardware() {
    ChargerHardware made = charger_hardware();
    made.time_of_day = callback<&ChargerClock::time>(*this);
    return made;
  }
  std::optional<TimeOfDay> time() { return now; }

  std::optional<TimeOfDay> now;
};

TEST(ChargerTime, IsToldEachMinuteWhereTheChargerHasAClock) {
  ChargerClock clock;
  Cable cable;
  ChargerDevice<> charger(cable.port(0), 5, clock.hardware());
  cable.connect(0, charger.node());
  cable.start_all();
  cable.run_for(3min);
  EXPECT_EQ(cable.count(0x100), 0u) << "it does not know the time";
  clock.now = TimeOfDay{.milliseconds = 43'200'000, .days = 15'665};
  cable.run_for(3min);
  EXPECT_EQ(cable.count(0x100), 3u);
  // The clock of the bench stands at noon; the charger reads it every 100 ms.
  const Frame told = wire_frame(cable.last(0x100));
  EXPECT_GE(load<std::uint32_t>(told.data.data()), 43'200'000u);
  EXPECT_LE(load<std::uint32_t>(told.data.data()), 43'200'100u);
  EXPECT_EQ(load<std::uint16_t>(&told.data[4]), 15'665u);
}

TEST(ChargerTime, IsNotToldBy1012hWithoutBit30) {
  ChargerClock clock;
  clock.now = TimeOfDay{};
  Cable cable;
  ChargerDevice<> charger(cable.port(0), 5, clock.hardware());
  cable.connect(0, charger.node());
  cable.start_all();
  cable.send("605#23 12 10 00 00 01 00 00");
  cable.run_for(3min);
  EXPECT_EQ(cable.count(0x100), 0u);
}

/// 6020h, sub-index 3, is read during linking; 0 and FFFFh mean no value.
TEST(ChargerLimit, WhatTheBatteryBearsBoundsTheCurrentWithoutARequest) {
  struct Case {
    std::uint16_t told;
    double delivered;
  };
  for (const auto& [told, delivered] :
       std::to_array<Case>({{20, 20}, {39, 39}, {40, 40}, {60, 40}, {0, 40}, {0xFFFF, 40}})) {
    Bench bench;
    Cable cable;
    ChargerDevice<> charger(cable.port(0), 5, bench.charger_hardware(),
                            {.limits = {.current_without_request_ampere = 40}});
    cia418::BatteryDevice<> battery(cable.port(1), 10, bench.battery_hardware(), {});
    cable.connect(0, charger.node());
    cable.connect(1, battery.node());
    cable.start_all();
    battery.node().dictionary().set_number(0x1802, 1, 0x8000'038A);
    battery.node().dictionary().set_number(0x6020, 3, told);
    cable.run_for(10s);
    EXPECT_EQ(bench.delivered, delivered) << told;
  }
}

/// A loss without a boot-up message: all is read again, and nothing else has changed.
TEST_F(ChargerConnection, ABatteryThatBearsLessAfterALossIsChargedWithLess) {
  cable.start_all();
  cable.run_for(5s);
  ASSERT_EQ(bench.delivered, 40);
  cable.cut(1);
  cable.run_for(5s);
  ASSERT_EQ(bench.delivered, 0);
  ASSERT_TRUE(battery.node().dictionary().set_number(0x6020, 3, 20));
  cable.cut(1, false);
  cable.run_for(5s);
  EXPECT_EQ(bench.delivered, 20);
}

}  // namespace
}  // namespace canvoy::cia419::charger_connection_test
