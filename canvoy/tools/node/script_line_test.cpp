#include "canvoy/tools/node/script_line.hpp"

#include <gtest/gtest.h>

#include "canvoy/tools/node/junit.hpp"

namespace canvoy::tools::script_line_test {
namespace {

using Words = std::vector<std::string>;

TEST(ScriptLine, BlanksPartWordsAndQuotesKeepThemTogether) {
  EXPECT_EQ(script_words("expect 10 'temperature > 20degC'  # warm"),
            (Words{"expect", "10", "temperature > 20degC"}));
  EXPECT_EQ(script_words("\tsend  123#DEAD 456#R\r"), (Words{"send", "123#DEAD", "456#R"}))
      << "a # in a word begins no comment";
  EXPECT_EQ(script_words("write 10 1008 \"it's\""), (Words{"write", "10", "1008", "it's"}));
  EXPECT_EQ(script_words("write 10 2001 ''"), (Words{"write", "10", "2001", ""}));
  EXPECT_EQ(script_words("  # nothing"), Words{});
  EXPECT_EQ(script_words("read 'open"), std::nullopt);
}

TEST(Junit, TellsWhatPassedWhatFailedAndWhatWasNotRun) {
  JunitSuite suite{.name = "a.canvoy"};
  suite.cases = {
      {.name = "line 1: sync", .time = 5ms},
      {.name = "line 2: expect 10 temperature < 5", .time = 1s, .failure = "it is \"20\""},
      {.name = "line 3: sync", .is_skipped = true}};
  EXPECT_EQ(
      junit_text(suite),
      "<?xml version=\"1.0\"?>\n"
      "<testsuite name=\"a.canvoy\" tests=\"3\" failures=\"1\" skipped=\"1\" time=\"1.005\">\n"
      "  <testcase name=\"line 1: sync\" time=\"0.005\" />\n"
      "  <testcase name=\"line 2: expect 10 temperature &lt; 5\" time=\"1.000\">\n"
      "    <failure message=\"it is &quot;20&quot;\" />\n"
      "  </testcase>\n"
      "  <testcase name=\"line 3: sync\" time=\"0.000\">\n"
      "    <skipped />\n"
      "  </testcase>\n"
      "</testsuite>\n");
}

}  // namespace
}  // namespace canvoy::tools::script_line_test
