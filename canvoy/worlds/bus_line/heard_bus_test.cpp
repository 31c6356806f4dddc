// Data of a listener on a bus, from frames typed from the clauses: 8.1.4.3 for journeys and stops,
// 9.2.15 for motion and doors, 9.2.21.1 for positions, CiA 301, 7.2.8.3.2.2 for heartbeats.
#include "canvoy/worlds/bus_line/heard_bus.hpp"

#include <gtest/gtest.h>

#include "canvoy/worlds/bus_line/bus_places.hpp"

namespace canvoy::bus_line::heard_bus_test {
namespace {

/// Node-IDs: 1 on-board computer, 2 identification, 11 gateway, 16 positioning, 21 counting.
class Listener : public testing::Test {
 protected:
  void hear(Duration at, const Frame& frame) { heard_.hear(Time(at), frame); }
  void hear_heartbeat(Duration at, NodeId node, std::uint8_t state = 0x05) {
    hear(at, Frame::data_frame(0x700U + node, {state}));
  }
  /// Block 1, line 407, journey 1; then the second stop, which is the second in the route.
  void hear_way(Duration at) {
    hear(at, Frame::data_frame(0x281, {1, 0, 0, 0, 0x97, 0x01, 1, 0}));
    hear_stop(at, 2);
  }
  void hear_stop(Duration at, std::uint8_t number) {
    hear(at, Frame::data_frame(0x401, {number, 0, 0, 0, 0, 0, 0, 0}));
    hear(at, Frame::data_frame(0x381, {1, 0, 1, 0, 0, number}));
  }

  BusLine line_ = built_in_line();
  HeardBus heard_{line_};
};

TEST_F(Listener, KnowsNothingAtFirst) {
  EXPECT_EQ(heard_.journey(Time{}), nullptr);
  EXPECT_FALSE(heard_.stop(Time{}) || heard_.position(Time{}) || heard_.aboard(Time{}));
}

TEST_F(Listener, KnowsTheJourneyAndTheStop) {
  hear_way(10s);
  EXPECT_EQ(heard_.journey(Time(10s)), &line_.blocks[0].journeys[0]);
  ASSERT_TRUE(heard_.stop(Time(11s)));
  EXPECT_EQ(heard_.stop(Time(11s))->value.place, 1u);
  EXPECT_EQ(heard_.stop(Time(11s))->heard, Time(10s)) << "its age";
}

TEST_F(Listener, AStopThatDoesNotAgreeWithItsNumberIsNone) {
  hear_way(10s);
  hear(11s, Frame::data_frame(0x401, {3, 0, 0, 0, 0, 0, 0, 0}));
  EXPECT_FALSE(heard_.stop(Time(11s))) << "the third stop is not the second of the route";
  hear(11s, Frame::data_frame(0x381, {1, 0, 1, 0, 0, 3}));
  ASSERT_TRUE(heard_.stop(Time(11s)));
  EXPECT_EQ(heard_.stop(Time(11s))->value.left_before, Time(11s));
}

TEST_F(Listener, AnOnBoardComputerThatDoesNotKnowTellsNoStop) {
  hear_way(10s);
  hear_stop(11s, 0);
  EXPECT_FALSE(heard_.stop(Time(11s)));
  EXPECT_NE(heard_.journey(Time(11s)), nullptr);
}

TEST_F(Listener, WhoIsSilentHasToldNothing) {
  hear_way(10s);
  EXPECT_TRUE(heard_.stop(Time(12'500ms)));
  EXPECT_FALSE(heard_.stop(Time(12'501ms)));
  EXPECT_EQ(heard_.journey(Time(12'501ms)), nullptr);
  hear_heartbeat(20s, identification_id);
  hear_heartbeat(20s, computer_id);
  EXPECT_FALSE(heard_.stop(Time(20s))) << "what it told before may not be so any more";
}

TEST_F(Listener, HeartbeatsKeepWhatWasTold) {
  hear_way(10s);
  for (int i = 1; i <= 20; ++i) {
    hear_heartbeat(10s + i * 500ms, identification_id);
    hear_heartbeat(10s + i * 500ms, computer_id);
  }
  ASSERT_TRUE(heard_.stop(Time(21s)));
  EXPECT_EQ(heard_.stop(Time(21s))->heard, Time(20s));
  hear_heartbeat(21s, computer_id, 0x00);
  EXPECT_FALSE(heard_.stop(Time(21s))) << "it boots";
  hear_heartbeat(22s, computer_id);
  EXPECT_FALSE(heard_.stop(Time(22s)));
}

TEST_F(Listener, APositionIsInTenMillionthsOfADegree) {
  // 50.5 and -1.25 degrees: 260.5 and 208.75 from -210 on, 9B452540h and 7C6CB8E0h ten-millionths.
  static_assert(2'605'000'000 == 0x9B45'2540);
  static_assert(2'087'500'000 == 0x7C6C'B8E0);
  const auto frame = Frame::data_frame(0x190, {0x40, 0x25, 0x45, 0x9B, 0xE0, 0xB8, 0x6C, 0x7C});
  hear(10s, frame);
  ASSERT_TRUE(heard_.position(Time(10s)));
  EXPECT_NEAR(heard_.position(Time(10s))->value.latitude, 50.5, 1e-9);
  EXPECT_NEAR(heard_.position(Time(10s))->value.longitude, -1.25, 1e-9);
  EXPECT_FALSE(heard_.position(Time(12'501ms)));
  hear(13s, Frame::data_frame(0x190, {0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF}));
  EXPECT_FALSE(heard_.position(Time(13s))) << "not available";
}

TEST_F(Listener, DoorsThatOpenAreTheArrival) {
  hear_way(10s);
  hear(11s, Frame::data_frame(0x18B, {0x00, 0x24, 0x01, 0x00, 0x40}));
  EXPECT_EQ(heard_.speed(Time(11s)), 10.0) << "36 km/h, in 256ths";
  EXPECT_EQ(heard_.has_open_door(Time(11s)), false);
  EXPECT_FALSE(heard_.stop(Time(11s))->value.arrived);
  hear(12s, Frame::data_frame(0x18B, {0x00, 0x00, 0x00, 0x80, 0xC0}));
  EXPECT_EQ(heard_.stop(Time(12s))->value.arrived, Time(12s));
  hear(12s, Frame::data_frame(0x28B, {0xE8, 0x03, 0x00, 0x00, 0x00, 0x00}));
  EXPECT_EQ(heard_.odometer(Time(12s)), 5000.0) << "1000 times 5 m";
}

TEST_F(Listener, CountsAreThoseOfTheCountingManager) {
  hear(10s, Frame::data_frame(0x295, {0x02, 0x01, 50}));
  EXPECT_EQ(heard_.aboard(Time(10s)), 0x102u);
  EXPECT_EQ(heard_.aboard(Time(13s)), std::nullopt);
}

TEST_F(Listener, FramesOfAnotherShapeSayNothing) {
  hear(10s, Frame::data_frame(0x281, {1, 0, 0, 0}));
  hear(10s, Frame::data_frame(0x190, {1, 2, 3}));
  hear(10s, Frame::data_frame(0x295, {1}));
  hear(10s, Frame::data_frame(0x701, {}));
  EXPECT_EQ(heard_.journey(Time(10s)), nullptr);
  EXPECT_FALSE(heard_.position(Time(10s)) || heard_.aboard(Time(10s)));
}

TEST_F(Listener, ARouteOfMoreStopsThanNumbersIsToldByItsStops) {
  BusRoute& route = line_.routes[0];
  Journey& journey = line_.blocks[0].journeys[0];
  while (route.stops.size() < 300) {
    line_.stops.push_back({.number = static_cast<std::uint32_t>(line_.stops.size() + 1)});
    route.stops.push_back({.stop = line_.stops.size() - 1});
    journey.passings.push_back(journey.passings.back());
  }
  hear(10s, Frame::data_frame(0x281, {1, 0, 0, 0, 0x97, 0x01, 1, 0}));
  hear(10s, Frame::data_frame(0x381, {1, 0, 1, 0, 0, 255}));
  hear(10s, Frame::data_frame(0x401, {0x20, 0x01, 0, 0, 0, 0, 0, 0}));
  ASSERT_TRUE(heard_.stop(Time(10s)));
  EXPECT_EQ(heard_.stop(Time(10s))->value.place, 287u) << "stop 288";
}

}  // namespace
}  // namespace canvoy::bus_line::heard_bus_test
