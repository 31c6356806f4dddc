#include "canvoy/text/communication_text.hpp"

#include <gtest/gtest.h>

#include <array>
#include <string_view>

namespace canvoy::text::communication_text_test {
namespace {

std::string text_of(std::uint16_t index, std::uint8_t sub, std::uint32_t raw) {
  const std::array bytes = {static_cast<std::uint8_t>(raw), static_cast<std::uint8_t>(raw >> 8),
                            static_cast<std::uint8_t>(raw >> 16),
                            static_cast<std::uint8_t>(raw >> 24)};
  return communication_text(index, sub, bytes);
}

struct Case {
  std::uint16_t index;
  std::uint8_t sub;
  std::uint32_t raw;
  std::string_view text;
};

// Bit 30 of 1005h and 1012h sends, bit 31 of 1012h receives; bit 31 of all others makes invalid,
// bit 30 of a TPDO forbids RTR; 1016h has the node-ID in bits 16 to 23 and the time in bits 0 to
// 15; a mapped object is its index, sub-index and length (CiA 301, 7.5.2).
constexpr std::array cases = {
    Case{0x1005, 0, 0x0000'0080, "80h, sends no SYNC"},
    Case{0x1005, 0, 0x4000'0080, "80h, sends SYNC"},
    Case{0x1012, 0, 0x8000'0100, "100h, sends no TIME, takes it"},
    Case{0x1012, 0, 0x4000'0100, "100h, sends TIME, does not take it"},
    Case{0x1014, 0, 0x0000'008A, "8Ah, in use"},
    Case{0x1014, 0, 0x8000'008A, "8Ah, not in use"},
    Case{0x1016, 1, 0x000A'05DC, "node 10 (0Ah), within 1500 ms"},
    Case{0x1016, 2, 0x000A'0000, "none"},
    Case{0x1016, 2, 0x0000'05DC, "none"},
    Case{0x1016, 2, 0x0080'05DC, "none"},
    Case{0x1016, 127, 0x007F'0001, "node 127 (7Fh), within 1 ms"},
    Case{0x1028, 3, 0x8000'0000, "0h, not in use"},
    Case{0x1200, 1, 0x0000'060A, "60Ah, in use"},
    Case{0x1280, 2, 0x8000'0000, "0h, not in use"},
    Case{0x1400, 1, 0x0000'020A, "20Ah, in use"},
    Case{0x1400, 1, 0x8000'020A, "20Ah, not in use"},
    Case{0x1400, 1, 0x2123'4567, "01234567h, of 29 bits, in use"},
    Case{0x15FF, 1, 0x0000'0300, "300h, in use"},
    Case{0x1800, 1, 0x4000'018A, "18Ah, in use"},
    Case{0x1800, 1, 0x0000'018A, "18Ah, in use, also on request"},
    Case{0x1600, 1, 0x6001'0008, "6001h:00h, 8 bits"},
    Case{0x1600, 2, 0x0005'0008, "8 bits that nobody wants"},
    Case{0x1A00, 1, 0x6010'0101, "6010h:01h, 1 bit"},
    Case{0x1A00, 64, 0, "nothing"},
};

TEST(CommunicationText, PutsTheBitsOfCommunicationParametersIntoWords) {
  for (const Case& each : cases) {
    EXPECT_EQ(text_of(each.index, each.sub, each.raw), each.text)
        << std::hex << each.index << ":" << unsigned{each.sub} << " " << each.raw;
  }
}

TEST(CommunicationText, LeavesOtherObjectsAlone) {
  EXPECT_EQ(text_of(0x1016, 0, 1), "");
  EXPECT_EQ(text_of(0x1400, 2, 255), "");
  EXPECT_EQ(text_of(0x1018, 1, 1), "");
  EXPECT_EQ(text_of(0x13FF, 1, 1), "");
  EXPECT_EQ(text_of(0x6000, 1, 1), "");
  EXPECT_EQ(communication_text(0x1016, 1, std::array<std::uint8_t, 2>{1, 2}), "");
}

}  // namespace
}  // namespace canvoy::text::communication_text_test
