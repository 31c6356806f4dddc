// SDO client, expedited upload (CiA 301, 7.2.4.3.6).
#include <gtest/gtest.h>

#include "canvoy/canopen/testing/sdo_client_node.hpp"

namespace canvoy::sdo_client_expedited_upload_test {
namespace {

class SdoClientExpeditedUpload : public SdoClientNode {};

TEST_F(SdoClientExpeditedUpload, AnExpeditedUploadTakesOneFrameEachWay) {
  EXPECT_EQ(upload(bytes, 0x1018, 4), AbortCode::none);
  expect_request("40 18 10 04 00 00 00 00");
  expect_waiting();
  answer("43 18 10 04 11 22 33 44");
  expect_done(4);
  EXPECT_EQ(Bytes(bytes.begin(), bytes.begin() + 5), (Bytes{0x11, 0x22, 0x33, 0x44, 0}));
}

TEST_F(SdoClientExpeditedUpload, AnExpeditedAnswerTellsHowManyBytesItHas) {
  const std::array<std::string, 4> answers{"4F 08 20 00 11 22 33 44", "4B 08 20 00 11 22 33 44",
                                           "47 08 20 00 11 22 33 44", "43 08 20 00 11 22 33 44"};
  for (std::size_t size = 1; size <= 4; ++size) {
    bytes.fill(0);
    EXPECT_EQ(upload(bytes), AbortCode::none);
    wire.sent.clear();
    answer(answers.at(size - 1));
    expect_done(size);
    const Bytes all{0x11, 0x22, 0x33, 0x44};
    EXPECT_TRUE(std::equal(bytes.begin(), bytes.begin() + static_cast<long>(size), all.begin()));
    EXPECT_EQ(bytes.at(size), 0);
  }
}

TEST_F(SdoClientExpeditedUpload, AnExpeditedAnswerWithoutSizeFillsTheDestination) {
  EXPECT_EQ(upload(std::span(bytes).first(2)), AbortCode::none);
  wire.sent.clear();
  answer("42 08 20 00 11 22 33 44");
  expect_done(2);
  EXPECT_EQ(Bytes(bytes.begin(), bytes.begin() + 3), (Bytes{0x11, 0x22, 0}));
  EXPECT_EQ(upload(bytes), AbortCode::none);
  wire.sent.clear();
  answer("4E 08 20 00 11 22 33 44");
  expect_done(4);
}

}  // namespace
}  // namespace canvoy::sdo_client_expedited_upload_test
