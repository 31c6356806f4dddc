#include "canvoy/worlds/charger/connection_watch.hpp"

#include <gtest/gtest.h>

#include <array>

namespace canvoy::charger::connection_watch_test {
namespace {

SdoConnection given(NodeId client, NodeId server) {
  SdoConnection made;
  made.client = client;
  made.server = server;
  made.state = SdoConnection::State::given;
  return made;
}

class ConnectionWatchTest : public testing::Test {
 protected:
  SdoConnectionChanged told(std::size_t event) const {
    return std::get<SdoConnectionChanged>(events.at(event).what);
  }

  std::vector<ChargerEvent> events;
  ConnectionWatch sut{events};
};

TEST_F(ConnectionWatchTest, AConnectionIsToldWhenItIsGivenAndWhenItIsTakenBack) {
  const std::array here = {given(5, 10)};
  sut.look(Time(1s), here);
  sut.look(Time(2s), here);
  ASSERT_EQ(events.size(), 1U);
  EXPECT_EQ(events[0].at, Time(1s));
  EXPECT_EQ(told(0).client, 5);
  EXPECT_EQ(told(0).server, 10);
  EXPECT_TRUE(told(0).is_given);
  sut.look(Time(3s), std::array{SdoConnection()});
  ASSERT_EQ(events.size(), 2U);
  EXPECT_EQ(told(1).client, 5);
  EXPECT_EQ(told(1).server, 10);
  EXPECT_FALSE(told(1).is_given);
}

TEST_F(ConnectionWatchTest, AnotherOneInItsPlaceIsToldAsOneTakenBackAndOneGiven) {
  sut.look(Time(1s), std::array{given(5, 10)});
  sut.look(Time(2s), std::array{given(5, 11)});
  ASSERT_EQ(events.size(), 3U);
  EXPECT_EQ(told(1).server, 10);
  EXPECT_FALSE(told(1).is_given);
  EXPECT_EQ(told(2).server, 11);
  EXPECT_TRUE(told(2).is_given);
}

}  // namespace
}  // namespace canvoy::charger::connection_watch_test
