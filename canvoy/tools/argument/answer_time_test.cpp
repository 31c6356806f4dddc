#include "canvoy/tools/argument/answer_time.hpp"

#include <gtest/gtest.h>

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
  EXPECT_NO_THROW(parse_answer_time("2s"));
}

}  // namespace
}  // namespace canvoy::tools
