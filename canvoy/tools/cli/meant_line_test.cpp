// The line that was meant.
#include "canvoy/tools/cli/meant_line.hpp"

#include <gtest/gtest.h>

namespace canvoy::tools::meant_line_test {
namespace {

constexpr const char* examples =
    "Nobody is changed by it.\n"
    "Examples:\n"
    "  canvoy expect can0 10 'temperature > -20degC within 2s'\n"
    "  canvoy expect can0 10 'battery_voltage < 60 V' --json\n"
    "  printf 'sync\\n' | canvoy script can0 -";

TEST(MeantLine, HasQuotesWhereAShellNeedsThem) {
  EXPECT_EQ(typed_line({"read", "can0", "10", "battery voltage"}),
            "canvoy read can0 10 'battery voltage'");
  EXPECT_EQ(typed_line({"send", "can0", "123#1122"}), "canvoy send can0 123#1122");
  EXPECT_EQ(typed_line({"read", ""}), "canvoy read ''");
  EXPECT_EQ(typed_line({}), "canvoy");
}

TEST(MeantLine, IsCompletedAsTheFirstExample) {
  EXPECT_EQ(completed_line({"expect", "can1", "5"}, "expect", examples),
            "canvoy expect can1 5 'temperature > -20degC within 2s'");
  EXPECT_EQ(completed_line({"expect", "can1", "--json"}, "expect", examples),
            "canvoy expect can1 10 'temperature > -20degC within 2s' --json");
  EXPECT_EQ(completed_line({"expect", "can1", "5", "x"}, "expect", examples), "");
  EXPECT_EQ(completed_line({"read"}, "read", examples), "") << "it has no example";
}

TEST(MeantLine, AnOptionHasTheFirstExampleWithIt) {
  EXPECT_EQ(example_with(examples, "--json"),
            "canvoy expect can0 10 'battery_voltage < 60 V' --json");
  EXPECT_EQ(example_with(examples, "--every"), "");
  EXPECT_EQ(example_with(examples, "script"), "") << "a pipe is no line of its own";
}

TEST(MeantLine, IsWithoutWhatIsNotKnown) {
  EXPECT_EQ(line_without({"decode", "a.log", "--hex", "5", "--json"}, {"--hex", "5"}),
            "canvoy decode a.log --json");
}

}  // namespace
}  // namespace canvoy::tools::meant_line_test
