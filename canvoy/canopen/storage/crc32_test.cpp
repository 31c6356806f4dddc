#include "canvoy/canopen/storage/crc32.hpp"

#include <gtest/gtest.h>

#include <string_view>
#include <vector>

namespace canvoy::crc32_test {
namespace {

std::vector<std::uint8_t> bytes_of(std::string_view text) {
  return {text.begin(), text.end()};
}

// The common check values of CRC-32/ISO-HDLC.
TEST(Crc32, HasTheCheckValuesOfIsoHdlc) {
  EXPECT_EQ(crc32(bytes_of("123456789")), 0xCBF4'3926);
  EXPECT_EQ(crc32({}), 0x0000'0000);
  EXPECT_EQ(crc32(bytes_of("The quick brown fox jumps over the lazy dog")), 0x414F'A339);
}

TEST(Crc32, DoesNotCareHowTheBytesAreCut) {
  const auto text = bytes_of("123456789");
  for (std::size_t cut = 0; cut <= text.size(); ++cut) {
    Crc32 sut;
    sut.add(std::span(text).first(cut));
    sut.add(std::span(text).subspan(cut));
    EXPECT_EQ(sut.value(), 0xCBF4'3926) << "cut at " << cut;
  }
}

}  // namespace
}  // namespace canvoy::crc32_test
