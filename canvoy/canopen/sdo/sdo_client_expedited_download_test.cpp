// SDO client, expedited download (CiA 301, 7.2.4.3.3).
#include <gtest/gtest.h>

#include "canvoy/canopen/testing/sdo_client_node.hpp"

namespace canvoy::sdo_client_expedited_download_test {
namespace {

class SdoClientExpeditedDownload : public SdoClientNode {};

TEST_F(SdoClientExpeditedDownload, AnExpeditedDownloadTakesOneFrameEachWay) {
  const std::array<std::string, 4> requests{"2F 08 20 00 11 00 00 00", "2B 08 20 00 11 22 00 00",
                                            "27 08 20 00 11 22 33 00", "23 08 20 00 11 22 33 44"};
  const Bytes value{0x11, 0x22, 0x33, 0x44};
  for (std::size_t size = 1; size <= 4; ++size) {
    EXPECT_EQ(download(std::span(value).first(size)), AbortCode::none);
    expect_request(requests.at(size - 1));
    expect_waiting();
    answer("60 08 20 00 00 00 00 00");
    expect_done(size);
  }
}

}  // namespace
}  // namespace canvoy::sdo_client_expedited_download_test
