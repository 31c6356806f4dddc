// Wheel pulses that do not fit to the rpm of the wheels (CiA 447-3, 4.2.4.4), by the counts that a
// taximeter takes. k is 1000 pulses: 4 thousandths of a distance unit are 4 pulses.
#include "canvoy/devices/cia447/taximeter/wheel_pulses.hpp"

#include <gtest/gtest.h>

namespace canvoy::cia447::wheel_check_test {
namespace {

class Wheels : public testing::Test {
 protected:
  /// The wheels stand for 1.1 s, then these pulses come.
  void stand_and_count(std::uint32_t pulses) {
    for (int i = 0; i < 11; ++i) sut.take({.since = 100ms, .half_rpm = 0, .k = 1000});
    sut.take({.turned = pulses, .since = 100ms, .half_rpm = 0, .k = 1000});
  }
  /// 150 rpm, with so many pulses in each of these tenths of a second.
  void drive(int tenths, std::uint32_t pulses) {
    for (int i = 0; i < tenths; ++i) {
      sut.take({.turned = pulses, .since = 100ms, .half_rpm = 300, .k = 1000});
    }
  }
  /// No count for longer than 500 ms.
  void lose_counts() { sut.take({.turned = 0, .since = 600ms, .half_rpm = 300, .k = 1000}); }

  WheelCheck sut;
};

TEST_F(Wheels, PulsesWhileTheyStandAreExtraFromFourThousandthsOn) {
  stand_and_count(3);
  EXPECT_FALSE(sut.has_extra_pulses());
  stand_and_count(1);
  EXPECT_TRUE(sut.has_extra_pulses());
}

TEST_F(Wheels, PulsesOfOneStopDoNotCountAtTheNext) {
  stand_and_count(3);
  drive(1, 20);
  stand_and_count(3);
  EXPECT_FALSE(sut.has_extra_pulses());
}

TEST_F(Wheels, ATwentiethMoreThanInTheFirstWindowIsExtraInTwoOnEnd) {
  drive(100, 20);
  drive(100, 22);
  EXPECT_FALSE(sut.has_extra_pulses());
  drive(100, 22);
  EXPECT_TRUE(sut.has_extra_pulses());
}

TEST_F(Wheels, AWindowThatIsInterruptedBeginsWithoutWhatWasBefore) {
  drive(100, 20);
  for (int window = 0; window < 2; ++window) {
    drive(90, 24);
    lose_counts();
    drive(100, 20);
  }
  EXPECT_FALSE(sut.has_extra_pulses()) << "no whole window has had more";
}

}  // namespace
}  // namespace canvoy::cia447::wheel_check_test
