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

}  // namespace
}  // namespace canvoy::device_scan_test
