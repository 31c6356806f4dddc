// Two seats of an excavator, of which one has the command: joysticks 3 and 4 are the trainer's.
#include <gtest/gtest.h>

#include <cmath>

#include "canvoy/can/testing/tries_all.hpp"

#include "canvoy/worlds/excavator/excavator_network_test.hpp"

namespace canvoy::excavator::excavator_seats_test {
namespace {

ExcavatorOptions with_trainer() {
  ExcavatorOptions options;
  options.length = 20min;
  options.has_trainer = true;
  return options;
}

TEST(ExcavatorSeats, TheCommandGoesToTheTrainerAndBack) {
  ExcavatorNetwork network(with_trainer());
  bool was_taken = false;
  bool has_slewed = false;
  for (Time at{}; at < Time(20min); at += 20ms) {
    network.run_until(at);
    if (network.panel().commanding_seat() != 1U) continue;
    was_taken = true;
    has_slewed = has_slewed || network.machine().speed(Movement::slew) > 0.1;
    // The operator pulls the boom meanwhile, for longer than a valve takes.
    EXPECT_NEAR(network.machine().speed(Movement::boom), 0, 0.005);
  }
  EXPECT_TRUE(was_taken);
  EXPECT_TRUE(has_slewed);
  EXPECT_GE(network.trainer().lessons(), 4U);
  EXPECT_EQ(network.panel().commanding_seat(), 0U);
  EXPECT_EQ(broken(network), Names());
  EXPECT_GT(network.machine().earth().heaped, 5) << "the operator digs between the lessons";
}

/// A host that boots gives the command to the operator's seat; faults at each moment of a lesson.
TEST(ExcavatorSeats, FaultsInALessonMoveNothing) {
  const Time lesson(3min);
  for (const FaultKind kind : {FaultKind::restart, FaultKind::lost_node, FaultKind::cable_cut}) {
    for (const NodeId node : {host_id, seat_id}) {
      if (!tries_all() && (node == host_id) == (kind == FaultKind::lost_node)) continue;
      ExcavatorOptions options = with_trainer();
      for (int i = 0; i < 4; ++i) {
        options.faults.faults.push_back({.kind = kind,
                                         .start = lesson + i * Duration(3min + 17s),
                                         .duration = 3s,
                                         .node = node});
      }
      ExcavatorNetwork network(options);
      network.run_until(Time(20min));
      EXPECT_EQ(broken(network), Names()) << fault_name(kind) << " " << unsigned{node};
    }
  }
}

/// Sensors of a seat are compared whichever has the command.
TEST(ExcavatorSeats, ASensorThatDriftsIsFoundInEachSeat) {
  ExcavatorOptions options = with_trainer();
  options.faults.faults = {
      {.kind = FaultKind::drifting_axis, .start = Time(3min), .duration = 40s, .spot = 1}};
  ExcavatorNetwork network(options);
  network.run_until(Time(3min + 2s));
  EXPECT_TRUE(is_lit(network.panel().lit(), Lamp::fault));
  network.run_until(Time(20min));
  EXPECT_EQ(broken(network), Names());
}

/// A seat that trusts the first sensor of an axis: the machine follows a stick that is elsewhere,
/// and no lamp says so.
TEST(ExcavatorSeats, ASensorThatDriftsUnnoticedIsSeenByTheReferee) {
  ExcavatorOptions options = with_trainer();
  options.has_trainer = false;
  options.sabotage.single_channel = true;
  for (int i = 0; i < 8; ++i) {
    options.faults.faults.push_back({.kind = FaultKind::drifting_axis,
                                     .start = Time(1min) + i * Duration(61s),
                                     .duration = 8s});
  }
  ExcavatorNetwork network(options);
  network.run_until(Time(10min));
  EXPECT_EQ(broken(network), (Names{"axis_delta", "indicators"}));
}

}  // namespace
}  // namespace canvoy::excavator::excavator_seats_test
