// Changes behind a cut cable of a lift take effect when it is mended, in a whole building: keys
// that are turned and turned back, and lamps.
#include <gtest/gtest.h>

#include "canvoy/worlds/lift/lift_network.hpp"
#include "canvoy/worlds/lift/testing/broken.hpp"

namespace canvoy::lift::lift_cable_cut_test {
namespace {

/// The cable is cut behind the first car panel for 20 s: landings are not heard.
LiftNetworkDescription building() {
  LiftNetworkDescription made = standard_lift_network({.floors = 6});
  made.people.holds_door = 0;
  made.faults.faults = {{.kind = FaultKind::cable_cut,
                         .start = Time(300s),
                         .duration = 20s,
                         .node = node_id::first_car_panel}};
  return made;
}
ScheduledFault alarm(Time start, Duration duration) {
  return {.kind = FaultKind::fire_alarm, .start = start, .duration = duration};
}

TEST(CutCableOfALift, AnAlarmThatBeginsBehindItIsHeardWhenItIsMended) {
  LiftNetworkDescription description = building();
  description.faults.faults.push_back(alarm(Time(310s), 600s));
  description.arrivals = {{.at = Time(400s), .from = 1, .to = 5},
                          {.at = Time(500s), .from = 5, .to = 1},
                          {.at = Time(600s), .from = 2, .to = 4},
                          {.at = Time(920s), .from = 3, .to = 1}};
  LiftNetwork network(description);
  network.run_until(Time(340s));
  EXPECT_EQ(network.snapshot().lifts.at(0).mode, LiftMode::fire_recall);
  network.run_until(Time(905s));
  EXPECT_EQ(network.summary().served, 0U) << "nobody is carried through the alarm";
  network.run_until(Time(1100s));
  EXPECT_GE(network.summary().served, 1U);
  EXPECT_EQ(broken(network), "");
}

TEST(CutCableOfALift, AnAlarmThatEndsBehindItEnds) {
  LiftNetworkDescription description = building();
  description.faults.faults.push_back(alarm(Time(100s), 210s));
  description.arrivals = {{.at = Time(400s), .from = 5, .to = 1}};
  LiftNetwork network(description);
  network.run_until(Time(290s));
  ASSERT_EQ(network.snapshot().lifts.at(0).mode, LiftMode::fire_recall);
  network.run_until(Time(500s));
  EXPECT_EQ(network.summary().served, 1U);
  EXPECT_EQ(broken(network), "");
}

TEST(CutCableOfALift, ALampBehindItOfACallThatIsAnsweredMeanwhileGoesOut) {
  LiftNetworkDescription description = building();
  // On the way to floor 5 when the cable is cut; people at 6 and at 2 have pressed before.
  description.arrivals = {{.at = Time(295s), .from = 6, .to = 1},
                          {.at = Time(295s), .from = 2, .to = 1}};
  LiftNetwork network(description);
  network.run_until(Time(300s));
  EXPECT_TRUE(network.snapshot().landings.at(5).lamp_down);
  network.run_until(Time(370s));
  const LiftNetworkSnapshot view = network.snapshot();
  for (const LandingSnapshot& landing : view.landings) {
    EXPECT_FALSE(landing.lamp_up || landing.lamp_down);
  }
  EXPECT_EQ(network.summary().served, 2U);
  EXPECT_EQ(broken(network), "");
}

/// The controller is alone on its piece of cable, and its queue is full of its messages.
TEST(CutCableOfALift, ADriveThatBootsBehindItIsStartedWhenItIsMended) {
  LiftNetworkDescription description = standard_lift_network({.floors = 4});
  description.arrivals = {{.at = Time(250s), .from = 3, .to = 1}};
  description.faults.faults = {
      {.kind = FaultKind::cable_cut,
       .start = Time(100s),
       .duration = 30s,
       .node = node_id::lift_controller},
      {.kind = FaultKind::lost_node, .start = Time(102s), .duration = 5s, .node = node_id::drive}};
  LiftNetwork network(description);
  network.run_until(Time(400s));
  EXPECT_EQ(network.summary().served, 1U);
  EXPECT_EQ(broken(network), "");
}

}  // namespace
}  // namespace canvoy::lift::lift_cable_cut_test
