// Requests as RFC 9110 and RFC 9112 have them.
#include "canvoy/tools/run/http_request.hpp"

#include <gtest/gtest.h>

#include <string>

namespace canvoy::tools::http_request_test {
namespace {

/// 0: more is waited for.
int status_of(std::string_view text) {
  HttpRequest request;
  return request.append(text) ? static_cast<int>(request.status()) : 0;
}

TEST(HttpRequest, GetAndHeadOfAnyPathAreAnswered) {
  EXPECT_EQ(status_of("GET / HTTP/1.1\r\nHost: bus\r\n\r\n"), 200);
  EXPECT_EQ(status_of("GET /vehicle-positions.pb?key=1 HTTP/1.1\r\nhost:bus:80\r\nA: b\r\n\r\n"),
            200);
  EXPECT_EQ(status_of("GET http://bus/feed HTTP/1.1\r\nHost: bus\r\n\r\n"), 200);
  HttpRequest head;
  EXPECT_TRUE(head.append("HEAD / HTTP/1.1\r\nHOST: bus\r\n\r\n"));
  EXPECT_EQ(head.status(), HttpStatus::ok);
  EXPECT_TRUE(head.is_head());
}

TEST(HttpRequest, LinesMayEndWithLineFeedAloneAndAnEmptyOneMayComeFirst) {
  EXPECT_EQ(status_of("GET / HTTP/1.1\nHost: bus\n\n"), 200);
  EXPECT_EQ(status_of("\r\n\r\nGET / HTTP/1.1\r\nHost: bus\r\n\r\n"), 200);
}

TEST(HttpRequest, AVersionBeforeHostsNeedsNone) {
  EXPECT_EQ(status_of("GET / HTTP/1.0\r\n\r\n"), 200);
  EXPECT_EQ(status_of("GET / HTTP/1.1\r\n\r\n"), 400);
  EXPECT_EQ(status_of("GET / HTTP/1.1\r\nHost: a\r\nHost: b\r\n\r\n"), 400);
}

TEST(HttpRequest, OtherMethodsAreNotAllowed) {
  for (const char* const method : {"POST", "PUT", "DELETE", "OPTIONS", "get", "M-SEARCH"}) {
    EXPECT_EQ(status_of(std::string(method) + " / HTTP/1.1\r\nHost: bus\r\n\r\n"), 405) << method;
  }
}

TEST(HttpRequest, OtherVersionsAreNotSupported) {
  EXPECT_EQ(status_of("PRI * HTTP/2.0\r\n\r\n"), 505);
  EXPECT_EQ(status_of("GET / HTTP/1.9\r\nHost: bus\r\n\r\n"), 200) << "is one of 1";
}

TEST(HttpRequest, WhatIsNoneIsBad) {
  for (const std::string text : {
           "GET /\r\n\r\n",
           "GET / HTTP/1\r\n\r\n",
           "GET / HTTP/x.y\r\n\r\n",
           "GET / FTP/1.1\r\n\r\n",
           "GET  HTTP/1.1\r\n\r\n",
           "GET /a b HTTP/1.1\r\nHost: bus\r\n\r\n",
           "GET /\x01 HTTP/1.1\r\nHost: bus\r\n\r\n",
           "GET /\xC3\xBC HTTP/1.1\r\nHost: bus\r\n\r\n",
           "GET / HTTP/1.1\r\nHost: bus\r\nnothing\r\n\r\n",
           "GET / HTTP/1.1\r\nHost : bus\r\n\r\n",
           "GET / HTTP/1.1\r\nHost: bus\r\n folded: line\r\n\r\n",
           "GET / HTTP/1.1\r\nHost: b\rus\r\n\r\n",
           "GET / HTTP/1.1\r\n: bus\r\n\r\n",
       }) {
    EXPECT_EQ(status_of(text), 400) << text;
  }
  using std::string_literals::operator""s;
  EXPECT_EQ(status_of("GET / HTTP/1.1\r\nHost: b\0us\r\n\r\n"s), 400);
}

TEST(HttpRequest, WhatCannotBecomeOneIsBadAtOnce) {
  EXPECT_EQ(status_of("\x16\x03\x01"), 400) << "TLS";
  EXPECT_EQ(status_of(" "), 400);
  EXPECT_EQ(status_of("\xFF"), 400);
}

TEST(HttpRequest, ItMayComeInPieces) {
  HttpRequest request;
  const std::string text = "GET / HTTP/1.1\r\nHost: bus\r\n\r\n";
  EXPECT_FALSE(request.has_begun());
  for (std::size_t at = 0; at + 1 < text.size(); ++at) {
    EXPECT_FALSE(request.append(text.substr(at, 1))) << at;
    EXPECT_TRUE(request.has_begun());
  }
  EXPECT_TRUE(request.append("\n"));
  EXPECT_EQ(request.status(), HttpStatus::ok);
}

TEST(HttpRequest, WhatComesBehindItChangesNothing) {
  HttpRequest request;
  EXPECT_TRUE(request.append("GET / HTTP/1.1\r\nHost: bus\r\n\r\nPOST / HTTP/1.1\r\n\r\n"));
  EXPECT_TRUE(request.append("DELETE / HTTP/1.1\r\n\r\n"));
  EXPECT_EQ(request.status(), HttpStatus::ok);
}

TEST(HttpRequest, OneThatIsTooLongIsRefused) {
  const std::string begin = "GET / HTTP/1.1\r\nHost: bus\r\nX: ";
  const std::string end = "\r\n\r\n";
  const std::string filled(HttpRequest::bytes_max - begin.size() - end.size(), 'x');
  EXPECT_EQ(status_of(begin + filled + end), 200);
  EXPECT_EQ(status_of(begin + filled + "x" + end), 431);
  EXPECT_EQ(status_of(std::string(HttpRequest::bytes_max, 'A')), 0);
  EXPECT_EQ(status_of(std::string(HttpRequest::bytes_max + 1, 'A')), 431);
}

}  // namespace
}  // namespace canvoy::tools::http_request_test
