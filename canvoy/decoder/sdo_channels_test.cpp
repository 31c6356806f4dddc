#include "canvoy/decoder/sdo_channels.hpp"

#include <gtest/gtest.h>

#include <string>

namespace canvoy::decoder::sdo_channels_test {
namespace {

/// `channel client>server`, followed by `?` for a request.
std::string route(const SdoChannels& channels, std::uint32_t can_id, bool has_car = false) {
  const std::optional<SdoRoute> found = channels.find(can_id, has_car);
  if (!found) return "none";
  return std::to_string(found->channel) + ' ' + std::to_string(found->client) + '>' +
         std::to_string(found->server) + (found->is_request ? "?" : "");
}

// 600h and 580h plus node-ID (CiA 301, 7.3.3).
TEST(SdoChannels, AreTheDefaultOneOfEachNode) {
  const SdoChannels sut;
  EXPECT_EQ(route(sut, 0x605), std::to_string(0x605) + " 0>5?");
  EXPECT_EQ(route(sut, 0x585), std::to_string(0x605) + " 0>5");
  EXPECT_EQ(route(sut, 0x600), "none");
  EXPECT_EQ(route(sut, 0x700), "none");
}

// COB-ID client to server, COB-ID server to client, node-ID of the client (CiA 301, 7.5.2.33).
TEST(SdoChannels, AreThoseOfServerParametersOnceBothDirectionsAreKnown) {
  SdoChannels sut;
  sut.learn(7, 0x1201, 1, 0x6E1);
  EXPECT_EQ(route(sut, 0x6E1), "none");
  sut.learn(7, 0x1201, 2, 0x6E2);
  EXPECT_EQ(route(sut, 0x6E1), std::to_string(0x6E1) + " 0>7?");
  EXPECT_EQ(route(sut, 0x6E2), std::to_string(0x6E1) + " 0>7");
  sut.learn(7, 0x1201, 3, 4);
  EXPECT_EQ(route(sut, 0x6E2), std::to_string(0x6E1) + " 4>7");
  sut.learn(7, 0x1201, 1, 0x8000'06E1);  // invalid
  EXPECT_EQ(route(sut, 0x6E1), "none");
}

// For a client, the node-ID is that of its server (CiA 301, 7.5.2.34).
TEST(SdoChannels, AreThoseOfClientParametersOnceTheServerIsKnown) {
  SdoChannels sut;
  sut.learn(4, 0x1280, 1, 0x6E1);
  sut.learn(4, 0x1280, 2, 0x6E2);
  EXPECT_EQ(route(sut, 0x6E1), "none");
  sut.learn(4, 0x1280, 3, 7);
  EXPECT_EQ(route(sut, 0x6E1), std::to_string(0x6E1) + " 4>7?");
}

TEST(SdoChannels, AreForgottenWithTheirNode) {
  SdoChannels sut;
  sut.learn(7, 0x1201, 1, 0x6E1);
  sut.learn(7, 0x1201, 2, 0x6E2);
  sut.forget(8);
  EXPECT_NE(route(sut, 0x6E1), "none");
  sut.forget(7);
  EXPECT_EQ(route(sut, 0x6E1), "none");
  EXPECT_EQ(route(sut, 0x6E2), "none");
}

// Node 2 sends requests to node 7 on 256h, and gets answers on 1D6h (CiA 447-4, public facts).
TEST(SdoChannels, AreTheMeshOfACarOnly) {
  const SdoChannels sut;
  EXPECT_EQ(route(sut, 0x256), "none");
  EXPECT_EQ(route(sut, 0x256, true), std::to_string(0x256) + " 2>7?");
  EXPECT_EQ(route(sut, 0x1D6, true), std::to_string(0x256) + " 2>7");
}

}  // namespace
}  // namespace canvoy::decoder::sdo_channels_test
