#include "canvoy/tools/cli/toml_file.hpp"

#include <gtest/gtest.h>

#include "canvoy/tools/cli/failure.hpp"

namespace canvoy::tools::toml_file_test {
namespace {

/// The error in a text, when all keys of a small network are read.
std::string refusal(std::string_view text) {
  try {
    TomlFile file("net.toml", text);
    TomlTable& table = file.table();
    std::string name;
    bool is_real = false;
    double load = 0;
    std::uint8_t id = 0;
    Duration duration{};
    CivilTime begin{};
    std::vector<std::string> faults;
    std::vector<double> heights;
    table.take("name", name);
    table.take("real", is_real);
    table.take("load", load, {0, 1});
    table.take("for", duration);
    table.take("begin", begin);
    table.take("faults", faults);
    table.take("heights", heights, {0, 900});
    TomlTable bus = table.table("bus");
    bus.finish();
    for (TomlTable& node : table.tables("node")) {
      node.take<std::uint8_t>("id", id, {1, 127});
      node.finish();
    }
    table.finish();
  } catch (const Failure& failure) {
    return failure.what();
  }
  return "";
}

TEST(TomlFile, TellsFileAndLineOfWhatIsWrong) {
  EXPECT_EQ(refusal("load = 0.5\nname = 5"), "net.toml line 2: name: write a text in quotes");
  EXPECT_EQ(refusal("real = 1"), "net.toml line 1: real: write true or false");
  EXPECT_EQ(refusal("load = true"), "net.toml line 1: load: write a number");
  EXPECT_EQ(refusal("load = 1.5"), "net.toml line 1: load: 1.5 is not from 0 to 1");
  EXPECT_EQ(refusal("load = nan"), "net.toml line 1: load: nan is not from 0 to 1");
  EXPECT_EQ(refusal("for = '8'"),
            "net.toml line 1: for: '8' is no time: write a number and us, ms, s, min or h, as "
            "\"30s\" or \"8h\"");
  EXPECT_EQ(refusal("begin = '2026'"),
            "net.toml line 1: begin: write date and time, as 2026-11-21T18:00:00");
  EXPECT_EQ(refusal("begin = 1983-12-31T00:00:00"),
            "net.toml line 1: begin: write a date from 1984 on");
  EXPECT_EQ(refusal("faults = 'a'"),
            "net.toml line 1: faults: write a list of texts, as [\"a\", \"b\"]");
  EXPECT_EQ(refusal("faults = [1]"),
            "net.toml line 1: faults: write a list of texts, as [\"a\", \"b\"]");
  EXPECT_EQ(refusal("heights = [0, 'x']"),
            "net.toml line 1: heights: write a list of numbers, as [0, 3.5]");
  EXPECT_EQ(refusal("heights = [0, -1]"), "net.toml line 1: heights: -1 is not from 0 to 900");
  EXPECT_EQ(refusal("\n[[node]]\nid = 128"), "net.toml line 3: id: 128 is not from 1 to 127");
  EXPECT_EQ(refusal("[[node]]\nid = 1.5"), "net.toml line 2: id: write a whole number");
  EXPECT_EQ(refusal("[node]\nid = 1"), "net.toml line 1: node: write tables, as [[node]]");
  EXPECT_EQ(refusal("bus = 1"), "net.toml line 1: bus: write a table, as [bus]");
  EXPECT_EQ(refusal("[[node]]\nidd = 1"), "net.toml line 2: idd: is not known here; there are id");
  EXPECT_EQ(refusal("name = "),
            "net.toml line 1: Error while parsing key-value pair: encountered "
            "end-of-file");
}

TEST(TomlFile, LeavesAsItIsWhatIsNotThere) {
  TomlFile file("net.toml", "");
  double load = 0.25;
  std::uint16_t count = 7;
  Duration duration = 3s;
  file.table().take("load", load);
  file.table().take("count", count);
  file.table().take("for", duration);
  file.table().finish();
  EXPECT_EQ(load, 0.25);
  EXPECT_EQ(count, 7);
  EXPECT_EQ(duration, 3s);
}

TEST(TomlFile, ReadsWholeNumbersWhereNumbersAreWantedAndTimesOfDay) {
  TomlFile file("net.toml", "load = 1\nbegin = 2026-11-21T18:00:00.25\nfor = '1.5min'");
  double load = 0;
  CivilTime begin{};
  Duration duration{};
  file.table().take("load", load);
  file.table().take("begin", begin);
  file.table().take("for", duration);
  EXPECT_EQ(load, 1);
  EXPECT_EQ(duration, 90s);
  using namespace std::chrono;  // NOLINT(google-build-using-namespace): units and calendar
  EXPECT_EQ(begin, sys_days{2026y / 11 / 21} + 18h + 250ms);
}

TEST(TomlFile, SaysThatAFileCannotBeRead) {
  try {
    TomlFile file("/nowhere/net.toml");
    FAIL();
  } catch (const Failure& failure) {
    EXPECT_STREQ(failure.what(), "/nowhere/net.toml: No such file or directory; check the path");
  }
}

}  // namespace
}  // namespace canvoy::tools::toml_file_test
