// 254 floors with four doors each: a call to every floor and door is acknowledged, given to a lift,
// and done when that lift has been there.
#include <gtest/gtest.h>

#include <cstdio>

#include "canvoy/canopen/testing/cable.hpp"
#include "canvoy/devices/cia417/controller_device/call_controller_device.hpp"
#include "canvoy/devices/cia417/group/destination_dispatcher.hpp"
#include "canvoy/devices/cia417/group/hall_dispatcher.hpp"

namespace canvoy::cia417::tall_building_calls_test {
namespace {

constexpr FloorSet all = FloorSet::between(1, 254);

class TallCallsTest : public testing::Test {
 protected:
  TallCallsTest() {
    cable.connect(0, device.node());
    cable.start_all();
    cable.send("000#01 01");
    cable.run_for(1s);
  }
  std::string answer_to(const std::string& record) {
    cable.clear();
    cable.send("490#" + record);
    cable.run_for(1ms);
    return cable.last(0x400);
  }

  Cable cable;
  CallControllerDevice<> device{cable.port(0), 1, {.lift = 1, .served = {all, all, all, all}}};
  CallController& calls = device.calls();
};

TEST_F(TallCallsTest, ACarCallToEachFloorAndDoorIsAcknowledgedAndServed) {
  char text[40];
  for (unsigned floor = 1; floor <= 254; ++floor) {
    for (unsigned door = 1; door <= 4; ++door) {
      std::snprintf(text, sizeof text, "05 %02X 01 00 %02X 01", floor, 0x10U | 1U << (door - 1));
      const std::string answer = answer_to(text);
      std::snprintf(text, sizeof text, "400#05 %02X 01 00 %02X 81", floor,
                    0xF0U | 1U << (door - 1));
      EXPECT_EQ(answer, text);
    }
    const auto number = static_cast<std::uint8_t>(floor);
    EXPECT_EQ(calls.calls().doors_at(number, car_calls), 0b1111);
    calls.answered(number, Direction::up);
    cable.run_for(10ms);
    EXPECT_EQ(calls.calls().doors_at(number, car_calls), 0);
  }
}

TEST_F(TallCallsTest, AHallCallAtEachFloorAndDoorIsAcknowledgedAndServed) {
  char text[40];
  for (unsigned floor = 1; floor <= 254; ++floor) {
    const unsigned way = floor == 1 ? hall_up : hall_down;
    for (unsigned door = 1; door <= 4; ++door) {
      std::snprintf(text, sizeof text, "02 %02X 01 %02X %02X 01", way, floor, 0x10U << (door - 1));
      const std::string answer = answer_to(text);
      std::snprintf(text, sizeof text, "400#02 %02X 01 %02X %02X 81", way, floor,
                    0x10U << (door - 1));
      EXPECT_EQ(answer, text);
    }
    calls.answered(static_cast<std::uint8_t>(floor), floor == 1 ? Direction::up : Direction::down);
    cable.run_for(10ms);
  }
  EXPECT_TRUE(calls.calls().empty());
}

TEST_F(TallCallsTest, EachDestinationFromTheMainFloorIsKeptAtOnce) {
  char text[40];
  for (unsigned to = 2; to <= 254; ++to) {
    std::snprintf(text, sizeof text, "08 %02X 01 01 11 01", to);
    const std::string answer = answer_to(text);
    std::snprintf(text, sizeof text, "400#08 %02X 01 01 11 81", to);
    EXPECT_EQ(answer, text);
  }
  EXPECT_EQ(calls.destinations_without_room(), 0u);
  calls.answered(1, Direction::up);
  EXPECT_EQ(calls.calls().floors(car_calls), FloorSet::between(2, 254));
}

TEST(TallDispatchTest, EachHallCallAndDestinationIsGivenToALiftAndServed) {
  std::array<GroupLift, 8> lifts;
  for (unsigned i = 0; i < lifts.size(); ++i) {
    lifts[i] = {.in_service = true,
                .floor = static_cast<std::uint8_t>(1 + 36 * i),
                .served = {all, all, all, all}};
  }
  std::array<HallDispatcher::Slot, 4> hall_slots{};
  HallDispatcher hall(lifts, hall_slots);
  std::array<DestinationDispatcher::Slot, 8> destination_slots{};
  DestinationDispatcher destinations(lifts, destination_slots);
  hall.plan_with(destinations.plans());
  destinations.plan_with(hall.plans());
  for (unsigned i = 1; i <= 254; ++i) {
    const auto floor = static_cast<std::uint8_t>(i);
    const auto target = static_cast<std::uint8_t>(255 - i);
    const Direction way = floor == 254 ? Direction::down : Direction::up;
    EXPECT_EQ(hall.add({.floor = floor, .direction = way, .doors = 0b1111}),
              DispatchAnswer::assigned);
    EXPECT_EQ(hall.calls().size(), 4u) << "one at each door";
    const unsigned lift = hall.calls()[0].lift;
    hall.answered(lift, {floor, way}, 0b1111);
    EXPECT_TRUE(hall.calls().empty());
    for (unsigned door = 0; door < 4; ++door) {
      const auto doors = static_cast<DoorMask>(1U << door);
      const auto answer = destinations.add(
          {.source = floor, .target = target, .source_doors = doors, .target_doors = doors});
      EXPECT_EQ(answer.answer, DispatchAnswer::assigned) << i;
      destinations.departed(answer.lift, {floor, Direction::none}, doors);
      EXPECT_TRUE(destinations.calls().empty());
      destinations.alighted(answer.lift, target);
      EXPECT_TRUE(destinations.riders().empty());
    }
  }
}

}  // namespace
}  // namespace canvoy::cia417::tall_building_calls_test
