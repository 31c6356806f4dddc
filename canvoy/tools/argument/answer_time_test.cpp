#include "canvoy/tools/argument/answer_time.hpp"

#include <gtest/gtest.h>

#include <string>

namespace canvoy::tools {
namespace {

class AnswerTimes : public ::testing::Test {
 protected:
  AnswerTimes() { ::unsetenv("CANVOY_TIMEOUT"); }
  ~AnswerTimes() override { ::unsetenv("CANVOY_TIMEOUT"); }
};

TEST_F(AnswerTimes, LeaveTimeToWriteMemory) {
  EXPECT_EQ(parse_answer_time("").usual, Duration(1s));
  EXPECT_EQ(parse_answer_time("").storing, Duration(10s));
}

TEST_F(AnswerTimes, OfTheCommandLineHoldForAllAnswers) {
  EXPECT_EQ(parse_answer_time("500ms").usual, Duration(500ms));
  EXPECT_EQ(parse_answer_time("500ms").storing, Duration(500ms));
}

TEST_F(AnswerTimes, OfTheEnvironmentHoldWithoutOneOfTheCommandLine) {
  ::setenv("CANVOY_TIMEOUT", "20s", 1);
  EXPECT_EQ(parse_answer_time("").usual, Duration(20s));
  EXPECT_EQ(parse_answer_time("").storing, Duration(20s));
  EXPECT_EQ(parse_answer_time("2s").storing, Duration(2s));
  ::setenv("CANVOY_TIMEOUT", "soon", 1);
  EXPECT_THROW(parse_answer_time(""), UsageError);
  ::setenv("CANVOY_TIMEOUT", "", 1);
  EXPECT_EQ(parse_answer_time("").usual, Duration(1s));
  EXPECT_NO_THROW(parse_answer_time("2s"));
}

TEST_F(AnswerTimes, ThatAreNoneAreRefusedByWhatIsWrong) {
  EXPECT_EQ(wrong_duration("1h30min"), "");
  EXPECT_EQ(wrong_duration("100"), "'100' has no unit: 100ms, 100s or 100min");
  EXPECT_EQ(wrong_duration("2000000h"), "'2000000h' is more than a hundred years");
  for (const char* text : {"", "0", "0s", "soon", "5 years", "-1s", "1s 1min", "s"}) {
    EXPECT_NE(wrong_duration(text), "") << text;
    EXPECT_EQ(wrong_duration(text).find("hundred years"), std::string::npos) << text;
  }
  ::setenv("CANVOY_TIMEOUT", "2000000h", 1);
  try {
    parse_answer_time("");
    ADD_FAILURE() << "it was taken";
  } catch (const UsageError& error) {
    EXPECT_STREQ(error.what(), "CANVOY_TIMEOUT: '2000000h' is more than a hundred years");
  }
}

}  // namespace
}  // namespace canvoy::tools
