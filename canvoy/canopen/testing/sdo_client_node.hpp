// A node with an SDO client, for tests of the client at the wire: the test is the server.
//
//     EXPECT_EQ(upload(bytes), AbortCode::none);
//     expect_request("40 08 20 00 00 00 00 00");
//     answer("4B 08 20 00 34 12 00 00");
//     expect_done(2);
//
// For tests only.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "canvoy/canopen/sdo/sdo_client.hpp"
#include "canvoy/canopen/testing/sdo_objects.hpp"
#include "canvoy/canopen/testing/wire.hpp"

namespace canvoy {

/// Node 1 with a client; the test is the server, node 5.
class SdoClientNode : public testing::Test {
 protected:
  using Bytes = std::vector<std::uint8_t>;

  SdoClientNode() { wire.boot(); }

  void done(SdoClient::Outcome outcome) {
    ++calls;
    last = outcome;
  }
  AbortCode upload(std::span<std::uint8_t> destination, std::uint16_t index = 0x2008,
                   std::uint8_t sub = 0) {
    return sut.upload(5, index, sub, destination, on_done);
  }
  AbortCode download(std::span<const std::uint8_t> value, std::uint16_t index = 0x2008,
                     std::uint8_t sub = 0) {
    return sut.download(5, index, sub, value, on_done);
  }
  /// Sends a response of the server and checks the next request, both as eight bytes.
  void answer(const std::string& response, const std::string& next_request) {
    SCOPED_TRACE(response);
    wire.receive("585#" + response);
    wire.expect({"605#" + next_request});
  }
  void answer(const std::string& response) {
    SCOPED_TRACE(response);
    wire.receive("585#" + response);
    wire.expect({});
  }
  void expect_request(const std::string& request) { wire.expect({"605#" + request}); }
  void expect_done(std::size_t size) {
    EXPECT_EQ(std::exchange(calls, 0), 1);
    EXPECT_TRUE(last) << std::hex << static_cast<unsigned>(last.abort());
    EXPECT_EQ(*last, size);
    EXPECT_FALSE(sut.busy());
  }
  /// Checks the end. An abort code alone: aborted by the client.
  void expect_failed(SdoEnd end) {
    EXPECT_EQ(std::exchange(calls, 0), 1);
    EXPECT_EQ(last, end) << std::hex << static_cast<unsigned>(last.abort());
    EXPECT_FALSE(sut.busy());
  }
  void expect_waiting() {
    EXPECT_EQ(calls, 0);
    EXPECT_TRUE(sut.busy());
  }

  WireNode wire{sdo_objects(), 1};
  SdoClient sut{wire.node};
  SdoClient::Done on_done = SdoClient::Done::to<&SdoClientNode::done>(*this);
  SdoClient::Outcome last = AbortCode::none;
  int calls = 0;
  std::array<std::uint8_t, 20> bytes{};
};

}  // namespace canvoy
