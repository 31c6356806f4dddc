// Messages of 8.1.4.3 on the wire that are right, or not: sender, length, kind of frame, and
// contents.
#include "canvoy/worlds/bus_line/message_referee.hpp"

#include <gtest/gtest.h>

#include "canvoy/canopen/testing/wire.hpp"

namespace canvoy::bus_line::message_referee_test {
namespace {

struct MessageRefereeTest : testing::Test {
  static constexpr ControllerId computer{1};
  static constexpr ControllerId identification{2};

  MessageRefereeTest() {
    sut.name(computer, identification);
    truth.learn(Time(1s), {.stop_point = 0x0102, .driver = 0x04D2});
  }
  std::optional<bool> judge(ControllerId sender, std::string_view frame) const {
    return sut.is_right(Time(10s), sender, wire_frame(frame), truth);
  }

  MessageReferee sut;
  TrueHistory truth;
};

TEST_F(MessageRefereeTest, TheTruthOfItsSenderInItsLengthIsRight) {
  EXPECT_EQ(judge(identification, "201#D2 04 00 00"), true);
  EXPECT_EQ(judge(computer, "401#02 01 00 00 00 00 00 00"), true);
  EXPECT_EQ(judge(identification, "201#00 00 00 00"), true) << "not known yet";
  EXPECT_EQ(judge(identification, "201#D3 04 00 00"), false);
}

TEST_F(MessageRefereeTest, WhoeverElseSendsItLies) {
  EXPECT_EQ(judge(computer, "201#D2 04 00 00"), false);
  EXPECT_EQ(judge(identification, "401#02 01 00 00 00 00 00 00"), false);
  EXPECT_EQ(judge(ControllerId{3}, "401#02 01 00 00 00 00 00 00"), false);
}

TEST_F(MessageRefereeTest, AnotherLengthAndARequestAreWrong) {
  EXPECT_EQ(judge(identification, "201#D2 04 00"), false);
  EXPECT_EQ(judge(identification, "201#D2 04 00 00 00"), false);
  EXPECT_EQ(judge(identification, "201#R4"), false);
}

TEST_F(MessageRefereeTest, OtherFramesAreNoneOfThem) {
  EXPECT_EQ(judge(computer, "1C1#01"), std::nullopt);
  EXPECT_EQ(judge(computer, "00000201#D2 04 00 00"), std::nullopt);
}

}  // namespace
}  // namespace canvoy::bus_line::message_referee_test
