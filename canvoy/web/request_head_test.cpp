#include "canvoy/web/request_head.hpp"

#include <gtest/gtest.h>

namespace canvoy::web::request_head_test {
namespace {

// 400 if HTTP/1.1 has no Host, or any request more than one (RFC 9112, 3.2).
TEST(RequestHead, HasOneHost) {
  EXPECT_EQ(fault_of({.hosts = 1}), "");
  EXPECT_NE(fault_of({.hosts = 0}), "");
  EXPECT_NE(fault_of({.hosts = 2}), "");
  EXPECT_EQ(fault_of({.is_1_1 = false, .hosts = 0}), "");
  EXPECT_NE(fault_of({.is_1_1 = false, .hosts = 2}), "");
}

TEST(RequestHead, HasAtMostOneOfEachFieldThatDecides) {
  EXPECT_EQ(fault_of({.hosts = 1, .origins = 1, .sites = 1, .authorizations = 1}), "");
  EXPECT_NE(fault_of({.hosts = 1, .origins = 2}), "");
  EXPECT_NE(fault_of({.hosts = 1, .sites = 2}), "");
  EXPECT_NE(fault_of({.hosts = 1, .authorizations = 2}), "");
  EXPECT_NE(fault_of({.hosts = 1, .types = 2}), "");
  EXPECT_NE(fault_of({.hosts = 1, .socket_keys = 2}), "");
}

// RFC 9112, 6.3: without chunked at the end the body has no certain end.
TEST(RequestHead, HasNoCodingButChunked) {
  EXPECT_EQ(fault_of({.hosts = 1, .coding = "chunked"}), "");
  EXPECT_EQ(fault_of({.hosts = 1, .coding = "Chunked"}), "");
  for (const char* coding : {"identity", "gzip, chunked", "chunked, gzip", "gzip"}) {
    EXPECT_NE(fault_of({.hosts = 1, .coding = coding}), "") << coding;
  }
}

// RFC 6455, 4.2.1; the first key is the example of RFC 6455, 1.3.
TEST(RequestHead, AKeyOfAWebSocketIsOfSixteenBytes) {
  EXPECT_TRUE(is_socket_key("dGhlIHNhbXBsZSBub25jZQ=="));
  EXPECT_TRUE(is_socket_key("AAAAAAAAAAAAAAAAAAAAAA=="));
  for (const char* text : {"", "AAAA", "dGhlIHNhbXBsZSBub25jZQ", "dGhlIHNhbXBsZSBub25jZR==",
                           "dGhlIHNhbXBsZSBub25jZQ==AAAA", "dGhlIHNhbXBsZSBub25j!Q=="}) {
    EXPECT_FALSE(is_socket_key(text)) << text;
  }
}

// A weight of 0 is "not acceptable" (RFC 9110, 12.5.3).
TEST(RequestHead, TakesGzipWhereItSaysSo) {
  for (const char* text :
       {"gzip", "gzip, deflate, br", "br, gzip;q=0.5", "deflate,\tgzip ; q=1.0"}) {
    EXPECT_TRUE(accepts_gzip(text)) << text;
  }
  for (const char* text : {"", "br", "gzip;q=0", "br, gzip;q=0.000", "xgzip", "gzipped"}) {
    EXPECT_FALSE(accepts_gzip(text)) << text;
  }
}

}  // namespace
}  // namespace canvoy::web::request_head_test
