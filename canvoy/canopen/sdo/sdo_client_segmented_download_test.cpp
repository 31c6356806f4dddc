// SDO client, download in segments (CiA 301, 7.2.4.3.3 and 7.2.4.3.4).
#include <gtest/gtest.h>

#include "canvoy/canopen/testing/sdo_client_node.hpp"

namespace canvoy::sdo_client_segmented_download_test {
namespace {

class SdoClientSegmentedDownload : public SdoClientNode {};

/// Supplies `left` bytes, all 55h.
struct Stock {
  std::size_t left;
  Result<std::size_t> operator()(std::span<std::uint8_t> piece) {
    const std::size_t size = std::min(piece.size(), left);
    std::fill_n(piece.begin(), size, std::uint8_t{0x55});
    left -= size;
    return size;
  }
};

TEST_F(SdoClientSegmentedDownload, ADownloadInSegmentsTellsItsSizeAndSendsOneAfterTheOther) {
  const Bytes value = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16};
  EXPECT_EQ(download(value), AbortCode::none);
  expect_request("21 08 20 00 10 00 00 00");
  answer("60 08 20 00 00 00 00 00", "00 01 02 03 04 05 06 07");
  answer("20 00 00 00 00 00 00 00", "10 08 09 0A 0B 0C 0D 0E");
  answer("30 00 00 00 00 00 00 00", "0B 0F 10 00 00 00 00 00");
  expect_waiting();
  answer("20 00 00 00 00 00 00 00");
  expect_done(16);
}

TEST_F(SdoClientSegmentedDownload, ALastSegmentMayBeFull) {
  const Bytes value = {1, 2, 3, 4, 5, 6, 7};
  EXPECT_EQ(download(value), AbortCode::none);
  wire.sent.clear();
  answer("60 08 20 00 00 00 00 00", "01 01 02 03 04 05 06 07");
  answer("20 00 00 00 00 00 00 00");
  expect_done(7);
}

TEST_F(SdoClientSegmentedDownload, AnEmptyValueIsDownloadedAsOneEmptySegment) {
  EXPECT_EQ(download({}), AbortCode::none);
  expect_request("21 08 20 00 00 00 00 00");
  answer("60 08 20 00 00 00 00 00", "0F 00 00 00 00 00 00 00");
  answer("20 00 00 00 00 00 00 00");
  expect_done(0);
}

TEST_F(SdoClientSegmentedDownload, ReservedBitsOfAnAnswerDoNotMatter) {
  EXPECT_EQ(upload(bytes), AbortCode::none);
  wire.sent.clear();
  answer("53 08 20 00 11 22 33 44");
  expect_done(4);
  const Bytes value = {1, 2, 3, 4, 5, 6, 7, 8};
  EXPECT_EQ(download(value), AbortCode::none);
  wire.sent.clear();
  answer("7F 08 20 00 FF FF FF FF", "00 01 02 03 04 05 06 07");
  answer("2F FF FF FF FF FF FF FF", "1D 08 00 00 00 00 00 00");
  answer("3F FF FF FF FF FF FF FF");
  expect_done(8);
}

TEST_F(SdoClientSegmentedDownload, ADownloadMayComeFromASupplyOfUnknownSize) {
  Stock stock{10};
  EXPECT_EQ(sut.download(5, 0x2008, 0, SdoClient::Supply::of(stock), std::nullopt, on_done),
            AbortCode::none);
  expect_request("20 08 20 00 00 00 00 00");
  answer("60 08 20 00 00 00 00 00", "00 55 55 55 55 55 55 55");
  answer("20 00 00 00 00 00 00 00", "19 55 55 55 00 00 00 00");
  answer("30 00 00 00 00 00 00 00");
  expect_done(10);
}

TEST_F(SdoClientSegmentedDownload, ASupplyThatEndsWithAFullSegmentIsFollowedByAnEmptyOne) {
  Stock stock{7};
  EXPECT_EQ(sut.download(5, 0x2008, 0, SdoClient::Supply::of(stock), std::nullopt, on_done),
            AbortCode::none);
  wire.sent.clear();
  answer("60 08 20 00 00 00 00 00", "00 55 55 55 55 55 55 55");
  answer("20 00 00 00 00 00 00 00", "1F 00 00 00 00 00 00 00");
  answer("30 00 00 00 00 00 00 00");
  expect_done(7);
}

TEST_F(SdoClientSegmentedDownload, ADownloadMayComeFromASupplyOfKnownSize) {
  Stock stock{100};
  EXPECT_EQ(sut.download(5, 0x2008, 0, SdoClient::Supply::of(stock), 7, on_done), AbortCode::none);
  expect_request("21 08 20 00 07 00 00 00");
  answer("60 08 20 00 00 00 00 00", "01 55 55 55 55 55 55 55");
  answer("20 00 00 00 00 00 00 00");
  expect_done(7);
  EXPECT_EQ(stock.left, 93U);
}

TEST_F(SdoClientSegmentedDownload, ASupplyMayEndADownload) {
  auto fail = [&](std::span<std::uint8_t>) { return Result<std::size_t>(AbortCode::hardware); };
  EXPECT_EQ(sut.download(5, 0x2008, 0, SdoClient::Supply::of(fail), std::nullopt, on_done),
            AbortCode::none);
  wire.sent.clear();
  answer("60 08 20 00 00 00 00 00", "80 08 20 00 00 00 06 06");
  expect_failed(AbortCode::hardware);
}

TEST_F(SdoClientSegmentedDownload, ASupplyThatClaimsMoreThanItWasAskedForEndsADownload) {
  auto lie = [&](std::span<std::uint8_t>) { return Result<std::size_t>(8); };
  EXPECT_EQ(sut.download(5, 0x2008, 0, SdoClient::Supply::of(lie), std::nullopt, on_done),
            AbortCode::none);
  wire.sent.clear();
  answer("60 08 20 00 00 00 00 00", "80 08 20 00 47 00 04 06");
  expect_failed(AbortCode::internal_incompatible);
}

}  // namespace
}  // namespace canvoy::sdo_client_segmented_download_test
