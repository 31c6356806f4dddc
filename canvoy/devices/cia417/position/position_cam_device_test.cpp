// A position CAM unit at its wire: positions in, cams out.
#include "canvoy/devices/cia417/position/position_cam_device.hpp"

#include <gtest/gtest.h>

#include "canvoy/canopen/testing/cable.hpp"

namespace canvoy::cia417::position_cam_device_test {
namespace {

constexpr Cam two_cams[] = {{.number = 1, .low = 0, .high = 100},
                            {.number = 3, .low = 50, .high = 200, .hysteresis = 20}};

class PositionCam : public testing::Test {
 protected:
  PositionCam() {
    cable.connect(0, device.node());
    cable.start_all();
    cable.send("60F#23 00 18 01 8F 03 00 00");  // TPDO 1: 38Fh
    cable.send("000#01 0F");
    cable.send("60F#2F A1 63 01 05 00 00 00");
    cable.clear();
  }

  Cable cable;
  PositionCamDevice<> device{cable.port(0), 15, {.cams = two_cams}};
};

/// 18Ch: 6383h:01h in tenths of a millimetre.
TEST_F(PositionCam, TellsTheCamsThatTheCarIsOn) {
  cable.send("18C#E8 03 00 00");
  EXPECT_EQ(cable.last(0x38F), "38F#05") << "100 mm";
  cable.send("18C#D0 07 00 00");
  EXPECT_EQ(cable.last(0x38F), "38F#04") << "200 mm";
  cable.send("18C#60 08 00 00");
  EXPECT_EQ(cable.count(0x38F), 2u) << "214.4 mm: within the hysteresis";
  cable.send("18C#FF FF FF FF");
  EXPECT_EQ(cable.last(0x38F), "38F#00") << "-0.1 mm";
}

TEST_F(PositionCam, ObeysEnableAndPolarity) {
  cable.send("18C#E8 03 00 00");
  cable.send("60F#2F A1 63 01 04 00 00 00");
  EXPECT_EQ(cable.last(0x38F), "38F#04");
  cable.send("60F#2F A2 63 01 04 00 00 00");
  EXPECT_EQ(cable.last(0x38F), "38F#00");
}

}  // namespace
}  // namespace canvoy::cia417::position_cam_device_test
