// The car as a plant: alone, with numbers calculated by hand, and with a drive, a controller and a
// position unit on a simulated bus.
#include "canvoy/worlds/lift/car_plant.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "canvoy/devices/cia417/drive/car_drive_controller_device.hpp"
#include "canvoy/devices/cia417/drive/car_drive_device.hpp"
#include "canvoy/devices/cia417/position/car_position_device.hpp"
#include "canvoy/sim/world.hpp"

namespace canvoy::lift::car_plant_test {
namespace {

using cia417::MotionLimits;
using cia417::MotionProfile;

/// 3000 kg in total, so that 3000 N are 1 m/s2; balanced with 500 kg in it.
constexpr CarPlantDesign design = {.car_kg = 1000,
                                   .counterweight_kg = 1500,
                                   .rotating_kg = 0,
                                   .friction_n = 0,
                                   .stretch_um_per_kg = 0,
                                   .brake_force_n = 9000,
                                   .motor_efficiency = 0.5,
                                   .regeneration_efficiency = 0.25,
                                   .standby_w = 0};

class CarPlantAlone : public testing::Test {
 protected:
  Time read_clock() { return now; }
  /// Accelerates to 1 m/s, and stays there.
  void run_up(double velocity = 1) {
    drive.power(true);
    drive.release_brake(true);
    const MotionLimits limits{
        .velocity = 10, .acceleration = 1, .deceleration = 1, .type = cia402::ProfileType::linear};
    drive.follow(MotionProfile::to_velocity({}, velocity * 10'000, in_increments(limits)),
                 Duration{});
    now += 1s;
  }
  static MotionLimits in_increments(MotionLimits limits) {
    for (double* limit : {&limits.velocity, &limits.acceleration, &limits.deceleration}) {
      *limit *= 10'000;
    }
    return limits;
  }
  Time now{};
  Callback<Time()> clock = callback<&CarPlantAlone::read_clock>(*this);
  CarPlant plant{design, clock};
  cia417::CarDriveHardware drive = plant.drive_hardware();
  cia417::CarPositionHardware position = plant.position_hardware();
};

TEST_F(CarPlantAlone, FollowsTheProfileOfTheDriveAfterItsDelay) {
  drive.power(true);
  drive.release_brake(true);
  const MotionLimits limits{.velocity = 2, .type = cia402::ProfileType::linear};
  drive.follow(MotionProfile::to_position({}, 40'000, in_increments(limits)), 200ms);
  now += 200ms;
  EXPECT_EQ(plant.truth().position_m, 0);
  now += 1s;
  EXPECT_NEAR(plant.truth().position_m, 0.5, 1e-9);
  EXPECT_NEAR(plant.truth().velocity_m_s, 1, 1e-9);
  EXPECT_NEAR(plant.truth().acceleration_m_s2, 1, 1e-9);
  EXPECT_NEAR(drive.sense().position, 5'000, 1e-6);
  EXPECT_NEAR(position.sense(1).velocity_millimetre_per_second, 1000, 1e-6);
  now += 10s;
  EXPECT_NEAR(plant.truth().position_m, 4, 1e-9);
}

TEST_F(CarPlantAlone, LosesNothingByAClockThatGoesOnWhileItIsRead) {
  auto read = [this] { return now += 5us; };
  CarPlant hasty(design, Callback<Time()>::of(read));
  const cia417::CarDriveHardware of_hasty = hasty.drive_hardware();
  of_hasty.power(true);
  of_hasty.release_brake(true);
  const MotionLimits limits{.velocity = 2, .type = cia402::ProfileType::linear};
  of_hasty.follow(MotionProfile::to_position({}, 140'000, in_increments(limits)), 200ms);
  for (int i = 0; i < 2000; ++i) {
    now += 10ms;
    of_hasty.sense();
  }
  EXPECT_NEAR(hasty.truth().position_m, 14, 1e-9);
}

TEST_F(CarPlantAlone, MovesAlikeWhetherLookedAtOrNot) {
  CarPlant alone{design, clock};
  for (CarPlant* each : {&plant, &alone}) {
    each->set_faults({.slip = 0.1});
    drive = each->drive_hardware();
    run_up();
    now = Time{};
  }
  for (int i = 1; i <= 777; ++i) {
    now = Time{} + i * 1234us;
    // 1 m/s2, of which the ropes lose a tenth.
    const double t = i * 0.001234;
    EXPECT_NEAR(plant.look().position_m, 0.9 * t * t / 2, 1e-9);
    EXPECT_NEAR(plant.look().way_m, 0.9 * t * t / 2, 1e-9);
  }
  EXPECT_EQ(plant.truth().position_m, alone.truth().position_m);
  EXPECT_EQ(plant.truth().energy_in_joule, alone.truth().energy_in_joule);
}

TEST_F(CarPlantAlone, IsStoppedByItsBrake) {
  plant.set_load(500);
  run_up();
  const double from = plant.truth().position_m;
  drive.release_brake(false);
  // 9000 N on 3000 kg: 3 m/s2.
  now += 200ms;
  EXPECT_NEAR(plant.truth().velocity_m_s, 0.4, 1e-9);
  now += 1s;
  EXPECT_EQ(plant.truth().velocity_m_s, 0);
  EXPECT_NEAR(plant.truth().position_m - from, 1.0 / 6, 1e-9);
}

TEST_F(CarPlantAlone, IsPulledByItsCounterweightWhereNothingHoldsIt) {
  // 500 kg less than the counterweight: 4905 N on 2500 kg.
  drive.release_brake(true);
  now += 1s;
  EXPECT_NEAR(plant.truth().velocity_m_s, 4905.0 / 2500, 1e-9);
  EXPECT_GT(plant.truth().position_m, 0);
  drive.arrest();
  now += 2s;
  EXPECT_EQ(plant.truth().velocity_m_s, 0) << "the safety gear has it";
  EXPECT_TRUE(plant.truth().gear_is_caught);
}

TEST_F(CarPlantAlone, SlidesThroughAWeakBrakeAndStandsByAGoodOne) {
  plant.set_faults({.brake_share = 0.5});
  now += 1s;
  // 4905 N against 4500 N.
  EXPECT_NEAR(plant.truth().velocity_m_s, 405.0 / 2500, 1e-9);
  plant.set_faults({});
  now += 1s;
  EXPECT_EQ(plant.truth().velocity_m_s, 0);
}

TEST_F(CarPlantAlone, TurnsRoundWhereItsPullIsStrongerThanItsBrake) {
  plant.set_load(500);
  run_up();
  plant.set_faults({.brake_share = 0});
  plant.set_load(1500);
  drive.release_brake(false);
  drive.power(false);
  for (int i = 0; i < 50; ++i) {
    now += 20ms;
    plant.truth();
  }
  // 9810 N on 4000 kg, from 1 m/s up to as much down within 0.82 s.
  EXPECT_NEAR(plant.truth().velocity_m_s, 1 - 9.81 / 4, 0.05);
}

TEST_F(CarPlantAlone, TakesEnergyToLiftAndGivesAPartOfItBack) {
  plant.set_load(1500);  // 1000 kg more than the counterweight
  drive.power(true);
  drive.release_brake(true);
  const MotionLimits limits{.velocity = 2, .type = cia402::ProfileType::linear};
  drive.follow(MotionProfile::to_position({}, 100'000, in_increments(limits)), Duration{});
  now += 20s;
  // 1000 kg by 10 m, and twice as much energy from the mains.
  EXPECT_NEAR(plant.truth().energy_in_joule, 2 * 1000 * 9.81 * 10, 1e-3);
  EXPECT_EQ(plant.truth().energy_out_joule, 0);
  drive.follow(MotionProfile::to_position({100'000, 0, 0}, 0, in_increments(limits)), Duration{});
  now += 20s;
  EXPECT_NEAR(plant.truth().energy_out_joule, 0.25 * 1000 * 9.81 * 10, 1e-3);
  EXPECT_NEAR(plant.truth().way_m, 20, 1e-9);
}

TEST_F(CarPlantAlone, StrikesTheBufferAtTheEndOfItsShaft) {
  plant.set_load(500);
  run_up();
  now += 60s;
  EXPECT_EQ(plant.truth().buffer_strikes, 1U);
  EXPECT_NEAR(plant.truth().position_m, 30.3, 1e-9);
  EXPECT_EQ(plant.truth().velocity_m_s, 0);
}

TEST_F(CarPlantAlone, ADeadEncoderTellsWhereTheCarWas) {
  plant.set_load(500);
  run_up();
  plant.set_faults({.position_encoder_is_dead = true});
  const double was = position.sense(1).position_millimetre;
  now += 1s;
  EXPECT_EQ(position.sense(1).position_millimetre, was);
  EXPECT_EQ(position.sense(1).velocity_millimetre_per_second, 0);
  EXPECT_GT(plant.truth().position_m, 1.4);
  plant.set_faults({});
  EXPECT_GT(position.sense(1).position_millimetre, was + 900);
}

TEST_F(CarPlantAlone, RunsAwayWhereItsDriveHasADeadEncoder) {
  plant.set_load(500);
  run_up();
  plant.set_faults({.drive_encoder_is_dead = true});
  now += 1s;
  EXPECT_NEAR(plant.truth().velocity_m_s, 1.8, 1e-9);
  EXPECT_EQ(drive.sense().velocity, 0);
}

TEST_F(CarPlantAlone, SlipsOnItsSheaveSoThatTheDriveSeesMoreThanThereIs) {
  plant.set_load(500);
  plant.set_faults({.slip = 0.1});
  run_up();
  now += 4s;
  EXPECT_NEAR(drive.sense().position, 45'000, 1e-6);
  EXPECT_NEAR(plant.truth().position_m, 4.05, 1e-9);
  EXPECT_NEAR(drive.sense().position, 45'000, 1e-6);
}

TEST_F(CarPlantAlone, TheCarSinksByItsLoadAndTheMotorDoesNotSeeIt) {
  CarPlantDesign soft = design;
  soft.stretch_um_per_kg = 2;
  auto read = [this] { return now; };
  CarPlant elastic(soft, Callback<Time()>::of(read));
  elastic.set_load(1000);
  EXPECT_NEAR(elastic.truth().position_m, -0.002, 1e-12);
  EXPECT_EQ(elastic.drive_hardware().sense().position, 0);
  EXPECT_NEAR(elastic.position_hardware().sense(1).position_millimetre, -2, 1e-9);
}

TEST_F(CarPlantAlone, IsWhereADriveElsewhereHasIt) {
  cia417::MotionState elsewhere{3.5, 1, 0};
  auto read = [&] { return elsewhere; };
  plant.lead_by(Callback<cia417::MotionState()>::of(read));
  EXPECT_EQ(plant.truth().position_m, 3.5);
  now += 1s;
  elsewhere.position = 4.5;
  EXPECT_EQ(plant.truth().position_m, 4.5);
  EXPECT_EQ(plant.truth().velocity_m_s, 1);
  EXPECT_NEAR(plant.truth().way_m, 1, 1e-9);
  EXPECT_EQ(position.sense(1).position_millimetre, 4500);
}

// With a drive, a controller and a position unit on a bus.

class CarOnABus : public testing::Test {
 protected:
  CarOnABus() {
    world.occupy(slots[0], controller.node());
    world.occupy(slots[1], drive.node());
    world.occupy(slots[2], position.node());
    for (const SlotIndex slot : slots) world.start(slot);
    world.run_for(100ms);
    constexpr std::uint8_t of_position_unit[] = {0x84, 0, 0, 0};
    drive.node().dictionary().write(0x1028, 4, of_position_unit, Source::application);
    for (Node* node : {&controller.node(), &drive.node(), &position.node()}) {
      node->command(NmtCommand::start);
    }
    touch();
    world.run_for(500ms);
  }
  void touch() {
    for (const SlotIndex slot : slots) world.touched(slot);
  }
  SlotIndex slot() { return world.add_slot(bus); }
  void travel_to(std::int32_t micrometre) {
    controller.node().advance(world.now());
    controller.unit().controller().travel_to(micrometre);
    touch();
  }
  cia417::MotionStatus status() { return controller.unit().controller().status(); }

  World world;
  BusIndex bus = world.add_bus({.bit_rate = 250'000});
  std::array<SlotIndex, 3> slots{slot(), slot(), slot()};
  CarPlant plant{{}, callback<&World::now>(world)};
  cia417::CarDriveControllerDevice<> controller{world.port(slots[0]), 1};
  cia417::CarDriveDevice<> drive{world.port(slots[1]), 2, plant.drive_hardware()};
  cia417::CarPositionDevice<> position{world.port(slots[2]),
                                       4,
                                       plant.position_hardware(),
                                       {.overspeed_millimetre_per_second = 1840}};
};

TEST_F(CarOnABus, TravelsFromFloorToFloorToTheMillimetre) {
  for (const std::int32_t floor : {10'500'000, 3'500'000, 28'000'000, 0}) {
    travel_to(floor);
    world.run_for(25s);
    EXPECT_TRUE(status().arrived) << floor;
    EXPECT_NEAR(plant.truth().position_m * 1e6, floor, 1000);
    EXPECT_TRUE(plant.truth().brake_is_closed);
    EXPECT_EQ(plant.truth().buffer_strikes, 0U);
  }
  EXPECT_EQ(world.livelocks(), 0U);
}

TEST_F(CarOnABus, ADeadEncoderOfTheDriveEndsBehindTheBrakeAndServiceResumes) {
  travel_to(28'000'000);
  world.run_for(5s);
  plant.set_faults({.drive_encoder_is_dead = true});
  world.run_for(1500ms);
  EXPECT_EQ(plant.truth().velocity_m_s, 0);
  EXPECT_TRUE(plant.truth().brake_is_closed);
  EXPECT_EQ(drive.unit().state(), cia417::DriveState::fault);
  EXPECT_FALSE(status().available);
  plant.set_faults({});
  world.run_for(5s);
  EXPECT_TRUE(status().available);
  travel_to(28'000'000);
  world.run_for(25s);
  EXPECT_TRUE(status().arrived);
}

TEST_F(CarOnABus, ADeadEncoderOfThePositionUnitStopsTheCarFast) {
  travel_to(28'000'000);
  world.run_for(5s);
  plant.set_faults({.position_encoder_is_dead = true});
  world.run_for(4s);
  EXPECT_EQ(plant.truth().velocity_m_s, 0);
  EXPECT_TRUE(plant.truth().brake_is_closed);
  EXPECT_FALSE(status().available);
  plant.set_faults({});
  world.run_for(1s);
  EXPECT_TRUE(status().available);
}

TEST_F(CarOnABus, ARunawayMotorIsCaughtAndTheDriveStaysInFault) {
  travel_to(28'000'000);
  world.run_for(5s);
  plant.set_faults({.motor_runs_away = true});
  world.run_for(4s);
  EXPECT_EQ(plant.truth().velocity_m_s, 0);
  EXPECT_EQ(plant.truth().buffer_strikes, 0U);
  EXPECT_TRUE(plant.truth().brake_is_closed);
}

TEST_F(CarOnABus, ASafetyChainThatOpensStopsTheCarByItsBrakeWhateverTheDriveWants) {
  travel_to(28'000'000);
  world.run_for(6s);
  const double at_m = plant.truth().position_m;
  ASSERT_NEAR(plant.truth().velocity_m_s, 1.6, 0.001);
  plant.cut(true);
  EXPECT_TRUE(plant.truth().brake_is_closed);
  EXPECT_TRUE(plant.truth().is_cut);
  world.run_for(1s);
  EXPECT_EQ(plant.truth().velocity_m_s, 0);
  EXPECT_LT(plant.truth().position_m - at_m, 0.6) << "less than a quick stop of the drive";
  EXPECT_NE(drive.unit().state(), cia417::DriveState::fault);
  const double stood_m = plant.truth().position_m;
  world.run_for(10s);
  EXPECT_EQ(plant.truth().position_m, stood_m);
  plant.cut(false);
  travel_to(28'000'000);
  world.run_for(30s);
  EXPECT_NEAR(plant.truth().position_m, 28, 0.001);
}

TEST_F(CarOnABus, ABrakeThatSlidesIsUnintendedMovement) {
  world.run_for(1s);
  plant.set_faults({.brake_share = 0.1});
  world.run_for(1500ms);
  EXPECT_TRUE(plant.truth().gear_is_caught);
  EXPECT_EQ(drive.unit().state(), cia417::DriveState::fault);
  EXPECT_LT(std::abs(plant.truth().position_m), 0.3);
}

TEST_F(CarOnABus, ABrakeThatDoesNotOpenIsAFollowingError) {
  plant.set_faults({.brake_is_stuck = true});
  travel_to(10'500'000);
  world.run_for(2500ms);
  EXPECT_EQ(plant.truth().position_m, 0);
  EXPECT_EQ(drive.unit().state(), cia417::DriveState::fault);
}

}  // namespace
}  // namespace canvoy::lift::car_plant_test
