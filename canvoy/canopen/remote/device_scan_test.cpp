// The search for a device profile by 1000h (CiA 301, SDO upload).
#include "canvoy/canopen/remote/device_scan.hpp"

#include <gtest/gtest.h>

#include "canvoy/canopen/testing/dynamic_sdo_nodes.hpp"
#include "canvoy/canopen/testing/prompt_bus.hpp"

namespace canvoy::device_scan_test {
namespace {

/// Node 1 searches for profile 418 (1A2h). All others answer at once: all except node 100 with 401.
struct Scanner : PromptBus {
  Scanner() : PromptBus(dynamic_sdo_manager(), 1) {
    scan.on_found(callback<&Scanner::found>(*this));
    answers = [this](const Frame& frame) -> std::optional<Frame> {
      if (frame.id <= 0x600 || frame.id >= 0x680) return std::nullopt;
      const std::uint8_t profile = frame.id == 0x600U + wanted ? 0xA2 : 0x91;
      return Frame::data_frame(frame.id - 0x80, {0x43, 0x00, 0x10, 0x00, profile, 0x01, 0, 0});
    };
    sent.clear();
  }
  void found(NodeId id) { devices.push_back(id); }

  unsigned wanted = 100;
  std::vector<NodeId> devices;
  DeviceScan scan{node, {.profile = 418}};
};

TEST(DeviceScan, AsksAllNodesWhoseAnswersComeAtOnce) {
  Scanner sut;
  sut.wanted = 0;
  sut.scan.start();
  sut.run_for(1250ms);
  EXPECT_EQ(sut.scan.requests(), 126u) << "one each 10 ms";
  EXPECT_EQ(sut.sent.back(), "67F#40 00 10 00 00 00 00 00");
  EXPECT_TRUE(sut.devices.empty());
}

TEST(DeviceScan, EndsWhereTheDeviceThatIsFoundAnswersAtOnce) {
  Scanner sut;
  sut.scan.start();
  sut.run_for(1h);
  EXPECT_EQ(sut.devices, std::vector<NodeId>{100});
  EXPECT_FALSE(sut.scan.running());
  EXPECT_EQ(sut.sent.back(), "664#40 00 10 00 00 00 00 00");
  EXPECT_EQ(sut.node.deadline(), never);
}

/// Node 1 on a bus where the test gives the answers.
struct Listener : WireNode {
  Listener() : WireNode(dynamic_sdo_manager(), 1) {
    boot();
    scan.on_found(callback<&Listener::found>(*this));
  }
  void found(NodeId id) { devices.push_back(id); }

  std::vector<NodeId> devices;
  DeviceScan scan{node, {.profile = 418}};
};

TEST(DeviceScan, AsksNoMoreThanFourNodesAtATime) {
  Listener sut;
  sut.scan.start();
  sut.run_for(85ms);
  sut.expect({"@0 602#40 00 10 00 00 00 00 00", "@10000 603#40 00 10 00 00 00 00 00",
              "@20000 604#40 00 10 00 00 00 00 00", "@30000 605#40 00 10 00 00 00 00 00"});
  sut.receive("583#43 00 10 00 91 01 00 00");  // of another profile
  sut.run_for(9ms);
  sut.expect({"@90000 606#40 00 10 00 00 00 00 00"});
  EXPECT_TRUE(sut.devices.empty());
}

TEST(DeviceScan, ARefusalAndAShortAnswerAreNoDevice) {
  Listener sut;
  sut.scan.start();
  sut.run_for(10ms);
  sut.receive("582#80 00 10 00 00 00 02 06");
  sut.receive("583#4B 00 10 00 A2 01 00 00");  // two bytes
  EXPECT_TRUE(sut.devices.empty());
  EXPECT_TRUE(sut.scan.running());
}

TEST(DeviceScan, AsksThoseThatWereHeardFirstAndNeverItself) {
  Listener sut;
  for (const NodeId id : {NodeId{1}, NodeId{100}, NodeId{128}}) sut.scan.prefer(id);
  sut.scan.start();
  sut.run_for(10ms);
  sut.expect({"@0 664#40 00 10 00 00 00 00 00", "@10000 602#40 00 10 00 00 00 00 00"});
}

TEST(DeviceScan, GoesOnBehindWhatItFound) {
  Listener sut;
  sut.scan.start();
  sut.run_for(1ms);
  sut.expect({"602#40 00 10 00 00 00 00 00"});
  sut.receive("582#43 00 10 00 A2 01 00 00");
  ASSERT_EQ(sut.devices, std::vector<NodeId>{2});
  EXPECT_FALSE(sut.scan.running());
  sut.scan.go_on();
  EXPECT_TRUE(sut.scan.running());
  sut.run_for(10ms);
  ASSERT_EQ(sut.sent.size(), 1u);
  EXPECT_EQ(wire_text(sut.sent.front().frame), "603#40 00 10 00 00 00 00 00");
}

TEST(DeviceScan, BeginsTheNextRoundAfterAPause) {
  Scanner sut;
  sut.wanted = 0;
  sut.scan.start();
  sut.run_for(1260ms);
  ASSERT_EQ(sut.scan.requests(), 126u);
  sut.run_for(999ms);
  EXPECT_EQ(sut.scan.requests(), 126u);
  sut.run_for(1ms);
  EXPECT_EQ(sut.scan.requests(), 127u);
  EXPECT_EQ(sut.sent.back(), "602#40 00 10 00 00 00 00 00");
}

TEST(DeviceScan, WaitsUntilItsLastRequestIsOnTheBus) {
  Listener sut;
  sut.full = true;
  sut.scan.start();
  sut.run_for(50ms);
  EXPECT_EQ(sut.scan.requests(), 1u);
  sut.full = false;
  sut.node.tx_ready(sut.now);
  sut.run_for(10ms);
  EXPECT_EQ(sut.scan.requests(), 2u);
}

}  // namespace
}  // namespace canvoy::device_scan_test
