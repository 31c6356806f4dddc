#include "canvoy/tools/cli/spelling.hpp"

#include <gtest/gtest.h>

namespace canvoy::tools::spelling_test {
namespace {

TEST(SpellingTest, CountsWhatIsToBeChanged) {
  EXPECT_EQ(distance("", ""), 0U);
  EXPECT_EQ(distance("", "abc"), 3U);
  EXPECT_EQ(distance("kitten", "sitting"), 3U);
  EXPECT_EQ(distance("Node", "nODE"), 0U) << "case does not matter";
  EXPECT_EQ(distance("ndoe", "node"), 1U) << "two neighbours are swapped at once";
  EXPECT_EQ(distance("abcd", "badc"), 2U);
}

TEST(SpellingTest, NamesTheClosest) {
  const std::vector<std::string> known = {"node", "mode", "temperature", "ah_capacity"};
  EXPECT_EQ(did_you_mean("tempersture", known), "; did you mean 'temperature'?");
  EXPECT_EQ(did_you_mean("ah_capactiy", known), "; did you mean 'ah_capacity'?");
  EXPECT_EQ(did_you_mean("nod", known), "; did you mean 'node'?");
  EXPECT_EQ(did_you_mean("--node", {"--move", "--node-id"}), "; did you mean '--node-id'?");
  EXPECT_EQ(did_you_mean("--mode", {"--modes-of-all", "--move"}), "; did you mean '--move'?");
}

TEST(SpellingTest, NeverNamesTheWordItself) {
  EXPECT_EQ(did_you_mean("--eds", {"--ends", "--eds"}), "");
  EXPECT_EQ(did_you_mean("--EDS", {"--eds"}), "; did you mean '--eds'?");
}

TEST(SpellingTest, IsSilentWhereNoneIsClose) {
  EXPECT_EQ(did_you_mean("speed", {"node", "bus", "temperature"}), "");
  EXPECT_EQ(did_you_mean("", {"node"}), "");
  EXPECT_EQ(did_you_mean("x", {"y"}), "") << "nothing of it is left";
  EXPECT_EQ(did_you_mean(std::string(100'000, 'x'), {std::string(100'001, 'x')}), "")
      << "nobody types that";
}

}  // namespace
}  // namespace canvoy::tools::spelling_test
