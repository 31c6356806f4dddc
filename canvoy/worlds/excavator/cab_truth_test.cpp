#include "canvoy/worlds/excavator/cab_truth.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

namespace canvoy::excavator::cab_truth_test {
namespace {

constexpr unsigned bit(Lamp lamp) {
  return 1U << static_cast<unsigned>(lamp);
}

/// A machine that stands, cold, with a fifth of its fuel and without pilot pressure.
struct CabTruthTest : testing::Test {
  void light(std::size_t lamps) { seat.show_indicators(1, 1, static_cast<std::uint8_t>(lamps)); }
  void show(Shown what, double value) {
    seat.show_parameter(1, static_cast<unsigned>(what) + 1,
                        static_cast<std::int16_t>(std::lround(value)));
  }
  /// Shows all eight values, as the machine has them, with the angle of the boom as detail.
  void show_all() {
    show(Shown::fuel, fuel_percent());
    show(Shown::oil, machine.oil_celsius());
    show(Shown::slew, machine.angle(Movement::slew));
    show(Shown::height, machine.tip().z * 100);
    show(Shown::rpm, machine.rpm());
    show(Shown::reach, machine.tip().x * 100);
    show(Shown::page, 0);
    show(Shown::detail, machine.angle(Movement::boom));
  }
  /// Turns the rotator alone: the display stays as it is.
  void turn_rotator() {
    machine.set_pilot_pressure(true);
    machine.set_throttle(1);
    machine.command(Movement::rotator, 1);
  }
  double fuel_percent() const { return machine.litres() / Excavator::tank_litres * 100; }

  Excavator machine;
  SeatPanel panel;
  ValvesHardware valves{machine, [](Button, bool) {}};
  CabTruth sut{machine, panel, valves};
  cia852::OperatorHardware seat = panel.hardware();
};

/// Of a machine with a failed module, fuel and oil are unknown.
TEST_F(CabTruthTest, EachLampIsLookedAtWhicheverOfThreeFaultsAreThere) {
  for (const unsigned faults : {0U, 1U, 2U, 3U, 4U, 5U, 6U, 7U}) {
    const bool has_valves = (faults & 1) == 0;
    const bool has_armrest = (faults & 2) == 0;
    panel.break_wire(Stick::right_y, (faults & 4) != 0);
    const unsigned right = bit(Lamp::locked) | (has_valves ? bit(Lamp::ready) : 0) |
                           (faults != 0 ? bit(Lamp::fault) : 0);
    light(right);
    EXPECT_TRUE(sut.lamps_are_right(has_valves, has_armrest)) << faults;
    for (std::size_t i = 0; i < lamp_count; ++i) {
      const auto lamp = static_cast<Lamp>(i);
      light(right ^ bit(lamp));
      const bool is_unknown = !has_valves && (lamp == Lamp::low_fuel || lamp == Lamp::hot);
      EXPECT_EQ(sut.lamps_are_right(has_valves, has_armrest), is_unknown) << i << ' ' << faults;
    }
  }
}

TEST_F(CabTruthTest, WithoutTheModuleNoLevelIsShownThatNobodyMeasures) {
  EXPECT_TRUE(sut.display_is_right(Time(2s), false));
  for (std::size_t i = 0; i < shown_parameters; ++i) {
    const auto each = static_cast<Shown>(i);
    show(each, 0);
    EXPECT_FALSE(sut.display_is_right(Time(2s), false)) << i;
    show(each, no_value);
  }
}

/// Within half a percent of its limit, a lamp may be lit or not: it changes a moment later.
TEST_F(CabTruthTest, LowFuelAndHotOilAreToldOnceTheyAreClearlyBeyondTheirLimits) {
  turn_rotator();
  while (machine.oil_celsius() < Excavator::hot + 0.6) machine.step(1);
  light(bit(Lamp::ready));
  EXPECT_FALSE(sut.lamps_are_right(true, true)) << "the oil is hot";
  while (fuel_percent() > 15.4) machine.step(1);
  light(bit(Lamp::ready) | bit(Lamp::hot) | bit(Lamp::low_fuel));
  EXPECT_TRUE(sut.lamps_are_right(true, true)) << "a little early";
  while (fuel_percent() > 14.4) machine.step(1);
  light(bit(Lamp::ready) | bit(Lamp::hot));
  EXPECT_FALSE(sut.lamps_are_right(true, true)) << "the fuel is low";
}

TEST_F(CabTruthTest, EachValueOfTheDisplayIsLookedAt) {
  sut.step(Time(2s));
  show_all();
  EXPECT_TRUE(sut.display_is_right(Time(2s), true));
  for (const auto& [what, off] :
       {std::pair(Shown::fuel, 3), std::pair(Shown::oil, 4), std::pair(Shown::slew, 4),
        std::pair(Shown::height, 12), std::pair(Shown::rpm, 70), std::pair(Shown::reach, 12),
        std::pair(Shown::page, 1), std::pair(Shown::detail, 4)}) {
    for (const int by : {off, -off}) {
      show_all();
      show(what, panel.shown(what) + by);
      EXPECT_FALSE(sut.display_is_right(Time(2s), true)) << static_cast<int>(what);
    }
  }
  show_all();
  show(Shown::slew, panel.shown(Shown::slew) - 360);
  EXPECT_TRUE(sut.display_is_right(Time(2s), true)) << "a whole turn is none";
}

TEST_F(CabTruthTest, TheKnobTurnsPagesInBothDirectionsWithoutEnd) {
  machine.set_pilot_pressure(true);
  machine.step(0.1);
  show_all();
  const double details[] = {machine.angle(Movement::boom), machine.angle(Movement::stick),
                            machine.angle(Movement::bucket), machine.pressure_bar()};
  panel.turn_knob(-4);
  for (unsigned clicks = 0; clicks < 9; ++clicks, panel.turn_knob(1)) {
    const unsigned page = clicks % display_pages;
    show(Shown::page, page);
    for (const double off : {0, 6}) {
      show(Shown::detail, details[page] + off);
      EXPECT_EQ(sut.display_is_right(Time(2s), true), off == 0) << clicks;
    }
  }
}

TEST_F(CabTruthTest, AMachineThatHasJustMovedMayBeShownWhereItWas) {
  turn_rotator();
  for (int i = 0; i < 10; ++i) machine.step(0.1);
  sut.step(Time(10s));
  show_all();
  show(Shown::height, panel.shown(Shown::height) + 100);
  EXPECT_TRUE(sut.display_is_right(Time(11s), true)) << "it is told a moment later";
  EXPECT_FALSE(sut.display_is_right(Time(11s) + 1us, true));
  show(Shown::height, panel.shown(Shown::height) + 100);
  EXPECT_FALSE(sut.display_is_right(Time(11s), true));
}

/// While the machine moves, its pressure may be off by 400 bar: by that of all its load at once.
TEST_F(CabTruthTest, AMovingPressureIsLookedAtAsWell) {
  turn_rotator();
  for (int i = 0; i < 10; ++i) machine.step(0.1);
  sut.step(Time(10s));
  show_all();
  panel.turn_knob(3);
  show(Shown::page, 3);
  const double bar = machine.pressure_bar();
  show(Shown::detail, std::ceil(bar) - 400);
  EXPECT_TRUE(sut.display_is_right(Time(10s), true));
  show(Shown::detail, std::floor(bar) + 400);
  EXPECT_TRUE(sut.display_is_right(Time(10s), true));
  for (const double off : {std::floor(bar) - 401, std::floor(bar) + 401}) {
    show(Shown::detail, off);
    EXPECT_FALSE(sut.display_is_right(Time(10s), true)) << off;
  }
}

TEST_F(CabTruthTest, WithoutAHostNothingIsShownButTheLampOfFaults) {
  light(lamps_without_host.to_ulong());
  EXPECT_TRUE(sut.is_as_without_host());
  for (std::size_t i = 0; i < shown_parameters; ++i) {
    show(static_cast<Shown>(i), 0);
    EXPECT_FALSE(sut.is_as_without_host()) << i;
    show(static_cast<Shown>(i), no_value);
  }
  light(0);
  EXPECT_FALSE(sut.is_as_without_host());
}

}  // namespace
}  // namespace canvoy::excavator::cab_truth_test
