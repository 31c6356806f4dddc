// Every value of every field of a door's statusword, typed from the tables of CiA 417-4, 4.7.1
// (errata A1: the safety contact is bits 1 and 0).
#include <gtest/gtest.h>

#include "canvoy/devices/cia417/door/car_door_unit_test.hpp"

namespace canvoy::cia417::car_door_status_test {
namespace {

/// A closed door with all detectors at "no", except for one.
struct Field {
  const char* name;
  Detection DoorReadings::*reading;
  unsigned words[4];  ///< no, yes, error, not available
};
class DoorStatusField : public testing::TestWithParam<Field> {};

TEST_P(DoorStatusField, HasItsTwoBitsForEachReading) {
  DoorReadings readings{.is_closed = true,
                        .position_mm = 0,
                        .force_limit = Detection::no,
                        .motion = Detection::no,
                        .finger = Detection::no,
                        .lock = Detection::no,
                        .safety_contact = Detection::no,
                        .battery = Detection::no};
  auto sense = [&readings](Time) { return readings; };
  DoorHardware hardware;
  hardware.sense = Callback<DoorReadings(Time)>::of(sense);
  Cable cable;
  CarDoorDevice<> device(cable.port(0), 6, {hardware});
  cable.connect(0, device.node());
  cable.start_all();
  cable.send("000#01 06");
  constexpr Detection all[] = {Detection::no, Detection::yes, Detection::error,
                               Detection::not_available};
  for (unsigned i = 0; i < 4; ++i) {
    readings.*GetParam().reading = all[i];
    cable.run_for(100ms);
    char frame[32];
    std::snprintf(frame, sizeof frame, "201#%02X %02X 00 00", GetParam().words[i] & 0xFF,
                  GetParam().words[i] >> 8);
    EXPECT_EQ(cable.last(0x201), frame);
  }
}
INSTANTIATE_TEST_SUITE_P(
    Of471, DoorStatusField,
    testing::Values(
        Field{"ForceLimit", &DoorReadings::force_limit, {0x1000, 0x1400, 0x1800, 0x1C00}},
        Field{"MotionDetector", &DoorReadings::motion, {0x1000, 0x1100, 0x1200, 0x1300}},
        Field{"FingerProtector", &DoorReadings::finger, {0x1000, 0x1040, 0x1080, 0x10C0}},
        Field{"DoorLock", &DoorReadings::lock, {0x1000, 0x1010, 0x1020, 0x1030}},
        Field{"BatteryPower", &DoorReadings::battery, {0x1000, 0x1004, 0x1008, 0x100C}},
        Field{"SafetyContact", &DoorReadings::safety_contact, {0x1000, 0x1001, 0x1002, 0x1003}}),
    [](const auto& test) { return test.param.name; });

using DoorStatus = CarDoorTest;

/// Bits 15 to 12, in a possible order of states of a door.
TEST_F(DoorStatus, HasEachOfItsStates) {
  const auto status = [this] { return word() >> 12; };
  EXPECT_EQ(status(), 0x1u) << "closed without torque";
  command(0x1);
  EXPECT_EQ(status(), 0x0u) << "closed with torque";
  command(0x4);
  EXPECT_EQ(status(), 0x5u) << "opening";
  cable.run_for(3s);
  EXPECT_EQ(status(), 0x3u) << "opened with torque";
  command(0xE);
  EXPECT_EQ(status(), 0x4u) << "opened without torque";
  write(0x6304, 4, 1);
  command(0x1);
  EXPECT_EQ(status(), 0x2u) << "closing";
  cable.run_for(1s);
  bench.light_barrier = Detection::yes;
  changed();
  EXPECT_EQ(status(), 0x6u) << "re-opening";
  command(0x8);
  EXPECT_EQ(status(), 0x7u) << "stopped";
  bench.has_fault = true;
  changed();
  EXPECT_EQ(status(), 0xEu) << "error indicator";
}

}  // namespace
}  // namespace canvoy::cia417::car_door_status_test
