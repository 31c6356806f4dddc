// SDO server, upload in segments (CiA 301, 7.2.4.3.6 and 7.2.4.3.7).
#include <gtest/gtest.h>

#include <algorithm>

#include "canvoy/canopen/testing/sdo_server_node.hpp"

namespace canvoy::sdo_server_segmented_upload_test {
namespace {

class SdoServerSegmentedUpload : public SdoServerNode {};

TEST_F(SdoServerSegmentedUpload, AnUploadOfMoreThanFourBytesTellsTheSizeAndGoesOnInSegments) {
  ask("40 13 20 00 00 00 00 00", "41 13 20 00 0B 00 00 00");
  EXPECT_TRUE(sut.busy());
  ask("60 00 00 00 00 00 00 00", "00 43 61 6E 76 6F 79 20");
  ask("70 00 00 00 00 00 00 00", "17 6E 6F 64 65 00 00 00");
  EXPECT_FALSE(sut.busy());
}

TEST_F(SdoServerSegmentedUpload, ALastSegmentMayBeFull) {
  set_value(wire.node, 0x2021, pattern(14, 0));
  ask("40 21 20 00 00 00 00 00", "41 21 20 00 0E 00 00 00");
  ask("60 00 00 00 00 00 00 00", "00 00 1F 3E 5D 7C 9B BA");
  ask("70 00 00 00 00 00 00 00", "11 DA F9 18 37 56 75 94");
}

TEST_F(SdoServerSegmentedUpload, AnEmptyStringIsUploadedAsOneEmptySegment) {
  ask("40 20 20 00 00 00 00 00", "41 20 20 00 00 00 00 00");
  ask("60 00 00 00 00 00 00 00", "0F 00 00 00 00 00 00 00");
  EXPECT_FALSE(sut.busy());
}

TEST_F(SdoServerSegmentedUpload, AValueThatChangesDuringItsUploadIsNotTorn) {
  set_value(wire.node, 0x2008, Bytes{1, 1, 1, 1, 1, 1, 1, 1});
  ask("40 08 20 00 00 00 00 00", "41 08 20 00 08 00 00 00");
  ask("60 00 00 00 00 00 00 00", "00 01 01 01 01 01 01 01");
  set_value(wire.node, 0x2008, Bytes{2, 2, 2, 2, 2, 2, 2, 2});
  ask("70 00 00 00 00 00 00 00", "1D 01 00 00 00 00 00 00");
}

TEST_F(SdoServerSegmentedUpload, AnUploadSegmentWithTheWrongToggleBitEndsTheTransfer) {
  ask("40 13 20 00 00 00 00 00", "41 13 20 00 0B 00 00 00");
  ask("70 00 00 00 00 00 00 00", "80 13 20 00 00 00 03 05");
  ask("60 00 00 00 00 00 00 00", "80 00 00 00 01 00 04 05");
  expect_alive();
}

TEST_F(SdoServerSegmentedUpload, ReservedBitsOfARequestForASegmentDoNotMatter) {
  ask("40 13 20 00 00 00 00 00", "41 13 20 00 0B 00 00 00");
  ask("6F FF FF FF FF FF FF FF", "00 43 61 6E 76 6F 79 20");
}

TEST_F(SdoServerSegmentedUpload, ADomainIsUploadedPieceByPiece) {
  readable.content = {1, 2, 3, 4, 5, 6, 7, 8};
  ask("40 31 20 00 00 00 00 00", "41 31 20 00 08 00 00 00");
  ask("60 00 00 00 00 00 00 00", "00 01 02 03 04 05 06 07");
  ask("70 00 00 00 00 00 00 00", "1D 08 00 00 00 00 00 00");
  EXPECT_EQ(readable.longest_piece, is_small_machine ? 7U : 8U);
}

TEST_F(SdoServerSegmentedUpload, AnEmptyDomainIsUploadedAsOneEmptySegment) {
  ask("40 31 20 00 00 00 00 00", "41 31 20 00 00 00 00 00");
  ask("60 00 00 00 00 00 00 00", "0F 00 00 00 00 00 00 00");
  EXPECT_FALSE(sut.busy());
}

TEST_F(SdoServerSegmentedUpload, ADomainThatDoesNotKnowItsSizeIsUploadedUntilItEnds) {
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

TEST_F(SdoServerSegmentedUpload, ADomainThatEndsBeforeTheSizeThatItToldEndsTheTransfer) {
  readable.content = pattern(20);
  ask("40 31 20 00 00 00 00 00", "41 31 20 00 14 00 00 00");
  readable.content.resize(5);
  ask("60 00 00 00 00 00 00 00", "80 31 20 00 47 00 04 06");
  EXPECT_FALSE(sut.busy());
}

TEST_F(SdoServerSegmentedUpload, ADomainThatReturnsMoreThanItWasAskedForEndsTheTransfer) {
  for (const bool tells_size : {true, false}) {
    std::size_t given = 0;
    Domain generous;
    auto open = [&](const Entry&) -> Result<std::uint32_t> {
      return tells_size ? 20U : Domain::size_unknown;
    };
    auto read = [&](const Entry&, std::uint32_t, std::span<std::uint8_t> bytes) {
      std::ranges::fill(bytes, std::uint8_t{0});
      return Result<std::size_t>(bytes.size() + given);
    };
    generous.open_read = decltype(Domain::open_read)::of(open);
    generous.read = decltype(Domain::read)::of(read);
    Hook hook;
    hook.first = hook.last = 0x2033;
    hook.domain = &generous;
    WireNode other(sdo_objects(), 5);
    SdoServer server(other.node, 0, {});
    other.node.dictionary().attach(hook);
    other.boot();
    other.receive("605#40 33 20 00 00 00 00 00");
    other.sent.clear();
    other.receive("605#60 00 00 00 00 00 00 00");
    other.expect({"585#00 00 00 00 00 00 00 00"});
    given = 1;
    other.receive("605#70 00 00 00 00 00 00 00");
    other.expect({"585#80 33 20 00 47 00 04 06"});
    EXPECT_FALSE(server.busy());
  }
}

TEST_F(SdoServerSegmentedUpload, AValueAfterADomainIsNotTakenFromTheDomain) {
  domain.content = pattern(11, 0xAA);
  ask("40 30 20 00 00 00 00 00", "41 30 20 00 0B 00 00 00");
  ask("40 13 20 00 00 00 00 00", "41 13 20 00 0B 00 00 00");
  ask("60 00 00 00 00 00 00 00", "00 43 61 6E 76 6F 79 20");
}

}  // namespace
}  // namespace canvoy::sdo_server_segmented_upload_test
