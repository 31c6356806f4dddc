#include "canvoy/tools/session/bus_news.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

namespace canvoy::tools::bus_news_test {
namespace {

/// A bus with the test at its other end.
class OtherEnd final : public host::Carrier {
 public:
  explicit OtherEnd(std::string_view name) : name_(name) {}
  std::string_view name() const override { return name_; }
  host::SendResult send(const Frame&) override { return host::SendResult::sent; }
  void hear(const Frame& frame, Time time) { events_.frame(frame, time, host::Origin::elsewhere); }
  void tell(BusState state) { events_.state(state, Time{}); }
  void complain() { events_.trouble(host::Error{.where = name_, .what = "the network is down"}); }
  void lose(std::uint64_t frames) { counters_.overrun += frames; }

 private:
  std::string name_;
};

class BusNewsTest : public testing::Test {
 protected:
  OtherEnd& follow(std::string_view name, bool with_nodes = true) {
    auto made = std::make_unique<OtherEnd>(name);
    OtherEnd& end = *made;
    buses_.push_back(std::make_unique<host::HostBus>(*loop_, std::move(made)));
    news_.follow(*buses_.back(), with_nodes);
    return end;
  }
  /// Heartbeats of node 10: operational, each 100 ms, the last one at `last`.
  static void beat(OtherEnd& end, Time first, Time last) {
    for (Time at = first; at <= last; at += 100ms) end.hear(Frame::data_frame(0x70A, {0x05}), at);
  }

  std::unique_ptr<host::EventLoop> loop_ = *host::EventLoop::create();
  std::vector<std::unique_ptr<host::HostBus>> buses_;
  std::vector<std::string> told_;
  BusNews news_{[this](const std::string& line) { told_.push_back(line); }};
};

using Told = std::vector<std::string>;

TEST_F(BusNewsTest, NothingIsSaidWhereAllIsWell) {
  OtherEnd& end = follow("can0");
  beat(end, Time(100ms), Time(5s));
  news_.look(Time(5s));
  EXPECT_EQ(told_, Told{});
  EXPECT_EQ(news_.text(Time(5s)), "");
}

TEST_F(BusNewsTest, ABusThatIsOffIsToldUntilItIsBack) {
  OtherEnd& end = follow("can0");
  end.tell(BusState::bus_off);
  EXPECT_EQ(news_.text(Time(1s)), "can0 is bus-off");
  end.tell(BusState::error_active);
  EXPECT_EQ(news_.text(Time(1s)), "");
  EXPECT_EQ(told_, (Told{"can0 is bus-off", "can0 is back"}));
}

TEST_F(BusNewsTest, ABusThatIsLostIsToldUntilItIsBack) {
  OtherEnd& end = follow("can0");
  end.complain();
  end.tell(BusState::bus_off);
  EXPECT_NE(news_.text(Time(1s)).find("the network is down"), std::string::npos);
  EXPECT_NE(news_.trouble().find("can0"), std::string::npos);
  end.tell(BusState::error_active);
  EXPECT_EQ(news_.trouble(), "");
  EXPECT_EQ(told_, (Told{"canvoy: can0: the network is down", "can0 is bus-off", "can0 is back"}));
}

TEST_F(BusNewsTest, ABusWithoutStatesIsBackWithAFrame) {
  OtherEnd& end = follow("any0");
  end.complain();
  EXPECT_NE(news_.trouble(), "");
  end.hear(Frame::data_frame(0x18A, {0x01}), Time(1s));
  EXPECT_EQ(news_.trouble(), "");
}

TEST_F(BusNewsTest, FramesThatWereLostAreCounted) {
  OtherEnd& end = follow("can0");
  end.lose(1);
  news_.look(Time(1s));
  end.lose(2530);
  news_.look(Time(2s));
  news_.look(Time(3s));
  EXPECT_EQ(told_, (Told{"can0: 1 frame was lost before it was read",
                         "can0: 2530 frames were lost before they were read"}));
  EXPECT_EQ(news_.frames_lost(), 2531U);
  EXPECT_EQ(news_.text(Time(3s)), "2531 frames were lost before they were read");
}

TEST_F(BusNewsTest, ANodeIsSilentAfterThreePeriodsAndASecondAtLeast) {
  OtherEnd& end = follow("can0");
  beat(end, Time(1s), Time(2s));
  news_.look(Time(3s));
  EXPECT_EQ(told_, Told{}) << "a second has not passed";
  news_.look(Time(3s + 1ms));
  EXPECT_EQ(news_.text(Time(14s)), "node 10 (0Ah) is silent for 12 s");
  beat(end, Time(15s), Time(15s));
  news_.look(Time(15s));
  EXPECT_EQ(news_.text(Time(15s)), "");
  EXPECT_EQ(told_, (Told{"can0: node 10 (0Ah): no heartbeat any more",
                         "can0: node 10 (0Ah): its heartbeat is back"}));
}

TEST_F(BusNewsTest, AllOfItIsOneLineWithTheBusWhereThereAreSeveral) {
  OtherEnd& first = follow("can0");
  OtherEnd& second = follow("can1");
  beat(second, Time(1s), Time(2s));
  first.tell(BusState::error_passive);
  second.lose(3);
  news_.look(Time(10s));
  EXPECT_EQ(news_.text(Time(10s)),
            "can0 is error-passive; can1: node 10 (0Ah) is silent for 8 s; 3 frames were lost "
            "before they were read");
}

TEST_F(BusNewsTest, WithoutNodesTheirHeartbeatsAreNotListenedTo) {
  OtherEnd& end = follow("can0", false);
  beat(end, Time(1s), Time(2s));
  news_.look(Time(1min));
  EXPECT_EQ(told_, Told{});
}

}  // namespace
}  // namespace canvoy::tools::bus_news_test
