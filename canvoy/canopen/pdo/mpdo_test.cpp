#include "canvoy/canopen/pdo/mpdo.hpp"

#include <gtest/gtest.h>

namespace canvoy::mpdo_test {
namespace {

// Bytes and bits are derived from the layout of CiA 301, 7.2.3 and 7.5.2.39 to 7.5.2.40, as other
// stacks implement it.

TEST(Mpdo, HasNodeIdThenIndexThenSubIndexThenFourBytesOfData) {
  const Mpdo mpdo{MpdoMode::source, 0x05, 0x6001, 0x02, {0x11, 0x22, 0x33, 0x44}};
  const PdoImage image = {0x05, 0x01, 0x60, 0x02, 0x11, 0x22, 0x33, 0x44};
  EXPECT_EQ(encode(mpdo), image);
  EXPECT_EQ(decode_mpdo(image.data()), mpdo);
}

TEST(Mpdo, IsInDestinationAddressModeByBit7OfItsFirstByte) {
  const Mpdo mpdo{MpdoMode::destination, 0x7F, 0x2ABC, 0xFE, {0xFF, 0, 0, 0x80}};
  const PdoImage image = {0xFF, 0xBC, 0x2A, 0xFE, 0xFF, 0, 0, 0x80};
  EXPECT_EQ(encode(mpdo), image);
  EXPECT_EQ(decode_mpdo(image.data()), mpdo);
}

TEST(Mpdo, OfEveryFirstByteIsTheSameWhenItIsEncodedAgain) {
  for (unsigned first = 0; first <= 0xFF; ++first) {
    const PdoImage image = {static_cast<std::uint8_t>(first), 1, 2, 3, 4, 5, 6, 7};
    const Mpdo mpdo = decode_mpdo(image.data());
    EXPECT_EQ(mpdo.mode == MpdoMode::destination, first >= 0x80) << first;
    EXPECT_EQ(mpdo.node, first % 0x80);
    EXPECT_EQ(encode(mpdo), image);
  }
}

TEST(Mpdo, HasTheModeThatSubIndex0OfTheMappingSays) {
  for (unsigned count = 0; count <= 0x1FF; ++count) {
    const MpdoMode mode = count == 0xFE   ? MpdoMode::source
                          : count == 0xFF ? MpdoMode::destination
                                          : MpdoMode::none;
    EXPECT_EQ(mpdo_mode(count), mode) << count;
  }
}

TEST(ScannerEntry, HasItsBlockSizeInTheUppermostByte) {
  const ScannerEntry entry = decode_scanner_entry(0x03'6411'02);
  EXPECT_EQ(entry.block_size, 3U);
  EXPECT_EQ(entry.index, 0x6411);
  EXPECT_EQ(entry.sub, 2);
}

TEST(ScannerEntry, WithoutABlockSizeIsOneObject) {
  EXPECT_EQ(decode_scanner_entry(0x00'6411'02).block_size, 1U);
  EXPECT_EQ(decode_scanner_entry(0x01'6411'02).block_size, 1U);
  EXPECT_EQ(decode_scanner_entry(0xFF'6411'02).block_size, 255U);
}

TEST(DispatcherEntry, HasBlockSizeOwnObjectAndObjectOfTheProducer) {
  const DispatcherEntry entry = decode_dispatcher_entry(0x04'6200'01'6000'03'0A);
  EXPECT_EQ(entry.block_size, 4U);
  EXPECT_EQ(entry.index, 0x6200);
  EXPECT_EQ(entry.sub, 1);
  EXPECT_EQ(entry.producer_index, 0x6000);
  EXPECT_EQ(entry.producer_sub, 3);
  EXPECT_EQ(entry.producer, 10);
}

TEST(DispatcherEntry, CoversTheSubIndicesOfItsBlock) {
  const DispatcherEntry block = decode_dispatcher_entry(0x04'6200'01'6000'03'0A);
  const DispatcherEntry single = decode_dispatcher_entry(0x00'6200'01'6000'03'0A);
  for (unsigned sub = 0; sub <= 0xFF; ++sub) {
    const Mpdo mpdo{MpdoMode::source, 10, 0x6000, static_cast<std::uint8_t>(sub), {}};
    EXPECT_EQ(block.covers(mpdo), sub >= 3 && sub <= 6) << sub;
    EXPECT_EQ(single.covers(mpdo), sub == 3) << sub;
  }
  EXPECT_FALSE(block.covers({MpdoMode::source, 11, 0x6000, 3, {}})) << "another node";
  EXPECT_FALSE(block.covers({MpdoMode::source, 10, 0x6001, 3, {}})) << "another object";
}

}  // namespace
}  // namespace canvoy::mpdo_test
