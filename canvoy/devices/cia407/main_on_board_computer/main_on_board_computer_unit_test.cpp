// The main on-board computer and identification at their wire. Frames are those of 8.1.4.3, what is
// previous is that of table 1.
#include "canvoy/devices/cia407/main_on_board_computer/main_on_board_computer_unit.hpp"

#include <gtest/gtest.h>

#include "canvoy/devices/cia407/kit/bus_bench_test.hpp"
#include "canvoy/devices/cia407/main_on_board_computer/identification_unit.hpp"
#include "canvoy/devices/cia407/passenger_information/passenger_information_unit.hpp"
#include "canvoy/devices/cia407/passenger_information/shown_texts_test.hpp"

namespace canvoy::cia407::main_on_board_computer_unit_test {
namespace {

class Computer : public testing::Test {
 protected:
  static constexpr const BusUnit* units[] = {&bus_unit<MainOnBoardComputerKind>};

  std::optional<CivilTime> clock() {
    if (!has_time) return std::nullopt;
    const auto passed =
        std::chrono::duration_cast<std::chrono::seconds>(bench.cable.now.time_since_epoch());
    return cia447::civil_time(begin + passed.count());
  }
  std::optional<double> warmth() { return cabin_celsius; }
  void heard(unsigned number, std::uint32_t event) { events.emplace_back(number, event); }
  MainOnBoardComputerHardware hardware() {
    return {.clock = callback<&Computer::clock>(*this),
            .inside_temperature = callback<&Computer::warmth>(*this),
            .on_event = callback<&Computer::heard>(*this)};
  }
  MainOnBoardComputerSettings settings() {
    return {.vehicle_id = 4711,
            .body_id = 12,
            .garage_id = 3,
            .radio_id = 99,
            .vehicle_class = VehicleClass::tram,
            .vehicle_units = 2,
            .vehicle_id_text = "Bus 4711",
            .body_id_text = "Body",
            .garage_id_text = "Garage",
            .radio_id_text = "Radio"};
  }
  void run(Duration duration) { bench.cable.run_for(duration); }
  void settle() { bench.cable.run_for(0s); }

  bool has_time = true;
  std::optional<double> cabin_celsius;
  // 2026-11-23 08:05:37.
  std::int64_t begin = cia447::seconds_since_1970(
      {.year = 2026, .month = 11, .day = 23, .hour = 8, .minute = 5, .second = 37});
  std::vector<std::pair<unsigned, std::uint32_t>> events;
  MainOnBoardComputerUnit* computer = nullptr;
  BusBench bench{units,
                 [this](Environment& environment) {
                   environment.provide(callback<&Computer::hardware>(*this));
                   environment.provide(callback<&Computer::settings>(*this));
                   environment.watch(computer);
                 },
                 1};
};

TEST_F(Computer, SendsEachMessageOnceWhenItIsOperational) {
  for (const std::uint32_t id : {0x181U, 0x381U, 0x401U, 0x481U, 0x501U}) {
    EXPECT_EQ(bench.cable.count(id), 1u) << std::hex << id;
  }
  // 2026 is 29h, the 23rd 5Ch quarters, 08:05, 37 s are 94h quarters.
  EXPECT_EQ(bench.cable.last(0x181), "181#29 5C 0B 08 05 94");
  EXPECT_EQ(bench.cable.last(0x381), "381#00 00 00 00 01 01") << "forward by default, first stop";
}

TEST_F(Computer, TellsTheTimeAtEachFullMinute) {
  bench.cable.clear();
  run(22s);
  EXPECT_EQ(bench.cable.count(0x181), 0u);
  run(1s);
  EXPECT_EQ(bench.cable.count(0x181), 1u);
  EXPECT_EQ(bench.cable.last(0x181), "181#29 5C 0B 08 06 00");
  run(5min);
  EXPECT_EQ(bench.cable.count(0x181), 6u);
  EXPECT_EQ(bench.cable.last(0x181), "181#29 5C 0B 08 0B 00");
}

TEST_F(Computer, AClockThatIsNotSetSaysSo) {
  has_time = false;
  computer->clock_changed();
  settle();
  EXPECT_EQ(bench.cable.last(0x181), "181#FF FF FF FF FF FF");
  has_time = true;
  run(1s);
  EXPECT_EQ(bench.cable.last(0x181), "181#29 5C 0B 08 05 98") << "as soon as it is";
}

/// Seconds are 0 to 59.75 (9.2.6.15): 23:59:60 is sent as 23:59:59, and the new year in time.
TEST(ComputerClock, ALeapSecondIsTheSecondBeforeIt) {
  static constexpr const BusUnit* units[] = {&bus_unit<MainOnBoardComputerKind>};
  CivilTime time = {.year = 2026, .month = 12, .day = 31, .hour = 23, .minute = 59};
  auto clock = [&time] { return std::optional(time); };
  auto hardware = [&clock] {
    return MainOnBoardComputerHardware{.clock = Callback<std::optional<CivilTime>()>::of(clock)};
  };
  const auto prepare = [&](Environment& environment) {
    environment.provide(Callback<MainOnBoardComputerHardware()>::of(hardware));
  };
  BusBench bench(units, prepare, 1);
  EXPECT_EQ(bench.cable.last(0x181), "181#29 7C 0C 17 3B 00");
  bench.cable.run_for(59s);
  time.second = 60;
  bench.cable.run_for(1s);
  EXPECT_EQ(bench.cable.last(0x181), "181#29 7C 0C 17 3B EC");
  time = {.year = 2027, .month = 1, .day = 1};
  bench.cable.run_for(1s);
  EXPECT_EQ(bench.cable.last(0x181), "181#2A 04 01 00 00 00");
  time.minute = 1;
  bench.cable.run_for(1min);
  EXPECT_EQ(bench.cable.last(0x181), "181#2A 04 01 00 01 00") << "and the next full minute";
}

/// A year that the objects cannot hold is no time: what follows is seen within a second.
TEST_F(Computer, ATimeThatCannotBeToldIsLookedAtAgainSoon) {
  begin = 0;  // 1970
  computer->clock_changed();
  settle();
  EXPECT_EQ(bench.cable.last(0x181), "181#FF FF FF FF FF FF");
  begin = cia447::seconds_since_1970({.year = 2026, .month = 11, .day = 23, .hour = 8});
  run(1s);
  EXPECT_EQ(bench.cable.last(0x181), "181#29 5C 0B 08 00 04");
}

TEST_F(Computer, TellsWhatIsPreviousAsTable1HasIt) {
  const auto previous = [this] {
    return std::pair(computer->device()[previous_fare_zone].raw(),
                     computer->device()[previous_route_segment].raw());
  };
  computer->begin_route({.stop_point_id = 1, .fare_zone = 1, .route_segment = 1});
  EXPECT_EQ(previous(), (std::pair<std::uint8_t, std::uint16_t>(0, 0)));
  computer->set_position(
      {.stop_point_id = 2, .number_of_running = 2, .fare_zone = 1, .route_segment = 2});
  EXPECT_EQ(previous(), (std::pair<std::uint8_t, std::uint16_t>(0, 1)));
  settle();
  EXPECT_EQ(bench.cable.last(0x381), "381#02 00 01 00 01 02");
  EXPECT_EQ(bench.cable.last(0x401), "401#02 00 00 00 00 00 00 00");
  computer->set_position({.stop_point_id = 3, .fare_zone = 2, .route_segment = 1});
  EXPECT_EQ(previous(), (std::pair<std::uint8_t, std::uint16_t>(1, 2)));
  computer->set_position({.stop_point_id = 4, .fare_zone = 2, .route_segment = 2});
  EXPECT_EQ(previous(), (std::pair<std::uint8_t, std::uint16_t>(1, 1)));
}

TEST_F(Computer, NamesAndBlockingGoOutOnChange) {
  bench.cable.clear();
  computer->set_line_name("U8");
  computer->set_stop_name("CENTRAL STATION");
  computer->block_tickets(true);
  settle();
  EXPECT_EQ(bench.cable.last(0x481), "481#55 38 00 00 00 00 00 00");
  EXPECT_EQ(bench.cable.last(0x501), "501#43 45 4E 54 52 41 4C 20") << "8 characters";
  EXPECT_EQ(bench.cable.last(0x381), "381#00 00 00 80 01 01");
  computer->block_tickets(true);
  settle();
  EXPECT_EQ(bench.cable.count(0x381), 1u);
}

TEST_F(Computer, SaysWhoTheVehicleIsAfterEachReset) {
  EXPECT_EQ(bench.ask("40 00 61 00 00 00 00 00"), "43 00 61 00 67 12 00 00");
  bench.cable.send("000#81 01");
  EXPECT_EQ(bench.ask("40 00 61 00 00 00 00 00"), "43 00 61 00 67 12 00 00");
  EXPECT_EQ(bench.upload(0x611C, 0), "Bus 4711");
  EXPECT_EQ(bench.ask("40 01 61 00 00 00 00 00"), "4B 01 61 00 0C 00 00 00");
  EXPECT_EQ(bench.ask("40 02 61 00 00 00 00 00"), "4B 02 61 00 03 00 00 00");
  EXPECT_EQ(bench.ask("40 03 61 00 00 00 00 00"), "43 03 61 00 63 00 00 00");
  EXPECT_EQ(bench.ask("40 05 61 00 00 00 00 00"), "4F 05 61 00 02 00 00 00");
  EXPECT_EQ(bench.upload(0x611D, 0), "Body");
  EXPECT_EQ(bench.upload(0x611E, 0), "Garage");
  EXPECT_EQ(bench.upload(0x611F, 0), "Radio");
}

/// 611Ah and 611Bh are the values of the vehicle gateway; 6115h and 6119h those of the device's own
/// hardware: 23 days are 5Ch quarters, 30 s 78h, 21.5 degrees D7h tenths.
TEST_F(Computer, TellsMileageTemperatureAndTheScheduledTime) {
  bench.ask("23 82 64 00 E8 03 00 00");
  EXPECT_EQ(bench.ask("40 1A 61 00 00 00 00 00"), "43 1A 61 00 E8 03 00 00");
  bench.ask("2B 83 64 00 02 00 00 00");
  EXPECT_EQ(bench.ask("40 1B 61 00 00 00 00 00"), "4B 1B 61 00 02 00 00 00");
  cabin_celsius = 21.5;
  run(1min);
  EXPECT_EQ(bench.ask("40 19 61 00 00 00 00 00"), "4B 19 61 00 D7 00 00 00");
  computer->set_scheduled(
      {.year = 2026, .month = 11, .day = 23, .hour = 8, .minute = 7, .second = 30});
  const char* expected[] = {"29", "5C", "0B", "08", "07", "78"};
  for (unsigned sub = 1; sub <= 6; ++sub) {
    const std::string at = "0" + std::to_string(sub);
    EXPECT_EQ(bench.ask("40 15 61 " + at + " 00 00 00 00"),
              "4F 15 61 " + at + " " + expected[sub - 1] + " 00 00 00");
  }
}

TEST_F(Computer, TakesIdentification) {
  bench.cable.send("301#09 00 00 00 03 00");
  bench.cable.send("281#44 33 22 11 17 00 05 00");
  EXPECT_EQ(computer->device()[destination_number].raw(), 9u);
  EXPECT_EQ(computer->device()[route_number].raw(), 3);
  EXPECT_EQ(computer->device()[line_id].raw(), 23);
  EXPECT_EQ(computer->device()[journey_number].raw(), 5);
}

TEST_F(Computer, SumsUpTheEventsOfOthersAndPassesThemOn) {
  // The second of its own RPDOs takes events of the second device (1404h: number 5).
  bench.ask("23 04 14 01 85 01 00 00");
  bench.cable.clear();
  bench.cable.send("185#01 00 00 00 01 00 00 04");
  EXPECT_EQ(bench.cable.last(0x401), "401#00 00 00 00 02 00 00 00");
  EXPECT_EQ(events, (std::vector<std::pair<unsigned, std::uint32_t>>{{2, 0x04000001}}));
  bench.cable.send("185#00 00 00 00 00 00 00 00");
  EXPECT_EQ(bench.cable.last(0x401), "401#00 00 00 00 00 00 00 00");
}

TEST_F(Computer, ACommandStandsInItsEntry) {
  computer->command(3, DeviceCode::tachograph, 2, 0x0001);
  EXPECT_EQ(bench.ask("40 02 60 03 00 00 00 00"), "43 02 60 03 02 01 00 0C");
  computer->command(3, DeviceCode::tachograph, 0);
  EXPECT_EQ(bench.ask("40 02 60 03 00 00 00 00"), "43 02 60 03 00 00 00 00");
}

TEST_F(Computer, OpenDoorsEndARequestToStop) {
  computer->request_stop();
  EXPECT_EQ(bench.ask("40 04 62 00 00 00 00 00"), "4F 04 62 00 01 00 00 00");
  EXPECT_EQ(bench.ask("2F 88 64 01 80 00 00 00"), "60 88 64 01 00 00 00 00");
  EXPECT_EQ(bench.ask("40 04 62 00 00 00 00 00"), "4F 04 62 00 00 00 00 00");
}

// The request is for the next station (9.2.8.5), not for that of doors which are already open.
TEST_F(Computer, ARequestWhileDoorsAreOpenIsForTheNextStop) {
  const auto is_requested = [this] { return bench.ask("40 04 62 00 00 00 00 00").substr(12, 2); };
  bench.ask("2F 88 64 01 80 00 00 00");
  bench.ask("2F 88 64 02 C0 00 00 00");  // door 1
  computer->request_stop();
  settle();
  EXPECT_EQ(bench.cable.last(0x1C1), "1C1#01");
  bench.ask("2F 88 64 02 F0 00 00 00");  // and door 2
  bench.ask("2F 88 64 01 80 00 00 00");
  EXPECT_EQ(is_requested(), "01");
  bench.ask("2F 88 64 02 50 00 00 00");
  bench.ask("2F 88 64 01 00 00 00 00");
  EXPECT_EQ(is_requested(), "01") << "doors close";
  bench.ask("2F 88 64 01 80 00 00 00");
  EXPECT_EQ(is_requested(), "00") << "the next stop";
}

/// Doors that were open before a reset of the node may have closed meanwhile: the first message
/// that they are open is that of a stop.
TEST_F(Computer, AfterAResetOfTheNodeOpenDoorsEndTheRequestThatCameSince) {
  bench.ask("2F 88 64 01 80 00 00 00");
  bench.cable.send("000#81 01");
  bench.cable.send("000#01 01");
  computer->request_stop();
  settle();
  EXPECT_EQ(bench.cable.last(0x1C1), "1C1#01");
  bench.ask("2F 88 64 01 80 00 00 00");
  EXPECT_EQ(bench.cable.last(0x1C1), "1C1#00");
}

// 6204h is TRUE or FALSE (9.2.8.5), in a message of its own (8.1.5) that no network has to set up.
TEST_F(Computer, ARequestToStopIsSentWithoutBeingConfigured) {
  bench.cable.clear();
  computer->request_stop();
  settle();
  EXPECT_EQ(bench.cable.last(0x1C1), "1C1#01");
  bench.ask("2F 88 64 01 80 00 00 00");  // a door opens
  EXPECT_EQ(bench.cable.last(0x1C1), "1C1#00");
  EXPECT_EQ(bench.cable.count(0x1C1), 2u);
}

TEST_F(Computer, ItsSpeedIsTheFirstThatIsKnown) {
  bench.ask("2B 62 66 00 64 00 00 00");  // 10 m/s by GPS
  EXPECT_EQ(bench.ask("40 23 61 00 00 00 00 00"), "4B 23 61 00 00 24 00 00") << "36 km/h";
  bench.ask("2B 20 65 00 00 1E 00 00");  // 30 km/h by tachograph
  EXPECT_EQ(bench.ask("40 23 61 00 00 00 00 00"), "4B 23 61 00 00 1E 00 00");
  bench.ask("2B 62 66 00 00 00 00 00");
  EXPECT_EQ(bench.ask("40 23 61 00 00 00 00 00"), "4B 23 61 00 00 1E 00 00");
}

/// 6123h has no code for "not known"; no speed by satellites has been received (9.2.6.36).
TEST_F(Computer, ItsSpeedStaysWhereNoneIsKnownAnyMore) {
  bench.ask("2B 81 64 00 00 32 00 00");
  for (const char* lost : {"2B 81 64 00 FF FF 00 00", "2B 81 64 00 00 FE 00 00"}) {
    bench.ask(lost);
    EXPECT_EQ(bench.ask("40 23 61 00 00 00 00 00").substr(12), "00 32 00 00") << lost;
  }
  bench.ask("2B 62 66 00 00 00 00 00");  // the satellites say that it stands
  EXPECT_EQ(bench.ask("40 23 61 00 00 00 00 00").substr(12), "00 00 00 00");
  bench.ask("2B 81 64 00 00 14 00 00");
  EXPECT_EQ(bench.ask("40 23 61 00 00 00 00 00").substr(12), "00 14 00 00");
  bench.ask("2B 81 64 00 FF FF 00 00");
  EXPECT_EQ(bench.ask("40 23 61 00 00 00 00 00").substr(12), "00 00 00 00");
}

TEST_F(Computer, ASpeedBySatellitesIsForgottenAtAReset) {
  bench.ask("2B 62 66 00 00 00 00 00");
  bench.cable.send("000#81 00");
  settle();
  bench.ask("2B 81 64 00 00 32 00 00");
  bench.ask("2B 81 64 00 FF FF 00 00");
  EXPECT_EQ(bench.ask("40 23 61 00 00 00 00 00").substr(12), "00 32 00 00");
}

TEST_F(Computer, ATextOf128OctetsArrivesWholeBeforeItIsShown) {
  using NextStop = PassengerInformationKind<InformationClass::next_stop, InformationSubclass::text>;
  static constexpr const BusUnit* display_units[] = {&bus_unit<NextStop>};
  ShownTexts shown;
  Environment environment;
  environment.provide(callback<&ShownTexts::hardware>(shown));
  BusDevice display(display_units, bench.cable.port(1), 5, environment);
  bench.cable.connect(1, display.node());
  display.node().start(bench.cable.now);
  const std::string longest(128, 'M');
  const std::span octets(reinterpret_cast<const std::uint8_t*>(longest.data()), longest.size());
  EXPECT_TRUE(computer->texts().send(5, 0x6112, 1, octets));
  EXPECT_TRUE(computer->texts().send(5, 0x6203, 2, 0x00126101U));
  EXPECT_TRUE(computer->texts().send(5, 0x6203, 1, 1U));
  run(1s);
  EXPECT_EQ(shown.texts, (std::vector<std::string>{longest}));
  EXPECT_EQ(computer->texts().delivered(), 3u);
  EXPECT_FALSE(computer->texts().send(5, 0x6112, 1, std::vector<std::uint8_t>(129)));
}

TEST_F(Computer, ATextForNobodyIsTriedThreeTimes) {
  bench.cable.clear();
  std::vector<std::pair<NodeId, bool>> ended;
  auto end = [&ended](NodeId server, bool has_arrived) { ended.emplace_back(server, has_arrived); };
  computer->texts().on_done(Callback<void(NodeId, bool)>::of(end));
  EXPECT_TRUE(computer->texts().send(99, 0x6203, 1, 1U));
  run(10s);
  EXPECT_EQ(ended, (std::vector<std::pair<NodeId, bool>>{{99, false}}));
  EXPECT_EQ(bench.cable.count(0x663), 6u) << "three requests, each with its abort";
  EXPECT_EQ(computer->texts().failed(), 1u);
  EXPECT_TRUE(computer->texts().is_idle());
}

TEST(Identification, TellsWhoLogsIn) {
  static constexpr const BusUnit* units[] = {&bus_unit<IdentificationKind>};
  IdentificationUnit* unit = nullptr;
  auto made = [&](IdentificationUnit& of, Node&) { unit = &of; };
  BusBench bench(
      units,
      [&](Environment& environment) {
        environment.watch(Callback<void(IdentificationUnit&, Node&)>::of(made));
      },
      2);
  EXPECT_EQ(bench.cable.last(0x201), "201#00 00 00 00");
  bench.cable.clear();
  unit->log_in({.driver_id = 1234,
                .destination_number = 9,
                .line_id = 23,
                .route_number = 3,
                .block_id = 0x11223344,
                .journey_number = 5});
  bench.cable.run_for(0s);
  EXPECT_EQ(bench.cable.last(0x201), "201#D2 04 00 00");
  EXPECT_EQ(bench.cable.last(0x281), "281#44 33 22 11 17 00 05 00");
  EXPECT_EQ(bench.cable.last(0x301), "301#09 00 00 00 03 00");
  EXPECT_EQ(bench.cable.count(0x281), 1u) << "three changes are one message";
}

}  // namespace
}  // namespace canvoy::cia407::main_on_board_computer_unit_test
