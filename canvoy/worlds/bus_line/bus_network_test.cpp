// Days of a bus: all invariants hold without a fault, and after each. The built-in line begins at
// 5:00, with a journey every 20 minutes; time 0 is 4:55.
#include "canvoy/worlds/bus_line/bus_network.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <string>
#include <vector>

#include "canvoy/can/testing/tries_all.hpp"
#include "canvoy/worlds/bus_line/bus_day_test.hpp"

namespace canvoy::bus_line::bus_network_test {
namespace {

template <class What>
std::vector<What> all_of(const BusNetwork& network) {
  std::vector<What> found;
  for (const NetworkEvent& event : network.events()) {
    if (const auto* what = std::get_if<What>(&event.what)) found.push_back(*what);
  }
  return found;
}

/// The last journey of a day, 20 minutes after which the clocks of Central Europe are set, in s of
/// UTC. It begins at 24:00 in the timetable, and this much later here; time 0 is five minutes
/// earlier.
BusNetworkOptions night(std::chrono::year_month_day date, EpochSeconds set_at, Duration later,
                        std::int64_t hours_before, std::int64_t hours_after) {
  constexpr std::int64_t hour = 3600;
  BusNetworkOptions options = with_seed(1);
  options.date = date;
  options.clock = LocalClock({{.since = 0, .offset = hours_before * hour},
                              {.since = set_at, .offset = hours_after * hour}});
  auto& journeys = options.line.blocks.front().journeys;
  journeys.erase(journeys.begin(), journeys.end() - 1);
  for (Passing& passing : journeys.front().passings) {
    passing.arrival += later;
    passing.departure += later;
  }
  return options;
}

/// `3-29 1:59`
std::string clock_text(const cia407::CivilTime& time) {
  return std::to_string(time.month) + "-" + std::to_string(time.day) + " " +
         std::to_string(time.hour) + ":" + std::to_string(time.minute);
}

std::string clock_of(BusNetwork& network) {
  return clock_text(network.snapshot().local_time);
}

/// 610Eh as received by the ticket canceller.
std::string reported_clock(BusNetwork& network) {
  const auto time = cia407::local_time(Values(network.node(canceller_id).node().dictionary()));
  return time ? clock_text(*time) : "none";
}

TEST(BusNetwork, SummerTimeBeginsInTheNight) {
  // 2026-03-29 01:00 UTC is 26:00 of the 28th.
  BusNetwork network(night(std::chrono::year(2026) / 3 / 28, 1'774'746'000, 1h + 40min, 1, 2));
  network.run_until(Time(24min + 30s));
  EXPECT_EQ(clock_of(network), "3-29 1:59");
  EXPECT_EQ(reported_clock(network), "3-29 1:59");
  network.run_until(Time(25min + 5s));
  EXPECT_EQ(clock_of(network), "3-29 3:0");
  EXPECT_EQ(reported_clock(network), "3-29 3:0");
  network.run_until(Time(35min));
  EXPECT_EQ(broken(network), "");
}

TEST(BusNetwork, SummerTimeEndsInTheNight) {
  // 2026-10-25 01:00 UTC is 27:00 of the 24th: the hour from 2:00 on comes twice.
  BusNetwork network(night(std::chrono::year(2026) / 10 / 24, 1'792'890'000, 2h + 40min, 2, 1));
  network.run_until(Time(24min + 30s));
  EXPECT_EQ(reported_clock(network), "10-25 2:59");
  network.run_until(Time(25min + 5s));
  EXPECT_EQ(reported_clock(network), "10-25 2:0");
  network.run_until(Time(35min));
  EXPECT_EQ(broken(network), "");
}

// The times of a timetable count from twelve hours before noon.
TEST(BusNetwork, OnTheDayAfterItTheTimetableGoesByTheNewTime) {
  BusNetworkOptions options = with_seed(1);
  options.date = std::chrono::year(2026) / 3 / 29;
  options.clock =
      LocalClock({{.since = 0, .offset = 3600}, {.since = 1'774'746'000, .offset = 7200}});
  BusNetwork network(options);
  network.run_until(Time(5min));
  EXPECT_EQ(clock_of(network), "3-29 5:0");
  EXPECT_EQ(network.snapshot().utc, 1'774'753'200) << "03:00 UTC";
}

TEST(BusNetwork, DisplaysFollowTheBusAlongItsRoute) {
  BusNetwork network(with_seed(1));
  network.run_until(Time(4min));
  EXPECT_EQ(network.display(front_display_id).text(), "407\nHarbour");
  EXPECT_EQ(network.display(side_display_id).text(), "407\nHarbour");
  EXPECT_EQ(network.display(next_stop_id).text(), "Central Station");
  EXPECT_EQ(network.display(information_id).text(),
            "407 to Harbour: Market Square, Town Hall, Old Bridge, School, Hospital, Garden City");
  // The second journey begins when all are out of the first one, and departs at 5:20.
  network.run_until(Time(30min));
  EXPECT_EQ(broken(network), "");
  std::vector<std::string> read;
  for (const DisplayShows& shown : all_of<DisplayShows>(network)) {
    if (shown.node == next_stop_id && !shown.text.empty()) read.push_back(shown.text);
  }
  const std::vector<std::string> there = {"Central Station", "Market Square", "Town Hall",
                                          "Old Bridge",      "School",        "Hospital",
                                          "Garden City",     "Harbour",       "Garden City"};
  ASSERT_GE(read.size(), there.size());
  read.resize(there.size());
  EXPECT_EQ(read, there);
  EXPECT_EQ(network.display(front_display_id).text(), "407\nCentral Station");
}

TEST(BusNetwork, TheSecondCarMirrorsTheFirst) {
  BusNetwork network(with_seed(1));
  network.run_until(Time(4min));
  EXPECT_EQ(network.display(destination_of(2)).text(), "407\nHarbour");
  EXPECT_EQ(network.display(next_stop_of(2)).text(), "Central Station");
  network.run_until(Time(30min));
  std::vector<std::string> first;
  std::vector<std::string> second;
  for (const DisplayShows& shown : all_of<DisplayShows>(network)) {
    if (shown.text.empty()) continue;
    if (shown.node == next_stop_id) first.push_back(shown.text);
    // Where a journey begins, the display is dark for a moment, until all texts have arrived.
    const bool is_again = !second.empty() && second.back() == shown.text;
    if (shown.node == next_stop_of(2) && !is_again) second.push_back(shown.text);
  }
  EXPECT_GT(second.size(), 8u);
  EXPECT_EQ(second, first);
  EXPECT_EQ(network.display(destination_of(2)).text(), "407\nCentral Station");
  // Its announcer has announced the same stops.
  std::vector<std::uint32_t> said[2];
  for (const Announced& each : all_of<Announced>(network)) {
    said[each.car - 1].push_back(each.stop_point);
  }
  EXPECT_GT(said[0].size(), 8u);
  EXPECT_EQ(said[1], said[0]);
}

/// The gateway sends them where there is no main on-board computer (8.1.4.3).
TEST(BusNetwork, TheSecondCarHasThePredefinedMessages) {
  BusNetwork network(with_seed(1));
  struct Seen {
    Frame time, stop, block;
  } seen;
  network.world().bus(1).observe(
      {.context = &seen, .on_frame = [](void* self, Time, ControllerId, const Frame& frame) {
         auto& kept = *static_cast<Seen*>(self);
         if (frame.id == 0x181) kept.time = frame;
         if (frame.id == 0x401) kept.stop = frame;
         if (frame.id == 0x281) kept.block = frame;
       }});
  network.run_until(Time(4min + 1s));
  // 4:59 on 2026-11-23, of SAE J1939: 41 years since 1985, quarters of days.
  EXPECT_EQ(seen.time, Frame::data_frame(0x181, {41, 92, 11, 4, 59, 0}));
  const std::uint32_t stop = network.vehicle().truth().stop->number;
  EXPECT_EQ(seen.stop,
            Frame::data_frame(0x401, {static_cast<std::uint8_t>(stop), 0, 0, 0, 0, 0, 0, 0}));
  EXPECT_EQ(seen.block.length, 8u);
  EXPECT_EQ(seen.block.data[0], 1) << "block";
}

TEST(BusNetwork, TheSecondCarIsDarkWithoutTheTrainBus) {
  BusNetworkOptions options = with_seed(1);
  options.faults.faults = {
      {.kind = FaultKind::train_bus_cut, .start = Time(10min), .duration = 5min}};
  BusNetwork network(options);
  network.run_until(Time(10min) - 1us);
  EXPECT_FALSE(network.display(next_stop_of(2)).text().empty());
  // No message is received for 300 ms, which is checked each 100 ms and reported by SDO.
  network.run_until(Time(10min + 600ms));
  EXPECT_EQ(network.display(next_stop_of(2)).text(), "");
  EXPECT_EQ(network.display(destination_of(2)).text(), "");
  EXPECT_EQ(network.display(next_stop_id).text(), network.vehicle().truth().stop->name);
  network.run_until(Time(15min + 2s));
  EXPECT_EQ(network.display(next_stop_of(2)).text(), network.vehicle().truth().stop->name);
  EXPECT_EQ(broken(network), "");
}

TEST(BusNetwork, TheSecondCarIsDarkWithoutTheComputerOfTheFirst) {
  BusNetworkOptions options = with_seed(1);
  options.faults.faults = {{.start = Time(10min), .duration = 5min, .node = computer_id}};
  BusNetwork network(options);
  // The gateway misses the heartbeat after 1.2 s, like the displays of the first car.
  network.run_until(Time(10min + 1900ms));
  EXPECT_EQ(network.display(next_stop_of(2)).text(), "");
  EXPECT_EQ(network.display(destination_of(2)).text(), "");
}

std::size_t signs_lit(const BusNetwork& network, unsigned car) {
  const auto all = all_of<StopSignLit>(network);
  return static_cast<std::size_t>(std::ranges::count_if(
      all, [car](const StopSignLit& sign) { return sign.is_lit && sign.car == car; }));
}

/// 6204h: from the computer on 1C1h, and from the train bus gateway on 180h + 30.
TEST(BusNetwork, WhoPressesInTheSecondCarIsHeardAndShownInBoth) {
  BusNetwork network(with_seed(1));
  struct Seen {
    bool is_requested = false;
    unsigned by_train = 0;
  } seen;
  network.world().bus(0).observe(
      {.context = &seen, .on_frame = [](void* self, Time, ControllerId, const Frame& frame) {
         auto& kept = *static_cast<Seen*>(self);
         if (frame.id == 0x1C1) kept.is_requested = frame.data[0] == 1;
         if (frame.id == 0x19E && frame.data[0] == 1 && !kept.is_requested) ++kept.by_train;
       }});
  network.run_until(Time(40min));
  EXPECT_GT(seen.by_train, 0u);
  EXPECT_GT(signs_lit(network, 1), seen.by_train);
  EXPECT_EQ(signs_lit(network, 2), signs_lit(network, 1));
  EXPECT_EQ(broken(network), "");
}

TEST(BusNetwork, WithoutTheTrainBusPeopleOfTheSecondCarGoForwardToPress) {
  BusNetworkOptions options = with_seed(1);
  options.faults.faults = {{.kind = FaultKind::train_bus_cut, .duration = 4h}};
  options.vehicle.riders.behind_every = 1;  // all riders
  BusNetwork network(options);
  network.run_until(Time(45min));
  EXPECT_EQ(signs_lit(network, 2), 0u);
  EXPECT_GT(signs_lit(network, 1), 5u);
  EXPECT_EQ(network.vehicle().riders().statistics().carried_past, 0u);
  EXPECT_EQ(broken(network), "");
}

/// The gateway keeps 6204h while the computer is lost, and the requested stop passes.
TEST(BusNetwork, AComputerThatComesBackTakesNoOldRequestOfTheTrain) {
  BusNetworkOptions options = with_seed(1);
  options.faults.faults = {{.start = Time(9min + 30s), .duration = 2min, .node = computer_id}};
  BusNetwork network(options);
  network.run_until(Time(9min + 29s));
  EXPECT_TRUE(network.display(next_stop_of(2)).is_sign_lit());
  network.run_until(Time(11min + 40s));
  EXPECT_TRUE(network.node(computer_id).is_operational());
  EXPECT_FALSE(network.display(next_stop_id).is_sign_lit());
  EXPECT_FALSE(network.display(next_stop_of(2)).is_sign_lit());
}

/// A passenger requested a stop while the cable was cut, and has reached it long ago.
TEST(BusNetwork, AComputerThatHearsTheTrainAgainTakesNoOldRequest) {
  BusNetworkOptions options = with_seed(1);
  options.faults.faults = {{.kind = FaultKind::cable_cut, .start = Time(13min), .duration = 12min}};
  BusNetwork network(options);
  network.run_until(Time(25min + 20s));
  EXPECT_TRUE(network.node(train_gateway_id).is_operational());
  EXPECT_FALSE(network.display(next_stop_id).is_sign_lit());
  EXPECT_FALSE(network.display(next_stop_of(2)).is_sign_lit());
  EXPECT_EQ(broken(network), "");
}

TEST(BusNetwork, PeopleAreCarriedAndCountedAndHaveTickets) {
  BusNetwork network(with_seed(2));
  network.run_until(Time(1h));
  EXPECT_EQ(broken(network), "");
  const BusNetworkSnapshot now = network.snapshot();
  EXPECT_GT(now.riders.in, 15u);
  EXPECT_EQ(now.riders.carried_past, 0u);
  EXPECT_EQ(now.riders.in - now.riders.out, now.truth.aboard);
  const auto tickets = all_of<TicketIssued>(network);
  EXPECT_EQ(static_cast<std::size_t>(std::ranges::count(tickets, true, &TicketIssued::is_printed)),
            now.riders.bought);
  EXPECT_EQ(static_cast<std::size_t>(std::ranges::count(tickets, false, &TicketIssued::is_printed)),
            now.riders.cancelled);
  EXPECT_GT(now.statistics.announced, 15u);
}

TEST(BusNetwork, TheDayEndsWithItsBlock) {
  BusNetworkOptions options = with_seed(3);
  options.line.blocks[0].journeys.resize(2);
  BusNetwork network(options);
  // The last arrival is at 5:36, the run goes on for ten minutes, and it begins at 4:55.
  EXPECT_EQ(network.end(), Time(51min));
  network.run_until(network.end());
  EXPECT_EQ(all_of<BlockEnded>(network).size(), 1u);
  EXPECT_EQ(broken(network), "");
  EXPECT_EQ(network.snapshot().state, BusState::over);
}

TEST(BusNetwork, TheSameOptionsGiveTheSameDay) {
  BusNetwork one(with_seed(4));
  BusNetwork other(with_seed(4));
  one.run_until(Time(15min));
  other.run_until(Time(15min));
  EXPECT_EQ(one.world().bus().statistics().frames, other.world().bus().statistics().frames);
  EXPECT_EQ(one.events().size(), other.events().size());
}

/// ISO 8859-1 inside, ISO 646-US outside, where a display has no character sets (6.4).
TEST(BusNetwork, NamesAreShownAsTheDisplaysCan) {
  BusNetworkOptions options = with_seed(1);
  options.line.stops.front().name = "Bärenplatz";
  options.line.routes[0].destination = "Zürich Löwenstraße";
  BusNetwork network(options);
  network.run_until(Time(4min));
  EXPECT_EQ(network.display(next_stop_id).text(), "Bärenplatz");
  EXPECT_EQ(network.display(front_display_id).text(), "407\nZurich Lowenstrasse");
  EXPECT_EQ(broken(network), "");
}

/// Octets of a text in the display with this node-ID.
std::string octets_at(BusNetwork& network, NodeId id, std::uint16_t index, std::uint8_t sub) {
  const Result<Entry> entry = network.node(id).node().dictionary().find(index, sub);
  const auto bytes = entry ? entry->bytes() : std::span<const std::uint8_t>();
  return {bytes.begin(), bytes.end()};
}

std::uint32_t selected_set(BusNetwork& network, NodeId id) {
  return network.node(id).node().dictionary().word(0x6205, 1);
}

/// Each text has a set with all its letters; outside they are Latin ones. ISO 8859-2 has L with a
/// stroke at A3h, o with an acute at F3h, z with an acute at BCh; 8859-5 has capital letters from
/// B0h on, small ones from D0h on; 8859-7 capital alpha at C1h, theta at E8h, eta with tonos at
/// DEh.
TEST(BusNetwork, EachTextHasACharacterSetOfItsDisplay) {
  BusNetworkOptions options = with_seed(1);
  options.line.stops[0].name = "\u0141\u00F3d\u017A";
  options.line.stops[1].name = "\u041F\u0430\u0440\u043A";
  options.line.stops[2].name = "\u0391\u03B8\u03AE\u03BD\u03B1";
  options.line.stops[3].name = "L\u00F6wenplatz";
  options.line.routes[0].destination = "\u0416\u0438\u0442\u043E\u043C\u0438\u0440";
  BusNetwork network(options);
  network.run_until(Time(4min));
  EXPECT_EQ(selected_set(network, next_stop_id), 2u);
  EXPECT_EQ(octets_at(network, next_stop_id, 0x6112, 1),
            "\xA3\xF3"
            "d\xBC");
  EXPECT_EQ(network.display(next_stop_id).reading(), U"\u0141\u00F3d\u017A");
  EXPECT_EQ(network.display(next_stop_of(2)).text(), "L\u00F3dz") << "the train has Latin-1";
  EXPECT_EQ(network.display(front_display_id).text(), "407\nZhitomir");
  EXPECT_EQ(octets_at(network, next_stop_id, 0x6112, 2), "\xBF\xD0\xE0\xDA");
  EXPECT_EQ(octets_at(network, next_stop_id, 0x6112, 3), "\xC1\xE8\xDE\xED\xE1");
  EXPECT_EQ(octets_at(network, next_stop_id, 0x6112, 4), "L\xF6wenplatz");
  std::vector<std::uint32_t> sets;
  for (Time at(4min); at < Time(23min); at += 1s) {
    network.run_until(at);
    const std::uint32_t set = selected_set(network, next_stop_id);
    if (sets.empty() || sets.back() != set) sets.push_back(set);
  }
  EXPECT_EQ(sets, (std::vector<std::uint32_t>{2, 5, 7, 1}));
  EXPECT_EQ(broken(network), "");
}

/// A name of one word that is longer than 24 columns is cut, and so unreadable.
TEST(BusNetwork, AWordThatIsCutIsJudged) {
  BusNetworkOptions options = with_seed(1);
  options.line.stops.front().name = "Donaudampfschifffahrtsgesellschaft";
  BusNetwork network(options);
  network.run_until(Time(4min));
  EXPECT_EQ(broken(network), "next_stop second_car ");
}

/// No set of ISO 8859 has these letters: the text is sent in other letters, or is unreadable.
TEST(BusNetwork, ATextThatNoSetHasIsJudged) {
  BusNetworkOptions options = with_seed(1);
  options.line.stops.front().name = "\u5317\u4EAC";
  BusNetwork network(options);
  network.run_until(Time(4min));
  EXPECT_EQ(broken(network), "next_stop second_car ");
}

/// Names continue in the next line of 24 columns, and the sign shows two lines at a time.
TEST(BusNetwork, LongNamesAndAWayOfTwoStopsAreShown) {
  BusNetworkOptions options = with_seed(1);
  BusRoute& route = options.line.routes[0];
  route.stops.erase(route.stops.begin() + 1, route.stops.end() - 1);
  route.destination = "University Hospital, Children's Clinic, South Entrance and Car Park";
  Journey& journey = options.line.blocks[0].journeys[0];
  journey.passings.erase(journey.passings.begin() + 1, journey.passings.end() - 1);
  options.line.stops.front().name = "Museum of the History of the Country and of its Neighbours";
  BusNetwork network(options);
  network.run_until(Time(27min));
  EXPECT_EQ(broken(network), "");
}

/// Position on its path of a point: beside a street, at a corner, before its start.
TEST(BusPath, TheNearestPlaceOfAPointIsOnAPiece) {
  constexpr double degree_m = 111'195;  // of latitude, and of longitude at the equator
  const Path path({{0, 0}, {0, 0.01}, {0.01, 0.01}});
  EXPECT_NEAR(path.nearest_to({0.0001, 0.004}), 0.004 * degree_m, 0.1);
  EXPECT_NEAR(path.nearest_to({0.006, 0.0102}), 0.016 * degree_m, 0.1);
  EXPECT_NEAR(path.nearest_to({-0.001, 0.012}), 0.01 * degree_m, 0.1);
  EXPECT_EQ(path.nearest_to({0, -0.01}), 0);
  EXPECT_EQ(Path().nearest_to({1, 1}), 0);
}

TEST(BusNetwork, AComputerThatRestartsOnTheWayFindsItsPlaceAgain) {
  BusNetworkOptions options = with_seed(1);
  options.faults.faults = {{.kind = FaultKind::restart, .start = Time(10min), .node = computer_id}};
  BusNetwork network(options);
  network.run_until(Time(10min) - 1us);
  const std::string before = network.display(next_stop_id).text();
  EXPECT_FALSE(before.empty());
  network.run_until(Time(10min + 20ms));
  EXPECT_EQ(network.display(next_stop_id).text(), "") << "nobody knows yet where it is";
  network.run_until(Time(10min + 4s));
  EXPECT_EQ(network.display(next_stop_id).text(), network.vehicle().truth().stop->name);
  network.run_until(Time(22min));
  EXPECT_EQ(broken(network), "");
}

TEST(BusNetwork, DisplaysGoDarkWithoutTheirComputer) {
  BusNetworkOptions options = with_seed(1);
  options.faults.faults = {{.start = Time(10min), .duration = 5min, .node = computer_id}};
  BusNetwork network(options);
  // Its heartbeat comes twice a second, and is awaited for 1.2 s.
  network.run_until(Time(10min + 1300ms));
  for (const NodeId id : {front_display_id, side_display_id, next_stop_id, information_id}) {
    EXPECT_EQ(network.display(id).text(), "") << unsigned{id};
  }
  network.run_until(Time(22min));
  EXPECT_EQ(broken(network), "");
}

TEST(BusNetwork, TheClockOfSatellitesLeads) {
  BusNetworkOptions options = with_seed(1);
  options.faults.faults = {{.kind = FaultKind::wrong_clock, .start = Time(0min)}};
  BusNetwork network(options);
  network.run_until(Time(22min));
  EXPECT_EQ(broken(network), "");
}

class BusSeed : public testing::TestWithParam<std::uint64_t> {};

TEST_P(BusSeed, AllHoldsWithoutAFault) {
  BusNetwork network(with_seed(GetParam()));
  network.run_until(Time(tries_all() ? Duration(4h) : Duration(2h)));
  EXPECT_EQ(broken(network), "");
}

INSTANTIATE_TEST_SUITE_P(Some, BusSeed, testing::Range<std::uint64_t>(5, tries_all() ? 9 : 6));

// Each fault alone: displays are right or dark, and state that was lost is restored.

class BusFault : public testing::TestWithParam<const char*> {};

TEST_P(BusFault, AloneBreaksNothing) {
  BusNetworkOptions options = with_seed(1);
  const ParsedFault<FaultKind> parsed = parse_fault<FaultKind>(GetParam());
  ASSERT_TRUE(parsed.fault) << parsed.error;
  options.faults.faults = {*parsed.fault};
  // To the next stops, where lost state is restored; or on through the next journey.
  const ScheduledFault& fault = options.faults.faults.front();
  const Time over = fault.end() == never ? fault.start : fault.end();
  BusNetwork network(options);
  network.run_until(tries_all() ? Time(80min) : std::clamp(over + 5min, Time(10min), Time(35min)));
  EXPECT_EQ(broken(network), "") << GetParam();
  for (const auto& node : network.nodes()) {
    EXPECT_TRUE(node->is_operational()) << node->place().name;
  }
  EXPECT_EQ(network.display(next_stop_id).text(), network.vehicle().truth().stop->name);
  EXPECT_EQ(network.display(next_stop_of(2)).text(), network.vehicle().truth().stop->name);
}

constexpr const char* bus_fault_cases[] = {"lost-node@10min+3min",
                                           "lost-node@0s+30s",
                                           "lost-node:node=1@0s+1min",
                                           "lost-node:node=1@10min+5min",
                                           "lost-node:node=1@20min+10min",
                                           "lost-node:node=2@10min+1min",
                                           "lost-node:node=2@20min+5min",
                                           "lost-node:node=4@10min+1min",
                                           "lost-node:node=6@10min+10min",
                                           "lost-node:node=7@10min+10min",
                                           "lost-node:node=8@10min+1min",
                                           "lost-node:node=9@10min+1min",
                                           "lost-node:node=10@10min+1min",
                                           "lost-node:node=11@10min+5min",
                                           "lost-node:node=12@10min+1min",
                                           "lost-node:node=13@10min+1min",
                                           "lost-node:node=16@10min+20min",
                                           "lost-node:node=20@10min+1min",
                                           "lost-node:node=21@10min+1min",
                                           "lost-node:node=22@10min+1min",
                                           "lost-node:node=30@10min+1min",
                                           "lost-node:node=31@20min+5min",
                                           "lost-node:node=34@10min+1min",
                                           "lost-node:node=35@10min+1min",
                                           "lost-node:node=39@10min+1min",
                                           "train-bus-cut@0s+30s",
                                           "train-bus-cut@112ms+72ms",
                                           "train-bus-cut@20min+6min",
                                           "restart@5min",
                                           "restart@21min+10s",
                                           "restart:node=2@10min",
                                           "restart:node=5@10min",
                                           "restart:node=8@0s",
                                           "restart:node=9@10min",
                                           "restart:node=16@10min",
                                           "cable-cut@10min+1min",
                                           "cable-cut@20min+6min",
                                           "cable-cut@10min+1s",
                                           "cable-cut@0s+20s",
                                           "babbling-node@10min+10s",
                                           "babbling-node@20min+5min",
                                           "corrupted-frames@5min+1h",
                                           "wrong-clock@10min+10min",
                                           "no-satellites@0s+1h",
                                           "broken-door@10min+10min",
                                           "blocked-door@10min+3min",
                                           "no-paper@10min+10min"};

INSTANTIATE_TEST_SUITE_P(Each, BusFault, testing::ValuesIn(bus_fault_cases));

}  // namespace
}  // namespace canvoy::bus_line::bus_network_test
