#include "canvoy/canopen/sdo/crc16.hpp"

#include <gtest/gtest.h>

#include <array>
#include <string_view>
#include <vector>

#include "canvoy/canopen/protocol/little_endian.hpp"

namespace canvoy::crc16_test {
namespace {

/// Bit by bit, as defined.
std::uint16_t crc16_by_definition(std::span<const std::uint8_t> bytes) {
  std::uint16_t crc = 0;
  for (const std::uint8_t byte : bytes) {
    for (unsigned bit = 0; bit < 8; ++bit) {
      const bool feedback = ((crc >> 15 ^ byte >> (7 - bit)) & 1) != 0;
      crc = static_cast<std::uint16_t>(crc << 1 ^ (feedback ? 0x1021 : 0));
    }
  }
  return crc;
}

std::vector<std::uint8_t> bytes_of(std::string_view text) {
  return {text.begin(), text.end()};
}

TEST(Crc16, TheCheckStringHasTheChecksumThatCiA301Gives) {
  EXPECT_EQ(crc16(bytes_of("123456789")), 0x31C3);
  static_assert(crc16(std::array<std::uint8_t, 9>{'1', '2', '3', '4', '5', '6', '7', '8', '9'}) ==
                0x31C3);
}

TEST(Crc16, NothingHasTheChecksumZero) {
  EXPECT_EQ(crc16({}), 0);
  EXPECT_EQ(crc16({}, 0x1234), 0x1234);
}

TEST(Crc16, EveryByteAfterEveryByteAgreesWithTheDefinition) {
  for (unsigned first = 0; first < 256; ++first) {
    for (unsigned second = 0; second < 256; ++second) {
      const std::array bytes{static_cast<std::uint8_t>(first), static_cast<std::uint8_t>(second)};
      ASSERT_EQ(crc16(bytes), crc16_by_definition(bytes));
    }
  }
}

TEST(Crc16, EveryLengthAgreesWithTheDefinitionInOnePieceAndInTwo) {
  std::vector<std::uint8_t> bytes(150);
  std::uint32_t state = 1;
  for (auto& byte : bytes) byte = static_cast<std::uint8_t>((state = state * 1'664'525 + 1) >> 24);
  for (std::size_t size = 0; size <= bytes.size(); ++size) {
    const auto whole = std::span(bytes).first(size);
    const std::uint16_t expected = crc16_by_definition(whole);
    ASSERT_EQ(crc16(whole), expected) << size;
    for (std::size_t cut = 0; cut <= size; ++cut) {
      ASSERT_EQ(crc16(whole.subspan(cut), crc16(whole.first(cut))), expected) << size << ' ' << cut;
    }
  }
}

TEST(Crc16, AWholeSegmentAgreesWithTheDefinitionForEveryChecksumBeforeIt) {
  for (unsigned before = 0; before < 0x10000; ++before) {
    // The checksum of two bytes takes each value once.
    std::array<std::uint8_t, 9> bytes{0, 0, 0x12, 0x34, 0x56, 0x78, 0x9A, 0xBC, 0xDE};
    bytes[0] = static_cast<std::uint8_t>(before >> 8);
    bytes[1] = static_cast<std::uint8_t>(before);
    const std::uint16_t start = crc16_by_definition(std::span(bytes).first(2));
    ASSERT_EQ(crc16_of_segment(load<std::uint64_t>(bytes.data() + 1), 7, start),
              crc16_by_definition(bytes));
  }
}

TEST(Crc16, EachOfItsBitsCounts) {
  std::array<std::uint8_t, 8> frame{};
  for (unsigned bit = 8; bit < 64; ++bit) {
    frame.fill(0);
    frame[0] = 0xFF;  // the number does not count
    frame[bit / 8] = static_cast<std::uint8_t>(0x80U >> bit % 8);
    EXPECT_EQ(crc16_of_segment(load<std::uint64_t>(frame.data()), 7, 0),
              crc16_by_definition(std::span(frame).subspan(1)))
        << bit;
    EXPECT_NE(crc16_of_segment(load<std::uint64_t>(frame.data()), 7, 0), 0) << bit;
  }
}

}  // namespace
}  // namespace canvoy::crc16_test
