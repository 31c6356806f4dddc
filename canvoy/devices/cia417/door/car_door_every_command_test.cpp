// A small world, exhausted: every command of the controlword in every state of the door, and every
// controlword there is.
#include <gtest/gtest.h>

#include <array>

#include "canvoy/devices/cia417/door/car_door_unit_test.hpp"

namespace canvoy::cia417::car_door_every_command_test {
namespace {

using enum DoorState;

class EveryDoorCommand : public CarDoorTest {
 protected:
  /// Brings the door to a state by the commands that lead to it; the last command is none.
  void bring_to(DoorState wanted) {
    if (wanted == closed_with_torque) command(0x1);
    if (wanted == opening || wanted == stopped || wanted == error) start(0x4);
    if (wanted == closing || wanted == re_opening) {
      open();
      start(0x1);
    }
    if (wanted == opened_with_torque) open();
    if (wanted == opened_without_torque) {
      open();
      command(0xE);
    }
    if (wanted == stopped) command(0x8);
    if (wanted == error) fail();
    if (wanted == re_opening) turn();
    command(0xF);
    ASSERT_EQ(state(), wanted);
  }

 private:
  void start(unsigned number) {
    command(number);
    cable.run_for(1s);
  }
  void fail() {
    bench.has_fault = true;
    changed();
    bench.has_fault = false;
    changed();
  }
  void turn() {
    write(0x6304, 4, 1);
    bench.light_barrier = Detection::yes;
    changed();
    bench.light_barrier = Detection::no;
    changed();
  }
};

struct Row {
  DoorState from;
  DoorState after_close;
  DoorState after_open;
  DoorState after_stop;
  DoorState after_reset;
};
constexpr Row rows[] = {
    {closed_with_torque, closed_with_torque, opening, closed_with_torque, closed_without_torque},
    {closed_without_torque, closed_with_torque, opening, closed_with_torque, closed_without_torque},
    {closing, closing, opening, stopped, stopped},
    {opened_with_torque, closing, opened_with_torque, opened_with_torque, opened_without_torque},
    {opened_without_torque, closing, opened_with_torque, opened_with_torque, opened_without_torque},
    {opening, closing, opening, stopped, stopped},
    {re_opening, closing, opening, stopped, stopped},
    {stopped, closing, opening, stopped, stopped},
    {error, error, error, error, stopped},
};
DoorState expected(const Row& row, unsigned command) {
  if (command == 0x0 || command == 0x1) return row.after_close;
  if (command == 0x3 || command == 0x4) return row.after_open;
  if (command == 0x7 || command == 0x8) return row.after_stop;
  if (command == 0xE) return row.after_reset;
  return row.from;  // reserved, and no action
}

class EveryStateOfADoor : public EveryDoorCommand, public testing::WithParamInterface<Row> {};

TEST_P(EveryStateOfADoor, KnowsEveryCommandByPdoAndBySdo) {
  for (unsigned number = 0; number <= 0xF; ++number) {
    for (const bool by_sdo : {false, true}) {
      SCOPED_TRACE(testing::Message() << "command " << number << (by_sdo ? " by SDO" : " by PDO"));
      cable.send("000#81 06");
      cable.send("000#01 06");
      bench.position_mm = 0;
      changed();
      bring_to(GetParam().from);
      if (by_sdo) {
        order_by_sdo(number << 12 | 0xFFF);
      } else {
        command(number);
      }
      EXPECT_EQ(state(), expected(GetParam(), number));
      cable.run_for(5s);
      const DoorState end = state();
      EXPECT_FALSE(is_moving(end)) << "it comes to rest";
    }
  }
}
INSTANTIATE_TEST_SUITE_P(CiA417, EveryStateOfADoor, testing::ValuesIn(rows));

/// Result of a word for a door that is half open and cannot move.
struct Model {
  DoorState state = stopped;
  bool limits_force = true;
  bool is_reduced = false;
  bool detects_motion = true;
  bool protects_fingers = true;
  bool uses_battery = false;

  void obey(unsigned word) {
    const auto choose = [word](unsigned bit, bool& value, bool zero) {
      const unsigned field = word >> bit & 3;
      if (field < 2) value = (field == 0) == zero;
    };
    choose(10, is_reduced, false);
    choose(8, detects_motion, true);
    choose(6, protects_fingers, true);
    choose(2, uses_battery, false);
    const unsigned command = word >> 12;
    if (command <= 1) move(closing, command == 1);
    if (command == 3 || command == 4) move(opening, command == 4);
    if (command == 7 || command == 8) move(stopped, command == 8);
    if (command == 0xE) state = stopped;
  }
  void move(DoorState to, bool is_limited) {
    state = to;
    limits_force = is_limited;
  }
};

TEST_F(EveryDoorCommand, EveryControlwordDoesWhatItsFieldsSay) {
  command(0x4);
  cable.run_for(1s);
  command(0x8);
  bench.is_blocked = true;
  bench.motion = Detection::yes;
  bench.finger = Detection::yes;
  cable.send("000#80 06");
  Model model;
  model.limits_force = true;
  for (unsigned i = 0; i <= 0xFFFF; ++i) {
    // In an order in which each one follows very different ones.
    const unsigned word = i * 40'503 & 0xFFFF;
    const std::array bytes = {static_cast<std::uint8_t>(word),
                              static_cast<std::uint8_t>(word >> 8)};
    ASSERT_EQ(door.node().dictionary().write(0x6300, 1, bytes, Source::sdo), AbortCode::none);
    model.obey(word);
    const DoorReport& report = unit().report();
    ASSERT_EQ(report.state, model.state) << word;
    ASSERT_EQ(unit().driven().limits_force, model.limits_force) << word;
    ASSERT_EQ(unit().driven().is_reduced, model.is_reduced) << word;
    ASSERT_EQ(report.motion_detector == Detection::yes, model.detects_motion) << word;
    ASSERT_EQ(report.finger_protector == Detection::yes, model.protects_fingers) << word;
    ASSERT_EQ(bench.uses_battery, model.uses_battery) << word;
  }
}

TEST_F(EveryDoorCommand, EveryWordIsWhatItsFieldsAre) {
  for (unsigned word = 0; word <= 0xFFFF; ++word) {
    const auto bits = static_cast<std::uint16_t>(word);
    EXPECT_EQ(DoorOrder::of(bits).word(), word | 3) << "bits 1 and 0 are reserved, and 1";
    EXPECT_EQ(DoorReport::of(bits).word(), word);
  }
  EXPECT_EQ(DoorOrder{}.word(), 0xFFFF);
  EXPECT_EQ(DoorReport{}.word(), 0xFFFF);
}

TEST_F(EveryDoorCommand, APdoOfAnyOtherLengthMovesNothing) {
  for (const char* frame : {"200#", "200#FF", "200#FF 4F", "200#FF 4F FF FF FF FF FF"}) {
    cable.send(frame);
    EXPECT_EQ(state(), closed_without_torque) << frame;
  }
}

}  // namespace
}  // namespace canvoy::cia417::car_door_every_command_test
