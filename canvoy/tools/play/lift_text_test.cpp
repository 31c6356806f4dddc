#include "canvoy/tools/play/lift_text.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "canvoy/tools/play/lift_picture.hpp"

namespace canvoy::tools::lift_text_test {
namespace {

using lift::LiftEvent;

lift::LiftNetworkDescription house() {
  lift::LiftNetworkDescription made = lift::standard_lift_network({.lifts = 2, .floors = 4});
  made.faults.faults = {{.kind = lift::FaultKind::dead_encoder, .start = Time(5min)}};
  return made;
}

std::string words(const decltype(LiftEvent::what)& what) {
  return reported_event(LiftEvent{Time(1s), what}, house()).text;
}

lift::LiftNetworkSnapshot some_moment() {
  lift::LiftNetworkSnapshot now;
  now.at = Time(90s);
  now.waiting = 3;
  now.riding = 4;
  now.served = 17;
  now.lifts.resize(2);
  now.lifts[0].nearest_floor = 3;
  now.lifts[0].direction = lift::Direction::up;
  now.lifts[0].persons = 4;
  now.lifts[0].load_kg = 301.4;
  now.lifts[0].speed_m_s = -1.6;
  now.lifts[0].mode = lift::LiftMode::normal;
  now.lifts[0].car_calls = {4};
  now.lifts[0].starts = 12;
  now.lifts[1].nearest_floor = 1;
  now.lifts[1].doors[0] = {.is_there = true, .open_share = 1, .locked = false};
  now.lifts[1].mode = lift::LiftMode::fault;
  now.lifts[1].overload = true;
  now.lifts[1].load_kg = 1200;
  now.landings.resize(4);
  now.landings[1] = {.waiting_up = 2, .waiting_down = 1, .lamp_up = true, .lamp_down = true};
  now.buses = {{.load = 0.123}, {.load = 0.05}, {}};
  return now;
}

TEST(LiftPicture, ShowsShaftsWithCarsDoorsCallsAndPeople) {
  EXPECT_EQ(lift_picture(house(), some_moment(), 10, 40),
            R"(Canvoy: 2 lifts of 4 floors    1min 30.000s  (x10)    3 wait, 4 ride, 17 were carried

  floor   waiting    calls|lift 1 |lift 2 |
  4                       |   .   |       |
  3                       | [ 4]^ |       |
  2         2^   1v  ^v   |       |       |
  1                       |       | ] 0[  |
                          |normal | FAULT |
  load, kg                |  301  | 1200! |
  speed, m/s              |  1.6  |  0.0  |
  starts                  |  12   |   0   |
  bus load                |12.3 % | 5.0 % |
  [ 4] a car with persons, ][ its doors are open, . somebody wants to go there

)");
}

TEST(LiftPicture, EightLiftsFitEightyColumns) {
  auto moment = some_moment();
  moment.lifts.resize(8, moment.lifts.front());
  std::istringstream lines(lift_picture(house(), moment, 0, 10, 80));
  for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 80U) << line;
}

TEST(LiftPicture, ARowIsSeveralFloorsWhereThereIsNoRoom) {
  const std::string picture = lift_picture(house(), some_moment(), 0, 2);
  EXPECT_NE(picture.find("  3                       | [ 4]^ |       |\n"
                         "  1         2^   1v  ^v   |       | ] 0[  |\n"),
            std::string::npos)
      << picture;
}

TEST(LiftText, TellsEventsInWords) {
  EXPECT_EQ(words(BootedUp{.bus = 1, .node = 2}), "lift2: lift-drive (2): boot-up");
  EXPECT_EQ(words(BootedUp{.bus = 0, .node = 99}), "lift1: node 99 (63h): boot-up");
  EXPECT_EQ(words(BootedUp{.bus = 2, .node = 2}), "group: controller of lift 2: boot-up");
  EXPECT_EQ(words(BootedUp{.bus = 2, .node = 3}), "group: node 3 (03h): boot-up");
  EXPECT_EQ(words(NmtStateSeen{.bus = 2, .node = 17, .state = NmtState::operational}),
            "group: lift-group-controller (17): NMT state operational");
  EXPECT_EQ(words(EmergencySeen{.bus = 0, .node = 4, .code = 0xFF05}),
            "lift1: lift-position (4): EMERGENCY FF05h: overspeed");
  EXPECT_EQ(words(EmergencySeen{.bus = 0, .node = 4, .code = 0, .error_register = 0x21}),
            "lift1: lift-position (4): emergency: an error is gone");
  EXPECT_EQ(words(EmergencySeen{.bus = 0, .node = 4}),
            "lift1: lift-position (4): emergency: no error any more");
  EXPECT_EQ(
      words(lift::LampChanged{.call = {.floor = 2, .direction = lift::Direction::up}, .lit = true}),
      "call up at floor 2 is acknowledged");
  EXPECT_EQ(
      words(lift::LampChanged{.call = {.lift = 2, .floor = 3}, .end = lift::CallEnd::fire_service}),
      "call to floor 3 in lift 2 is taken back: fire service");
  EXPECT_EQ(words(lift::CarStarted{.lift = 1, .floor = 4, .persons = 1}),
            "lift 1 starts at floor 4 with 1 person");
  EXPECT_EQ(words(lift::CarStopped{.lift = 2, .floor = lift::no_floor}),
            "lift 2 stops between floors");
}

TEST(LiftText, SaysWhereAFaultIs) {
  lift::LiftNetworkDescription network = house();
  network.faults.faults = {{.kind = lift::FaultKind::stuck_button, .spot = 2}};
  const auto told = [&](lift::FaultKind kind, const FaultPlace& place, std::size_t fault = 1) {
    return reported_event(LiftEvent{.what = lift::FaultBegan{fault, kind, place}}, network).text;
  };
  using enum lift::FaultKind;
  EXPECT_EQ(told(dead_encoder, {1, 0, 4}),
            "FAULT begins: dead-encoder at lift1: lift-position (4)");
  EXPECT_EQ(told(cable_cut, {2, 1, 2}), "FAULT begins: cable-cut behind lift2: lift-drive (2)");
  EXPECT_EQ(told(stuck_button, {2, 1, 2}, 0),
            "FAULT begins: stuck-button at lift2: lift-drive (2), floor 2");
  EXPECT_EQ(told(lost_node, {0, 2, 17}),
            "FAULT begins: lost-node at group: lift-group-controller (17)");
  EXPECT_EQ(told(lost_node, {1, 0, 99}), "FAULT begins: lost-node at lift1: node 99 (63h)");
  EXPECT_EQ(told(fire_brigade, {2, 1, 0}), "FAULT begins: fire-brigade of lift 2");
  EXPECT_EQ(told(fire_alarm, {0, 0, 0}), "FAULT begins: fire-alarm of all lifts");
  EXPECT_EQ(words(lift::FaultEnded{0, dead_encoder, {1, 0, 4}}),
            "fault ends: dead-encoder at lift1: lift-position (4)");
}

TEST(LiftText, SaysWhereAFaultIsAsJson) {
  const lift::FaultBegan began{0, lift::FaultKind::dead_encoder, {1, 0, 4}};
  const auto json =
      nlohmann::ordered_json::parse(reported_event(LiftEvent{.what = began}, house()).json);
  EXPECT_EQ(json["event"], "fault-begins");
  EXPECT_EQ(json["fault"], "dead-encoder");
  EXPECT_EQ(json["lift"], 1);
  EXPECT_EQ(json["bus"], "lift1");
  EXPECT_EQ(json["node"], 4);
  EXPECT_EQ(json["text"], "FAULT begins: dead-encoder at lift1: lift-position (4)");
}

TEST(LiftText, AnInvariantNamesItsLiftAndFaultAndWhatIsAllowed) {
  EXPECT_EQ(lift_invariant_text({.kind = lift::InvariantKind::opens_at_floor,
                                 .part = 2,
                                 .worst = 12.5,
                                 .allowed = 10,
                                 .held = false,
                                 .judged = 1},
                                house()),
            "lift 2: a door began to open beside a floor by 12.5 mm, 10 mm allowed");
  EXPECT_EQ(lift_invariant_text({.kind = lift::InvariantKind::safe_stand,
                                 .part = 1,
                                 .fault = 0,
                                 .worst = 2,
                                 .allowed = 5,
                                 .judged = 1},
                                house()),
            "lift 1: dead-encoder: from the fault to a car that stands 2 s, 5 s allowed");
}

TEST(LiftText, AnInvariantIsReadAsPeopleReadNumbers) {
  const auto words = [](lift::InvariantKind kind, double value, double bound) {
    return lift_invariant_text({.kind = kind, .worst = value, .allowed = bound, .judged = 1},
                               house());
  };
  EXPECT_EQ(words(lift::InvariantKind::no_overload, 828, 1100),
            "left a floor with 828 kg, 1100 kg allowed");
  EXPECT_EQ(words(lift::InvariantKind::travel, 1.6e-14, 0.3),
            "beyond the last floors by 0 m, 0.3 m allowed");
  EXPECT_EQ(words(lift::InvariantKind::fire_calls, 0, 0),
            "calls taken in a fire service 0, 0 allowed");
  EXPECT_EQ(lift_invariant_text({.kind = lift::InvariantKind::fire_calls, .worst = 0}, house()),
            "not decided: calls taken in a fire service");
}

TEST(LiftText, SaysAllOfASnapshotAsJson) {
  const auto json = lift_snapshot_json(house(), some_moment());
  EXPECT_EQ(json["time"], 90);
  EXPECT_EQ(json["lifts"][0]["floor"], 3);
  EXPECT_EQ(json["lifts"][1]["open"], 1);
  EXPECT_EQ(json["buses"][1]["load_percent"], 5);
}

TEST(LiftText, SaysOfEachBusOfASummaryWhatItSaysOfOneOfASnapshot) {
  lift::LiftSummary summary;
  summary.buses = {{.load = 0.25, .frames = 7, .error_frames = 2}};
  const auto json = lift_summary_json(summary, {}, house());
  EXPECT_EQ(json["buses"][0]["bus"], "lift1");
  EXPECT_EQ(json["buses"][0]["load_percent"], 25);
  EXPECT_EQ(json["buses"][0]["frames"], 7);
  EXPECT_EQ(json["buses"][0]["error_frames"], 2);
}

}  // namespace
}  // namespace canvoy::tools::lift_text_test
