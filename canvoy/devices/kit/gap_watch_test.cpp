// Signs of lost frames at a node, and the resulting requests.
#include "canvoy/devices/kit/gap_watch.hpp"

#include <gtest/gtest.h>

#include <array>
#include <string>

#include "canvoy/devices/cia417/load/load_measuring_device.hpp"

namespace canvoy::gap_watch_test {
namespace {

/// Requests to any node, and their times.
class Gaps : public testing::Test {
 protected:
  Gaps() {
    node().start(now);
    node().command(NmtCommand::start);
    run_to(Time(10s));
  }
  Node& node() { return device.node(); }
  void run_to(Time until) {
    while (node().deadline() <= until) {
      now = std::max(now, node().deadline());
      node().advance(now);
    }
    now = until;
    node().advance(now);
  }
  void asked(NodeId id) {
    questions += std::to_string((node().now() - Time{}) / 1ms) + ":" + std::to_string(id) + " ";
  }
  void state_is(BusState state) { node().bus_state(state, now); }

  static bool swallow(void* /*none*/, const Frame& /*frame*/) { return true; }

  Time now{};
  std::string questions;  ///< "milliseconds:node", 0 is everyone
  cia417::LoadMeasuringDevice<> device{{nullptr, &Gaps::swallow, nullptr}, 13, {}};
  std::array<GapWatch::Rhythm, 10> rhythms;
  GapWatch watch{device.node(), callback<&Gaps::asked>(*this), rhythms};
};

TEST_F(Gaps, TheEndOfErrorPassiveIsASign) {
  state_is(BusState::error_passive);
  run_to(Time(11s));
  EXPECT_EQ(questions, "") << "frames may still be lost";
  state_is(BusState::error_warning);
  run_to(Time(12s));
  EXPECT_EQ(questions, "11020:0 ");
}

TEST_F(Gaps, TheEndOfBusOffIsASign) {
  state_is(BusState::bus_off);
  run_to(Time(11s));
  node().command(NmtCommand::start);  // it was left by that (1029h)
  EXPECT_EQ(questions, "");
  state_is(BusState::error_active);
  run_to(Time(12s));
  EXPECT_EQ(questions, "11020:0 ");
}

TEST_F(Gaps, LostFramesOfTheControllerAreASign) {
  node().overrun(now);
  run_to(Time(11s));
  EXPECT_EQ(questions, "10020:0 ");
}

TEST_F(Gaps, AHeartbeatThatIsHalfAPeriodLateIsASign) {
  for (const Time at : {Time(10s), Time(11s), Time(12s), Time(13499ms), Time(14s)}) {
    run_to(at);
    watch.heard(4, RemoteState::operational);
  }
  run_to(Time(14900ms));
  EXPECT_EQ(questions, "");
  run_to(Time(16002ms));  // twice as long as the time before, and more
  watch.heard(4, RemoteState::operational);
  run_to(Time(17s));
  EXPECT_EQ(questions, "16022:4 ");
}

TEST_F(Gaps, TheFirstHeartbeatAfterABootUpIsNone) {
  for (const Time at : {Time(10s), Time(11s)}) {
    run_to(at);
    watch.heard(4, RemoteState::operational);
  }
  run_to(Time(12s));
  watch.heard(4, RemoteState::boot_up);
  run_to(Time(15s));
  watch.heard(4, RemoteState::pre_operational);
  run_to(Time(16s));
  EXPECT_EQ(questions, "");
}

TEST_F(Gaps, ANodeThatTellsOfTroubleWithItsCommunicationIsASign) {
  watch.heard(7, Emergency{.code = 0x8120});
  watch.heard(8, Emergency{.code = 0x8250});
  watch.heard(9, Emergency{.code = 0xFF04});
  run_to(Time(11s));
  EXPECT_EQ(questions, "10020:7 ");
}

TEST_F(Gaps, ADisturbedBusIsNotFilledWithQuestions) {
  for (int i = 0; i < 100; ++i) {
    node().overrun(now);
    run_to(now + 10ms);
  }
  run_to(Time(12s));
  EXPECT_EQ(questions, "10020:0 11020:0 ");
}

TEST_F(Gaps, NobodyIsAskedWhileTheNodeHearsNoPdos) {
  node().overrun(now);
  node().command(NmtCommand::enter_pre_operational);
  run_to(Time(12s));
  EXPECT_EQ(questions, "");
}

}  // namespace
}  // namespace canvoy::gap_watch_test
