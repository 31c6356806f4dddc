// SDO client, upload in segments (CiA 301, 7.2.4.3.6 and 7.2.4.3.7).
#include <gtest/gtest.h>

#include "canvoy/canopen/testing/sdo_client_node.hpp"

namespace canvoy::sdo_client_segmented_upload_test {
namespace {

class SdoClientSegmentedUpload : public SdoClientNode {};

TEST_F(SdoClientSegmentedUpload, AnUploadInSegmentsAsksForOneAfterTheOther) {
  EXPECT_EQ(upload(bytes), AbortCode::none);
  expect_request("40 08 20 00 00 00 00 00");
  answer("41 08 20 00 10 00 00 00", "60 00 00 00 00 00 00 00");
  answer("00 01 02 03 04 05 06 07", "70 00 00 00 00 00 00 00");
  EXPECT_EQ(sut.transferred(), 7U);
  EXPECT_EQ(sut.announced(), 16U);
  answer("10 08 09 0A 0B 0C 0D 0E", "60 00 00 00 00 00 00 00");
  expect_waiting();
  answer("0B 0F 10 EE EE EE EE EE");
  expect_done(16);
  EXPECT_EQ(Bytes(bytes.begin(), bytes.begin() + 17),
            (Bytes{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 0}));
}

TEST_F(SdoClientSegmentedUpload, TheServerNeedNotTellTheSize) {
  EXPECT_EQ(upload(bytes), AbortCode::none);
  wire.sent.clear();
  answer("40 08 20 00 EE EE EE EE", "60 00 00 00 00 00 00 00");
  EXPECT_EQ(sut.announced(), std::nullopt);
  answer("00 01 02 03 04 05 06 07", "70 00 00 00 00 00 00 00");
  answer("1D 08 00 00 00 00 00 00");
  expect_done(8);
}

TEST_F(SdoClientSegmentedUpload, AnEmptyValueIsUploaded) {
  EXPECT_EQ(upload({}), AbortCode::none);
  wire.sent.clear();
  answer("41 08 20 00 00 00 00 00", "60 00 00 00 00 00 00 00");
  answer("0F 00 00 00 00 00 00 00");
  expect_done(0);
}

TEST_F(SdoClientSegmentedUpload, AServerMayEndWithAnEmptySegment) {
  EXPECT_EQ(upload(bytes), AbortCode::none);
  wire.sent.clear();
  answer("41 08 20 00 07 00 00 00", "60 00 00 00 00 00 00 00");
  answer("00 01 02 03 04 05 06 07", "70 00 00 00 00 00 00 00");
  answer("1F 00 00 00 00 00 00 00");
  expect_done(7);
}

TEST_F(SdoClientSegmentedUpload, ADestinationThatIsTooShortEndsAnUpload) {
  EXPECT_EQ(upload(std::span(bytes).first(1)), AbortCode::none);
  wire.sent.clear();
  answer("4B 08 20 00 11 22 00 00", "80 08 20 00 05 00 04 05");
  expect_failed(AbortCode::out_of_memory);
  EXPECT_EQ(upload(std::span(bytes).first(7)), AbortCode::none);
  wire.sent.clear();
  answer("41 08 20 00 08 00 00 00", "80 08 20 00 05 00 04 05");
  expect_failed(AbortCode::out_of_memory);
  EXPECT_EQ(upload(std::span(bytes).first(7)), AbortCode::none);
  wire.sent.clear();
  answer("40 08 20 00 00 00 00 00", "60 00 00 00 00 00 00 00");
  answer("00 01 02 03 04 05 06 07", "70 00 00 00 00 00 00 00");
  answer("1D 08 00 00 00 00 00 00", "80 08 20 00 05 00 04 05");
  expect_failed(AbortCode::out_of_memory);
  EXPECT_EQ(bytes.at(7), 0);
}

TEST_F(SdoClientSegmentedUpload, ASizeThatIsNotKeptEndsAnUpload) {
  EXPECT_EQ(upload(bytes), AbortCode::none);
  wire.sent.clear();
  answer("41 08 20 00 08 00 00 00", "60 00 00 00 00 00 00 00");
  answer("00 01 02 03 04 05 06 07", "70 00 00 00 00 00 00 00");
  answer("1B 08 09 00 00 00 00 00", "80 08 20 00 12 00 07 06");
  expect_failed(AbortCode::length_too_high);
  EXPECT_EQ(upload(bytes), AbortCode::none);
  wire.sent.clear();
  answer("41 08 20 00 08 00 00 00", "60 00 00 00 00 00 00 00");
  answer("01 01 02 03 04 05 06 07", "80 08 20 00 13 00 07 06");
  expect_failed(AbortCode::length_too_low);
}

TEST_F(SdoClientSegmentedUpload, AnUploadMayGoToASink) {
  Bytes all;
  auto take = [&](std::span<const std::uint8_t> piece) {
    all.insert(all.end(), piece.begin(), piece.end());
    return AbortCode::none;
  };
  const auto sink = SdoClient::Sink::of(take);
  EXPECT_EQ(sut.upload(5, 0x2008, 0, sink, on_done), AbortCode::none);
  expect_request("40 08 20 00 00 00 00 00");
  answer("40 08 20 00 00 00 00 00", "60 00 00 00 00 00 00 00");
  answer("00 01 02 03 04 05 06 07", "70 00 00 00 00 00 00 00");
  EXPECT_EQ(all.size(), 7U);
  answer("1D 08 00 00 00 00 00 00");
  expect_done(8);
  EXPECT_EQ(all, (Bytes{1, 2, 3, 4, 5, 6, 7, 8}));
  all.clear();
  EXPECT_EQ(sut.upload(5, 0x2008, 0, sink, on_done), AbortCode::none);
  wire.sent.clear();
  answer("4B 08 20 00 11 22 00 00");
  expect_done(2);
  EXPECT_EQ(all, (Bytes{0x11, 0x22}));
}

TEST_F(SdoClientSegmentedUpload, ASinkMayEndAnUpload) {
  auto refuse = [&](std::span<const std::uint8_t>) { return AbortCode::cannot_store; };
  EXPECT_EQ(sut.upload(5, 0x2008, 0, SdoClient::Sink::of(refuse), on_done), AbortCode::none);
  wire.sent.clear();
  answer("40 08 20 00 00 00 00 00", "60 00 00 00 00 00 00 00");
  answer("00 01 02 03 04 05 06 07", "80 08 20 00 20 00 00 08");
  expect_failed(AbortCode::cannot_store);
  EXPECT_EQ(sut.upload(5, 0x2008, 0, SdoClient::Sink::of(refuse), on_done), AbortCode::none);
  wire.sent.clear();
  answer("43 08 20 00 01 02 03 04", "80 08 20 00 20 00 00 08");
  expect_failed(AbortCode::cannot_store);
}

}  // namespace
}  // namespace canvoy::sdo_client_segmented_upload_test
