// What counts as a motion that no hand commands, and whose silence explains it; without a network.
#include "canvoy/worlds/excavator/excavator_referee.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace canvoy::excavator::excavator_referee_test {
namespace {

/// A machine that slews though no hand commands it, from the first second of a run on.
struct ExcavatorRefereeTest : testing::Test {
  ExcavatorRefereeTest() {
    machine.set_pilot_pressure(true);
    machine.set_throttle(1);
    machine.command(Movement::slew, 1);
    for (int i = 0; i < 20; ++i) machine.step(0.1);
  }
  /// For ten seconds, host and seat are heard each 10 ms; the armrest for this time.
  void move_while_heard(Duration armrest) {
    for (Time now{10ms}; now <= Time(10s); now += 10ms) {
      sut.heard_host(now);
      sut.heard_seat(now);
      if (now <= Time(armrest)) sut.heard_armrest(now);
      sut.moves(now, machine, {});
    }
  }
  double worst(InvariantKind kind) const {
    const auto verdicts = sut.verdicts();
    return std::ranges::find(verdicts, kind, &Invariant::kind)->worst;
  }

  Excavator machine;
  ExcavatorReferee sut;
};

TEST_F(ExcavatorRefereeTest, AMotionWithoutAHandIsUnwanted) {
  move_while_heard(10s);
  EXPECT_NEAR(worst(InvariantKind::unwanted_motion), 10, 0.02);
  EXPECT_EQ(worst(InvariantKind::lost_armrest), 0);
}

TEST_F(ExcavatorRefereeTest, OneThatGoesOnWithoutTheArmrestIsTheFaultOfWhoDoesNotMissIt) {
  move_while_heard(1s);
  EXPECT_NEAR(worst(InvariantKind::lost_armrest), 9, 0.02);
  EXPECT_LT(worst(InvariantKind::unwanted_motion), 2) << "judged while all were heard";
}

TEST_F(ExcavatorRefereeTest, WhereThereIsNoArmrestItsSilenceExplainsNothing) {
  sut.has_no_armrest();
  move_while_heard(0s);
  EXPECT_NEAR(worst(InvariantKind::unwanted_motion), 10, 0.02);
}

}  // namespace
}  // namespace canvoy::excavator::excavator_referee_test
