#include "canvoy/worlds/police/operator_hands.hpp"

#include <gtest/gtest.h>

namespace canvoy::police::operator_hands_test {
namespace {

using cia447::NumberPadKey;

/// A person at a terminal, in steps of 100 ms; the actions are in `diary`, with their times in ms.
class OperatorHands : public testing::Test {
 protected:
  void note(const std::string& what) {
    diary.push_back(std::to_string(now.time_since_epoch() / 1ms) + " " + what);
  }
  /// Runs up to a time, which is that of a step.
  void run_until(Duration until) {
    for (; now <= Time(until); now += 100ms) sut.step(now);
  }

  Time now{};
  std::string title;
  std::string text;
  std::vector<std::string> diary;
  Operator sut{{.open = [this](Client client) { note("open " + std::string(title_of(client))); },
                .press =
                    [this](Client, NumberPadKey key) {
                      note("key " + std::to_string(static_cast<unsigned>(key)));
                    },
                .title = [this] { return title; },
                .text = [this] { return text; }}};
};

TEST_F(OperatorHands, ThinksOpensAndPressesWhenTheTitleAndEachAnswerHasBeenRead) {
  sut.want({Client::radio, {NumberPadKey::key_3, NumberPadKey::key_4}, {"status 3", "sent"}});
  run_until(1s);
  EXPECT_EQ(diary, (std::vector<std::string>{"700 open RADIO"}));
  title = "RADIO";
  run_until(2s);  // read at 1.1 s
  text = "status 3?";
  run_until(3s);  // read at 2.1 s
  EXPECT_EQ(diary, (std::vector<std::string>{"700 open RADIO", "1500 key 3", "2100 key 4"}));
  EXPECT_EQ(sut.waits_since(now), Time(2100ms));
  text = "sent";
  run_until(4s);
  EXPECT_EQ(sut.done(), 1u);
  EXPECT_TRUE(sut.is_idle());
  EXPECT_EQ(sut.waits_since(now), now);
  EXPECT_EQ(diary.size(), 3u);
}

TEST_F(OperatorHands, AKeyOfWhichNothingComesIsPressedAgainAfterThreeSeconds) {
  title = "SOUND";
  sut.want({Client::signals, {NumberPadKey::key_1}, {"yelp"}});
  run_until(8s);
  EXPECT_EQ(diary,
            (std::vector<std::string>{"700 open SOUND", "1200 key 1", "4200 key 1", "7200 key 1"}));
}

TEST_F(OperatorHands, AClientThatDoesNotShowItselfIsOpenedAgainAfterFiveSeconds) {
  sut.want({Client::radio, {NumberPadKey::key_3}, {"status 3"}});
  run_until(6s);
  EXPECT_EQ(diary, (std::vector<std::string>{"700 open RADIO", "5700 open RADIO"}));
}

TEST_F(OperatorHands, WhereTheClientHasGoneItBeginsAgain) {
  title = "RADIO";
  sut.want({Client::radio, {NumberPadKey::key_3, NumberPadKey::key_4}, {"status", "sent"}});
  text = "status";
  run_until(2s);
  title = "SOUND";
  run_until(2100ms);
  title = "RADIO";
  run_until(2600ms);
  EXPECT_EQ(diary, (std::vector<std::string>{"700 open RADIO", "1200 key 3", "1600 key 4",
                                             "2100 open RADIO", "2600 key 3"}));
}

TEST_F(OperatorHands, KeepsEightTasksInMindAndForgetsThemAllWhereItGivesUp) {
  for (int i = 0; i < 9; ++i) sut.want({Client::radio, {NumberPadKey::key_1}, {""}});
  title = "RADIO";
  run_until(60s);
  EXPECT_EQ(sut.done(), 8u);
  sut.want({Client::radio, {NumberPadKey::key_1}, {"never"}});
  run_until(62s);
  sut.give_up();
  run_until(63s);
  EXPECT_TRUE(sut.is_idle());
  EXPECT_EQ(sut.done(), 8u);
}

}  // namespace
}  // namespace canvoy::police::operator_hands_test
