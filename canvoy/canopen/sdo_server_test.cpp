#include "canvoy/canopen/sdo_server.hpp"

#include <gtest/gtest.h>

#include "canvoy/canopen/testing/sdo_objects.hpp"
#include "canvoy/canopen/testing/wire.hpp"

namespace canvoy {
namespace {

class SdoServerTest : public testing::Test {
 protected:
  SdoServerTest() { wire.boot(); }

  /// Request and answer are the eight bytes.
  void ask(const std::string& request, const std::string& answer) {
    SCOPED_TRACE(request);
    wire.receive("605#" + request);
    wire.expect({"585#" + answer});
  }
  void ask_in_vain(const std::string& request) {
    SCOPED_TRACE(request);
    wire.receive("605#" + request);
    wire.expect({});
  }
  void expect_alive() { ask("40 00 10 00 00 00 00 00", "43 00 10 00 A2 01 02 00"); }
  std::vector<std::uint8_t> value(std::uint16_t index, std::uint8_t sub = 0) {
    return value_of(wire.node, index, sub);
  }

  WireNode wire{sdo_objects(), 5};
  std::array<std::uint8_t, 5000> buffer{};
  SdoServer sut{wire.node, 0, buffer};
  MemoryDomain domain{wire.node, 0x2030};
  MemoryDomain readable{wire.node, 0x2031};
  MemoryDomain writable{wire.node, 0x2032};
};

using Bytes = std::vector<std::uint8_t>;

// Upload, expedited

TEST_F(SdoServerTest, AnUploadOfOneToFourBytesIsAnsweredInOneFrameThatTellsHowManyAreUnused) {
  set_value(wire.node, 0x2001, Bytes{0x11});
  set_value(wire.node, 0x2002, Bytes{0x11, 0x22});
  set_value(wire.node, 0x2003, Bytes{0x11, 0x22, 0x33});
  set_value(wire.node, 0x2004, Bytes{0x11, 0x22, 0x33, 0x44});
  ask("40 01 20 00 00 00 00 00", "4F 01 20 00 11 00 00 00");
  ask("40 02 20 00 00 00 00 00", "4B 02 20 00 11 22 00 00");
  ask("40 03 20 00 00 00 00 00", "47 03 20 00 11 22 33 00");
  ask("40 04 20 00 00 00 00 00", "43 04 20 00 11 22 33 44");
  EXPECT_FALSE(sut.busy());
}

TEST_F(SdoServerTest, AStringOfUpToFourBytesIsUploadedExpeditedToo) {
  set_value(wire.node, 0x2020, Bytes{'a', 'b'});
  ask("40 20 20 00 00 00 00 00", "4B 20 20 00 61 62 00 00");
}

TEST_F(SdoServerTest, EachSubIndexOfAnArrayHasItsOwnValue) {
  ask("2B 09 20 01 01 00 00 00", "60 09 20 01 00 00 00 00");
  ask("2B 09 20 03 FD FF 00 00", "60 09 20 03 00 00 00 00");
  ask("40 09 20 00 00 00 00 00", "4F 09 20 00 03 00 00 00");
  ask("40 09 20 01 00 00 00 00", "4B 09 20 01 01 00 00 00");
  ask("40 09 20 02 00 00 00 00", "4B 09 20 02 00 00 00 00");
  ask("40 09 20 03 00 00 00 00", "4B 09 20 03 FD FF 00 00");
}

TEST_F(SdoServerTest, ReservedBitsOfARequestDoNotMatter) {
  ask("5F 00 10 00 FF FF FF FF", "43 00 10 00 A2 01 02 00");
  ask("3B 02 20 00 34 12 FF FF", "60 02 20 00 00 00 00 00");  // bit 4
  EXPECT_EQ(value(0x2002), (Bytes{0x34, 0x12}));
}

TEST_F(SdoServerTest, AnUploadOfWhatIsNotThereIsAborted) {
  ask("40 99 20 00 00 00 00 00", "80 99 20 00 00 00 02 06");
  ask("40 00 00 00 00 00 00 00", "80 00 00 00 00 00 02 06");
  ask("40 FF FF FF 00 00 00 00", "80 FF FF FF 00 00 02 06");
  ask("40 09 20 04 00 00 00 00", "80 09 20 04 11 00 09 06");
  ask("40 00 10 01 00 00 00 00", "80 00 10 01 11 00 09 06");
}

TEST_F(SdoServerTest, AnUploadOfAWriteOnlyEntryIsAborted) {
  ask("40 11 20 00 00 00 00 00", "80 11 20 00 01 00 01 06");
  ask("40 32 20 00 00 00 00 00", "80 32 20 00 01 00 01 06");
}

TEST_F(SdoServerTest, AHookRefreshesAValueBeforeItIsUploadedOrRefuses) {
  auto refresh = [&](const Entry& entry) {
    if (value(0x2001) == Bytes{0xFF}) return AbortCode::no_data;
    wire.node.dictionary().set(entry, Bytes{0x42, 0x00});
    return AbortCode::none;
  };
  Hook hook{.first = 0x2002, .last = 0x2002};
  hook.before_read = decltype(hook.before_read)::of(refresh);
  wire.node.dictionary().attach(hook);
  ask("40 02 20 00 00 00 00 00", "4B 02 20 00 42 00 00 00");
  set_value(wire.node, 0x2001, Bytes{0xFF});
  ask("40 02 20 00 00 00 00 00", "80 02 20 00 24 00 00 08");
}

// Upload, in segments

TEST_F(SdoServerTest, AnUploadOfMoreThanFourBytesTellsTheSizeAndGoesOnInSegments) {
  ask("40 13 20 00 00 00 00 00", "41 13 20 00 0B 00 00 00");
  EXPECT_TRUE(sut.busy());
  ask("60 00 00 00 00 00 00 00", "00 43 61 6E 76 6F 79 20");
  ask("70 00 00 00 00 00 00 00", "17 6E 6F 64 65 00 00 00");
  EXPECT_FALSE(sut.busy());
}

TEST_F(SdoServerTest, ALastSegmentMayBeFull) {
  set_value(wire.node, 0x2021, pattern(14, 0));
  ask("40 21 20 00 00 00 00 00", "41 21 20 00 0E 00 00 00");
  ask("60 00 00 00 00 00 00 00", "00 00 1F 3E 5D 7C 9B BA");
  ask("70 00 00 00 00 00 00 00", "11 DA F9 18 37 56 75 94");
}

TEST_F(SdoServerTest, AnEmptyStringIsUploadedAsOneEmptySegment) {
  ask("40 20 20 00 00 00 00 00", "41 20 20 00 00 00 00 00");
  ask("60 00 00 00 00 00 00 00", "0F 00 00 00 00 00 00 00");
  EXPECT_FALSE(sut.busy());
}

TEST_F(SdoServerTest, AValueThatChangesDuringItsUploadIsNotTorn) {
  set_value(wire.node, 0x2008, Bytes{1, 1, 1, 1, 1, 1, 1, 1});
  ask("40 08 20 00 00 00 00 00", "41 08 20 00 08 00 00 00");
  ask("60 00 00 00 00 00 00 00", "00 01 01 01 01 01 01 01");
  set_value(wire.node, 0x2008, Bytes{2, 2, 2, 2, 2, 2, 2, 2});
  ask("70 00 00 00 00 00 00 00", "1D 01 00 00 00 00 00 00");
}

TEST_F(SdoServerTest, AnUploadSegmentWithTheWrongToggleBitEndsTheTransfer) {
  ask("40 13 20 00 00 00 00 00", "41 13 20 00 0B 00 00 00");
  ask("70 00 00 00 00 00 00 00", "80 13 20 00 00 00 03 05");
  ask("60 00 00 00 00 00 00 00", "80 00 00 00 01 00 04 05");
  expect_alive();
}

TEST_F(SdoServerTest, ReservedBitsOfARequestForASegmentDoNotMatter) {
  ask("40 13 20 00 00 00 00 00", "41 13 20 00 0B 00 00 00");
  ask("6F FF FF FF FF FF FF FF", "00 43 61 6E 76 6F 79 20");
}

// Download, expedited

TEST_F(SdoServerTest, ADownloadOfOneToFourBytesIsConfirmedInOneFrame) {
  ask("2F 01 20 00 11 00 00 00", "60 01 20 00 00 00 00 00");
  ask("2B 02 20 00 11 22 00 00", "60 02 20 00 00 00 00 00");
  ask("27 03 20 00 11 22 33 00", "60 03 20 00 00 00 00 00");
  ask("23 04 20 00 11 22 33 44", "60 04 20 00 00 00 00 00");
  EXPECT_EQ(value(0x2001), (Bytes{0x11}));
  EXPECT_EQ(value(0x2002), (Bytes{0x11, 0x22}));
  EXPECT_EQ(value(0x2003), (Bytes{0x11, 0x22, 0x33}));
  EXPECT_EQ(value(0x2004), (Bytes{0x11, 0x22, 0x33, 0x44}));
}

TEST_F(SdoServerTest, AnExpeditedDownloadWithoutSizeHasTheLengthOfTheEntry) {
  ask("22 01 20 00 11 AA AA AA", "60 01 20 00 00 00 00 00");
  ask("22 02 20 00 11 22 AA AA", "60 02 20 00 00 00 00 00");
  ask("2E 03 20 00 11 22 33 AA", "60 03 20 00 00 00 00 00");  // n does not count without s
  ask("22 04 20 00 11 22 33 44", "60 04 20 00 00 00 00 00");
  ask("22 20 20 00 61 62 63 00", "60 20 20 00 00 00 00 00");
  EXPECT_EQ(value(0x2001), (Bytes{0x11}));
  EXPECT_EQ(value(0x2002), (Bytes{0x11, 0x22}));
  EXPECT_EQ(value(0x2003), (Bytes{0x11, 0x22, 0x33}));
  EXPECT_EQ(value(0x2004), (Bytes{0x11, 0x22, 0x33, 0x44}));
  EXPECT_EQ(value(0x2020), (Bytes{'a', 'b', 'c'}));
}

TEST_F(SdoServerTest, AnExpeditedDownloadOfAnotherLengthIsAborted) {
  ask("2B 01 20 00 11 22 00 00", "80 01 20 00 12 00 07 06");
  ask("23 02 20 00 11 22 00 00", "80 02 20 00 12 00 07 06");
  ask("2F 02 20 00 11 00 00 00", "80 02 20 00 13 00 07 06");
  ask("27 04 20 00 11 22 33 00", "80 04 20 00 13 00 07 06");
  ask("23 05 20 00 11 22 33 44", "80 05 20 00 13 00 07 06");
  ask("22 08 20 00 11 22 33 44", "80 08 20 00 13 00 07 06");
  ask("23 20 20 00 61 62 63 64", "80 20 20 00 12 00 07 06");
  EXPECT_EQ(value(0x2002), (Bytes{0, 0}));
}

TEST_F(SdoServerTest, ADownloadToWhatIsNotThereIsAborted) {
  ask("2F 99 20 00 00 00 00 00", "80 99 20 00 00 00 02 06");
  ask("2F 01 20 01 00 00 00 00", "80 01 20 01 11 00 09 06");
  ask("21 99 20 00 08 00 00 00", "80 99 20 00 00 00 02 06");
  ask("21 08 20 01 08 00 00 00", "80 08 20 01 11 00 09 06");
}

TEST_F(SdoServerTest, ADownloadToAReadOnlyEntryIsAborted) {
  ask("2B 12 20 00 00 00 00 00", "80 12 20 00 02 00 01 06");
  ask("21 13 20 00 0B 00 00 00", "80 13 20 00 02 00 01 06");
  ask("21 31 20 00 0B 00 00 00", "80 31 20 00 02 00 01 06");
  EXPECT_EQ(value(0x2012), (Bytes{0x34, 0x12}));
}

TEST_F(SdoServerTest, ADownloadOutOfTheRangeIsAborted) {
  ask("2F 10 20 00 15 00 00 00", "80 10 20 00 31 00 09 06");
  ask("2F 10 20 00 F5 00 00 00", "80 10 20 00 32 00 09 06");
  ask("2F 10 20 00 14 00 00 00", "60 10 20 00 00 00 00 00");
  ask("2F 10 20 00 F6 00 00 00", "60 10 20 00 00 00 00 00");
}

TEST_F(SdoServerTest, AHookMayRefuseADownload) {
  auto refuse = [](const Entry&, std::span<const std::uint8_t>) { return AbortCode::device_state; };
  Hook hook{.first = 0x2001, .last = 0x2008};
  hook.before_write = decltype(hook.before_write)::of(refuse);
  wire.node.dictionary().attach(hook);
  ask("2F 01 20 00 11 00 00 00", "80 01 20 00 22 00 00 08");
  ask("21 08 20 00 08 00 00 00", "60 08 20 00 00 00 00 00");
  ask("00 01 02 03 04 05 06 07", "20 00 00 00 00 00 00 00");
  ask("1D 08 00 00 00 00 00 00", "80 08 20 00 22 00 00 08");
  EXPECT_EQ(value(0x2008), Bytes(8));
}

// Download, in segments

TEST_F(SdoServerTest, ADownloadInSegmentsIsWrittenWholeAtItsEnd) {
  ask("21 08 20 00 08 00 00 00", "60 08 20 00 00 00 00 00");
  EXPECT_TRUE(sut.busy());
  ask("00 01 02 03 04 05 06 07", "20 00 00 00 00 00 00 00");
  EXPECT_EQ(value(0x2008), Bytes(8));
  ask("1D 08 00 00 00 00 00 00", "30 00 00 00 00 00 00 00");
  EXPECT_EQ(value(0x2008), (Bytes{1, 2, 3, 4, 5, 6, 7, 8}));
  EXPECT_FALSE(sut.busy());
}

TEST_F(SdoServerTest, ADownloadInSegmentsNeedNotTellItsSize) {
  ask("20 08 20 00 EE EE EE EE", "60 08 20 00 00 00 00 00");
  ask("00 01 02 03 04 05 06 07", "20 00 00 00 00 00 00 00");
  ask("1D 08 00 00 00 00 00 00", "30 00 00 00 00 00 00 00");
  EXPECT_EQ(value(0x2008), (Bytes{1, 2, 3, 4, 5, 6, 7, 8}));
}

TEST_F(SdoServerTest, SegmentsMayBeShorterThanTheyCouldBe) {
  ask("21 05 20 00 05 00 00 00", "60 05 20 00 00 00 00 00");
  ask("0A 01 02 EE EE EE EE EE", "20 00 00 00 00 00 00 00");
  ask("1E EE EE EE EE EE EE EE", "30 00 00 00 00 00 00 00");
  ask("09 03 04 05 EE EE EE EE", "20 00 00 00 00 00 00 00");
  EXPECT_EQ(value(0x2005), (Bytes{1, 2, 3, 4, 5}));
}

TEST_F(SdoServerTest, AShortValueMayComeInSegmentsToo) {
  ask("21 02 20 00 02 00 00 00", "60 02 20 00 00 00 00 00");
  ask("0B 34 12 00 00 00 00 00", "20 00 00 00 00 00 00 00");
  EXPECT_EQ(value(0x2002), (Bytes{0x34, 0x12}));
}

TEST_F(SdoServerTest, AStringIsEmptiedByADownloadOfNoBytes) {
  set_value(wire.node, 0x2020, Bytes{'a', 'b'});
  ask("21 20 20 00 00 00 00 00", "60 20 20 00 00 00 00 00");
  ask("0F 00 00 00 00 00 00 00", "20 00 00 00 00 00 00 00");
  EXPECT_EQ(value(0x2020), Bytes{});
}

TEST_F(SdoServerTest, ASizeThatDoesNotFitTheEntryIsAbortedAtOnce) {
  ask("21 08 20 00 09 00 00 00", "80 08 20 00 12 00 07 06");
  ask("21 08 20 00 07 00 00 00", "80 08 20 00 13 00 07 06");
  ask("21 20 20 00 04 00 00 00", "80 20 20 00 12 00 07 06");
  ask("21 21 20 00 89 13 00 00", "80 21 20 00 12 00 07 06");
  ask("21 21 20 00 FF FF FF FF", "80 21 20 00 12 00 07 06");
  EXPECT_FALSE(sut.busy());
}

TEST_F(SdoServerTest, MoreBytesThanToldAreAborted) {
  ask("21 21 20 00 08 00 00 00", "60 21 20 00 00 00 00 00");
  ask("00 01 02 03 04 05 06 07", "20 00 00 00 00 00 00 00");
  ask("1B 08 09 00 00 00 00 00", "80 21 20 00 12 00 07 06");
  EXPECT_FALSE(sut.busy());
  EXPECT_EQ(value(0x2021), Bytes{});
}

TEST_F(SdoServerTest, FewerBytesThanToldAreAborted) {
  ask("21 21 20 00 09 00 00 00", "60 21 20 00 00 00 00 00");
  ask("00 01 02 03 04 05 06 07", "20 00 00 00 00 00 00 00");
  ask("1D 08 00 00 00 00 00 00", "80 21 20 00 13 00 07 06");
  EXPECT_EQ(value(0x2021), Bytes{});
}

TEST_F(SdoServerTest, WithoutSizeTheLengthIsCheckedByTheEntry) {
  ask("20 05 20 00 00 00 00 00", "60 05 20 00 00 00 00 00");
  ask("01 01 02 03 04 05 06 07", "80 05 20 00 12 00 07 06");
  ask("20 05 20 00 00 00 00 00", "60 05 20 00 00 00 00 00");
  ask("07 01 02 03 04 00 00 00", "80 05 20 00 13 00 07 06");
  ask("20 20 20 00 00 00 00 00", "60 20 20 00 00 00 00 00");
  ask("07 61 62 63 64 00 00 00", "80 20 20 00 12 00 07 06");
  EXPECT_EQ(value(0x2005), Bytes(5));
}

TEST_F(SdoServerTest, TooManyBytesAreAbortedBeforeTheLastSegment) {
  ask("20 20 20 00 00 00 00 00", "60 20 20 00 00 00 00 00");
  ask("00 61 62 63 64 65 66 67", "80 20 20 00 12 00 07 06");
  EXPECT_FALSE(sut.busy());
}

TEST_F(SdoServerTest, ADownloadSegmentWithTheWrongToggleBitEndsTheTransfer) {
  ask("21 08 20 00 08 00 00 00", "60 08 20 00 00 00 00 00");
  ask("00 01 02 03 04 05 06 07", "20 00 00 00 00 00 00 00");
  ask("00 01 02 03 04 05 06 07", "80 08 20 00 00 00 03 05");
  ask("1D 08 00 00 00 00 00 00", "80 00 00 00 01 00 04 05");
  EXPECT_EQ(value(0x2008), Bytes(8));
}

TEST_F(SdoServerTest, ADownloadOfMoreThan255BytesArrivesWhole) {
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

// The order of messages

TEST_F(SdoServerTest, SegmentsOutOfNowhereAreAborted) {
  ask("60 00 00 00 00 00 00 00", "80 00 00 00 01 00 04 05");
  ask("70 00 00 00 00 00 00 00", "80 00 00 00 01 00 04 05");
  ask("00 01 02 03 04 05 06 07", "80 00 00 00 01 00 04 05");
  ask("1D 08 00 00 00 00 00 00", "80 00 00 00 01 00 04 05");
  expect_alive();
}

TEST_F(SdoServerTest, ASegmentOfTheOtherDirectionEndsTheTransfer) {
  ask("21 08 20 00 08 00 00 00", "60 08 20 00 00 00 00 00");
  ask("60 00 00 00 00 00 00 00", "80 08 20 00 01 00 04 05");
  EXPECT_FALSE(sut.busy());
  ask("40 13 20 00 00 00 00 00", "41 13 20 00 0B 00 00 00");
  ask("00 01 02 03 04 05 06 07", "80 13 20 00 01 00 04 05");
  EXPECT_FALSE(sut.busy());
}

TEST_F(SdoServerTest, AnAbortFromTheClientEndsTheTransferWithoutAnAnswer) {
  ask("21 08 20 00 08 00 00 00", "60 08 20 00 00 00 00 00");
  ask_in_vain("80 08 20 00 00 00 00 08");
  EXPECT_FALSE(sut.busy());
  ask("00 01 02 03 04 05 06 07", "80 00 00 00 01 00 04 05");
  ask_in_vain("80 08 20 00 00 00 00 08");
  expect_alive();
}

TEST_F(SdoServerTest, ANewInitiateInMidTransferStartsAfresh) {
  ask("21 08 20 00 08 00 00 00", "60 08 20 00 00 00 00 00");
  ask("00 01 02 03 04 05 06 07", "20 00 00 00 00 00 00 00");
  ask("21 08 20 00 08 00 00 00", "60 08 20 00 00 00 00 00");
  ask("00 11 12 13 14 15 16 17", "20 00 00 00 00 00 00 00");
  ask("1D 18 00 00 00 00 00 00", "30 00 00 00 00 00 00 00");
  EXPECT_EQ(value(0x2008), (Bytes{0x11, 0x12, 0x13, 0x14, 0x15, 0x16, 0x17, 0x18}));
  ask("40 13 20 00 00 00 00 00", "41 13 20 00 0B 00 00 00");
  ask("60 00 00 00 00 00 00 00", "00 43 61 6E 76 6F 79 20");
  ask("40 13 20 00 00 00 00 00", "41 13 20 00 0B 00 00 00");
  ask("60 00 00 00 00 00 00 00", "00 43 61 6E 76 6F 79 20");
  expect_alive();
  ask("70 00 00 00 00 00 00 00", "80 00 00 00 01 00 04 05");
}

TEST_F(SdoServerTest, AnUnknownCommandSpecifierIsAborted) {
  ask("E0 13 20 00 00 00 00 00", "80 00 00 00 01 00 04 05");
  ask("FF 13 20 00 00 00 00 00", "80 00 00 00 01 00 04 05");
  ask("40 13 20 00 00 00 00 00", "41 13 20 00 0B 00 00 00");
  ask("E0 00 00 00 00 00 00 00", "80 13 20 00 01 00 04 05");
  EXPECT_FALSE(sut.busy());
}

TEST_F(SdoServerTest, ABlockTransferIsRefusedByNameSoThatTheClientTakesAnother) {
  ask("A4 13 20 00 7F 00 00 00", "80 13 20 00 01 00 04 05");
  ask("C6 08 20 00 08 00 00 00", "80 08 20 00 01 00 04 05");
  ask("21 08 20 00 08 00 00 00", "60 08 20 00 00 00 00 00");
  ask("A0 13 20 00 7F 00 00 00", "80 13 20 00 01 00 04 05");
  EXPECT_FALSE(sut.busy());
  ask("A2 01 02 03 00 00 00 00", "80 00 00 00 01 00 04 05");
}

// Time

TEST_F(SdoServerTest, AnAbandonedTransferIsAbortedAfterTheTimeOut) {
  ask("21 08 20 00 08 00 00 00", "60 08 20 00 00 00 00 00");
  wire.run_until(Time(999'999us));
  wire.expect({});
  wire.run_until(Time(10s));
  wire.expect({"@1000000 585#80 08 20 00 00 00 04 05"});
  EXPECT_FALSE(sut.busy());
  ask("00 01 02 03 04 05 06 07", "80 00 00 00 01 00 04 05");
  EXPECT_EQ(value(0x2008), Bytes(8));
}

TEST_F(SdoServerTest, EachSegmentStartsTheTimeOutAnew) {
  ask("40 08 20 00 00 00 00 00", "41 08 20 00 08 00 00 00");
  wire.run_until(Time(900ms));
  ask("60 00 00 00 00 00 00 00", "00 00 00 00 00 00 00 00");
  wire.run_until(Time(1899ms));
  wire.expect({});
  wire.run_until(Time(10s));
  wire.expect({"@1900000 585#80 08 20 00 00 00 04 05"});
}

TEST_F(SdoServerTest, AFinishedTransferHasNoTimeOut) {
  ask("40 08 20 00 00 00 00 00", "41 08 20 00 08 00 00 00");
  ask("60 00 00 00 00 00 00 00", "00 00 00 00 00 00 00 00");
  ask("70 00 00 00 00 00 00 00", "1D 00 00 00 00 00 00 00");
  wire.run_until(Time(10s));
  wire.expect({});
}

TEST_F(SdoServerTest, AnExpeditedTransferNeedsNoTimer) {
  expect_alive();
  EXPECT_EQ(wire.node.deadline(), never);
}

TEST_F(SdoServerTest, TheTimeOutIsTheOwnersChoice) {
  WireNode other(sdo_objects(), 5);
  SdoServer server(other.node, 0, {}, 50ms);
  other.boot();
  other.receive("605#21 08 20 00 08 00 00 00");
  other.run_until(Time(1s));
  other.expect({"585#60 08 20 00 00 00 00 00", "@50000 585#80 08 20 00 00 00 04 05"});
}

// The buffer

TEST_F(SdoServerTest, ValuesOfEightBytesNeedNoBuffer) {
  WireNode other(sdo_objects(), 5);
  SdoServer server(other.node, 0, {});
  other.boot();
  other.receive("605#21 08 20 00 08 00 00 00");
  other.receive("605#00 01 02 03 04 05 06 07");
  other.receive("605#1D 08 00 00 00 00 00 00");
  other.receive("605#40 08 20 00 00 00 00 00");
  other.expect({"585#60 08 20 00 00 00 00 00", "585#20 00 00 00 00 00 00 00",
                "585#30 00 00 00 00 00 00 00", "585#41 08 20 00 08 00 00 00"});
}

TEST_F(SdoServerTest, AValueThatDoesNotFitTheBufferIsAborted) {
  WireNode other(sdo_objects(), 5);
  std::array<std::uint8_t, 10> small{};
  SdoServer server(other.node, 0, small);
  other.boot();
  other.receive("605#21 21 20 00 0B 00 00 00");
  other.expect({"585#80 21 20 00 05 00 04 05"});
  other.receive("605#20 21 20 00 00 00 00 00");
  other.receive("605#00 01 02 03 04 05 06 07");
  other.receive("605#17 08 09 0A 0B 00 00 00");
  other.expect({"585#60 21 20 00 00 00 00 00", "585#20 00 00 00 00 00 00 00",
                "585#80 21 20 00 05 00 04 05"});
  set_value(other.node, 0x2021, Bytes(11));
  other.receive("605#40 21 20 00 00 00 00 00");
  other.expect({"585#80 21 20 00 05 00 04 05"});
}

TEST_F(SdoServerTest, AConstantValueNeedsNoBuffer) {
  WireNode other(sdo_objects(), 5);
  SdoServer server(other.node, 0, {});
  other.boot();
  other.receive("605#40 13 20 00 00 00 00 00");
  other.receive("605#60 00 00 00 00 00 00 00");
  other.receive("605#70 00 00 00 00 00 00 00");
  other.expect({"585#41 13 20 00 0B 00 00 00", "585#00 43 61 6E 76 6F 79 20",
                "585#17 6E 6F 64 65 00 00 00"});
}

TEST(SdoBufferSize, IsTheLengthOfTheLongestValue) {
  EXPECT_EQ(sdo_buffer_size(sdo_objects()), 5000U);
}

// Domains

TEST_F(SdoServerTest, ADomainIsUploadedPieceByPiece) {
  readable.content = {1, 2, 3, 4, 5, 6, 7, 8};
  ask("40 31 20 00 00 00 00 00", "41 31 20 00 08 00 00 00");
  ask("60 00 00 00 00 00 00 00", "00 01 02 03 04 05 06 07");
  ask("70 00 00 00 00 00 00 00", "1D 08 00 00 00 00 00 00");
  EXPECT_EQ(readable.longest_piece, 7U);
}

TEST_F(SdoServerTest, AnEmptyDomainIsUploadedAsOneEmptySegment) {
  ask("40 31 20 00 00 00 00 00", "41 31 20 00 00 00 00 00");
  ask("60 00 00 00 00 00 00 00", "0F 00 00 00 00 00 00 00");
  EXPECT_FALSE(sut.busy());
}

TEST_F(SdoServerTest, ADomainThatDoesNotKnowItsSizeIsUploadedUntilItEnds) {
  readable.tells_size = false;
  readable.content = {1, 2, 3, 4, 5, 6, 7, 8};
  ask("40 31 20 00 00 00 00 00", "40 31 20 00 00 00 00 00");
  ask("60 00 00 00 00 00 00 00", "00 01 02 03 04 05 06 07");
  ask("70 00 00 00 00 00 00 00", "1D 08 00 00 00 00 00 00");
  EXPECT_FALSE(sut.busy());
  readable.content = {1, 2, 3, 4, 5, 6, 7};
  ask("40 31 20 00 00 00 00 00", "40 31 20 00 00 00 00 00");
  ask("60 00 00 00 00 00 00 00", "00 01 02 03 04 05 06 07");
  ask("70 00 00 00 00 00 00 00", "1F 00 00 00 00 00 00 00");
  readable.content = {};
  ask("40 31 20 00 00 00 00 00", "40 31 20 00 00 00 00 00");
  ask("60 00 00 00 00 00 00 00", "0F 00 00 00 00 00 00 00");
  EXPECT_FALSE(sut.busy());
}

TEST_F(SdoServerTest, ADomainThatEndsBeforeTheSizeThatItToldEndsTheTransfer) {
  readable.content = pattern(20);
  ask("40 31 20 00 00 00 00 00", "41 31 20 00 14 00 00 00");
  readable.content.resize(5);
  ask("60 00 00 00 00 00 00 00", "80 31 20 00 47 00 04 06");
  EXPECT_FALSE(sut.busy());
}

TEST_F(SdoServerTest, ADomainIsDownloadedPieceByPiece) {
  ask("21 32 20 00 08 00 00 00", "60 32 20 00 00 00 00 00");
  EXPECT_EQ(writable.announced, 8U);
  ask("00 01 02 03 04 05 06 07", "20 00 00 00 00 00 00 00");
  EXPECT_EQ(writable.arriving, (Bytes{1, 2, 3, 4, 5, 6, 7}));
  ask("1D 08 00 00 00 00 00 00", "30 00 00 00 00 00 00 00");
  EXPECT_EQ(writable.content, (Bytes{1, 2, 3, 4, 5, 6, 7, 8}));
  EXPECT_FALSE(writable.open);
}

TEST_F(SdoServerTest, ADomainIsDownloadedWithoutSizeAndWithoutBytes) {
  domain.content = {1, 2, 3};
  ask("20 30 20 00 00 00 00 00", "60 30 20 00 00 00 00 00");
  EXPECT_EQ(domain.announced, 0U);
  ask("0F 00 00 00 00 00 00 00", "20 00 00 00 00 00 00 00");
  EXPECT_EQ(domain.content, Bytes{});
  EXPECT_EQ(domain.dropped, 0);
}

TEST_F(SdoServerTest, AShortDomainMayBeDownloadedExpedited) {
  ask("2B 30 20 00 11 22 00 00", "60 30 20 00 00 00 00 00");
  EXPECT_EQ(domain.content, (Bytes{0x11, 0x22}));
  ask("22 30 20 00 11 22 33 44", "60 30 20 00 00 00 00 00");
  EXPECT_EQ(domain.content, (Bytes{0x11, 0x22, 0x33, 0x44}));
}

TEST_F(SdoServerTest, ADomainThatNobodyServesCannotBeAccessed) {
  ask("40 33 20 00 00 00 00 00", "80 33 20 00 00 00 01 06");
  ask("20 33 20 00 00 00 00 00", "80 33 20 00 00 00 01 06");
  ask("2F 33 20 00 00 00 00 00", "80 33 20 00 00 00 01 06");
}

TEST_F(SdoServerTest, ADomainNeedNotServeBothDirections) {
  const Domain nothing;
  Hook hook{.first = 0x2033, .last = 0x2033, .domain = &nothing};
  wire.node.dictionary().attach(hook);
  ask("40 33 20 00 00 00 00 00", "80 33 20 00 00 00 01 06");
  ask("20 33 20 00 00 00 00 00", "80 33 20 00 00 00 01 06");
}

TEST_F(SdoServerTest, AValueAfterADomainIsNotTakenFromTheDomain) {
  domain.content = pattern(11, 0xAA);
  ask("40 30 20 00 00 00 00 00", "41 30 20 00 0B 00 00 00");
  ask("40 13 20 00 00 00 00 00", "41 13 20 00 0B 00 00 00");
  ask("60 00 00 00 00 00 00 00", "00 43 61 6E 76 6F 79 20");
}

TEST_F(SdoServerTest, ADomainMayRefuseToBeOpened) {
  domain.open_answer = AbortCode::local_control;
  ask("40 30 20 00 00 00 00 00", "80 30 20 00 21 00 00 08");
  ask("20 30 20 00 00 00 00 00", "80 30 20 00 21 00 00 08");
  ask("2F 30 20 00 00 00 00 00", "80 30 20 00 21 00 00 08");
  EXPECT_EQ(domain.dropped, 0);
}

TEST_F(SdoServerTest, ADomainMayFailInTheMiddle) {
  domain.content = pattern(20);
  domain.refused_from = 8;
  ask("40 30 20 00 00 00 00 00", "41 30 20 00 14 00 00 00");
  wire.receive("605#60 00 00 00 00 00 00 00");
  wire.sent.clear();
  ask("70 00 00 00 00 00 00 00", "80 30 20 00 00 00 06 06");
  ask("20 30 20 00 00 00 00 00", "60 30 20 00 00 00 00 00");
  ask("00 01 02 03 04 05 06 07", "20 00 00 00 00 00 00 00");
  ask("10 01 02 03 04 05 06 07", "80 30 20 00 00 00 06 06");
  EXPECT_EQ(domain.dropped, 1);
  EXPECT_EQ(domain.content, pattern(20));
}

TEST_F(SdoServerTest, ADomainMayRefuseWhatHasArrived) {
  domain.close_answer = AbortCode::cannot_store;
  ask("2F 30 20 00 00 00 00 00", "80 30 20 00 20 00 00 08");
  EXPECT_FALSE(domain.open);
  EXPECT_EQ(domain.dropped, 0);
}

TEST_F(SdoServerTest, ADomainForgetsADownloadThatCameToNothing) {
  const auto begin = [&] {
    ask("21 30 20 00 08 00 00 00", "60 30 20 00 00 00 00 00");
    ask("00 01 02 03 04 05 06 07", "20 00 00 00 00 00 00 00");
    EXPECT_TRUE(domain.open);
  };
  begin();
  ask_in_vain("80 30 20 00 00 00 00 08");
  EXPECT_EQ(domain.dropped, 1);
  begin();
  expect_alive();
  EXPECT_EQ(domain.dropped, 2);
  begin();
  ask("0D 08 00 00 00 00 00 00", "80 30 20 00 00 00 03 05");
  EXPECT_EQ(domain.dropped, 3);
  begin();
  ask("1F 00 00 00 00 00 00 00", "80 30 20 00 13 00 07 06");
  EXPECT_EQ(domain.dropped, 4);
  begin();
  ask("1B 08 09 00 00 00 00 00", "80 30 20 00 12 00 07 06");
  EXPECT_EQ(domain.dropped, 5);
  begin();
  wire.run_for(1s);
  EXPECT_EQ(domain.dropped, 6);
  wire.sent.clear();
  begin();
  wire.receive("000#02 05");
  EXPECT_EQ(domain.dropped, 7);
  EXPECT_FALSE(domain.open);
  EXPECT_EQ(domain.content, Bytes{});
}

// NMT states and malformed frames

TEST_F(SdoServerTest, ItServesInPreOperationalAndOperationalAndIsSilentInStopped) {
  expect_alive();
  wire.receive("000#01 05");
  expect_alive();
  wire.receive("000#02 05");
  ask_in_vain("40 00 10 00 00 00 00 00");
  wire.receive("000#80 05");
  expect_alive();
}

TEST_F(SdoServerTest, ItIsSilentInInitialisation) {
  WireNode other(sdo_objects(), node_id_unconfigured);
  SdoServer server(other.node, 0, {});
  other.start();
  other.receive("6FF#40 00 10 00 00 00 00 00");
  other.receive("605#40 00 10 00 00 00 00 00");
  other.expect({});
}

TEST_F(SdoServerTest, ATransferSurvivesTheWayFromPreOperationalToOperational) {
  ask("40 13 20 00 00 00 00 00", "41 13 20 00 0B 00 00 00");
  wire.receive("000#01 05");
  ask("60 00 00 00 00 00 00 00", "00 43 61 6E 76 6F 79 20");
}

TEST_F(SdoServerTest, StoppedAndResetEndATransferWithoutAWord) {
  ask("40 13 20 00 00 00 00 00", "41 13 20 00 0B 00 00 00");
  wire.receive("000#02 05");
  wire.receive("000#80 05");
  wire.expect({});
  ask("60 00 00 00 00 00 00 00", "80 00 00 00 01 00 04 05");
  ask("40 13 20 00 00 00 00 00", "41 13 20 00 0B 00 00 00");
  wire.receive("000#82 05");
  wire.expect({"705#00"});
  ask("60 00 00 00 00 00 00 00", "80 00 00 00 01 00 04 05");
}

TEST_F(SdoServerTest, AWriteThatStopsTheNodeIsNotConfirmed) {
  auto stop = [&](const Entry&, Source) { wire.node.command(NmtCommand::stop); };
  Hook hook{.first = 0x2001, .last = 0x2001};
  hook.after_write = decltype(hook.after_write)::of(stop);
  wire.node.dictionary().attach(hook);
  ask_in_vain("2F 01 20 00 11 00 00 00");
  EXPECT_EQ(wire.node.state(), NmtState::stopped);
}

TEST_F(SdoServerTest, FramesOfAnotherLengthAreIgnoredAndCounted) {
  ask("40 13 20 00 00 00 00 00", "41 13 20 00 0B 00 00 00");
  for (const char* frame : {"605#", "605#60", "605#60 00 00 00", "605#60 00 00 00 00 00 00"}) {
    wire.receive(frame);
  }
  wire.expect({});
  EXPECT_EQ(wire.node.counters().malformed, 4U);
  ask("60 00 00 00 00 00 00 00", "00 43 61 6E 76 6F 79 20");
}

TEST_F(SdoServerTest, RemoteAndExtendedFramesAndForeignCanIdsAreNotRequests) {
  wire.receive("605#R8");
  wire.receive("00000605#40 00 10 00 00 00 00 00");
  wire.receive("606#40 00 10 00 00 00 00 00");
  wire.receive("585#40 00 10 00 00 00 00 00");
  wire.expect({});
}

TEST_F(SdoServerTest, AnAnswerWaitsWhereTheControllerIsFull) {
  wire.full = true;
  ask_in_vain("40 00 10 00 00 00 00 00");
  wire.full = false;
  wire.node.tx_ready(wire.now);
  wire.expect({"585#43 00 10 00 A2 01 02 00"});
}

}  // namespace
}  // namespace canvoy
