#include "canvoy/gateway/line_reader.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace canvoy::gateway::line_reader_test {
namespace {

std::vector<std::string> lines_of(LineReader& reader) {
  std::vector<std::string> lines;
  while (const auto line = reader.next()) lines.push_back((line->too_long ? "!" : "") + line->text);
  return lines;
}
using Lines = std::vector<std::string>;

TEST(GatewayLine, EndsWithLineFeedWithOrWithoutCarriageReturn) {
  LineReader reader(100);
  reader.append("one\r\ntwo\nthree\r\n\r\n\nrest");
  EXPECT_EQ(lines_of(reader), (Lines{"one", "two", "three", "", ""}));
  EXPECT_EQ(reader.size(), 4U);
}

TEST(GatewayLine, IsTheSameHoweverItWasCut) {
  const std::string text = "[1] start\r\n[2] stop\r\n\r\n# end\r\n";
  const Lines whole = {"[1] start", "[2] stop", "", "# end"};
  for (std::size_t first = 0; first <= text.size(); ++first) {
    for (std::size_t second = first; second <= text.size(); ++second) {
      LineReader reader(100);
      Lines lines;
      for (const auto& piece :
           {text.substr(0, first), text.substr(first, second - first), text.substr(second)}) {
        reader.append(piece);
        const Lines more = lines_of(reader);
        lines.insert(lines.end(), more.begin(), more.end());
      }
      EXPECT_EQ(lines, whole) << first << ", " << second;
    }
  }
}

TEST(GatewayLine, AsLongAsAllowedIsWholeAndLongerIsNot) {
  LineReader reader(20);
  const std::string twenty(20, 'x');
  reader.append(twenty + "\r\n" + twenty + "\n" + twenty + "y\r\nnext\n");
  EXPECT_EQ(lines_of(reader), (Lines{twenty, twenty, "!" + std::string(16, 'x'), "next"}));
}

TEST(GatewayLine, TooLongIsTheSameByteByByte) {
  LineReader reader(20);
  Lines lines;
  for (const char c : "[7] " + std::string(1000, 'x') + "\r\n" + std::string(20, 'y') + "\r\n") {
    reader.append({&c, 1});
    const Lines more = lines_of(reader);
    lines.insert(lines.end(), more.begin(), more.end());
    EXPECT_LE(reader.size(), 21U);
  }
  EXPECT_EQ(lines, (Lines{"![7] xxxxxxxxxxxx", std::string(20, 'y')}));
}

TEST(GatewayLine, ALineWithoutAnEndTakesNoMemory) {
  LineReader reader(1000);
  for (int i = 0; i < 1000; ++i) {
    reader.append(std::string(1000, 'x'));
    EXPECT_FALSE(reader.next());
    EXPECT_LE(reader.size(), 1000U);
  }
  reader.append("\n[1] start\n");
  EXPECT_EQ(lines_of(reader), (Lines{"!" + std::string(16, 'x'), "[1] start"}));
}

TEST(GatewayLine, TheLengthCanBeChanged) {
  LineReader reader(20);
  reader.set_length_max(30);
  reader.append(std::string(30, 'x') + "\n");
  EXPECT_EQ(lines_of(reader), Lines{std::string(30, 'x')});
}

}  // namespace
}  // namespace canvoy::gateway::line_reader_test
