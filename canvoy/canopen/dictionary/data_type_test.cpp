#include "canvoy/canopen/dictionary/data_type.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <vector>

namespace canvoy::data_type_test {
namespace {

struct Width {
  unsigned code;
  unsigned bits;
};

// CiA 301, 7.4.7.1 (codes) and 7.1.4 (lengths).
constexpr Width cia_301[] = {
    {0x01, 1},  {0x02, 8},  {0x03, 16}, {0x04, 32}, {0x05, 8},  {0x06, 16}, {0x07, 32},
    {0x08, 32}, {0x09, 0},  {0x0A, 0},  {0x0B, 0},  {0x0C, 48}, {0x0D, 48}, {0x0F, 0},
    {0x10, 24}, {0x11, 64}, {0x12, 40}, {0x13, 48}, {0x14, 56}, {0x15, 64}, {0x16, 24},
    {0x18, 40}, {0x19, 48}, {0x1A, 56}, {0x1B, 64},
};

DataType type(unsigned code) {
  return static_cast<DataType>(code);
}

TEST(DataType, HasTheLengthThatCia301GivesIt) {
  for (const Width& width : cia_301) {
    EXPECT_EQ(bit_length(type(width.code)), width.bits) << std::hex << width.code;
  }
}

TEST(DataType, HasEveryOddLengthFrom60hTo7Ah) {
  std::set<unsigned> lengths;
  for (unsigned code = 0x60; code <= 0x7A; ++code) lengths.insert(bit_length(type(code)));
  std::set<unsigned> expected;
  for (unsigned bits = 2; bits <= 31; ++bits) {
    if (bits % 8 != 0) expected.insert(bits);
  }
  EXPECT_EQ(lengths, expected);
  EXPECT_EQ(bit_length(DataType::unsigned2), 2U);
  EXPECT_EQ(bit_length(DataType::unsigned31), 31U);
}

TEST(DataType, HasNoLengthWhereItDoesNotExist) {
  std::set<unsigned> known;
  for (const Width& width : cia_301) known.insert(width.code);
  for (unsigned code = 0; code < 256; ++code) {
    if (known.contains(code) || (code >= 0x60 && code <= 0x7A)) continue;
    EXPECT_EQ(bit_length(type(code)), 0U) << std::hex << code;
    EXPECT_EQ(is_string(type(code)), code == 0x7B) << std::hex << code;
    EXPECT_FALSE(is_signed(type(code)) || is_integer(type(code)) || is_real(type(code)))
        << std::hex << code;
  }
}

TEST(DataType, TravelsInWholeBytes) {
  const std::map<unsigned, unsigned> bytes_of_bits = {{0, 0},  {1, 1},  {8, 1},  {16, 2}, {24, 3},
                                                      {32, 4}, {40, 5}, {48, 6}, {56, 7}, {64, 8}};
  for (const Width& width : cia_301) {
    EXPECT_EQ(byte_length(type(width.code)), bytes_of_bits.at(width.bits));
  }
  for (unsigned code = 0x60; code <= 0x7A; ++code) {
    const unsigned bits = bit_length(type(code));
    EXPECT_EQ(byte_length(type(code)), bits < 8 ? 1U : bits < 16 ? 2U : bits < 24 ? 3U : 4U);
  }
}

TEST(DataType, IsSignedForTheEightIntegersOnly) {
  const std::set<unsigned> signed_types = {0x02, 0x03, 0x04, 0x10, 0x12, 0x13, 0x14, 0x15};
  for (unsigned code = 0; code < 256; ++code) {
    EXPECT_EQ(is_signed(type(code)), signed_types.contains(code)) << std::hex << code;
  }
}

TEST(DataType, IsAStringARealOrAnIntegerOrNoneOfThem) {
  const std::set<unsigned> strings = {0x09, 0x0A, 0x0B, 0x7B};
  const std::set<unsigned> reals = {0x08, 0x11};
  const std::set<unsigned> others = {0x0C, 0x0D, 0x0F};
  for (const Width& width : cia_301) {
    EXPECT_EQ(is_string(type(width.code)), strings.contains(width.code));
    EXPECT_EQ(is_real(type(width.code)), reals.contains(width.code));
    const bool other =
        strings.contains(width.code) || reals.contains(width.code) || others.contains(width.code);
    EXPECT_EQ(is_integer(type(width.code)), !other) << std::hex << width.code;
  }
}

}  // namespace
}  // namespace canvoy::data_type_test
