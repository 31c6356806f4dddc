// A position CAM unit at its wire: positions in, cams out.
#include "canvoy/devices/cia417/position/position_cam_device.hpp"

#include <gtest/gtest.h>

#include <span>

#include "canvoy/can/random.hpp"
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

/// From the settings of a cam, one section after the other, without any state but the cams.
std::uint8_t cams_at(double position, std::uint8_t before, std::span<const Cam> stretches) {
  unsigned on = 0;
  for (const Cam& cam : stretches) {
    const unsigned bit = 1U << (cam.number - 1U);
    const double margin = (before & bit) != 0 ? cam.hysteresis : 0;
    if (position >= cam.low - margin && position <= cam.high + margin) on |= bit;
  }
  return static_cast<std::uint8_t>(on);
}

TEST_F(PositionCam, FindsCamsHoweverTheCarMoves) {
  static constexpr Cam stretches[] = {{.number = 1, .low = 0, .high = 100},
                                      {.number = 1, .low = 150, .high = 200, .hysteresis = 60},
                                      {.number = 2, .low = 50, .high = 50},
                                      {.number = 3, .low = 50, .high = 200, .hysteresis = 20},
                                      {.number = 4, .low = 90, .high = 160, .hysteresis = 5}};
  Dictionary& dictionary = device.node().dictionary();
  dictionary.set_number(0x63A1, 1, 0xFF);
  PositionCamUnit cams(dictionary, 1, stretches);
  Random random(7);
  std::uint8_t expected = 0;
  // In halves of a millimetre, so that it also stops on edges; steps from none to far.
  int position = 0;
  for (int step = 0; step < 20'000; ++step) {
    const int far = step % 100 == 0 ? 400 : 12;
    position += static_cast<int>(random.below(2U * static_cast<unsigned>(far) + 1U)) - far;
    if (position < -200 || position > 700) position = 250;
    expected = cams_at(position / 2.0, expected, stretches);
    cams.update(1, position / 2.0);
    ASSERT_EQ(dictionary.number(0x63A0, 1), expected) << position / 2.0 << " mm, step " << step;
  }
}

}  // namespace
}  // namespace canvoy::cia417::position_cam_device_test
