#include "canvoy/can/host/candump_replay.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "canvoy/can/frame_text.hpp"
#include "canvoy/can/host/temporary_file_test.hpp"

namespace canvoy::host::candump_replay_test {
namespace {

struct Played {
  std::string text;
  Time due;
  friend bool operator==(const Played&, const Played&) = default;
};

class CandumpReplayTest : public testing::Test {
 protected:
  void load(const std::string& content, const ReplayOptions& options = {}) {
    file_.emplace(content);
    replay_.emplace(*CandumpReader::open(file_->path()), options,
                    CandumpReplay::Play::to<&CandumpReplayTest::play>(*this));
  }
  void play(const LogEntry& entry, Time due) {
    played_.push_back({entry.interface + " " + std::string(FrameText(entry.frame).view()), due});
  }

 public:
  std::optional<TemporaryFile> file_;
  std::optional<CandumpReplay> replay_;
  std::vector<Played> played_;
};

TEST_F(CandumpReplayTest, TheFirstFrameIsDueAtTheStartAndTheOthersKeepTheirDistance) {
  load(
      "(1700000000.500000) can0 181#01\n(1700000000.600000) can1 182#02\n(1700000002.500000) can0 "
      "183#03\n",
      {.start = Time{10s}});
  EXPECT_EQ(replay_->deadline(), Time{10s});
  replay_->advance(Time{10s});
  EXPECT_EQ(replay_->deadline(), Time{10s + 100ms});
  replay_->advance(Time{10s + 99ms});
  EXPECT_EQ(played_.size(), 1U);
  replay_->advance(Time{12s});
  EXPECT_EQ(played_, (std::vector<Played>{{"can0 181#01", Time{10s}},
                                          {"can1 182#02", Time{10s + 100ms}},
                                          {"can0 183#03", Time{12s}}}));
  EXPECT_TRUE(replay_->finished());
  EXPECT_EQ(replay_->deadline(), never);
  EXPECT_EQ(replay_->played(), 3U);
  EXPECT_FALSE(replay_->error());
}

TEST_F(CandumpReplayTest, AtTwiceTheSpeedTheDistancesAreHalved) {
  load("(5.000000) can0 181#\n(6.000000) can0 182#\n", {.start = Time{}, .speed = 2.0});
  replay_->advance(Time{});
  EXPECT_EQ(replay_->deadline(), Time{500ms});
}

TEST_F(CandumpReplayTest, ATimeThatGoesBackIsDueAtOnceAndDoesNotHoldTheOthersUp) {
  load("(5.000000) can0 181#\n(4.000000) can0 182#\n(6.000000) can0 183#\n");
  replay_->advance(Time{});
  EXPECT_EQ(played_.size(), 2U);
  EXPECT_EQ(played_[1].due, Time{});
  EXPECT_EQ(replay_->deadline(), Time{1s});
}

TEST_F(CandumpReplayTest, AnEmptyLogIsFinishedAtOnce) {
  load("");
  EXPECT_TRUE(replay_->finished());
}

TEST_F(CandumpReplayTest, AMalformedLineEndsItWithTheErrorButAfterTheFramesBeforeIt) {
  load("(5.000000) can0 181#\nnonsense\n(6.000000) can0 183#\n");
  replay_->advance(Time{10s});
  EXPECT_EQ(played_.size(), 1U);
  EXPECT_TRUE(replay_->finished());
  ASSERT_TRUE(replay_->error());
  EXPECT_EQ(replay_->error()->where, file_->path() + " line 2");
}

TEST_F(CandumpReplayTest, AVerySlowReplayOfFarApartTimesDoesNotOverflow) {
  load("(0.000000) can0 181#\n(999999999999.0) can0 182#\n", {.start = Time{}, .speed = 1e-12});
  replay_->advance(Time{24h});
  EXPECT_EQ(played_.size(), 1U);
  EXPECT_GT(replay_->deadline(), Time{24h});
}

TEST_F(CandumpReplayTest, TheLoopPlaysIt) {
  const std::unique_ptr<EventLoop> loop = *EventLoop::create();
  load("(5.000000) can0 181#\n(5.002000) can0 182#\n", {.start = loop->now()});
  loop->add(replay_->task());
  loop->run_until(loop->now() + 2500us);
  EXPECT_EQ(played_.size(), 2U);
}

}  // namespace
}  // namespace canvoy::host::candump_replay_test
