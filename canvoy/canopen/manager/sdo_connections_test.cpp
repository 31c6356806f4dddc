#include "canvoy/canopen/manager/sdo_connections.hpp"

#include <gtest/gtest.h>

#include <array>
#include <vector>

namespace canvoy::sdo_connections_test {
namespace {

using State = SdoConnection::State;

constexpr NodeId manager = 1;
constexpr NodeId client = 5;
constexpr NodeId server = 9;

/// A registered client with channels 2 and 3 to one server, and another registered client.
class SdoConnectionsTest : public testing::Test {
 protected:
  SdoConnectionsTest() {
    sut_.add({.state = State::given, .client = client, .client_channel = 1, .server = manager});
    sut_.add({.state = State::given,
              .client = client,
              .client_channel = 2,
              .server = server,
              .request = 0x6E1,
              .response = 0x6E2});
    sut_.add({.state = State::requested, .client = client, .client_channel = 3, .server = server});
    sut_.add({.state = State::given, .client = 6, .client_channel = 1, .server = manager});
  }
  std::vector<State> states() const {
    std::vector<State> states;
    for (const SdoConnection& connection : memory_) states.push_back(connection.state);
    return states;
  }

  std::array<SdoConnection, 4> memory_{};
  SdoConnections sut_{memory_};
};

TEST_F(SdoConnectionsTest, AreAsManyAsThereIsMemoryFor) {
  EXPECT_FALSE(sut_.has(State::unused));
  EXPECT_EQ(sut_.add({.state = State::requested}), nullptr);
}

TEST_F(SdoConnectionsTest, KnowWhoIsRegistered) {
  EXPECT_NE(sut_.registration(client, manager), nullptr);
  EXPECT_EQ(sut_.registration(server, manager), nullptr);
  memory_[0].state = State::ending;
  EXPECT_EQ(sut_.registration(client, manager), nullptr);
}

TEST_F(SdoConnectionsTest, KnowWhichCanIdsAreGiven) {
  EXPECT_TRUE(sut_.is_given(0x6E1));
  EXPECT_TRUE(sut_.is_given(0x6E2));
  EXPECT_FALSE(sut_.is_given(0x6E3));
}

TEST_F(SdoConnectionsTest, EndByChannelByServerOrAllWithTheRegistration) {
  constexpr State given = State::given;
  constexpr State ending = State::ending;
  sut_.release({.client_parameter = 0x1280 + 2, .device = client});
  EXPECT_EQ(states(), (std::vector{given, ending, State::requested, given}));
  sut_.release({.device = client, .server = server});
  EXPECT_EQ(states(), (std::vector{given, ending, ending, given}));
  sut_.release({.device = client});
  EXPECT_EQ(states(), (std::vector{ending, ending, ending, given}));
}

TEST_F(SdoConnectionsTest, OfALostServerEndAndTheClientIsTold) {
  sut_.lose(server);
  EXPECT_EQ(memory_[0].state, State::given);
  EXPECT_EQ(memory_[1].state, State::ending);
  EXPECT_TRUE(memory_[1].tell_client);
  EXPECT_TRUE(memory_[1].server_is_gone);
  EXPECT_EQ(memory_[1].error, DynamicSdoError::connection_lost);
}

TEST_F(SdoConnectionsTest, OfALostClientEndAndNobodyIsTold) {
  sut_.lose(client);
  EXPECT_EQ(memory_[0].state, State::ending);
  EXPECT_TRUE(memory_[1].client_is_gone);
  EXPECT_FALSE(memory_[1].tell_client);
  EXPECT_EQ(memory_[3].state, State::given);
}

}  // namespace
}  // namespace canvoy::sdo_connections_test
