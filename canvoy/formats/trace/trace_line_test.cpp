// Numbers in the form of printf.
#include "canvoy/formats/trace/trace_line.hpp"

#include <gtest/gtest.h>

#include <cstdio>
#include <string>

namespace canvoy::formats::trace_line_test {
namespace {

template <class... Values>
std::string printed(const char* format, Values... values) {
  std::array<char, 64> room{};
  std::snprintf(room.data(), room.size(), format, values...);
  return room.data();
}

TEST(TraceLine, PutsDecimalNumbersAsPrintfDoes) {
  for (std::uint64_t value = 1; value != 0 && value < 0x7FFF'FFFF'FFFF'FFFF;
       value = value * 3 + 7) {
    TraceLine line;
    line.put_decimal(value);
    line.put(' ');
    line.put_decimal(value, 12);
    line.put(' ');
    line.put_decimal(value, 12, '0');
    const auto number = static_cast<unsigned long long>(value);
    EXPECT_EQ(line.view(), printed("%llu %12llu %012llu", number, number, number));
    if (value > 0x1FFF'FFFF'FFFF'FFFF) break;
  }
  TraceLine zero;
  zero.put_decimal(0, 3);
  EXPECT_EQ(zero.view(), "  0");
}

TEST(TraceLine, PutsFixedPointNumbers) {
  TraceLine line;
  line.put_fixed<6>(1'700'000'000'000'125, 4);
  line.put(' ');
  line.put_fixed<6>(9, 4);
  line.put(' ');
  line.put_fixed<3>(12'045, 1);
  EXPECT_EQ(line.view(), "1700000000.000125    0.000009 12.045");
}

TEST(TraceLine, PutsTimesInAnyOrder) {
  TraceSeconds plain({});
  TraceSeconds padded({.before = '(', .width = 4, .fill = '0'});
  for (const std::uint64_t time :
       {std::uint64_t{0}, std::uint64_t{999'999}, std::uint64_t{1'000'000},
        std::uint64_t{1'000'001}, std::uint64_t{5}, std::uint64_t{1'700'000'000'000'125},
        std::uint64_t{1'700'000'000'999'999}, std::uint64_t{1'699'999'999'999'999},
        std::uint64_t{18'446'744'073'709'551'615U}}) {
    TraceLine line;
    plain.put(line, time);
    line.put(' ');
    padded.put(line, time);
    const auto second = static_cast<unsigned long long>(time / 1'000'000);
    const auto rest = static_cast<unsigned long long>(time % 1'000'000);
    EXPECT_EQ(line.view(), printed("%llu.%06llu (%04llu.%06llu", second, rest, second, rest));
  }
}

TEST(TraceLine, PutsHexadecimalNumbersOfAtLeastSoManyDigits) {
  for (const std::uint32_t value : {0x0U, 0x1U, 0x7FFU, 0x1FFF'FFFFU, 0xFFFF'FFFFU}) {
    TraceLine line;
    line.put_hex(value, 1);
    line.put(' ');
    line.put_hex(value, 3);
    line.put(' ');
    line.put_hex(value, 8);
    EXPECT_EQ(line.view(), printed("%X %03X %08X", value, value, value));
  }
}

TEST(TraceLine, PutsBytesAndBlanks) {
  TraceLine line;
  line.put("ab");
  line.pad_to(4);
  line.put_bytes(Frame::data_frame(1, {0x1E, 0xF0}));
  line.pad_to(2);
  EXPECT_EQ(line.view(), "ab   1E F0");
}

}  // namespace
}  // namespace canvoy::formats::trace_line_test
