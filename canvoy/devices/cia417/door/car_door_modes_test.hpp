// A car door unit with a configuration that the test sets, and the events in its doorway.
#pragma once

#include <gtest/gtest.h>

#include "canvoy/devices/cia417/door/car_door_unit_test.hpp"

namespace canvoy::cia417 {

class CarDoorModes : public CarDoorTest {
 protected:
  // Sub-indices of 6304h.
  static constexpr unsigned light_barrier = 0x04;
  static constexpr unsigned force_limit = 0x05;
  static constexpr unsigned finger_protector = 0x06;
  static constexpr unsigned motion_detection = 0x07;
  static constexpr unsigned barrier_reclose = 0x08;
  static constexpr unsigned force_reclose = 0x09;
  static constexpr unsigned broken_reclose = 0x0A;
  static constexpr unsigned heartbeat_lost = 0x0B;

  void set(unsigned sub, unsigned value) {
    write(0x6304, sub, value);
    ASSERT_EQ(cable.last(0x586).substr(0, 6), "586#60");
  }
  /// Opens, then closes for a second: at 600 mm.
  void close_for_a_second() {
    open();
    command(0x1);
    cable.run_for(1s);
    ASSERT_EQ(state(), DoorState::closing);
  }
  /// Expects the door to be open until then.
  void expect_closing_after(Duration time) {
    cable.run_for(time - 1ms);
    EXPECT_EQ(state(), DoorState::opened_with_torque);
    cable.run_for(1ms);
    EXPECT_EQ(state(), DoorState::closing);
  }
  void see(Detection seen) {
    bench.light_barrier = seen;
    changed();
  }
  /// A person passes while the door closes: it re-opens, and closes again `reclose` seconds later.
  void let_one_pass(unsigned reclose) {
    set(light_barrier, 1);
    set(barrier_reclose, reclose);
    close_for_a_second();
    see(Detection::yes);
    see(Detection::no);
    cable.run_for(1s);
    ASSERT_EQ(state(), DoorState::opened_with_torque);
  }
  void push(bool against) {
    bench.force_limit = against ? Detection::yes : Detection::no;
    bench.is_blocked = against;
    changed();
  }
  void move(bool is_seen) {
    bench.motion = is_seen ? Detection::yes : Detection::no;
    changed();
  }
  void pinch(bool is_felt) {
    bench.finger = is_felt ? Detection::yes : Detection::no;
    changed();
  }
};

}  // namespace canvoy::cia417
