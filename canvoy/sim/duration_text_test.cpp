#include "canvoy/sim/duration_text.hpp"

#include <gtest/gtest.h>

namespace canvoy::duration_text_test {
namespace {

TEST(DurationTextTest, ReadsEachUnit) {
  EXPECT_EQ(parse_duration("250us"), 250us);
  EXPECT_EQ(parse_duration("100ms"), 100ms);
  EXPECT_EQ(parse_duration("30s"), 30s);
  EXPECT_EQ(parse_duration("20min"), 20min);
  EXPECT_EQ(parse_duration("8h"), 8h);
  EXPECT_EQ(parse_duration("0s"), 0s);
  EXPECT_EQ(parse_duration("500 ms"), 500ms) << "as values are printed";
  EXPECT_EQ(parse_duration("1 min 30 s"), 90s);
}

TEST(DurationTextTest, ReadsUnitsInFull) {
  EXPECT_EQ(parse_duration("2sec"), 2s);
  EXPECT_EQ(parse_duration("2 seconds"), 2s);
  EXPECT_EQ(parse_duration("1 minute 30 secs"), 90s);
  EXPECT_EQ(parse_duration("8hours"), 8h);
  EXPECT_EQ(parse_duration("5msec"), 5ms);
  EXPECT_FALSE(parse_duration("5m")) << "a minute, or a thousandth";
}

TEST(DurationTextTest, ReadsFractions) {
  EXPECT_EQ(parse_duration("1.5min"), 90s);
  EXPECT_EQ(parse_duration("0.25h"), 15min);
  EXPECT_EQ(parse_duration("1.000001s"), 1000001us);
  EXPECT_EQ(parse_duration("0.999999999999999999h"), 1h - 4us) << "rounded down, nine digits count";
  EXPECT_EQ(parse_duration("1.9us"), 1us);
}

TEST(DurationTextTest, ReadsSeveralUnitsTheLargestFirst) {
  EXPECT_EQ(parse_duration("1h30min"), 90min);
  EXPECT_EQ(parse_duration("1min 30s"), 90s);
  EXPECT_EQ(parse_duration("1h 02min 03.456s"), 1h + 2min + 3456ms) << "as it is printed";
  EXPECT_EQ(parse_duration("2s500ms250us"), 2500250us);
}

TEST(DurationTextTest, IsWrittenInTheLargestUnitThatSaysItExactly) {
  EXPECT_EQ(written(8h), "8h");
  EXPECT_EQ(written(0h), "0s") << "no unit is the largest";
  EXPECT_EQ(written(90min), "90min");
  EXPECT_EQ(written(30s), "30s");
  EXPECT_EQ(written(1500ms), "1500ms");
  EXPECT_EQ(written(Duration(1'001)), "1001us");
}

TEST(DurationTextTest, RefusesWhatIsNoDuration) {
  for (const char* text :
       {"",     "8",         "h",    "8  h",    " 8h",  "8h ",         "-8h",   "+8h",
        ".5h",  "5.h",       "1e3s", "8hourz",  "8H",   "8.5.5h",      "0x10s", "m",
        "8h30", "8h  30min", "8h ",  "30min8h", "8h8h", "8h and 30min"}) {
    EXPECT_FALSE(parse_duration(text)) << text;
  }
}

TEST(DurationTextTest, RefusesMoreThanAHundredYears) {
  EXPECT_TRUE(parse_duration("876000h"));
  EXPECT_FALSE(parse_duration("876001h"));
  EXPECT_FALSE(parse_duration("99999999999999999999999us"));
}

}  // namespace
}  // namespace canvoy::duration_text_test
