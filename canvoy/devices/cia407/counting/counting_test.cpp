// Passenger counter and counting manager at their wire.
#include <gtest/gtest.h>

#include "canvoy/devices/cia407/counting/counting_manager_unit.hpp"
#include "canvoy/devices/cia407/counting/passenger_counter_unit.hpp"
#include "canvoy/devices/cia407/kit/bus_bench_test.hpp"

namespace canvoy::cia407::counting_test {
namespace {

class Counter : public testing::Test {
 protected:
  static constexpr const BusUnit* units[] = {&bus_unit<PassengerCounterKind>};
  /// Of doors 1 to 4: door 2 is bits 5 and 4, open and valid.
  void door(const std::string& bits) { bench.ask("2F 88 64 02 " + bits + " 00 00 00"); }
  std::string told() { return bench.ask("40 00 67 00 00 00 00 00").substr(12, 5); }

  PassengerCounterUnit* counter = nullptr;
  BusBench bench{units, [this](Environment& environment) {
                   environment.provide(Callback<PassengerCounterSettings()>(
                       [](void*) { return PassengerCounterSettings{.door = 2}; }, nullptr));
                   environment.watch(counter);
                 }};
};

TEST_F(Counter, CountsWhileItsDoorIsOpenAndTellsWhenItCloses) {
  counter->count_in(3);
  door("C0");
  counter->count_in(3);
  EXPECT_FALSE(counter->is_counting()) << "door 1 is another's";
  door("30");
  bench.cable.clear();
  counter->count_in(3);
  counter->count_out();
  EXPECT_EQ(told(), "00 00") << "not yet";
  door("10");
  EXPECT_EQ(told(), "01 03") << "out in the low byte, in in the high one";
  EXPECT_EQ(bench.cable.last(0x285), "285#01 03");
  EXPECT_EQ(bench.cable.count(0x285), 1u) << "in one message";
  counter->count_in();
  EXPECT_EQ(told(), "01 03");
  door("30");
  EXPECT_EQ(told(), "00 00");
}

/// A TPDO of this type is sent whenever the node becomes operational (CiA 301, 7.5.2.37).
TEST_F(Counter, WhatIsToldIsNotToldAgainAtTheNextStart) {
  door("30");
  counter->count_in(3);
  door("10");
  EXPECT_EQ(bench.cable.last(0x285), "285#00 03");
  for (const char* command : {"000#80 05", "000#81 05", "000#82 05"}) {
    bench.cable.clear();
    bench.cable.send(command);
    bench.cable.send("000#01 05");
    bench.cable.run_for(1s);
    EXPECT_EQ(bench.cable.last(0x285), "285#00 00") << command;
  }
}

TEST_F(Counter, WhatCameWhileItCouldNotBeToldIsToldAtTheNextStart) {
  door("30");
  counter->count_in(3);
  bench.cable.send("000#80 05");
  door("10");
  bench.cable.clear();
  bench.cable.send("000#01 05");
  bench.cable.run_for(0s);
  EXPECT_EQ(bench.cable.last(0x285), "285#00 03");
}

TEST_F(Counter, ADoorThatIsNotValidChangesNothing) {
  door("30");
  counter->count_in();
  door("00");
  EXPECT_TRUE(counter->is_counting());
}

TEST_F(Counter, MoreThan200AreAnEventAsTheyArise) {
  door("30");
  bench.cable.clear();
  counter->count_out(200);
  bench.cable.run_for(0s);
  EXPECT_EQ(bench.cable.count(0x185), 0u);
  counter->count_out();
  bench.cable.run_for(0s);
  EXPECT_EQ(bench.cable.last(0x185), "185#01 00 00 00 01 00 00 14");
  counter->count_out(500);
  door("10");
  EXPECT_EQ(told(), "FF 00") << "no more than a byte holds";
  door("30");
  EXPECT_EQ(bench.cable.last(0x185), "185#00 00 00 00 00 00 00 00");
}

class Manager : public testing::Test {
 protected:
  static constexpr const BusUnit* units[] = {&bus_unit<CountingManagerKind>};
  void count(const std::string& out, const std::string& in) {
    EXPECT_EQ(bench.ask("2B 00 67 00 " + out + " " + in + " 00 00"), "60 00 67 00 00 00 00 00");
  }
  std::string ask(const std::string& place) {
    return bench.ask("40 " + place + " 00 00 00 00").substr(12);
  }

  CountingManagerUnit* manager = nullptr;
  BusBench bench{units, [this](Environment& environment) {
                   environment.provide(Callback<CountingManagerSettings()>(
                       [](void*) { return CountingManagerSettings{.capacity = 50}; }, nullptr));
                   environment.watch(manager);
                 }};
};

TEST_F(Manager, AddsUpWhatEachDoorTells) {
  count("00", "14");
  count("02", "0A");
  EXPECT_EQ(ask("21 67 01"), "1E 00 00 00");
  EXPECT_EQ(ask("21 67 02"), "02 00 00 00");
  EXPECT_EQ(ask("22 67 00"), "1C 00 00 00");
  EXPECT_EQ(ask("23 67 00"), "38 00 00 00") << "28 of 50 are 56 %";
  EXPECT_EQ(bench.cable.last(0x285), "285#1C 00 38");
}

TEST_F(Manager, TakesTheMessagesOfSeveralDoors) {
  bench.ask("23 01 14 01 94 02 00 00");  // 1401h to 1404h: doors
  bench.ask("23 02 14 01 95 02 00 00");
  EXPECT_EQ(bench.ask("40 01 16 01 00 00 00 00"), "43 01 16 01 10 00 06 00")
      << "1401h is that of the doors' state";
  bench.ask("23 03 14 01 95 02 00 00");
  bench.cable.send("295#00 05");
  EXPECT_EQ(manager->aboard(), 5u + 5u) << "1402h and 1403h both take it";
}

TEST_F(Manager, TellsThatTheCarIsNearlyFullAndFull) {
  count("00", "2C");
  bench.cable.clear();
  count("00", "01");
  EXPECT_EQ(bench.cable.last(0x185), "185#01 00 00 00 01 00 00 15") << "90 %";
  count("00", "05");
  EXPECT_EQ(bench.cable.last(0x185), "185#01 00 00 00 03 00 00 15") << "100 %";
  count("32", "00");
  EXPECT_EQ(bench.cable.last(0x185), "185#00 00 00 00 00 00 00 00");
}

TEST_F(Manager, MoreWhoGetOffThanCameInLeaveNobody) {
  count("00", "05");
  count("09", "00");
  EXPECT_EQ(manager->aboard(), 0u);
  EXPECT_EQ(ask("21 67 02"), "09 00 00 00");
}

TEST_F(Manager, NobodyGetsOffBecauseOfAReset) {
  count("00", "05");
  bench.cable.send("000#81 05");
  EXPECT_EQ(ask("22 67 00"), "05 00 00 00");
  EXPECT_EQ(ask("21 67 01"), "05 00 00 00");
}

TEST_F(Manager, KeepsTheCountsOfEachStopWithTheLine) {
  const char* told[] = {"2F 0E 61 01 29 00 00 00", "2F 0E 61 02 5C 00 00 00",
                        "2F 0E 61 03 0B 00 00 00", "2F 0E 61 04 08 00 00 00",
                        "2F 0E 61 05 05 00 00 00", "2F 0E 61 06 00 00 00 00",
                        "2B 92 61 00 17 00 00 00", "2B 93 61 00 03 00 00 00",
                        "23 91 61 00 09 00 00 00", "23 09 61 00 4D 01 00 00"};
  for (const char* each : told) bench.ask(each);
  count("01", "05");
  count("02", "03");
  bench.ask("23 09 61 00 4E 01 00 00");
  count("04", "00");
  const std::string data = bench.upload(0x6720, 0);
  const std::string first(
      "\x29\x5C\x0B\x08\x05\x00\x17\x00\x03\x00\x09\x00\x00\x00\x4D\x01\x00\x00"
      "\x01\x00\x08\x00\x03\x00",
      24);
  ASSERT_EQ(data.size(), 48u);
  EXPECT_EQ(data.substr(0, 24), first);
  EXPECT_EQ(data.substr(38, 4), std::string("\x4E\x01\x00\x00", 4));
  EXPECT_EQ(data.substr(44, 4), std::string("\x00\x00\x04\x00", 4));
}

/// The message with the stop point has the events of others, too, and comes with each (8.1.4.3).
TEST_F(Manager, TheSameStopToldAgainIsOneRecord) {
  const char* seventh = "23 09 61 00 07 00 00 00";
  bench.ask(seventh);
  count("00", "02");
  bench.ask(seventh);
  count("01", "03");
  std::string data = bench.upload(0x6720, 0);
  ASSERT_EQ(data.size(), 24u);
  EXPECT_EQ(data.substr(20, 4), std::string("\x05\x00\x01\x00", 4));
  bench.ask("23 09 61 00 08 00 00 00");
  bench.ask(seventh);
  count("00", "01");
  EXPECT_EQ(bench.upload(0x6720, 0).size(), 48u) << "it was elsewhere meanwhile";
}

TEST_F(Manager, OfMoreStopsThanItKeepsTheOldestGo) {
  for (unsigned stop = 1; stop <= 130; ++stop) {
    char request[40];
    std::snprintf(request, sizeof request, "23 09 61 00 %02X 00 00 00", stop);
    bench.ask(request);
    count("00", "01");
  }
  const std::string data = bench.upload(0x6720, 0);
  ASSERT_EQ(data.size(), 128u * 24);
  EXPECT_EQ(data[14], 3) << "stop 3 is the oldest";
  EXPECT_EQ(static_cast<unsigned char>(data[127 * 24 + 14]), 130);
}

class CounterAndManager : public testing::Test {
 protected:
  static constexpr const BusUnit* units[] = {&bus_unit<PassengerCounterKind>,
                                             &bus_unit<CountingManagerKind>};

  PassengerCounterUnit* counter = nullptr;
  CountingManagerUnit* manager = nullptr;
  BusBench bench{units, [this](Environment& environment) {
                   environment.watch(counter);
                   environment.watch(manager);
                 }};
};

/// 6.22: the values of all doors, those of other devices too.
TEST_F(CounterAndManager, TheCountsOfOtherDoorsAreTaken) {
  counter->set_door(true);
  counter->count_in(3);
  counter->set_door(false);
  EXPECT_EQ(manager->aboard(), 3u);
  EXPECT_EQ(bench.ask("2B 00 67 00 00 02 00 00"), "60 00 67 00 00 00 00 00");
  EXPECT_EQ(manager->aboard(), 5u);
  EXPECT_EQ(bench.ask("40 00 67 00 00 00 00 00"), "4B 00 67 00 00 03 00 00") << "its own door";
}

TEST_F(CounterAndManager, ADoorsMessageIsTaken) {
  unsigned taken = 0;
  for (const char* number : {"00", "01", "02", "03", "04", "05", "06", "07", "08", "09", "0A"}) {
    const std::string mapped =
        bench.ask("40 " + std::string(number) + " 16 01 00 00 00 00").substr(12);
    if (mapped != "10 00 00 67" || taken != 0) continue;
    bench.ask("23 " + std::string(number) + " 14 01 94 02 00 00");
    ++taken;
  }
  EXPECT_EQ(taken, 1u);
  counter->set_door(true);
  counter->count_in(3);
  counter->set_door(false);
  bench.cable.run_for(0s);
  EXPECT_EQ(bench.cable.last(0x285), "285#00 03");
  bench.cable.clear();
  bench.cable.send("294#00 05");
  EXPECT_EQ(manager->aboard(), 8u);
  EXPECT_EQ(bench.cable.last(0x485), "485#08 00 0A") << "of 80";
  EXPECT_EQ(bench.ask("40 00 67 00 00 00 00 00"), "4B 00 67 00 00 03 00 00");
  EXPECT_EQ(bench.cable.count(0x285), 0u) << "its own door has counted nobody more";
}

}  // namespace
}  // namespace canvoy::cia407::counting_test
