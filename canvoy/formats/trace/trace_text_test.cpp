// Numbers of lines.
#include "canvoy/formats/trace/trace_text.hpp"

#include <gtest/gtest.h>

namespace canvoy::formats::trace_text_test {
namespace {

std::int64_t fixed(std::string_view word, std::size_t digits = 6) {
  std::int64_t value = -1;
  return read_fixed(word, digits, value) ? value : -1;
}

TEST(TraceText, ReadsFixedPointNumbersInTheUnitThatIsAskedFor) {
  EXPECT_EQ(fixed("1700000000.000125"), 1'700'000'000'000'125);
  EXPECT_EQ(fixed("0"), 0);
  EXPECT_EQ(fixed("7"), 7'000'000);
  EXPECT_EQ(fixed("0.5"), 500'000);
  EXPECT_EQ(fixed("0.000001"), 1);
  EXPECT_EQ(fixed("0.0000019"), 1) << "cut off, not rounded";
  EXPECT_EQ(fixed("0.0000019999999999999999999"), 1);
  EXPECT_EQ(fixed("1059.9", 3), 1'059'900);
  EXPECT_EQ(fixed("17", 3), 17'000);
  EXPECT_EQ(fixed("999999999999.999999"), 999'999'999'999'999'999) << "the largest";
}

TEST(TraceText, RefusesWhatIsNoFixedPointNumber) {
  for (const std::string_view wrong :
       {"", ".", ".5", "5.", "-1", "+1", "1.2.3", "1.x", "1x", "x", "1.0000000x", "1,5", " 1", "1 ",
        "1000000000000", "1000000000000.0", "99999999999999999999"}) {
    EXPECT_EQ(fixed(wrong), -1) << wrong;
  }
}

TEST(TraceText, ReadsWordsAndHexadecimalNumbers) {
  std::string_view text = " \tone  two\t";
  EXPECT_EQ(take_word(text), "one");
  EXPECT_EQ(take_word(text), "two");
  EXPECT_EQ(take_word(text), "");
  std::uint32_t value = 0;
  EXPECT_TRUE(read_hex("fFfFfFfF", value));
  EXPECT_EQ(value, 0xFFFF'FFFFU);
  for (const std::string_view wrong : {"", "G", "123456789", "0x1", "-1"})
    EXPECT_FALSE(read_hex(wrong, value)) << wrong;
}

}  // namespace
}  // namespace canvoy::formats::trace_text_test
