// The sensor unit in a building: its reports on the bus of its lift (CiA 417-4, 4.13).
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "canvoy/can/frame_text.hpp"
#include "canvoy/worlds/lift/lift_network.hpp"
#include "canvoy/worlds/lift/shaft_sensors.hpp"
#include "canvoy/worlds/lift/testing/broken.hpp"

namespace canvoy::lift::lift_sensors_test {
namespace {

constexpr NodeId sensors_id = 14;

LiftNetworkDescription with_sensors(std::vector<FloorNumber> floors) {
  LiftNetworkDescription description = standard_lift_network({.floors = 4});
  description.traffic.percent_in_5_minutes = 0;
  description.nodes.push_back(
      {.id = sensors_id, .kind = DeviceKind::sensors, .floors = std::move(floors)});
  return description;
}

/// Reports of its PDO, with their times.
class Told {
 public:
  explicit Told(LiftNetwork& network) {
    network.observe(0, {.context = this,
                        .on_frame =
                            [](void* self, Time now, ControllerId, const Frame& frame) {
                              if (frame.id != 0x38E) return;
                              static_cast<Told*>(self)->records.emplace_back(now, frame);
                            },
                        .on_state = nullptr});
  }
  std::vector<std::string> data() const {
    std::vector<std::string> all;
    for (const auto& [at, frame] : records) all.emplace_back(FrameText(frame).view());
    return all;
  }

  std::vector<std::pair<Time, Frame>> records;
};

/// 03h is smoke, 05h pressure, 06h temperature: 20 degrees, four times that in 14 bits,
/// left-aligned. Floor 0 is the car. Without a value, the bits are ones (4.13.1).
TEST(LiftSensors, SmokeInTheCarIsToldWhileItIsThere) {
  LiftNetworkDescription description = with_sensors({});
  description.faults.faults = {{FaultKind::smoke, Time(30s), 5s, 1}};
  LiftNetwork network(description);
  Told told(network);
  network.run_until(Time(1min));
  ASSERT_EQ(told.data(), (std::vector<std::string>{"38E#050100800000", "38E#060100805000",
                                                   "38E#03010080FDFF", "38E#03010080FCFF"}));
  EXPECT_LT(told.records[2].first - Time(30s), 5ms) << "behind the light barrier";
  EXPECT_LT(told.records[3].first - Time(35s), 5ms);
}

TEST(LiftSensors, AtALandingTheyKnowTheirFloorAndNothingOfTheCar) {
  LiftNetworkDescription description = with_sensors({3});
  description.faults.faults = {{FaultKind::smoke, Time(30s), 5s, 1}};
  LiftNetwork network(description);
  Told told(network);
  network.run_until(Time(40s));
  network.shaft(1).sensors(sensors_id)->set_level(cia417::SensorFunction::glass, true);
  network.run_until(Time(41s));
  EXPECT_EQ(told.data(),
            (std::vector<std::string>{"38E#050103800000", "38E#060103805000", "38E#02010380FDFF"}));
}

TEST(LiftSensors, WhoHasNoPowerTellsWhenItComesBack) {
  LiftNetworkDescription description = with_sensors({});
  description.faults.faults = {{FaultKind::lost_node, Time(20s), 20s, 1, sensors_id},
                               {FaultKind::smoke, Time(30s), 1min, 1}};
  LiftNetwork network(description);
  Told told(network);
  network.run_until(Time(39s));
  EXPECT_EQ(told.records.size(), 2U);
  network.run_until(Time(50s));
  const std::vector<std::string> data = told.data();
  EXPECT_EQ(std::ranges::count(data, "38E#03010080FDFF"), 1);
}

/// Its controller supervises it like any other node; the lift goes on.
TEST(LiftSensors, ALostUnitIsToldByEmergency) {
  LiftNetworkDescription description = with_sensors({});
  description.faults.faults = {{FaultKind::lost_node, Time(30s), 20s, 1, sensors_id}};
  LiftNetwork network(description);
  network.run_until(Time(2min));
  const auto is_loss = [](const LiftEvent& event) {
    const auto* const told = std::get_if<EmergencySeen>(&event.what);
    return told != nullptr && told->node == node_id::lift_controller && told->code == 0x8130;
  };
  EXPECT_EQ(std::ranges::count_if(network.events(), is_loss), 1);
  EXPECT_EQ(broken(network), "");
}

TEST(LiftSensors, HangAtOneFloorOrInTheCar) {
  EXPECT_EQ(check(with_sensors({})), "");
  EXPECT_EQ(check(with_sensors({2})), "");
  EXPECT_EQ(check(with_sensors({2, 3})),
            "lift-sensors with node-ID 14 has one floor, or none in the car");
  EXPECT_EQ(check(with_sensors({5})),
            "lift-sensors with node-ID 14 hangs at a floor that is not there");
}

}  // namespace
}  // namespace canvoy::lift::lift_sensors_test
