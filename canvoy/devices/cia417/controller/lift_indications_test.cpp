// States that a lift reports to its panels: each special indication (CiA 417-4, 4.4.1, basic
// function 43h), in the car and, where it applies, at the floors.
#include <gtest/gtest.h>

#include "canvoy/devices/cia417/controller/lift_controller_test.hpp"

namespace canvoy::cia417::lift_indications_test {
namespace {

class LiftIndicationsTest : public LiftBenchTest {
 protected:
  void turn(SpecialFunction function, bool on = true) {
    bench.turn(function, on);
    bench.step();
  }
  /// Number of changes since the last call.
  struct Told {
    std::size_t in_car;
    std::size_t at_floors;
    bool operator==(const Told&) const = default;
  };
  Told told(unsigned indication, bool on) {
    bench.run_for(50ms);
    char car[32];
    std::snprintf(car, sizeof car, "400#43 %02X 01 00 F0 0%u", indication, on ? 1U : 0U);
    char floors[32];
    std::snprintf(floors, sizeof floors, "400#43 %02X 01 FF F0 0%u", indication, on ? 1U : 0U);
    const Told made = {bench.told(car), bench.told(floors)};
    return made;
  }
  /// Of a key: on with it, off without.
  void expect_of(SpecialFunction function, unsigned indication, Told expected) {
    bench.cable.clear();
    turn(function);
    EXPECT_EQ(told(indication, true), expected) << static_cast<unsigned>(function);
    EXPECT_EQ(told(indication, false), (Told{0, 0}));
    turn(function, false);
    EXPECT_EQ(told(indication, false), expected) << static_cast<unsigned>(function);
  }

  static constexpr Told nobody = {0, 0};
  static constexpr Told car_alone = {1, 0};
  static constexpr Told everybody = {1, 1};
};

TEST_F(LiftIndicationsTest, NoLoadIsThatOfTheLoadUnit) {
  bench.weighed.zero = true;
  EXPECT_EQ(told(0x01, true), car_alone);
  bench.weighed.zero = false;
  EXPECT_EQ(told(0x01, false), car_alone);
}

TEST_F(LiftIndicationsTest, FullLoadIsToldWithoutOverloadAlone) {
  bench.weighed.full = true;
  EXPECT_EQ(told(0x02, true), everybody);
  EXPECT_EQ(told(0x03, true), nobody);
  bench.weighed.overload = true;
  EXPECT_EQ(told(0x02, false), everybody);
  EXPECT_EQ(told(0x03, true), car_alone);
  bench.weighed.overload = false;
  EXPECT_EQ(told(0x03, false), car_alone);
}

TEST_F(LiftIndicationsTest, FireIsThatOfBothFireServices) {
  for (const SpecialFunction function :
       {SpecialFunction::fire_service_enable, SpecialFunction::fire_service}) {
    bench.cable.clear();
    turn(function);
    EXPECT_EQ(told(0x04, true), everybody);
    ASSERT_TRUE(bench.run_to(1, LiftPhase::open));
    bench.run_for(1s);
    EXPECT_EQ(told(0x04, false), nobody);
    turn(function, false);
    ASSERT_TRUE(bench.run_until([&] { return lift.service() == LiftService::normal; }));
    EXPECT_EQ(told(0x04, false), everybody);
    ASSERT_TRUE(bench.run_to(1, LiftPhase::idle));
  }
}

TEST_F(LiftIndicationsTest, FireBrigadeServiceBeginsAtTheFireFloor) {
  bench.press("05 03 01 00 11 01");
  ASSERT_TRUE(bench.run_to(3, LiftPhase::idle));
  bench.cable.clear();
  turn(SpecialFunction::fire_service);
  EXPECT_EQ(told(0x05, true), nobody) << "it is called there first";
  ASSERT_TRUE(bench.run_until([&] { return lift.service() == LiftService::fire_brigade; }));
  EXPECT_EQ(told(0x05, true), everybody);
  turn(SpecialFunction::fire_service, false);
  EXPECT_EQ(told(0x05, false), everybody);
}

TEST_F(LiftIndicationsTest, HelpIsComingWhileSomebodySpeaks) {
  const VirtualInput alarm{.function = BasicFunction::speech_connection, .lifts = 1, .doors = 0x10};
  bench.device.calls().connected(alarm, true);
  EXPECT_EQ(told(0x06, true), car_alone);
  lift.update();
  EXPECT_EQ(told(0x06, false), nobody);
  bench.device.calls().connected(alarm, false);
  EXPECT_EQ(told(0x06, false), car_alone);
}

TEST_F(LiftIndicationsTest, SpecialServiceIsThatOfThoseWhoWorkWithTheLift) {
  for (const SpecialFunction function :
       {SpecialFunction::special_service, SpecialFunction::service_run,
        SpecialFunction::dogging_service_enable}) {
    expect_of(function, 0x07, everybody);
  }
}

TEST_F(LiftIndicationsTest, LoadTimeIsThatOfEitherOne) {
  expect_of(SpecialFunction::load_time_1, 0x08, car_alone);
  expect_of(SpecialFunction::load_time_2, 0x08, car_alone);
}

TEST_F(LiftIndicationsTest, OccupiedIsACarForSomebodyAlone) {
  expect_of(SpecialFunction::vip_service, 0x09, everybody);
  expect_of(SpecialFunction::bed_passenger_service, 0x09, everybody);
}

TEST_F(LiftIndicationsTest, OutOfOrderIsThatOfTheKeyAndOfEachFault) {
  expect_of(SpecialFunction::out_of_order, 0x0A, everybody);
  bench.cable.clear();
  bench.car.motion.available = false;
  EXPECT_EQ(told(0x0A, true), everybody);
}

// Functions with an effect of their own.

TEST_F(LiftIndicationsTest, EitherLoadTimeHoldsTheDoorsForLonger) {
  for (const SpecialFunction function :
       {SpecialFunction::load_time_1, SpecialFunction::load_time_2}) {
    turn(function);
    bench.press("05 03 01 00 11 01");
    ASSERT_TRUE(bench.run_to(3, LiftPhase::open));
    bench.run_for(14900ms);
    EXPECT_EQ(lift.phase(), LiftPhase::open);
    bench.run_for(200ms);
    EXPECT_EQ(lift.phase(), LiftPhase::closing);
    turn(function, false);
    bench.press("05 02 01 00 11 01");
    ASSERT_TRUE(bench.run_to(2, LiftPhase::idle));
  }
}

TEST_F(LiftIndicationsTest, AFanRunsWhileItsLampIsLit) {
  for (const SpecialFunction function : {SpecialFunction::fan_1, SpecialFunction::fan_2}) {
    turn(function);
    EXPECT_TRUE(bench.device.calls().is_on(function));
    turn(function, false);
    EXPECT_FALSE(bench.device.calls().is_on(function));
  }
}

TEST(KeyLocks, EachLetsCallsToItsOwnFloors) {
  for (unsigned key = 1; key <= 4; ++key) {
    Cable cable;
    CallControllerSettings settings{.lift = 1, .served = {FloorSet::between(1, 20)}};
    for (std::uint8_t floor = 1; floor <= 4; ++floor) {
      settings.locked_by_key[floor - 1U].insert(static_cast<std::uint8_t>(10 + floor));
    }
    CallControllerDevice<> device(cable.port(0), 1, settings);
    cable.connect(0, device.node());
    cable.start_all();
    cable.send("000#01 01");
    cable.run_for(1s);
    char turned[32];
    std::snprintf(turned, sizeof turned, "490#0E %02X 01 00 10 81", 4 + key);
    cable.send(turned);
    cable.run_for(10ms);
    for (unsigned floor = 11; floor <= 14; ++floor) {
      char press[32];
      std::snprintf(press, sizeof press, "490#05 %02X 01 00 11 01", floor);
      cable.send(press);
      cable.run_for(10ms);
      char answer[32];
      std::snprintf(answer, sizeof answer, "400#05 %02X 01 00 F1 %s", floor,
                    floor == 10 + key ? "81" : "00");
      EXPECT_EQ(cable.last(0x400), answer) << "key " << key;
    }
  }
}

}  // namespace
}  // namespace canvoy::cia417::lift_indications_test
