// SDO manager, requesting device and server on one cable: a connection is established and works,
// also with lost frames and lost nodes.
#include <gtest/gtest.h>

#include "canvoy/canopen/testing/cable.hpp"
#include "canvoy/canopen/testing/dynamic_sdo_nodes.hpp"

namespace canvoy::dynamic_sdo_test {
namespace {

class DynamicSdo : public testing::Test {
 protected:
  DynamicSdo() {
    cable.connect(0, manager.node);
    cable.connect(1, device.node);
    cable.connect(2, server.node);
    cable.start_all();
    for (const NodeId id : {NodeId{5}, NodeId{10}}) {
      manager.manager.remote_changed(id, RemoteState::pre_operational);
    }
    cable.run_for(1ms);
    cable.clear();
  }
  /// Connects, and reads 2000h of the server over the connection.
  void expect_connection() {
    std::array<std::uint8_t, 4> bytes{};
    cable.clear();
    ASSERT_EQ(device.clients[1].upload(10, 0x2000, 0, bytes, {}), AbortCode::none);
    cable.run_for(10ms);
    EXPECT_EQ(load<std::uint32_t>(bytes.data()), 0x1234'5678u);
    EXPECT_EQ(cable.count(0x60A), 0u) << "not on the default channel";
  }
  std::size_t in_use() const {
    return static_cast<std::size_t>(
        std::ranges::count_if(manager.connections, [](const SdoConnection& connection) {
          return connection.state != SdoConnection::State::unused;
        }));
  }
  Cable cable;
  ManagingNode manager{cable.port(0), 1};
  RequestingNode device{cable.port(1), 5};
  ServingNode server{cable.port(2), 10};
};

TEST_F(DynamicSdo, AConnectionIsRequestedUsedAndReleased) {
  ASSERT_EQ(device.connect(10, 1), AbortCode::none);
  cable.run_for(100ms);
  ASSERT_EQ(device.answers, std::vector<SdoEnd>{SdoEnd()});
  expect_connection();
  ASSERT_TRUE(device.requester.release(1));
  cable.run_for(100ms);
  EXPECT_EQ(device.clients[1].upload(10, 0x2000, 0, std::span<std::uint8_t>{}, {}),
            AbortCode::no_sdo_connection);
  EXPECT_EQ(in_use(), 1u) << "the registration";
  ASSERT_TRUE(device.requester.leave());
  cable.run_for(100ms);
  EXPECT_EQ(in_use(), 0u);
  EXPECT_FALSE(device.requester.registered());
}

TEST_F(DynamicSdo, TheServerServesItsDefaultChannelAtTheSameTime) {
  ASSERT_EQ(device.connect(10, 1), AbortCode::none);
  cable.run_for(100ms);
  cable.clear();
  cable.send("60A#40 00 20 00 00 00 00 00");
  EXPECT_EQ(cable.last(0x58A), "58A#43 00 20 00 78 56 34 12");
  expect_connection();
}

TEST_F(DynamicSdo, AManagerThatStartsAgainIsCalledAgain) {
  ASSERT_EQ(device.connect(10, 1), AbortCode::none);
  cable.run_for(100ms);
  ASSERT_TRUE(device.requester.release(1));
  cable.run_for(100ms);
  manager.node.start(cable.now);
  cable.run_for(100ms);
  ASSERT_EQ(in_use(), 0u);
  device.node.advance(cable.now);
  ASSERT_EQ(device.connect(10, 1), AbortCode::none);
  cable.run_for(2s);
  EXPECT_EQ(device.answers, (std::vector{SdoEnd(), SdoEnd()}));
  expect_connection();
}

TEST_F(DynamicSdo, AServerThatStartsAgainIsConnectedAgainWhileItsEndIsClosed) {
  ASSERT_EQ(device.connect(10, 1), AbortCode::none);
  cable.run_for(100ms);
  server.node.start(cable.now);
  manager.manager.remote_changed(10, RemoteState::boot_up);
  device.node.advance(cable.now);
  ASSERT_EQ(device.connect(10, 1), AbortCode::none);
  cable.run_for(2s);
  EXPECT_EQ(device.answers, (std::vector{SdoEnd(), SdoEnd()}));
  expect_connection();
}

TEST_F(DynamicSdo, WithoutAManagerTheDeviceLearnsItAfterItsTimeOut) {
  cable.cut(0);
  device.node.advance(cable.now);
  ASSERT_EQ(device.connect(10, 1), AbortCode::none);
  cable.run_for(999ms);
  EXPECT_TRUE(device.answers.empty());
  cable.run_for(1ms);
  EXPECT_EQ(device.answers, std::vector<SdoEnd>{SdoEnd::no_answer()});
}

TEST_F(DynamicSdo, ADeviceThatWasNeverHeardIsFoundAsWell) {
  manager.manager.remote_changed(5, RemoteState::lost);
  manager.manager.remote_changed(10, RemoteState::lost);
  cable.run_for(1ms);
  ASSERT_EQ(device.connect(10, 1), AbortCode::none);
  cable.run_for(900ms);
  EXPECT_EQ(device.answers, std::vector<SdoEnd>{SdoEnd()});
}

/// Each frame of the whole procedure, lost once.
TEST_F(DynamicSdo, NoSingleLostFrameKeepsTheConnectionAwayForEver) {
  ASSERT_EQ(device.connect(10, 1), AbortCode::none);
  cable.run_for(100ms);
  const std::size_t frames = cable.heard.size();
  // The call; search for the caller (5, and 10 has no 1F10h); registration; request; free channel;
  // connection.
  ASSERT_EQ(frames, 1 + 2 * 2 + 4 * 2 + 2 + 2 + 7 * 2u);
  for (std::size_t lost = 0; lost < frames; ++lost) {
    SCOPED_TRACE(lost);
    Cable line;
    ManagingNode managing(line.port(0), 1);
    RequestingNode requesting(line.port(1), 5);
    ServingNode serving(line.port(2), 10);
    line.connect(0, managing.node);
    line.connect(1, requesting.node);
    line.connect(2, serving.node);
    line.start_all();
    for (const NodeId id : {NodeId{5}, NodeId{10}}) {
      managing.manager.remote_changed(id, RemoteState::pre_operational);
    }
    std::size_t count = 0;
    line.filter = [&](const Frame&) { return count++ != lost; };
    ASSERT_EQ(requesting.connect(10, 1), AbortCode::none);
    line.run_for(3s);
    ASSERT_EQ(requesting.answers.size(), 1u);
    if (!requesting.answers[0]) {
      requesting.node.advance(line.now);
      ASSERT_EQ(requesting.connect(10, 1), AbortCode::none);
      line.run_for(3s);
    }
    EXPECT_TRUE(requesting.answers.back());
    std::array<std::uint8_t, 4> bytes{};
    ASSERT_EQ(requesting.clients[1].upload(10, 0x2000, 0, bytes, {}), AbortCode::none);
    line.run_for(10ms);
    EXPECT_EQ(load<std::uint32_t>(bytes.data()), 0x1234'5678u);
    EXPECT_FALSE(managing.manager.busy());
  }
}

TEST_F(DynamicSdo, ADeviceThatStartsAnewGetsItsConnectionAgain) {
  ASSERT_EQ(device.connect(10, 1), AbortCode::none);
  cable.run_for(100ms);
  cable.send("000#81 05");
  manager.manager.remote_changed(5, RemoteState::boot_up);
  cable.run_for(100ms);
  EXPECT_EQ(in_use(), 0u);
  EXPECT_EQ(server.node.dictionary().number(0x1201, 1), 0xC000'0000u) << "free for others";
  ASSERT_EQ(device.connect(10, 1), AbortCode::none);
  cable.run_for(100ms);
  EXPECT_TRUE(device.answers.back());
  expect_connection();
}

TEST_F(DynamicSdo, AServerThatIsLostTakesTheConnectionAlong) {
  ASSERT_EQ(device.connect(10, 1), AbortCode::none);
  cable.run_for(100ms);
  cable.cut(2);
  manager.manager.remote_changed(10, RemoteState::lost);
  cable.run_for(100ms);
  EXPECT_EQ(device.node.dictionary().number(0x1281, 1), 0xC000'0000u);
  EXPECT_EQ(device.node.dictionary().number(0x1F10, 0), 0x1281'0600u);
  EXPECT_TRUE(device.requester.registered());
  cable.cut(2, false);
  server.node.start(cable.now);
  ASSERT_EQ(device.connect(10, 1), AbortCode::none);
  cable.run_for(100ms);
  EXPECT_TRUE(device.answers.back());
  expect_connection();
}

TEST_F(DynamicSdo, TwoDevicesThatCallAtOnceAreBothServed) {
  RequestingNode other(cable.port(3), 6);
  cable.connect(3, other.node);
  other.node.start(cable.now);
  cable.run_for(1ms);
  manager.manager.remote_changed(6, RemoteState::pre_operational);
  manager.node.dictionary().set_number(0x1F02, 6, 0x685);
  ASSERT_EQ(device.connect(10, 1), AbortCode::none);
  ASSERT_EQ(other.connect(10, 1), AbortCode::none);
  cable.run_for(100ms);
  EXPECT_EQ(device.answers, std::vector<SdoEnd>{SdoEnd()});
  EXPECT_EQ(other.answers, std::vector<SdoEnd>{SdoEnd::by_server(AbortCode::no_sdo_connection)})
      << "there are COB-IDs for three only";
  EXPECT_EQ(other.requester.error(), DynamicSdoError::no_cob_id);
  expect_connection();
}

}  // namespace
}  // namespace canvoy::dynamic_sdo_test
