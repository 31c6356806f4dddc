#include "canvoy/can/frame_bits.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "canvoy/can/random.hpp"

namespace canvoy::frame_bits_test {
namespace {

using Bits = std::vector<bool>;

void append(Bits& bits, std::uint64_t value, int width) {
  for (int i = width - 1; i >= 0; --i) bits.push_back((value >> i & 1) != 0);
}

/// The frame from the start of frame to the last bit of data, field by field in the order of the
/// standard.
Bits fields_of(const Frame& frame) {
  Bits bits;
  append(bits, 0, 1);  // start of frame
  if (frame.is_extended()) {
    append(bits, frame.id >> 18, 11);
    append(bits, 0b11, 2);  // SRR, IDE
    append(bits, frame.id & 0x3FFFF, 18);
    append(bits, frame.is_remote() ? 1 : 0, 1);
    append(bits, 0, 2);  // r1, r0
  } else {
    append(bits, frame.id, 11);
    append(bits, frame.is_remote() ? 1 : 0, 1);
    append(bits, 0, 2);  // IDE, r0
  }
  append(bits, frame.length, 4);
  for (const std::uint8_t byte : frame.payload()) append(bits, byte, 8);
  return bits;
}

/// The remainder of a division by x^15 + x^14 + x^10 + x^8 + x^7 + x^4 + x^3 + 1, one bit after the
/// other.
std::uint16_t slow_crc(const Bits& bits) {
  unsigned remainder = 0;
  for (const bool bit : bits) {
    const bool carries = ((remainder & 0x4000) != 0) != bit;
    remainder = remainder << 1 & 0x7FFF;
    if (carries) remainder ^= 0b100'0101'1001'1001;
  }
  return static_cast<std::uint16_t>(remainder);
}

Bits stuffed(const Bits& bits) {
  Bits out;
  for (const bool bit : bits) {
    out.push_back(bit);
    const std::size_t n = out.size();
    if (n < 5 || std::count(out.end() - 5, out.end(), bit) != 5) continue;
    out.push_back(!bit);
  }
  return out;
}

Bits slow_wire(const Frame& frame) {
  Bits bits = fields_of(frame);
  append(bits, slow_crc(bits), 15);
  return stuffed(bits);
}

Frame random_frame(Random& random) {
  Frame frame;
  frame.flags = random.below(2) == 0 ? FrameFlags::none : FrameFlags::extended;
  frame.id = static_cast<std::uint32_t>(random.next()) &
             (frame.is_extended() ? Frame::extended_id_max : Frame::id_max);
  frame.length = static_cast<std::uint8_t>(random.below(9));
  if (random.below(8) == 0) {
    frame.flags = frame.flags | FrameFlags::remote;
    return frame;
  }
  const std::uint64_t runs = random.next() & random.next() & random.next();
  const bool is_inverted = random.below(2) == 1;
  for (std::size_t i = 0; i < frame.length; ++i) {
    frame.data[i] = static_cast<std::uint8_t>((is_inverted ? ~runs : runs) >> (8 * i));
  }
  return frame;
}

TEST(FrameBits, OfTheFrameOfZerosIsThirtyFourZerosWithAStuffBitAfterEachFiveAndTenBitsMore) {
  // 1 + 11 + 1 + 1 + 1 + 4 dominant bits leave a checksum of 15 more: 34, of which 6 fives; then
  // CRC delimiter, acknowledgement and its delimiter, seven bits of end of frame.
  EXPECT_EQ(frame_crc(Frame::data_frame(0, {})), 0);
  EXPECT_EQ(frame_bits(Frame::data_frame(0, {})), 34 + 6 + 10U);
}

TEST(FrameBits, OfFramesThatAreMetDailyAreAsCanUtilsCountsThem) {
  // The lengths that `canbusload -e` reports, less the three bits of intermission that it includes.
  EXPECT_EQ(frame_bits(Frame::data_frame(0x080, {})), 51U - 3);
  EXPECT_EQ(frame_bits(Frame::data_frame(0x000, {1, 0})), 68U - 3);
  EXPECT_EQ(frame_bits(Frame::data_frame(0x705, {5})), 59U - 3);
  EXPECT_EQ(frame_bits(Frame::data_frame(0x181, {1, 2, 3, 4, 5, 6, 7, 8})), 120U - 3);
  EXPECT_EQ(frame_bits(Frame::data_frame(0x605, {0x40, 0x18, 0x10, 1, 0, 0, 0, 0})), 122U - 3);
  EXPECT_EQ(frame_bits(Frame::data_frame(0x7FF, {255, 255, 255, 255, 255, 255, 255, 255})),
            126U - 3);
  EXPECT_EQ(frame_bits(Frame::data_frame(0x18FEF100, {255, 255, 255, 255, 255, 255, 255, 255})),
            146U - 3);
  Frame extended_zero;
  extended_zero.flags = FrameFlags::extended;
  EXPECT_EQ(frame_bits(extended_zero), 74U - 3);
}

TEST(FrameBits, EqualABitByBitModelForRandomFramesOfEveryKind) {
  Random random(1);
  for (int i = 0; i < 5000; ++i) {
    const Frame frame = random_frame(random);
    const unsigned expected = static_cast<unsigned>(slow_wire(frame).size()) + 10;
    ASSERT_EQ(frame_bits(frame), expected) << std::hex << frame.id << " " << int{frame.length};
    ASSERT_EQ(frame_crc(frame), slow_crc(fields_of(frame)));
    ASSERT_LE(expected, frame_bits_max);
  }
}

TEST(FrameBits, OfARemoteFrameCountNoDataWhateverLengthItAsksFor) {
  // 44 bits, and at most a stuff bit for each four of the 34 from the start of frame to the
  // checksum.
  for (std::uint8_t length = 0; length <= 8; ++length) {
    EXPECT_GE(frame_bits(Frame::remote_frame(0x2AA, length)), 44U);
    EXPECT_LE(frame_bits(Frame::remote_frame(0x2AA, length)), 44U + 34 / 4);
  }
}

TEST(FrameBits, OfAnErrorFrameAreNone) {
  Frame error;
  error.flags = FrameFlags::error;
  EXPECT_EQ(frame_bits(error), 0U);
}

TEST(FirstDifferentBit, IsCountedFromTheStartOfFrameWithStuffBits) {
  // Identifier 555h: 0 10101010101, then RTR, IDE, r0 and the first two bits of the length 0 0 0 0
  // 0, a stuff bit, and the rest of the length 0 1: twenty bits. So the first data bit is the 21st.
  const Frame base = Frame::data_frame(0x555, {0x80});
  EXPECT_EQ(first_different_bit(base, Frame::data_frame(0x555, {0x00})), 21U);
  EXPECT_EQ(first_different_bit(base, base), 0U);
}

TEST(FirstDifferentBit, OfRandomPairsEqualsThatOfTheBitByBitModel) {
  Random random(2);
  for (int i = 0; i < 2000; ++i) {
    const Frame a = random_frame(random);
    Frame b = random_frame(random);
    b.id = a.id;
    b.flags = a.flags;
    if (a.is_remote()) b.data = {};
    const Bits wire_a = slow_wire(a);
    const Bits wire_b = slow_wire(b);
    const auto [place, other] =
        std::mismatch(wire_a.begin(), wire_a.end(), wire_b.begin(), wire_b.end());
    const auto expected = a == b ? 0 : place - wire_a.begin() + 1;
    ASSERT_EQ(first_different_bit(a, b), static_cast<unsigned>(expected));
  }
}

}  // namespace
}  // namespace canvoy::frame_bits_test
