// Uses real sockets on the loopback interface.
#include "canvoy/web/document_server.hpp"

#include <gtest/gtest.h>

#include "canvoy/web/http_client_test.hpp"

namespace canvoy::web::document_server_test {
namespace {

using testing::Client;

constexpr std::string_view get = "GET /any HTTP/1.1\r\nHost: bus\r\nConnection: close\r\n\r\n";

std::string address_of(const DocumentServer& server) {
  constexpr std::string_view scheme = "http://";
  const std::string url = server.url();
  return url.substr(scheme.size(), url.size() - scheme.size() - 1);
}

std::unique_ptr<DocumentServer> served(std::string content) {
  return *DocumentServer::create("127.0.0.1:0", "application/x-protobuf", std::move(content));
}

std::string answer(const DocumentServer& server, std::string_view request) {
  Client client(address_of(server));
  client.say(request);
  return client.heard();
}

bool has(const std::string& text, std::string_view part) {
  return text.find(part) != std::string::npos;
}

std::string content_of(const std::string& text) {
  return text.substr(text.find("\r\n\r\n") + 4);
}

TEST(DocumentServer, ServesTheNewestContent) {
  const auto server = served(std::string("a\0\r\n\r\nb", 7));
  const std::string first = answer(*server, get);
  EXPECT_TRUE(first.starts_with("HTTP/1.1 200 OK\r\n")) << first;
  EXPECT_TRUE(has(first, "\r\nContent-Type: application/x-protobuf\r\n")) << first;
  EXPECT_TRUE(has(first, "\r\nContent-Length: 7\r\n")) << first;
  EXPECT_EQ(content_of(first), std::string("a\0\r\n\r\nb", 7));
  server->publish("newer");
  EXPECT_EQ(content_of(answer(*server, get)), "newer");
}

// No page, no live connection, and no token.
TEST(DocumentServer, ServesNothingElse) {
  const auto server = served("content");
  EXPECT_EQ(server->url().find("token"), std::string::npos);
  for (const std::string path : {"/", "/index.html", "/app.js", "/live", "/openapi.json"}) {
    const std::string request =
        "GET " + path + " HTTP/1.1\r\nHost: x\r\nOrigin: http://other\r\nConnection: close\r\n\r\n";
    EXPECT_EQ(content_of(answer(*server, request)), "content") << path;
  }
}

// RFC 9110, 9.3.2.
TEST(DocumentServer, HeadTellsTheLengthAndNoContent) {
  const auto server = served("content");
  const std::string heard =
      answer(*server, "HEAD / HTTP/1.1\r\nHost: bus\r\nConnection: close\r\n\r\n");
  EXPECT_TRUE(has(heard, "\r\nContent-Length: 7\r\n")) << heard;
  EXPECT_EQ(content_of(heard), "");
}

TEST(DocumentServer, WhatIsNotServedIsToldByItsStatus) {
  const auto server = served("content");
  const std::string post = answer(
      *server, "POST / HTTP/1.1\r\nHost: bus\r\nContent-Length: 2\r\nConnection: close\r\n\r\n{}");
  EXPECT_TRUE(post.starts_with("HTTP/1.1 405 Method Not Allowed\r\n")) << post;
  EXPECT_TRUE(has(post, "\r\nAllow: GET, HEAD\r\n")) << post;
  EXPECT_TRUE(answer(*server, "hello\r\n\r\n").starts_with("HTTP/1.1 400 Bad Request\r\n"));
  const std::string large = answer(*server, "GET / HTTP/1.1\r\nA: " + std::string(9000, 'A'));
  EXPECT_TRUE(large.starts_with("HTTP/1.1 431 ")) << large;
  EXPECT_EQ(content_of(answer(*server, get)), "content");
}

TEST(DocumentServer, MoreThanASocketTakesComesWhole) {
  const std::string content(20'000'000, 'x');
  const auto server = served(content);
  EXPECT_TRUE(content_of(answer(*server, get)) == content);
}

TEST(DocumentServer, EndsWhileClientsAreThere) {
  auto server = served(std::string(20'000'000, 'x'));
  Client idle(address_of(*server));
  Client reading(address_of(*server));
  reading.say(get);
  EXPECT_TRUE(has(reading.heard("\r\n\r\n"), " 200 "));
  server.reset();
  EXPECT_EQ(idle.heard(), "");
}

TEST(DocumentServer, APortThatIsTakenIsRefused) {
  const auto server = served("content");
  const std::string address = address_of(*server);
  const auto other = DocumentServer::create(address, "text/plain", "");
  ASSERT_FALSE(other);
  EXPECT_EQ(other.error().line(),
            address + ": Address already in use; choose another address or port");
}

}  // namespace
}  // namespace canvoy::web::document_server_test
