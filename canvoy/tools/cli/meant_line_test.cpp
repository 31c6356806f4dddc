// The line that was meant.
#include "canvoy/tools/cli/meant_line.hpp"

#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>
#include <string>

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

TEST(MeantLine, IsToldWithLessWordsWhereNothingIsWritten) {
  EXPECT_TRUE(only_shows({"decode", "a.log", "--hex"}));
  EXPECT_TRUE(only_shows({"eds", "diff", "a.eds", "b.eds", "c.eds"}));
  EXPECT_FALSE(only_shows({"decode", "a.log", "--hex", "-o", "b.pcapng"}));
  EXPECT_FALSE(only_shows({"convert-log", "a.log", "b.asc", "c.csv"})) << "b.asc would be lost";
  EXPECT_FALSE(only_shows({"write", "can0", "10", "1017", "5", "--dry-run"}));
  EXPECT_FALSE(only_shows({}));
}

TEST(MeantLine, SendsNoValueOfAnExampleAndNamesNoFileThatIsThere) {
  const std::string file = testing::TempDir() + "meant_line_test.asc";
  std::ofstream(file) << "a log";
  EXPECT_TRUE(is_safe_line("canvoy convert-log a.log none.asc", {"convert-log", "a.log"}));
  EXPECT_FALSE(is_safe_line("canvoy convert-log a.log " + file, {"convert-log", "a.log"}));
  EXPECT_TRUE(is_safe_line("canvoy convert-log " + file + " none.log", {"convert-log", file}));
  EXPECT_TRUE(is_safe_line("canvoy plot " + file + " speed", {"plot"})) << "it is read";
  EXPECT_FALSE(is_safe_line("canvoy write can0 20 1017 500ms", {"write", "can0", "20"}));
  std::remove(file.c_str());
}

TEST(MeantLine, NamesAFileThatIsNotThere) {
  const std::string stem = testing::TempDir() + "meant_line_new";
  EXPECT_EQ(new_file(stem + ".eds", "dcf"), stem + ".dcf");
  std::ofstream(stem + ".dcf") << "a sheet";
  EXPECT_EQ(new_file(stem + ".eds", "dcf"), stem + "-2.dcf");
  std::remove((stem + ".dcf").c_str());
}

}  // namespace
}  // namespace canvoy::tools::meant_line_test
