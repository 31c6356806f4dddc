// Longest times for which something may be wrong in a police car, without a network.
#include "canvoy/worlds/police/police_referee.hpp"

#include <gtest/gtest.h>

#include <utility>

namespace canvoy::police::police_referee_test {
namespace {

/// True if the invariant holds when it was wrong for so long, in steps of 10 ms.
bool holds_after(InvariantKind kind, Duration wrong) {
  PoliceReferee sut;
  sut.judge_unless(false, kind, Time(1s), true);
  for (Time now(1010ms); now <= Time(1s) + wrong; now += 10ms) {
    sut.judge_unless(false, kind, now, false);
  }
  return sut.verdicts({})[static_cast<std::size_t>(kind)].held;
}

/// A siren sounds without blue light (StVO, section 38) for a flash at most.
TEST(PoliceReferee, EachInvariantMayBeBrokenForItsTimeAndNoLonger) {
  using Kind = InvariantKind;
  for (const auto& [kind, bound] : {std::pair<Kind, Duration>(Kind::blue_light, 2s),
                                    {Kind::siren, 2s},
                                    {Kind::siren_alone, 500ms},
                                    {Kind::work_light, 3s},
                                    {Kind::speech, 2s},
                                    {Kind::carrier, 2s},
                                    {Kind::display, 3s},
                                    {Kind::locks, 3s},
                                    {Kind::power, 3s}}) {
    EXPECT_TRUE(holds_after(kind, bound)) << invariant_name(kind).name;
    EXPECT_FALSE(holds_after(kind, bound + 10ms)) << invariant_name(kind).name;
  }
}

/// What is right for a moment ends the interval.
TEST(PoliceReferee, TimesThatAreNotInOnePieceAreNotSummed) {
  PoliceReferee sut;
  const auto kind = InvariantKind::siren_alone;
  sut.judge_unless(false, kind, Time(1s), true);
  for (Time now(1s); now < Time(9s); now += 500ms) {
    sut.judge_unless(false, kind, now + 400ms, false);
    sut.judge_unless(false, kind, now + 500ms, true);
  }
  EXPECT_TRUE(sut.verdicts({})[static_cast<std::size_t>(kind)].held);
}

}  // namespace
}  // namespace canvoy::police::police_referee_test
