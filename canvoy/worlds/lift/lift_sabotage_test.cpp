// The referees can fail: a building is broken in one place at a time, unnoticed by its devices, and
// the broken invariant is detected. Judgements by facts alone are in referee_test.cpp and
// fault_referee_test.cpp.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>

#include "canvoy/devices/cia417/virtual_io/virtual_io.hpp"
#include "canvoy/worlds/lift/lift_network.hpp"
#include "canvoy/worlds/lift/testing/broken.hpp"

namespace canvoy::lift::lift_sabotage_test {
namespace {

// CAN-IDs of the first lift (CiA 417-4, pre-defined PDOs).
constexpr std::uint32_t door_control = 0x200;
constexpr std::uint32_t drive_control = 0x180;
constexpr std::uint32_t virtual_output = 0x400;
constexpr std::uint32_t virtual_input = 0x480;  // + node-ID

struct LiftSabotageTest : testing::Test {
  LiftSabotageTest() { description.people.holds_door = 0; }

  /// A foreign device sends on the bus of this lift.
  void begin() {
    network = std::make_unique<LiftNetwork>(description);
    stranger = network->world().bus(0).attach({});
    network->observe(0, {.context = this, .on_frame = note});
  }
  void run_until(Time until) {
    if (!network) begin();
    network->run_until(until);
  }
  static void note(void* self, Time, ControllerId sender, const Frame& frame) {
    auto& test = *static_cast<LiftSabotageTest*>(self);
    if (frame.id == drive_control) test.note_drive(frame, sender);
    if (frame.id != door_control || !test.is_opening() || sender == test.stranger) return;
    if (test.opening.length == 0) test.opening = frame;
    test.ordered = frame;
  }
  /// A device that holds the drive stops it as soon as it is to move with an open door.
  void note_drive(const Frame& frame, ControllerId sender) {
    constexpr unsigned new_set_point = 0x10;
    if (!holds_drive || sender == stranger || (frame.data[0] & new_set_point) == 0) return;
    if (network->snapshot().lifts.at(0).doors.at(0).open_share == 0) return;
    network->world().at(network->now() + 1ms, [this](Time) {
      send(Frame::data_frame(drive_control, {0x02, 0, 0, 0, 0, 0}));
    });
  }
  bool is_opening() const { return network->now() > Time(5s); }
  void send(const Frame& frame) { network->world().bus(0).send(stranger, frame); }
  void send_record(std::uint32_t id, std::uint64_t record) {
    Frame frame = Frame::data_frame(id, {0, 0, 0, 0, 0, 0});
    for (std::size_t i = 0; i < 6; ++i) {
      frame.data.at(i) = static_cast<std::uint8_t>(record >> (8 * i));
    }
    send(frame);
  }

  NodeDescription& node(DeviceKind kind) {
    return *std::ranges::find(description.nodes, kind, &NodeDescription::kind);
  }
  /// Makes its TPDO invalid: presses there are not reported.
  static void mute(NodeDescription& panel) {
    const auto low = static_cast<std::uint8_t>(0x80U + panel.id);
    panel.values.push_back({0x1881, 1, {low, 0x04, 0x00, 0x80}});
  }
  NodeDescription& landing_panel(FloorNumber floor) {
    return *std::ranges::find_if(description.nodes, [floor](const NodeDescription& each) {
      return each.kind == DeviceKind::landing_panel && each.floors.front() == floor;
    });
  }

  bool is_broken(InvariantKind kind) const {
    return std::ranges::any_of(network->invariants(), [kind](const Invariant& one) {
      return one.kind == kind && !one.held;
    });
  }
  std::vector<InvariantKind> all_broken() const {
    std::vector<InvariantKind> kinds;
    for (const Invariant& one : network->invariants()) {
      if (!one.held) kinds.push_back(one.kind);
    }
    return kinds;
  }
  /// Number of broken kinds of invariants.
  std::size_t broken_kinds() const {
    std::set<InvariantKind> kinds;
    for (const Invariant& one : network->invariants()) {
      if (!one.held) kinds.insert(one.kind);
    }
    return kinds.size();
  }
  void run_until_it_moves() {
    while (network->now() < Time(5min)) {
      network->run_until(network->now() + 100ms);
      const LiftSnapshot car = network->snapshot().lifts.at(0);
      if (std::abs(car.speed_m_s) > 1) return;
    }
    FAIL() << "it does not move";
  }

  LiftNetworkDescription description = standard_lift_network({.floors = 6});
  std::unique_ptr<LiftNetwork> network;
  ControllerId stranger = no_controller;
  Frame opening{};  ///< the controller's command to open its doors; empty: none yet
  Frame ordered{};  ///< its last command
  bool holds_drive = false;
};

TEST_F(LiftSabotageTest, NothingIsBrokenWhereNobodyBreaksIt) {
  description.arrivals = {{.at = Time(5s), .from = 1, .to = 5}, {.at = Time(40s), .from = 4}};
  run_until(Time(3min));
  EXPECT_EQ(broken(*network), "");
}

TEST_F(LiftSabotageTest, ADoorThatIsOpenedInAMovingCarIsSeen) {
  description.building.lifts[0].has_safety_chain = false;
  description.arrivals = {{.at = Time(6s), .from = 1, .to = 6}};
  begin();
  run_until_it_moves();
  ASSERT_NE(opening.length, 0);
  send(opening);
  run_until(network->now() + 2s);
  EXPECT_TRUE(is_broken(InvariantKind::closed_while_moving));
}

/// Its lock takes 100 ms to open, and is commanded to close again before the door moves.
TEST_F(LiftSabotageTest, ADoorThatIsUnlockedInAMovingCarStopsItByTheSafetyChainAndThatIsSeen) {
  description.arrivals = {{.at = Time(6s), .from = 1, .to = 6}, {.at = Time(60s), .from = 5}};
  begin();
  run_until_it_moves();
  const Frame closing = ordered;
  ASSERT_NE(opening, closing);
  send(opening);
  run_until(network->now() + 110ms);
  send(closing);
  run_until(network->now() + 1s);
  EXPECT_EQ(network->snapshot().lifts.at(0).speed_m_s, 0);
  run_until(Time(3min));
  EXPECT_EQ(all_broken(), std::vector{InvariantKind::chain_stops});
  EXPECT_EQ(network->summary().served, 2U) << "when it is locked, the lift goes on";
}

/// Its ropes stretch by 25 mm while eleven people get in, and a foreign device holds its drive.
TEST_F(LiftSabotageTest, ACarThatIsNotLevelledIsSeen) {
  description.building.lifts[0].car.rope_stretch_um_per_kg = 30;
  description.service.door_dwell = 40s;
  description.people.fill_share = 1;
  description.arrivals.assign(11, {.at = Time(6s), .from = 1, .to = 6, .mass_kg = 75});
  description.arrivals.push_back({.at = Time(60s), .from = 5, .to = 1});
  begin();
  holds_drive = true;
  run_until(Time(3min));
  EXPECT_EQ(all_broken(), std::vector{InvariantKind::levelled});
}

TEST_F(LiftSabotageTest, ADoorThatIsOpenedBetweenFloorsIsSeen) {
  description.arrivals = {{.at = Time(6s), .from = 1, .to = 6}};
  description.faults.faults = {
      {.kind = FaultKind::lost_node, .start = Time(18s), .node = node_id::drive}};
  run_until(Time(30s));
  ASSERT_NE(opening.length, 0);
  ASSERT_EQ(network->snapshot().lifts.at(0).speed_m_s, 0);
  EXPECT_EQ(broken(*network), "");
  send(opening);
  run_until(Time(33s));
  EXPECT_TRUE(is_broken(InvariantKind::opens_at_floor));
}

TEST_F(LiftSabotageTest, ACarThatDoesNotWeighLeavesWithTooMuch) {
  std::erase_if(description.nodes,
                [](const NodeDescription& each) { return each.kind == DeviceKind::load; });
  description.people.fill_share = 1;
  description.arrivals.assign(13, {.at = Time(5s), .from = 1, .to = 5, .mass_kg = 100});
  run_until(Time(3min));
  EXPECT_TRUE(is_broken(InvariantKind::no_overload));
}

TEST_F(LiftSabotageTest, AButtonThatNobodyHearsIsSeen) {
  mute(landing_panel(3));
  description.arrivals = {{.at = Time(5s), .from = 3, .to = 1}};
  run_until(Time(10s));
  EXPECT_TRUE(is_broken(InvariantKind::call_acknowledged));
}

TEST_F(LiftSabotageTest, ALampThatGoesOutWithoutACarIsSeen) {
  description.arrivals = {{.at = Time(5s), .from = 6, .to = 1}};
  run_until(Time(7s));
  cia417::VirtualOutput lamp{.function = cia417::BasicFunction::standard_hall_call,
                             .sub_function = cia417::hall_down,
                             .lifts = cia417::lift_bit(1),
                             .floor = 6,
                             .doors = cia417::source_door(1)};
  send_record(virtual_output, cia417::encode(lamp));
  run_until(Time(8s));
  EXPECT_TRUE(is_broken(InvariantKind::no_call_lost));
}

TEST_F(LiftSabotageTest, ACallThatNoCarAnswersAndWhoWaitsForItAreSeen) {
  std::erase_if(description.nodes,
                [](const NodeDescription& each) { return each.kind == DeviceKind::position; });
  description.people.patience_least = description.people.patience_most = 60min;
  description.service.technician = false;
  description.arrivals = {{.at = Time(5s), .from = 5, .to = 1}};
  run_until(Time(32min));
  EXPECT_TRUE(is_broken(InvariantKind::call_served));
  EXPECT_TRUE(is_broken(InvariantKind::no_endless_wait));
}

TEST_F(LiftSabotageTest, AFireAlarmThatNobodyHearsIsSeenInEachOfItsRules) {
  mute(landing_panel(description.service.fire_floor));
  description.arrivals = {{.at = Time(61s), .from = 5, .to = 2}};
  description.faults.faults = {
      {.kind = FaultKind::fire_alarm, .start = Time(60s), .duration = 5min}};
  run_until(Time(5min));
  EXPECT_TRUE(is_broken(InvariantKind::fire_recall));
  EXPECT_TRUE(is_broken(InvariantKind::fire_doors));
  EXPECT_TRUE(is_broken(InvariantKind::fire_calls));
}

TEST_F(LiftSabotageTest, ADoorThatOpensByItselfUnderTheFireBrigadeIsSeen) {
  description.faults.faults = {
      {.kind = FaultKind::fire_brigade, .start = Time(10s), .duration = 5min}};
  begin();
  run_until(Time(30s));
  run_until_it_moves();
  ASSERT_NE(opening.length, 0);
  send(opening);
  run_until(network->now() + 4s);
  EXPECT_TRUE(is_broken(InvariantKind::fire_buttons));
}

TEST_F(LiftSabotageTest, AnEncoderThatDiesSilentlyIsSeen) {
  // 1014h of the position unit is not valid: its emergencies are not sent.
  node(DeviceKind::position).values = {{0x1014, 0, {0x84, 0x00, 0x00, 0x80}}};
  description.arrivals = {{.at = Time(2s), .from = 1, .to = 6}};
  description.faults.faults = {
      {.kind = FaultKind::dead_encoder, .start = Time(14s), .duration = 40s}};
  run_until(Time(60s));
  EXPECT_TRUE(is_broken(InvariantKind::emergency_told));
}

TEST_F(LiftSabotageTest, ACarThatGoesOnWithoutAUnitThatItNeedsIsSeen) {
  description.arrivals = {{.at = Time(2s), .from = 1, .to = 6}, {.at = Time(20s), .from = 3}};
  description.faults.faults = {
      {.kind = FaultKind::lost_node, .start = Time(14s), .duration = 60s, .node = node_id::load}};
  begin();
  // A foreign device sends its heartbeats.
  for (Time at = Time(14s); at < Time(70s); at += 300ms) {
    network->world().at(at, [this](Time) { send(Frame::data_frame(0x700U + node_id::load, {5})); });
  }
  run_until(Time(70s));
  EXPECT_TRUE(is_broken(InvariantKind::safe_stand));
  EXPECT_TRUE(is_broken(InvariantKind::emergency_told));
}

TEST_F(LiftSabotageTest, ALiftThatStaysOutOfOrderAfterAFaultIsSeen) {
  description.faults.faults = {
      {.kind = FaultKind::light_barrier, .start = Time(14s), .duration = 10s}};
  run_until(Time(20s));
  send_record(virtual_input + node_id::first_car_panel,
              cia417::encode(cia417::VirtualInput{
                  .function = cia417::BasicFunction::special_function,
                  .sub_function = cia417::sub_function_of(cia417::SpecialFunction::out_of_order),
                  .lifts = cia417::lift_bit(1),
                  .doors = cia417::source_door(1),
                  .data = cia417::VirtualInput::lock_bit | 1U}));
  run_until(Time(6min));
  EXPECT_TRUE(is_broken(InvariantKind::service_resumed));
}

// Service: people, and doors that are wide open.

TEST_F(LiftSabotageTest, ADoorThatDoesNotHearItsCommandsIsSeen) {
  // Its RPDO of the controlword has another COB-ID: lamps go out where the car comes, and no
  // passenger gets in.
  node(DeviceKind::door).values = {{0x1508, 1, {0x7F, 0x02, 0x00, 0x80}},
                                   {0x1508, 1, {0x7F, 0x02, 0x00, 0x00}}};
  description.arrivals = {{.at = Time(5s), .from = 1, .to = 5}};
  run_until(Time(40s));
  EXPECT_EQ(network->summary().served, 0U);
  EXPECT_TRUE(is_broken(InvariantKind::no_call_lost));
  EXPECT_EQ(broken_kinds(), 1U);
}

TEST_F(LiftSabotageTest, PeopleWhoGiveUpWithoutAFaultAreSeen) {
  std::erase_if(description.nodes,
                [](const NodeDescription& each) { return each.kind == DeviceKind::position; });
  description.service.technician = false;
  description.arrivals = {{.at = Time(5s), .from = 5, .to = 1}};
  run_until(Time(22min));
  EXPECT_EQ(network->summary().gave_up, 1U);
  EXPECT_TRUE(is_broken(InvariantKind::nobody_gives_up));
  EXPECT_TRUE(is_broken(InvariantKind::lift_serves));
  EXPECT_EQ(broken_kinds(), 2U);
}

TEST_F(LiftSabotageTest, ARiderWhoDoesNotArriveIsSeen) {
  description.arrivals = {{.at = Time(6s), .from = 1, .to = 6}};
  description.service.technician = false;
  begin();
  run_until_it_moves();
  send(Frame::data_frame(0, {0x02, node_id::drive}));  // NMT stop
  run_until(network->now() + 14min);
  EXPECT_FALSE(is_broken(InvariantKind::no_endless_ride));
  run_until(network->now() + 2min);
  EXPECT_EQ(network->snapshot().riding, 1U);
  EXPECT_TRUE(is_broken(InvariantKind::no_endless_ride));
  EXPECT_TRUE(is_broken(InvariantKind::nobody_trapped));
  EXPECT_TRUE(is_broken(InvariantKind::chain_stops));
  EXPECT_EQ(broken_kinds(), 5U) << "and acceleration and jerk of the stop";
}

TEST_F(LiftSabotageTest, ALiftThatSaysThatItServesAndCarriesNobodyIsSeen) {
  // After the fault its drive is stopped unnoticed by its controller.
  description.arrivals = {{.at = Time(2s), .from = 1, .to = 5}, {.at = Time(90s), .from = 2}};
  description.arrivals.back().to = 4;
  description.faults.faults = {
      {.kind = FaultKind::light_barrier, .start = Time(60s), .duration = 10s}};
  run_until(Time(75s));
  send(Frame::data_frame(0, {0x02, node_id::drive}));
  run_until(Time(6min));
  EXPECT_TRUE(is_broken(InvariantKind::service_resumed));
  EXPECT_EQ(broken_kinds(), 1U);
}

TEST_F(LiftSabotageTest, ACarForOnePersonCarriesOneAtATime) {
  description.building.lifts.front().car.rated_persons = 1;
  description.building.lifts.front().car.rated_load_kg = 100;
  description.arrivals = {{.at = Time(5s), .from = 1, .to = 5},
                          {.at = Time(5s), .from = 1, .to = 5}};
  run_until(Time(4min));
  EXPECT_EQ(network->summary().served, 2U);
  EXPECT_EQ(broken(*network), "");
}

TEST_F(LiftSabotageTest, AGroupThatDoesNotComeBackIsSeen) {
  description = standard_lift_network({.lifts = 2, .floors = 5});
  // Its controller sends no heartbeat: no lift passes calls to it.
  node(DeviceKind::group_controller).values = {{0x1017, 0, {0, 0}}};
  description.faults.faults = {
      {.kind = FaultKind::lost_node, .start = Time(14s), .duration = 10s, .part = 0}};
  run_until(Time(2min));
  EXPECT_TRUE(is_broken(InvariantKind::service_resumed));
}

}  // namespace
}  // namespace canvoy::lift::lift_sabotage_test
