// A door as a plant, with a car door unit: actions of people, and defects.
#include "canvoy/worlds/lift/door_plant.hpp"

#include <gtest/gtest.h>

#include "canvoy/canopen/testing/cable.hpp"
#include "canvoy/devices/cia417/door/car_door_device.hpp"
#include "canvoy/devices/cia417/load/load_measuring_device.hpp"
#include "canvoy/devices/cia417/sensor/light_barrier_device.hpp"
#include "canvoy/worlds/lift/load_cell.hpp"

namespace canvoy::lift::door_plant_test {
namespace {

using cia417::Detection;
using cia417::DoorState;

class DoorPlantTest : public testing::Test {
 protected:
  DoorPlantTest() {
    cable.connect(0, door.node());
    cable.connect(1, barrier.node());
    plant.on_change(callback<&DoorPlantTest::changed>(*this));
    cable.start_all();
    cable.send("000#01 00");
    cable.run_for(1s);
  }
  void changed() {
    door.unit().hardware_changed();
    barrier.unit().hardware_changed();
  }
  void command(const char* word) { cable.send(std::string("200#") + word + " FF FF FF FF FF FF"); }
  void open() {
    command("FF 4F");
    cable.run_for(3s);
    ASSERT_EQ(state(), DoorState::opened_with_torque);
  }
  void set(unsigned sub, unsigned value) {
    char text[40];
    std::snprintf(text, sizeof text, "606#2F 04 63 %02X %02X 00 00 00", sub, value);
    cable.send(text);
    ASSERT_EQ(cable.last(0x586).substr(0, 6), "586#60");
  }
  DoorState state() const { return door.unit().state(); }
  void faults(const DoorFaults& what) {
    plant.set_faults(cable.now, what);
    cable.run_for(0s);
  }

  DoorPlant plant{DoorPlantOptions{}};
  Cable cable;
  cia417::CarDoorDevice<> door{cable.port(0), 6, {plant.hardware()}};
  cia417::LightBarrierDevice<> barrier{
      cable.port(1), 9, plant.light_barrier_hardware(), {.sensing_period = 0s}};
};

TEST_F(DoorPlantTest, OpensInItsTimeToTheMicrosecond) {
  EXPECT_EQ(cable.last(0x201), "201#11 10 00 00") << "closed, locked, contact closed";
  const Time told = cable.now;
  command("FF 4F");
  EXPECT_EQ(state(), DoorState::closed_with_torque) << "the lock takes 100 ms";
  cable.run_for(99ms);
  EXPECT_EQ(plant.open_m(cable.now), 0);
  cable.run_for(1ms);
  EXPECT_EQ(state(), DoorState::opening);
  cable.run_until(told + 2099ms);
  EXPECT_EQ(state(), DoorState::opening);
  cable.run_until(told + 2100ms);
  EXPECT_EQ(state(), DoorState::opened_with_torque);
  EXPECT_EQ(plant.open_m(cable.now), 0.9);
  EXPECT_EQ(cable.last(0x201), "201#00 30 84 03");
}

TEST_F(DoorPlantTest, ClosesAndLocksInItsTime) {
  open();
  const Time told = cable.now;
  command("FF 1F");
  cable.run_until(told + 2599ms);
  EXPECT_EQ(state(), DoorState::closing);
  EXPECT_TRUE(plant.contact_is_closed(cable.now)) << "5 mm before the end";
  cable.run_until(told + 2600ms);
  EXPECT_EQ(state(), DoorState::closed_with_torque);
  EXPECT_FALSE(plant.is_locked(cable.now));
  cable.run_until(told + 2700ms);
  EXPECT_TRUE(plant.is_locked(cable.now));
  EXPECT_EQ(cable.last(0x201), "201#11 00 00 00");
}

TEST_F(DoorPlantTest, AtReducedSpeedItTakesLonger) {
  open();
  command("FF 17");
  cable.run_for(3s);
  EXPECT_EQ(state(), DoorState::closing);
  cable.run_for(2s);
  EXPECT_EQ(state(), DoorState::closed_with_torque);
}

TEST_F(DoorPlantTest, TheDoorMovesWithoutFramesForAnyMillisecond) {
  cable.clear();
  open();
  EXPECT_LE(cable.count(0x201), 25u) << "its position each 100 ms, and what changes";
}

TEST_F(DoorPlantTest, ALimitedDoorStandsAtAPassengerAndTellsItsForce) {
  open();
  command("FF 1F");
  cable.run_for(500ms);
  plant.stand_in_way(cable.now, true);
  cable.run_for(3s);
  EXPECT_EQ(plant.open_m(cable.now), 0.4);
  EXPECT_EQ(cable.last(0x201), "201#00 24 90 01");
  EXPECT_EQ(cable.last(0x205), "205#7F");
  EXPECT_GT(plant.impact_energy_max_j(), 0);
  EXPECT_LT(plant.impact_energy_max_j(), 20);
  plant.stand_in_way(cable.now, false);
  cable.run_for(3s);
  EXPECT_EQ(cable.last(0x205), "205#3F");
  EXPECT_EQ(cable.last(0x201), "201#11 00 00 00");
}

TEST_F(DoorPlantTest, APassengerTurnsADoorThatKnowsTheLightBarrier) {
  set(4, 1);
  set(8, 2);
  open();
  command("FF 1F");
  cable.run_for(1s);
  plant.stand_in_way(cable.now, true);
  cable.run_for(0s);
  EXPECT_EQ(state(), DoorState::re_opening);
  cable.run_for(2s);
  plant.stand_in_way(cable.now, false);
  cable.run_for(1999ms);
  EXPECT_EQ(state(), DoorState::opened_with_torque);
  cable.run_for(1ms);
  EXPECT_EQ(state(), DoorState::closing);
  EXPECT_EQ(plant.impact_energy_max_j(), 0) << "nobody was touched";
}

TEST_F(DoorPlantTest, AFullForceShovesSomebodyAway) {
  open();
  plant.stand_in_way(cable.now, true, {.width_m = 0.4, .force_n = 200});
  command("FF 0F");
  cable.run_for(5s);
  EXPECT_EQ(state(), DoorState::closed_with_torque);
}

TEST_F(DoorPlantTest, FullForceOnWhatDoesNotGiveWayIsAStuckDoor) {
  open();
  plant.stand_in_way(cable.now, true, {.width_m = 0.4, .force_n = 1000});
  command("FF 0F");
  cable.run_for(5s);
  EXPECT_EQ(state(), DoorState::error);
  EXPECT_EQ(cable.last(0x086), "086#04 FF 01 01 00 00 00 00");
}

TEST_F(DoorPlantTest, NobodyIsWiderThanTheGap) {
  open();
  command("FF 1F");
  cable.run_for(2s);
  const double gap = plant.open_m(cable.now);
  ASSERT_LT(gap, 0.4);
  plant.stand_in_way(cable.now, true);
  cable.run_for(1s);
  EXPECT_NEAR(plant.open_m(cable.now), gap, 1e-6);
}

TEST_F(DoorPlantTest, AStuckDoorIsAnErrorAndGoesOnAfterAReset) {
  faults({.is_stuck = true});
  command("FF 4F");
  cable.run_for(3s);
  EXPECT_EQ(state(), DoorState::error);
  faults({});
  command("FF EF");
  command("FF 4F");
  cable.run_for(3s);
  EXPECT_EQ(state(), DoorState::opened_with_torque);
}

TEST_F(DoorPlantTest, ABrokenBeltIsAnErrorToo) {
  open();
  faults({.belt_is_broken = true});
  command("FF 1F");
  cable.run_for(3s);
  EXPECT_EQ(state(), DoorState::error);
  EXPECT_EQ(plant.open_m(cable.now), 0.9);
}

TEST_F(DoorPlantTest, ADriveThatFailsOnTheWayRunsOutAndTells) {
  command("FF 4F");
  cable.run_for(1s);
  faults({.drive_fails = true});
  EXPECT_EQ(state(), DoorState::error);
  cable.run_for(5s);
  EXPECT_EQ(plant.speed_m_s(cable.now), 0);
  EXPECT_LT(plant.open_m(cable.now), 0.9);
}

TEST_F(DoorPlantTest, ALockThatIsStuckLeavesTheDoorClosed) {
  faults({.lock_is_stuck = true});
  command("FF 4F");
  cable.run_for(5s);
  EXPECT_EQ(state(), DoorState::error);
  EXPECT_EQ(plant.open_m(cable.now), 0);
  faults({});
  command("FF EF");
  command("FF 4F");
  cable.run_for(5s);
  EXPECT_EQ(state(), DoorState::opened_with_torque);
}

TEST_F(DoorPlantTest, ALockThatDoesNotCloseIsTold) {
  open();
  faults({.lock_is_stuck = true});
  command("FF 1F");
  cable.run_for(5s);
  EXPECT_EQ(cable.last(0x201), "201#01 00 00 00");
}

TEST_F(DoorPlantTest, ALockThatSpringsOpenIsToldAndTheDoorStaysClosed) {
  faults({.lock_is_open = true});
  EXPECT_FALSE(plant.is_locked(cable.now));
  EXPECT_EQ(cable.last(0x201), "201#01 10 00 00");
  cable.run_for(5s);
  EXPECT_EQ(plant.open_m(cable.now), 0);
  faults({});
  EXPECT_TRUE(plant.is_locked(cable.now));
  EXPECT_EQ(cable.last(0x201), "201#11 10 00 00");
}

TEST_F(DoorPlantTest, ASafetyContactThatIsBrokenIsTold) {
  faults({.contact_is_broken = true});
  EXPECT_EQ(cable.last(0x201), "201#10 10 00 00");
}

TEST_F(DoorPlantTest, ALightBarrierThatIsBrokenIsAnEmergency) {
  faults({.barrier_is_broken = true});
  EXPECT_EQ(cable.last(0x205), "205#BF");
  EXPECT_EQ(cable.last(0x089), "089#01 FF 01 01 00 00 00 00");
  faults({.barrier_is_covered = true});
  EXPECT_EQ(cable.last(0x205), "205#7F");
}

TEST_F(DoorPlantTest, DetectorsSeePeopleAndBreak) {
  plant.approach(true);
  plant.touch_edge(true);
  cable.run_for(0s);
  EXPECT_EQ(cable.last(0x201), "201#51 11 00 00");
  faults({.finger_protector_is_broken = true, .motion_detector_is_broken = true});
  EXPECT_EQ(cable.last(0x201), "201#91 12 00 00");
  EXPECT_EQ(cable.last(0x086), "086#03 FF 01 01 00 00 00 00");
}

TEST_F(DoorPlantTest, ADoorThatRunsOutIsStoppedByTheEndOfItsWay) {
  DoorPlant other{DoorPlantOptions{}};
  const cia417::DoorHardware hardware = other.hardware();
  hardware.drive({.motion = cia417::DoorDrive::Motion::open}, Time{});
  hardware.drive({.motion = cia417::DoorDrive::Motion::close}, Time(3s));
  const Time near_end = Time(3s) + 2300ms;
  ASSERT_NEAR(other.open_m(near_end), 0.037, 0.001);
  hardware.drive({}, near_end);
  EXPECT_EQ(other.open_m(Time(10s)), 0) << "0.25 m/s would take it 62 mm";
  hardware.drive({.motion = cia417::DoorDrive::Motion::open}, Time(10s));
  EXPECT_EQ(other.open_m(Time(12s)), 0.9) << "from its end it takes its 2 s";
  EXPECT_LT(other.open_m(Time(11999ms)), 0.9);
}

TEST_F(DoorPlantTest, ProfilesAreSlowerAndNarrower) {
  DoorPlant other{DoorPlantOptions{}};
  cia417::DoorHardware hardware = other.hardware();
  hardware.drive(
      {.motion = cia417::DoorDrive::Motion::open, .velocity_profile = 1, .width_profile = 1},
      Time{});
  EXPECT_NEAR(other.open_m(Time(1min)), 0.765, 1e-9);
  EXPECT_TRUE(hardware.sense(Time(1min)).is_open);
  EXPECT_GT(other.speed_m_s(Time(1s)), 0);
  EXPECT_LT(other.speed_m_s(Time(1s)), 0.43);
}

TEST(LoadCell, TheRopesCarryCarAndPeople) {
  LoadCell cell({.car_mass_kg = 1000, .ropes = 4, .rope_ratio = 2, .unevenness = 0.1});
  Cable cable;
  cia417::LoadMeasuringDevice<cia417::LiftDeviceOptions{}, 4> unit(
      cable.port(0), 13, cell.hardware(), {.tare_kg = 1000, .rope_ratio = 0x0201});
  cable.connect(0, unit.node());
  cell.set_load(600);
  cable.start_all();
  Dictionary& dictionary = unit.node().dictionary();
  EXPECT_EQ(dictionary.number(0x6480, 1), 600u);
  EXPECT_EQ(dictionary.number(0x6484, 1), 220u) << "a tenth more";
  EXPECT_EQ(dictionary.number(0x6484, 4), 180u);
  cell.break_sensor(2);
  cable.run_for(100ms);
  EXPECT_EQ(dictionary.number(0x6480, 1), 0xFFFFu);
}

}  // namespace
}  // namespace canvoy::lift::door_plant_test
