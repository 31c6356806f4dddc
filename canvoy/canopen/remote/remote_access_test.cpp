// Both buses of a node with devices behind it, byte for byte. SDO frames follow CiA 301, 7.2.4.3;
// the selection of a device and the emergency follow remote_access.hpp.
#include "canvoy/canopen/remote/remote_access.hpp"

#include <gtest/gtest.h>

#include "canvoy/can/random.hpp"
#include "canvoy/canopen/sdo/sdo_block_client.hpp"
#include "canvoy/canopen/sdo/sdo_block_server.hpp"
#include "canvoy/canopen/testing/sdo_objects.hpp"
#include "canvoy/canopen/testing/wire.hpp"

namespace canvoy::remote_access_test {
namespace {

/// Node 5 with node 7 of network 2 behind it, which the test plays. Beside the default channel,
/// clients have one on 615h and 595h.
struct Module : testing::Test {
  Module() : host(sdo_objects(), 5), server(host.node, 0, buffer) { host.boot(); }

  void from_host(std::string_view frame) {
    access.receive(wire_frame(frame), host.now);
    host.settle();
  }
  void from_behind(std::string_view frame) {
    access.receive_embedded(wire_frame(frame), host.now);
    host.settle();
  }
  void expect_behind(const std::vector<std::string>& frames) {
    EXPECT_EQ(behind, frames);
    behind.clear();
  }
  /// Selects node 7 of network 2 for the next transfer, and checks the confirmation.
  void indicate() {
    from_host("605#E0 02 00 07 00 00 00 00");
    host.expect({"585#E0 02 00 07 00 00 00 00"});
  }
  /// A transfer with node 7 that ends at once: no other is under way.
  void expect_works() {
    behind.clear();
    indicate();
    from_host("605#40 01 64 01 00 00 00 00");
    expect_behind({"607#40 01 64 01 00 00 00 00"});
    from_behind("587#4B 01 64 01 34 12 00 00");
    host.expect({"585#4B 01 64 01 34 12 00 00"});
  }

  static bool take(void* context, const Frame& frame) {
    auto& self = *static_cast<Module*>(context);
    if (self.is_full) return false;
    self.behind.push_back(wire_text(frame));
    return true;
  }

  WireNode host;
  std::array<std::uint8_t, 64> buffer{};
  SdoServer server;
  std::vector<std::string> behind;
  bool is_full = false;
  std::array<RemoteChannel, 2> channels{RemoteChannel(), RemoteChannel(SdoChannel{0x615, 0x595})};
  RemoteAccess access{host.node,
                      {this, &Module::take, nullptr},
                      channels,
                      {.network = 2, .emergency_cob_id = 0x6C7}};
};
using RemoteSdo = Module;
using RemoteEmergency = Module;

TEST_F(RemoteSdo, ATransferIsWithTheDeviceThatWasIndicatedAndTheNextWithTheNodeItself) {
  expect_works();
  from_host("605#40 00 10 00 00 00 00 00");
  expect_behind({});
  host.expect({"585#43 00 10 00 A2 01 02 00"});
}

TEST_F(RemoteSdo, WithoutAnIndicationTheNodeIsAsked) {
  from_host("605#40 00 10 00 00 00 00 00");
  host.expect({"585#43 00 10 00 A2 01 02 00"});
  expect_behind({});
}

TEST_F(RemoteSdo, AnExpeditedDownloadEndsWithItsAnswer) {
  indicate();
  from_host("605#2F 00 62 01 05 00 00 00");
  expect_behind({"607#2F 00 62 01 05 00 00 00"});
  from_behind("587#60 00 62 01 00 00 00 00");
  host.expect({"585#60 00 62 01 00 00 00 00"});
  from_behind("587#60 00 62 01 00 00 00 00");
  host.expect({});
  expect_works();
}

TEST_F(RemoteSdo, SegmentsArePassedOnUntilTheLast) {
  indicate();
  from_host("605#40 08 10 00 00 00 00 00");
  from_behind("587#41 08 10 00 08 00 00 00");
  from_host("605#60 00 00 00 00 00 00 00");
  from_behind("587#00 41 42 43 44 45 46 47");
  from_host("605#70 00 00 00 00 00 00 00");
  from_behind("587#1D 48 00 00 00 00 00 00");
  expect_behind({"607#40 08 10 00 00 00 00 00", "607#60 00 00 00 00 00 00 00",
                 "607#70 00 00 00 00 00 00 00"});
  host.expect({"585#41 08 10 00 08 00 00 00", "585#00 41 42 43 44 45 46 47",
               "585#1D 48 00 00 00 00 00 00"});
  from_behind("587#1D 48 00 00 00 00 00 00");
  host.expect({});

  indicate();
  from_host("605#21 08 10 00 08 00 00 00");
  from_behind("587#60 08 10 00 00 00 00 00");
  from_host("605#00 41 42 43 44 45 46 47");
  from_behind("587#20 00 00 00 00 00 00 00");
  from_host("605#1D 48 00 00 00 00 00 00");
  from_behind("587#30 00 00 00 00 00 00 00");
  host.expect({"585#60 08 10 00 00 00 00 00", "585#20 00 00 00 00 00 00 00",
               "585#30 00 00 00 00 00 00 00"});
  expect_works();
}

/// E0h is the last segment of a block, number 96, and not a selection there; C1h is number 65, and
/// not an end.
TEST_F(RemoteSdo, SegmentsOfABlockDownloadMayLookLikeAnything) {
  indicate();
  from_host("605#C2 08 10 00 0E 00 00 00");
  from_behind("587#A0 08 10 00 7F 00 00 00");
  behind.clear();
  from_host("605#E0 02 00 07 00 00 00 00");
  from_host("605#40 00 10 00 00 00 00 00");
  from_host("605#C1 00 00 00 00 00 00 00");
  expect_behind({"607#E0 02 00 07 00 00 00 00", "607#40 00 10 00 00 00 00 00",
                 "607#C1 00 00 00 00 00 00 00"});
  from_behind("587#A2 60 7F 00 00 00 00 00");
  from_host("605#C1 00 00 00 00 00 00 00");
  from_behind("587#A1 00 00 00 00 00 00 00");
  host.expect({"585#A0 08 10 00 7F 00 00 00", "585#A2 60 7F 00 00 00 00 00",
               "585#A1 00 00 00 00 00 00 00"});
  expect_works();
}

/// 43h to 5Fh are segments 67 to 95, and not expedited answers; 01h is the first, and not the last.
TEST_F(RemoteSdo, SegmentsOfABlockUploadMayLookLikeAnything) {
  indicate();
  from_host("605#A0 08 10 00 7F 00 00 00");
  from_behind("587#C2 08 10 00 0E 00 00 00");
  from_host("605#A3 00 00 00 00 00 00 00");
  from_behind("587#01 08 10 00 00 00 00 00");
  from_behind("587#43 08 10 00 00 00 00 00");
  from_behind("587#C1 08 10 00 00 00 00 00");
  from_host("605#A2 03 7F 00 00 00 00 00");
  from_behind("587#C1 00 00 00 00 00 00 00");
  behind.clear();
  from_host("605#A1 00 00 00 00 00 00 00");
  expect_behind({"607#A1 00 00 00 00 00 00 00"});
  host.expect({"585#C2 08 10 00 0E 00 00 00", "585#01 08 10 00 00 00 00 00",
               "585#43 08 10 00 00 00 00 00", "585#C1 08 10 00 00 00 00 00",
               "585#C1 00 00 00 00 00 00 00"});
  from_behind("587#C1 00 00 00 00 00 00 00");
  host.expect({});
  expect_works();
}

TEST_F(RemoteSdo, ADeviceMayAnswerABlockUploadWithoutBlocks) {
  indicate();
  from_host("605#A0 08 10 00 7F 04 00 00");
  from_behind("587#43 08 10 00 31 32 33 34");
  host.expect({"585#43 08 10 00 31 32 33 34"});
  expect_works();
}

// Aborts.

TEST_F(RemoteSdo, AbortsOfEitherSideArePassedOnAndEndIt) {
  indicate();
  from_host("605#40 99 99 00 00 00 00 00");
  from_behind("587#80 99 99 00 00 00 02 06");
  host.expect({"585#80 99 99 00 00 00 02 06"});
  expect_works();
  indicate();
  from_host("605#40 08 10 00 00 00 00 00");
  from_behind("587#41 08 10 00 08 00 00 00");
  behind.clear();
  from_host("605#80 08 10 00 00 00 04 05");
  expect_behind({"607#80 08 10 00 00 00 04 05"});
  host.expect({"585#41 08 10 00 08 00 00 00"});
  expect_works();
}

/// 060A 0023h: no SDO connection.
TEST_F(RemoteSdo, AnUnknownNetworkOrNodeIsRefused) {
  from_host("605#E0 03 00 07 00 00 00 00");
  host.expect({"585#80 03 00 07 23 00 0A 06"});
  from_host("605#E0 02 01 07 00 00 00 00");
  host.expect({"585#80 02 01 07 23 00 0A 06"});
  from_host("605#E0 02 00 00 00 00 00 00");
  host.expect({"585#80 02 00 00 23 00 0A 06"});
  from_host("605#E0 02 00 80 00 00 00 00");
  host.expect({"585#80 02 00 80 23 00 0A 06"});
  from_host("605#E0 02 00 07 00 00 00 01");
  host.expect({"585#80 02 00 07 01 00 04 05"}) /* reserved bytes */;
  from_host("605#40 00 10 00 00 00 00 00");
  host.expect({"585#43 00 10 00 A2 01 02 00"});
  expect_behind({});
}

TEST_F(RemoteSdo, FramesThatAreNoneOfSdoAreLeftToTheNode) {
  from_host("605#E0 02 00 07");
  from_host("606#E0 02 00 07 00 00 00 00");
  host.expect({});
  host.receive("000#02 05");
  from_host("605#E0 02 00 07 00 00 00 00");
  host.expect({}) /* stopped */;
  expect_behind({});
}

// Time.

TEST_F(RemoteSdo, ADeviceThatIsLostIsTimeOutForBothAfter800Ms) {
  indicate();
  host.run_until(Time(100ms));
  from_host("605#40 01 64 01 00 00 00 00");
  expect_behind({"607#40 01 64 01 00 00 00 00"});
  host.run_until(Time(899'999us));
  host.expect({});
  host.run_until(Time(2s));
  host.expect({"@900000 585#80 01 64 01 00 00 04 05"});
  expect_behind({"607#80 01 64 01 00 00 04 05"});
  from_behind("587#4B 01 64 01 34 12 00 00");
  host.expect({}) /* too late */;
  expect_works();
}

TEST_F(RemoteSdo, ADeviceThatIsLostBetweenSegmentsIsTimeOutToo) {
  indicate();
  from_host("605#21 08 10 00 08 00 00 00");
  host.run_until(Time(700ms));
  from_behind("587#60 08 10 00 00 00 00 00");
  host.run_until(Time(1400ms));
  from_host("605#00 41 42 43 44 45 46 47");
  host.sent.clear();
  behind.clear();
  host.run_until(Time(3s));
  host.expect({"@2200000 585#80 08 10 00 00 00 04 05"});
  expect_behind({"607#80 08 10 00 00 00 04 05"});
}

TEST_F(RemoteSdo, ADeviceThatBootsHasForgottenTheTransfer) {
  indicate();
  from_host("605#40 08 10 00 00 00 00 00");
  from_behind("708#00");
  host.expect({}) /* another one */;
  from_behind("707#05");
  host.expect({}) /* a heartbeat */;
  from_behind("707#00");
  host.expect({"585#80 08 10 00 00 00 00 08"});
  expect_works();
}

/// A request for a device must not reach the node itself.
TEST_F(RemoteSdo, ARequestThatComesTooLateIsForNobody) {
  indicate();
  host.run_until(Time(800ms));
  from_host("605#2F 01 20 00 05 00 00 00");
  expect_behind({});
  host.expect({"585#80 01 20 00 00 00 04 05"});
  EXPECT_EQ(value_of(host.node, 0x2001), std::vector<std::uint8_t>{0});
  from_host("605#2F 01 20 00 05 00 00 00");
  host.expect({"585#60 01 20 00 00 00 00 00"}) /* the next request is for it */;
}

TEST_F(RemoteSdo, AnIndicationIsForTheNextRequestOnly) {
  indicate();
  from_host("605#60 00 00 00 00 00 00 00");
  host.expect({"585#80 00 00 00 01 00 04 05"}) /* the node's server: a segment of nothing */;
  from_host("605#40 00 10 00 00 00 00 00");
  host.expect({"585#43 00 10 00 A2 01 02 00"});
  expect_behind({});
}

TEST_F(RemoteSdo, WhoBeginsAnewHasGivenUpTheOldTransfer) {
  indicate();
  from_host("605#40 08 10 00 00 00 00 00");
  from_behind("587#41 08 10 00 08 00 00 00");
  host.sent.clear();
  behind.clear();
  from_host("605#40 00 10 00 00 00 00 00");
  expect_behind({"607#80 08 10 00 00 00 00 08"});
  host.expect({"585#43 00 10 00 A2 01 02 00"}) /* of the node: no device was selected */;
  indicate();
  from_host("605#40 08 10 00 00 00 00 00");
  behind.clear();
  indicate();
  expect_behind({"607#80 08 10 00 00 00 00 08"});
  from_host("605#40 01 64 01 00 00 00 00");
  expect_behind({"607#40 01 64 01 00 00 00 00"});
}

/// The node's server would report its own time-out among the device's answers.
TEST_F(RemoteSdo, WhatTheClientHasLeftUnfinishedWithTheNodeItselfIsOver) {
  from_host("605#40 08 20 00 00 00 00 00");
  host.expect({"585#41 08 20 00 08 00 00 00"});
  expect_works();
  host.run_for(5s);
  host.expect({});
}

TEST_F(RemoteSdo, WhenTheNodeIsStoppedOrResetTheDeviceIsTold) {
  for (const char* const command : {"000#02 05", "000#82 05"}) {
    expect_works();
    indicate();
    from_host("605#40 08 10 00 00 00 00 00");
    behind.clear();
    host.receive(command);
    expect_behind({"607#80 08 10 00 22 00 00 08"});
    host.sent.clear();
    from_behind("587#41 08 10 00 08 00 00 00");
    host.expect({});
    host.receive("000#80 05");
    host.sent.clear();
  }
}

TEST_F(RemoteSdo, ABusBehindThatTakesNothingIsSaidAtOnce) {
  indicate();
  is_full = true;
  from_host("605#40 01 64 01 00 00 00 00");
  host.expect({"585#80 01 64 01 22 00 00 08"});
  is_full = false;
  expect_works();
}

// Two clients.

TEST_F(RemoteSdo, TwoClientsSpeakWithTwoDevicesAtATime) {
  indicate();
  from_host("615#E0 02 00 08 00 00 00 00");
  host.expect({"595#E0 02 00 08 00 00 00 00"});
  from_host("605#40 08 10 00 00 00 00 00");
  from_host("615#40 01 64 01 00 00 00 00");
  expect_behind({"607#40 08 10 00 00 00 00 00", "608#40 01 64 01 00 00 00 00"});
  from_behind("588#4B 01 64 01 34 12 00 00");
  from_behind("587#43 08 10 00 31 32 33 34");
  host.expect({"595#4B 01 64 01 34 12 00 00", "585#43 08 10 00 31 32 33 34"});
}

TEST_F(RemoteSdo, ADeviceHasOneClientAtATime) {
  indicate();
  from_host("615#E0 02 00 07 00 00 00 00");
  host.expect({"595#80 02 00 07 22 00 00 08"});
  from_host("605#40 08 10 00 00 00 00 00");
  from_host("615#E0 02 00 07 00 00 00 00");
  host.expect({"595#80 02 00 07 22 00 00 08"});
  from_behind("587#43 08 10 00 31 32 33 34");
  host.expect({"585#43 08 10 00 31 32 33 34"});
  from_host("615#E0 02 00 07 00 00 00 00");
  host.expect({"595#E0 02 00 07 00 00 00 00"});
  from_host("605#40 00 10 00 00 00 00 00");
  host.expect({"585#43 00 10 00 A2 01 02 00"}) /* the other client continues with the node */;
}

// Emergencies.

TEST_F(RemoteEmergency, IsToldWithNetworkAndNode) {
  from_behind("087#10 70 81 01 02 03 04 05");
  host.expect({"6C7#10 70 81 02 07 01 02 03"});
  EXPECT_EQ(access.counters().emergencies, 1u);
  from_behind("080#");
  from_behind("087#10 70");
  from_behind("100#10 70 81 01 02 03 04 05");
  host.expect({}) /* SYNC, what is cut off, and TIME */;
}

TEST_F(RemoteEmergency, OfABabblingDeviceAreToldOneIn10MsAndCountedWhereThereAreTooMany) {
  for (int i = 0; i < 20; ++i) from_behind("087#10 70 81 00 00 00 00 00");
  EXPECT_EQ(host.sent.size(), 1u);
  from_behind("088#00 00 00 00 00 00 00 00");
  host.run_until(Time(10ms));
  EXPECT_EQ(host.sent.size(), 2u);
  host.run_until(Time(1s));
  EXPECT_EQ(host.sent.size(), 17u);
  EXPECT_EQ(host.sent.back().at, Time(160ms));
  EXPECT_EQ(access.counters().emergencies_lost, 4u);
  host.sent.clear();
  from_behind("088#00 00 00 00 00 00 00 00");
  host.expect({"@1000000 6C7#00 00 00 02 08 00 00 00"});
}

TEST_F(RemoteEmergency, IsNotToldByANodeThatIsStopped) {
  host.receive("000#02 05");
  from_behind("087#10 70 81 00 00 00 00 00");
  host.run_for(1s);
  host.expect({});
  EXPECT_EQ(access.counters().emergencies_lost, 1u);
}

TEST_F(RemoteEmergency, IsToldAndSdoPassedOnInNmtStateOperationalAsWell) {
  host.receive("000#01 05");
  from_behind("087#10 70 81 00 00 00 00 00");
  host.expect({"6C7#10 70 81 02 07 00 00 00"});
  expect_works();
}

TEST_F(RemoteSdo, FramesOfOtherKindsAreNotForDevicesBehind) {
  from_host("605#R8");
  from_host("00000605#E0 02 00 07 00 00 00 00");
  host.expect({});
  expect_works();
  from_behind("00000087#10 70 81 00 00 00 00 00");
  from_behind("087#R8");
  host.expect({});
}

TEST(RemoteNode, WithoutANodeIdOrACobIdForEmergenciesSaysNothing) {
  std::vector<std::string> behind;
  const auto take = [](void* context, const Frame& frame) {
    static_cast<std::vector<std::string>*>(context)->push_back(wire_text(frame));
    return true;
  };
  for (const NodeId id : {NodeId{5}, node_id_unconfigured}) {
    WireNode host(sdo_objects(), id);
    std::array<RemoteChannel, 2> channels;
    RemoteAccess access{host.node, {&behind, take, nullptr}, channels, {.network = 2}};
    host.boot();
    access.receive_embedded(wire_frame("087#10 70 81 00 00 00 00 00"), host.now);
    if (id == node_id_unconfigured) {
      access.receive(wire_frame("67F#E0 02 00 07 00 00 00 00"), host.now);
      access.receive(wire_frame("600#E0 02 00 07 00 00 00 00"), host.now);
    }
    host.run_for(1s);
    host.expect({});
  }
  EXPECT_TRUE(behind.empty());
}

// With whole clients and servers.

/// A client on the host's bus, the node, and a device behind it: frames arrive at once.
class RemotePath {
 public:
  RemotePath() {
    for (WireNode* node : {&client, &module, &device}) node->boot();
    client.receive("000#01 00");
  }

  /// Runs a transfer with node 7 behind node 5; returns its outcome.
  void run() {
    for (int i = 0; i < 100'000 && sdo.busy(); ++i) {
      if (!deliver()) {
        now += 1ms;
        for (WireNode* node : {&client, &module, &device}) node->run_until(now);
      }
    }
    ASSERT_FALSE(sdo.busy());
  }
  void indicate() {
    access.receive(wire_frame("605#E0 02 00 07 00 00 00 00"), now);
    module.sent.clear();
  }
  void done(SdoClient::Outcome of) { outcome = of; }
  SdoClient::Done on_done() { return SdoClient::Done::to<&RemotePath::done>(*this); }

  WireNode client{sdo_objects(), 1};
  WireNode module{sdo_objects(), 5};
  WireNode device{sdo_objects(), 7};
  SdoClient sdo{client.node};
  SdoClient::Outcome outcome{AbortCode::none};

 private:
  static std::vector<Frame> taken(WireNode& node) {
    std::vector<Frame> frames;
    for (const WireNode::Sent& sent : node.sent) frames.push_back(sent.frame);
    node.sent.clear();
    return frames;
  }
  bool deliver() {
    bool any = false;
    for (const Frame& frame : taken(client)) any = true, access.receive(frame, now);
    for (const Frame& frame : std::exchange(behind, {})) {
      any = true;
      device.node.receive(frame, now);
    }
    for (const Frame& frame : taken(device)) any = true, access.receive_embedded(frame, now);
    for (const Frame& frame : taken(module)) any = true, client.node.receive(frame, now);
    for (WireNode* node : {&client, &module, &device}) node->settle();
    return any;
  }
  static bool take(void* context, const Frame& frame) {
    static_cast<RemotePath*>(context)->behind.push_back(frame);
    return true;
  }

  std::vector<Frame> behind;
  std::array<std::uint8_t, SdoBlockClient::buffer_size> client_block{};
  SdoBlockClient blocks{sdo, client_block};
  std::array<std::uint8_t, 5000> module_buffer{};
  std::array<std::uint8_t, 5000> device_buffer{};
  SdoServer module_server{module.node, 0, module_buffer};
  SdoServer device_server{device.node, 0, device_buffer};
  SdoBlockServer device_blocks{device_server};
  std::array<RemoteChannel, 1> channels;
  RemoteAccess access{module.node, {this, &RemotePath::take, nullptr}, channels, {}};
  Time now{};
};

TEST(RemotePath, LongValuesComeWholeInSegmentsAndInBlocks) {
  for (const SdoTransfer transfer : {SdoTransfer::segmented, SdoTransfer::block}) {
    for (const std::size_t size : {1u, 4u, 5u, 7u, 8u, 889u, 890u, 5000u}) {
      RemotePath path;
      path.sdo.choose(transfer);
      const std::vector<std::uint8_t> value = pattern(size);
      path.indicate();
      ASSERT_EQ(path.sdo.download(5, 0x2021, 0, value, path.on_done()), AbortCode::none);
      path.run();
      EXPECT_TRUE(path.outcome) << size;
      EXPECT_EQ(value_of(path.device.node, 0x2021), value) << size;
      EXPECT_NE(value_of(path.module.node, 0x2021), value) << size;
      std::vector<std::uint8_t> read(5000);
      path.indicate();
      ASSERT_EQ(path.sdo.upload(5, 0x2021, 0, read, path.on_done()), AbortCode::none);
      path.run();
      ASSERT_TRUE(path.outcome) << size;
      read.resize(*path.outcome);
      EXPECT_EQ(read, value);
    }
  }
}

/// Both sides send any frames, in any order and at any time: no crash, and afterwards all works.
TEST_F(RemoteSdo, BearsWhateverBothSidesSend) {
  Random random(1);
  constexpr std::uint32_t ids[] = {0x605, 0x615, 0x587, 0x588, 0x087, 0x707, 0x000, 0x080};
  constexpr std::uint8_t commands[] = {0xE0, 0x40, 0x2F, 0x21, 0x60, 0x70, 0x00, 0x01, 0xA0, 0xA1,
                                       0xA2, 0xA3, 0xC0, 0xC1, 0xC2, 0x80, 0x43, 0x41, 0x20, 0xFF};
  for (int i = 0; i < 500'000; ++i) {
    Frame frame;
    frame.id = ids[random.below(std::size(ids))];
    frame.length = static_cast<std::uint8_t>(random.below(8) == 0 ? random.below(9) : 8);
    for (std::uint8_t& byte : frame.data) byte = static_cast<std::uint8_t>(random.below(256));
    frame.data[0] = commands[random.below(std::size(commands))];
    if (random.below(2) == 0) {
      frame.data = {frame.data[0], 2, 0, static_cast<std::uint8_t>(7 + random.below(2))};
    }
    const bool is_behind =
        frame.id == 0x587 || frame.id == 0x588 || frame.id == 0x087 || frame.id == 0x707;
    is_full = random.below(16) == 0;
    if (is_behind) {
      access.receive_embedded(frame, host.now);
    } else {
      access.receive(frame, host.now);
    }
    host.settle();
    if (random.below(8) == 0) host.run_for(Duration(random.below(500'000)));
    host.sent.clear();
    behind.clear();
  }
  EXPECT_GT(access.counters().transfers, 1'000u);
  is_full = false;
  host.receive("000#80 05");
  host.run_for(10s);
  from_host("605#40 00 10 00 00 00 00 00");  // receives the refusal of a late selection
  host.sent.clear();
  expect_works();
}

}  // namespace
}  // namespace canvoy::remote_access_test
