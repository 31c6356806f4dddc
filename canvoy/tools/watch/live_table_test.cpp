#include "canvoy/tools/watch/live_table.hpp"

#include <gtest/gtest.h>

#include "canvoy/profiles/cia418.hpp"
#include "canvoy/tools/terminal/screen.hpp"
#include "canvoy/tools/terminal/terminal_text.hpp"

namespace canvoy::tools {
namespace live_table_test {

/// A battery, node 10, with known profile.
class LiveTableTest : public testing::Test {
 protected:
  LiveTableTest() { decoder_.network().set_profile(10, cia418::profile); }

  /// Adds 6010h in an SDO answer: an eighth of a degree per count.
  void temperature(LiveTable& table, Duration time, std::uint8_t raw,
                   std::string_view bus = "can0") {
    const Frame frame = Frame::data_frame(0x58A, {0x4B, 0x10, 0x60, 0x00, raw, 0x00, 0x00, 0x00});
    table.take(time, bus, frame, decoder_.decode(frame));
  }
  void heartbeat(LiveTable& table, Duration time) {
    const Frame frame = Frame::data_frame(0x70A, {0x05});
    table.take(time, "can0", frame, decoder_.decode(frame));
  }

  text::FrameDecoder decoder_;
};

TEST_F(LiveTableTest, AnObjectHasItsValueItsAgeAndItsRate) {
  LiveTable table(LiveTable::By::object);
  for (int i = 0; i < 40; ++i) temperature(table, i * 100ms, 160);
  const auto lines = table.lines({.now = 4s, .columns = 80, .rows = 10});
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_EQ(columns_of(lines[0]), 80U);
  EXPECT_EQ(columns_of(lines[1]), 80U);
  EXPECT_NE(lines[1].find(" 10 6010:00"), std::string::npos) << lines[1];
  EXPECT_NE(lines[1].find("20.000 "), std::string::npos) << lines[1];
  EXPECT_TRUE(lines[1].ends_with("  100ms    10/s")) << lines[1];
}

TEST_F(LiveTableTest, ARateFallsWhileNothingComes) {
  LiveTable table(LiveTable::By::object);
  for (int i = 0; i < 40; ++i) temperature(table, i * 100ms, 160);
  EXPECT_TRUE(table.lines({.now = 13900ms})[1].ends_with("  10.0s  0.10/s"));
}

/// Three PDOs of a node come together, five times per second: 15 per second.
TEST_F(LiveTableTest, ABurstHasNoHigherRateThanItsMean) {
  LiveTable table(LiveTable::By::node);
  const auto burst = [&](Duration time) {
    for (int i = 0; i < 3; ++i) heartbeat(table, time + i * 100us);
  };
  const auto rate = [&](Duration now) {
    const std::string line = table.lines({.now = now})[1];
    return std::stod(line.substr(line.size() - 8));
  };
  burst(0s);
  EXPECT_LE(rate(100ms), 21) << "two intervals in a tenth of a second";
  burst(200ms);
  burst(400ms);
  EXPECT_LE(rate(410ms), 21);
  for (int i = 3; i <= 50; ++i) burst(i * 200ms);
  EXPECT_NEAR(rate(10010ms), 15, 1);
  EXPECT_NEAR(rate(10190ms), 15, 1) << "it does not flicker within the pause";
}

TEST_F(LiveTableTest, FramesOfOtherKindsHaveRowsOfTheirOwn) {
  LiveTable table(LiveTable::By::frame);
  Frame frame = Frame::data_frame(0x040, {});
  table.take(0s, "can0", frame, decoder_.decode(frame));
  frame.flags = FrameFlags::extended;
  table.take(0s, "can0", frame, decoder_.decode(frame));
  frame.flags = FrameFlags::error;  // of SocketCAN: bus-off
  table.take(0s, "can0", frame, decoder_.decode(frame));
  const auto lines = table.lines({.now = 0s});
  ASSERT_EQ(lines.size(), 4U);
  EXPECT_TRUE(lines[1].starts_with("040        - ")) << lines[1];
  EXPECT_TRUE(lines[2].starts_with("00000040   - ")) << lines[2];
  EXPECT_TRUE(lines[3].starts_with("20000040   - ")) << lines[3];
}

/// All words of the columns from `first` on, of all lines.
std::string column_text(const std::vector<std::string>& lines, std::size_t first,
                        std::size_t columns) {
  std::string text;
  for (std::size_t i = 1; i < lines.size(); ++i) {
    std::string part = lines[i].substr(first, columns);
    part.erase(part.find_last_not_of(' ') + 1);
    if (!part.empty()) text += (text.empty() ? "" : " ") + part;
  }
  return text;
}

/// An abort has a text of 60 characters (CiA 301, 7.2.4.3.17).
TEST_F(LiveTableTest, LongNamesAndValuesAreWholeOnTerminalsOfEachWidth) {
  const Frame abort = Frame::data_frame(0x58A, {0x80, 0x10, 0x60, 0x00, 0x11, 0x00, 0x09, 0x06});
  const std::string value(decoder_.decode(abort).text);
  ASSERT_GT(value.size(), 40U);
  LiveTable table(LiveTable::By::object);
  table.take(0s, "can0", abort, decoder_.decode(abort));
  for (const std::size_t columns : {60U, 80U, 100U, 200U}) {
    const auto lines = table.lines({.now = 0s, .columns = columns, .rows = LiveTable::View::all});
    for (const std::string& line : lines) {
      EXPECT_EQ(columns_of(line), columns) << line;
      EXPECT_EQ(line.find(ellipsis), std::string::npos) << line;
    }
    const std::size_t begin = lines[0].find("value");
    EXPECT_EQ(column_text(lines, begin, lines[0].find("    age") - begin), value);
    EXPECT_EQ(lines.size() > 2, columns < 200) << columns;
  }
  const auto lines = table.lines({.now = 0s, .columns = LiveTable::View::as_needed});
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_NE(lines[1].find(value), std::string::npos) << lines[1];
}

TEST_F(LiveTableTest, APageHasTheRowsThatAreWhole) {
  LiveTable table(LiveTable::By::object);
  for (int node = 1; node < 20; ++node) {
    Frame abort = Frame::data_frame(0x580, {0x80, 0x10, 0x60, 0x00, 0x11, 0x00, 0x09, 0x06});
    abort.id += static_cast<std::uint32_t>(node);
    table.take(0s, "can0", abort, decoder_.decode(abort));
  }
  const LiveTable::View view = {.now = 0s, .columns = 80, .rows = 13};
  const std::size_t each = table.lines({.columns = 80, .rows = LiveTable::View::all}).size() / 19;
  ASSERT_GE(each, 2U);
  EXPECT_NEAR(static_cast<double>(table.page(view)), 12.0 / static_cast<double>(each), 1);
  EXPECT_EQ(table.lines(view).size(), 13U);
}

TEST_F(LiveTableTest, WhatHasChangedIsMarkedForASecond) {
  LiveTable table(LiveTable::By::object);
  temperature(table, 0s, 160);
  temperature(table, 1s, 161);
  EXPECT_NE(table.lines({.now = 1500ms, .has_marks = true})[1].find("\x1b[7m20.125"),
            std::string::npos);
  EXPECT_EQ(table.lines({.now = 2500ms, .has_marks = true})[1].find('\x1b'), std::string::npos);
}

TEST_F(LiveTableTest, BusesAreKeptApart) {
  LiveTable table(LiveTable::By::object);
  temperature(table, 0s, 160, "can0");
  temperature(table, 1s, 168, "can1");
  EXPECT_EQ(table.size(), 2U);
  EXPECT_TRUE(table.lines({.now = 1s})[2].starts_with("can1"));
}

TEST_F(LiveTableTest, RowsAreSearchedAndSorted) {
  LiveTable table(LiveTable::By::object);
  temperature(table, 1s, 160);
  heartbeat(table, 2s);
  EXPECT_EQ(table.count({.search = "TEMPER"}), 1U);
  EXPECT_EQ(table.count({.search = "6010"}), 1U);
  EXPECT_EQ(table.count({.search = "pressure"}), 0U);
  EXPECT_NE(table.lines({.now = 2s, .sort = LiveTable::Sort::age})[1].find("heartbeat"),
            std::string::npos);
  EXPECT_NE(
      table.lines({.now = 2s, .sort = LiveTable::Sort::age, .is_reversed = true})[1].find("6010"),
      std::string::npos);
}

TEST_F(LiveTableTest, ItEndsGrowing) {
  LiveTable table(LiveTable::By::frame);
  for (unsigned id = 0; id < 30'000; ++id) {
    Frame frame;
    frame.id = id;
    frame.flags = FrameFlags::extended;
    table.take(0s, "can0", frame, decoder_.decode(frame));
  }
  EXPECT_TRUE(table.is_full());
  EXPECT_EQ(table.size(), 20'000U);
}

TEST(Screen, TextsGoOnBehindBlanks) {
  using Lines = std::vector<std::string>;
  EXPECT_EQ(in_lines("", 4), Lines{""});
  EXPECT_EQ(in_lines("a bc def", 4), (Lines{"a bc", "def"}));
  EXPECT_EQ(in_lines("a bc  def", 5), (Lines{"a bc ", "def"}));
  EXPECT_EQ(in_lines("abcdefgh ij", 3), (Lines{"abc", "def", "gh", "ij"}));
  EXPECT_EQ(in_lines("\xC2\xB5m/s \xC2\xB0", 4), (Lines{"\xC2\xB5m/s", "\xC2\xB0"}));
  EXPECT_EQ(in_lines("ab", 0), (Lines{"a", "b"})) << "it ends";
}

TEST(Screen, TextsAreCutByColumnsNotByBytes) {
  EXPECT_EQ(in_columns("\xC2\xB5m/s", 2), "\xC2\xB5…");
  EXPECT_EQ(in_columns("\xC2\xB5m/s", 4), "\xC2\xB5m/s");
  EXPECT_EQ(in_columns("ab", 4), "ab  ");
  EXPECT_EQ(columns_of("\x1b[7m20\x1b[27m"), 2U);
  EXPECT_EQ(in_columns("\x1b[7mabc\x1b[27m", 2), "\x1b[7ma…\x1b[27m")
      << "what ends the look is kept";
}

}  // namespace live_table_test
}  // namespace canvoy::tools
