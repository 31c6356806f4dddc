#include "canvoy/gateway/first_line.hpp"

#include <gtest/gtest.h>

namespace canvoy::gateway::first_line_test {
namespace {

std::string_view judge(std::string_view text) {
  return FirstLine().append(text);
}

TEST(GatewayFirstLine, OfABrowserIsHttp) {
  for (const char* text : {"POST / HTTP/1.1\r\n", "GET /[1] HTTP/1.1\r\n", "OPTIONS * HTTP/1.1\r\n",
                           "GET /\r\n", "PRI * HTTP/2.0\r\n", "FOO / HTTP/1.1\r\n",
                           "get / HTTP/1.0\n", "\r\n \tPUT / HTTP/1.1\n"}) {
    EXPECT_EQ(judge(text), "HTTP") << text;
  }
}

TEST(GatewayFirstLine, MayBeCutAnywhere) {
  const std::string_view text = "\r\nPOST / HTTP/1.1\r\n[1] 5 start\r\n";
  for (std::size_t cut = 0; cut <= text.size(); ++cut) {
    FirstLine first;
    const std::string_view early = first.append(text.substr(0, cut));
    EXPECT_EQ(early.empty() ? first.append(text.substr(cut)) : early, "HTTP") << cut;
  }
}

TEST(GatewayFirstLine, WithoutAnEndIsHttpWhereItBeginsWithAWord) {
  const std::string path(2000, 'a');
  EXPECT_EQ(judge("POST /" + path), "HTTP");
  EXPECT_EQ(judge("BREW /" + path + " HTTP/1.1\r\n"), "HTTP");
  EXPECT_EQ(judge("[1] 5 w 0x1008 0 vs " + path), "");
}

TEST(GatewayFirstLine, OfATlsClientIsKnownByItsFirstByte) {
  EXPECT_EQ(judge("\x16"), "TLS");
  EXPECT_EQ(judge("\x16\x03\x01\n[1] 5 start\r\n"), "TLS");
}

TEST(GatewayFirstLine, OfAClientOfCia309IsNeither) {
  for (const char* text :
       {"[1] 5 start\r\n", "# GET / HTTP/1.1\r\n", "\r\n", "start\r\n", "5 start\n",
        "info version\r\n", "[1] 5 w 0x1008 0 vs \"POST / HTTP/1.1\"\r\n"}) {
    EXPECT_EQ(judge(text), "") << text;
  }
}

TEST(GatewayFirstLine, IsTheOnlyOneThatIsJudged) {
  FirstLine first;
  EXPECT_EQ(first.append("# hello\r\nPOST / HTTP/1.1\r\n"), "");
  EXPECT_EQ(first.append("POST / HTTP/1.1\r\n"), "");
}

}  // namespace
}  // namespace canvoy::gateway::first_line_test
