// SDO server, download in segments (CiA 301, 7.2.4.3.3 and 7.2.4.3.4).
#include <gtest/gtest.h>

#include "canvoy/canopen/testing/sdo_server_node.hpp"

namespace canvoy::sdo_server_segmented_download_test {
namespace {

class SdoServerSegmentedDownload : public SdoServerNode {};

TEST_F(SdoServerSegmentedDownload, ADownloadInSegmentsIsWrittenWholeAtItsEnd) {
  ask("21 08 20 00 08 00 00 00", "60 08 20 00 00 00 00 00");
  EXPECT_TRUE(sut.busy());
  ask("00 01 02 03 04 05 06 07", "20 00 00 00 00 00 00 00");
  EXPECT_EQ(value(0x2008), Bytes(8));
  ask("1D 08 00 00 00 00 00 00", "30 00 00 00 00 00 00 00");
  EXPECT_EQ(value(0x2008), (Bytes{1, 2, 3, 4, 5, 6, 7, 8}));
  EXPECT_FALSE(sut.busy());
}

TEST_F(SdoServerSegmentedDownload, ADownloadInSegmentsNeedNotTellItsSize) {
  ask("20 08 20 00 EE EE EE EE", "60 08 20 00 00 00 00 00");
  ask("00 01 02 03 04 05 06 07", "20 00 00 00 00 00 00 00");
  ask("1D 08 00 00 00 00 00 00", "30 00 00 00 00 00 00 00");
  EXPECT_EQ(value(0x2008), (Bytes{1, 2, 3, 4, 5, 6, 7, 8}));
}

TEST_F(SdoServerSegmentedDownload, SegmentsMayBeShorterThanTheyCouldBe) {
  ask("21 05 20 00 05 00 00 00", "60 05 20 00 00 00 00 00");
  ask("0A 01 02 EE EE EE EE EE", "20 00 00 00 00 00 00 00");
  ask("1E EE EE EE EE EE EE EE", "30 00 00 00 00 00 00 00");
  ask("09 03 04 05 EE EE EE EE", "20 00 00 00 00 00 00 00");
  EXPECT_EQ(value(0x2005), (Bytes{1, 2, 3, 4, 5}));
}

TEST_F(SdoServerSegmentedDownload, AShortValueMayComeInSegmentsToo) {
  ask("21 02 20 00 02 00 00 00", "60 02 20 00 00 00 00 00");
  ask("0B 34 12 00 00 00 00 00", "20 00 00 00 00 00 00 00");
  EXPECT_EQ(value(0x2002), (Bytes{0x34, 0x12}));
}

TEST_F(SdoServerSegmentedDownload, AStringIsEmptiedByADownloadOfNoBytes) {
  set_value(wire.node, 0x2020, Bytes{'a', 'b'});
  ask("21 20 20 00 00 00 00 00", "60 20 20 00 00 00 00 00");
  ask("0F 00 00 00 00 00 00 00", "20 00 00 00 00 00 00 00");
  EXPECT_EQ(value(0x2020), Bytes{});
}

TEST_F(SdoServerSegmentedDownload, ASizeThatDoesNotFitTheEntryIsAbortedAtOnce) {
  ask("21 08 20 00 09 00 00 00", "80 08 20 00 12 00 07 06");
  ask("21 08 20 00 07 00 00 00", "80 08 20 00 13 00 07 06");
  ask("21 20 20 00 04 00 00 00", "80 20 20 00 12 00 07 06");
  ask("21 21 20 00 89 13 00 00", "80 21 20 00 12 00 07 06");
  ask("21 21 20 00 FF FF FF FF", "80 21 20 00 12 00 07 06");
  EXPECT_FALSE(sut.busy());
}

TEST_F(SdoServerSegmentedDownload, MoreBytesThanToldAreAborted) {
  ask("21 21 20 00 08 00 00 00", "60 21 20 00 00 00 00 00");
  ask("00 01 02 03 04 05 06 07", "20 00 00 00 00 00 00 00");
  ask("1B 08 09 00 00 00 00 00", "80 21 20 00 12 00 07 06");
  EXPECT_FALSE(sut.busy());
  EXPECT_EQ(value(0x2021), Bytes{});
}

TEST_F(SdoServerSegmentedDownload, FewerBytesThanToldAreAborted) {
  ask("21 21 20 00 09 00 00 00", "60 21 20 00 00 00 00 00");
  ask("00 01 02 03 04 05 06 07", "20 00 00 00 00 00 00 00");
  ask("1D 08 00 00 00 00 00 00", "80 21 20 00 13 00 07 06");
  EXPECT_EQ(value(0x2021), Bytes{});
}

TEST_F(SdoServerSegmentedDownload, WithoutSizeTheLengthIsCheckedByTheEntry) {
  ask("20 05 20 00 00 00 00 00", "60 05 20 00 00 00 00 00");
  ask("01 01 02 03 04 05 06 07", "80 05 20 00 12 00 07 06");
  ask("20 05 20 00 00 00 00 00", "60 05 20 00 00 00 00 00");
  ask("07 01 02 03 04 00 00 00", "80 05 20 00 13 00 07 06");
  ask("20 20 20 00 00 00 00 00", "60 20 20 00 00 00 00 00");
  ask("07 61 62 63 64 00 00 00", "80 20 20 00 12 00 07 06");
  EXPECT_EQ(value(0x2005), Bytes(5));
}

TEST_F(SdoServerSegmentedDownload, TooManyBytesAreAbortedBeforeTheLastSegment) {
  ask("20 20 20 00 00 00 00 00", "60 20 20 00 00 00 00 00");
  ask("00 61 62 63 64 65 66 67", "80 20 20 00 12 00 07 06");
  EXPECT_FALSE(sut.busy());
}

TEST_F(SdoServerSegmentedDownload, ADownloadSegmentWithTheWrongToggleBitEndsTheTransfer) {
  ask("21 08 20 00 08 00 00 00", "60 08 20 00 00 00 00 00");
  ask("00 01 02 03 04 05 06 07", "20 00 00 00 00 00 00 00");
  ask("00 01 02 03 04 05 06 07", "80 08 20 00 00 00 03 05");
  ask("1D 08 00 00 00 00 00 00", "80 00 00 00 01 00 04 05");
  EXPECT_EQ(value(0x2008), Bytes(8));
}

TEST_F(SdoServerSegmentedDownload, ADownloadOfMoreThan255BytesArrivesWhole) {
  for (const std::size_t size : {255U, 256U, 257U, 1000U, 5000U}) {
    const Bytes bytes = pattern(size);
    ask("20 21 20 00 00 00 00 00", "60 21 20 00 00 00 00 00");
    unsigned toggle = 0;
    for (std::size_t offset = 0; offset < size; offset += 7) {
      Frame frame = wire_frame("605#00 00 00 00 00 00 00 00");
      const std::size_t count = std::min<std::size_t>(7, size - offset);
      std::copy_n(bytes.begin() + static_cast<long>(offset), count, frame.data.begin() + 1);
      frame.data[0] =
          static_cast<std::uint8_t>(toggle | (7 - count) << 1 | (offset + 7 >= size ? 1U : 0U));
      toggle ^= 0x10U;
      wire.receive(wire_text(frame));
    }
    wire.sent.clear();
    EXPECT_EQ(value(0x2021), bytes) << size;
  }
}

TEST_F(SdoServerSegmentedDownload, ADomainIsDownloadedPieceByPiece) {
  ask("21 32 20 00 08 00 00 00", "60 32 20 00 00 00 00 00");
  EXPECT_EQ(writable.announced, 8U);
  ask("00 01 02 03 04 05 06 07", "20 00 00 00 00 00 00 00");
  EXPECT_EQ(writable.arriving, (Bytes{1, 2, 3, 4, 5, 6, 7}));
  ask("1D 08 00 00 00 00 00 00", "30 00 00 00 00 00 00 00");
  EXPECT_EQ(writable.content, (Bytes{1, 2, 3, 4, 5, 6, 7, 8}));
  EXPECT_FALSE(writable.open);
}

TEST_F(SdoServerSegmentedDownload, ADomainIsDownloadedWithoutSizeAndWithoutBytes) {
  domain.content = {1, 2, 3};
  ask("20 30 20 00 00 00 00 00", "60 30 20 00 00 00 00 00");
  EXPECT_EQ(domain.announced, 0U);
  ask("0F 00 00 00 00 00 00 00", "20 00 00 00 00 00 00 00");
  EXPECT_EQ(domain.content, Bytes{});
  EXPECT_EQ(domain.dropped, 0);
}

}  // namespace
}  // namespace canvoy::sdo_server_segmented_download_test
