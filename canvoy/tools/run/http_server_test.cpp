// Over real sockets on the loopback interface.
#include "canvoy/tools/run/http_server.hpp"

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/time.h>

#include <deque>
#include <thread>

#include "canvoy/can/host/descriptor.hpp"
#include "canvoy/gateway/tcp_address.hpp"

namespace canvoy::tools::http_server_test {
namespace {

constexpr std::string_view get = "GET /any HTTP/1.1\r\nHost: bus\r\n\r\n";

/// A client program that waits for ten seconds at most.
class Client {
 public:
  explicit Client(const HttpServer& server) {
    const timeval patience{.tv_sec = 10, .tv_usec = 0};
    ::setsockopt(socket_.get(), SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
    const auto address = gateway::parse_tcp_address(server.address());
    EXPECT_EQ(::connect(socket_.get(), address->get(), address->length), 0);
  }

  void say(std::string_view text) {
    EXPECT_EQ(::send(socket_.get(), text.data(), text.size(), MSG_NOSIGNAL),
              static_cast<ssize_t>(text.size()));
  }
  void end_output() { ::shutdown(socket_.get(), SHUT_WR); }
  /// All that comes until the server ends the connection; `timed out` where it does not.
  std::string heard() {
    std::string text;
    std::array<char, 4096> bytes;
    ssize_t size = 0;
    while ((size = ::recv(socket_.get(), bytes.data(), bytes.size(), 0)) > 0) {
      text.append(bytes.data(), static_cast<std::size_t>(size));
    }
    const bool is_over = size == 0 || errno == ECONNRESET;
    return is_over ? text : "timed out";
  }

 private:
  host::Descriptor socket_{::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)};
};

std::unique_ptr<HttpServer> served(std::string content, const HttpLimits& limits = {}) {
  return *HttpServer::create("127.0.0.1:0", "application/x-protobuf", std::move(content), limits);
}

std::string answer(const HttpServer& server, std::string_view request) {
  Client client(server);
  client.say(request);
  return client.heard();
}

bool has(const std::string& text, std::string_view part) {
  return text.find(part) != text.npos;
}

std::string content_of(const std::string& text) {
  return text.substr(text.find("\r\n\r\n") + 4);
}

/// Waits for ten seconds at most.
template <class Condition>
bool until(Condition condition) {
  for (int tries = 0; tries < 10'000 && !condition(); ++tries) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return condition();
}

TEST(HttpServer, TheNewestContentIsServed) {
  const auto server = served(std::string("a\0\r\n\r\nb", 7));
  const std::string first = answer(*server, get);
  EXPECT_TRUE(first.starts_with("HTTP/1.1 200 OK\r\n")) << first;
  EXPECT_TRUE(has(first, "\r\nContent-Type: application/x-protobuf\r\n")) << first;
  EXPECT_TRUE(has(first, "\r\nContent-Length: 7\r\n")) << first;
  EXPECT_TRUE(has(first, "\r\nConnection: close\r\n")) << first;
  EXPECT_EQ(content_of(first), std::string("a\0\r\n\r\nb", 7));
  server->publish("newer");
  EXPECT_EQ(content_of(answer(*server, get)), "newer");
}

// RFC 9110, 9.3.2.
TEST(HttpServer, HeadTellsTheLengthAndNoContent) {
  const auto server = served("content");
  const std::string heard = answer(*server, "HEAD / HTTP/1.1\r\nHost: bus\r\n\r\n");
  EXPECT_TRUE(has(heard, "\r\nContent-Length: 7\r\n")) << heard;
  EXPECT_EQ(content_of(heard), "");
}

TEST(HttpServer, WhatIsNotServedIsToldByItsStatus) {
  const auto server = served("content");
  const std::string post = answer(*server, "POST / HTTP/1.1\r\nHost: bus\r\n\r\n");
  EXPECT_TRUE(post.starts_with("HTTP/1.1 405 Method Not Allowed\r\n")) << post;
  EXPECT_TRUE(has(post, "\r\nAllow: GET, HEAD\r\n")) << post;
  EXPECT_TRUE(answer(*server, "hello\r\n\r\n").starts_with("HTTP/1.1 400 Bad Request\r\n"));
  const std::string large = answer(*server, std::string(9000, 'A'));
  EXPECT_TRUE(large.starts_with("HTTP/1.1 431 ")) << large;
  EXPECT_EQ(content_of(answer(*server, get)), "content");
}

TEST(HttpServer, AClientThatEndsItsHalfHearsTheAnswer) {
  const auto server = served("content");
  Client client(*server);
  client.say(get);
  client.end_output();
  EXPECT_EQ(content_of(client.heard()), "content");
  EXPECT_TRUE(until([&] { return server->clients() == 0; }));
}

TEST(HttpServer, MoreThanASocketTakesComesWhole) {
  std::string content;
  content.resize(20'000'000, 'x');
  const auto server = served(content);
  EXPECT_TRUE(content_of(answer(*server, get)) == content);
}

TEST(HttpServer, WhatIsSentBehindTheRequestDoesNotTakeTheAnswerAlong) {
  const auto server = served("content");
  Client client(*server);
  client.say("POST / HTTP/1.1\r\nHost: bus\r\nContent-Length: 1000000\r\n\r\n");
  client.say(std::string(1'000'000, 'x'));
  EXPECT_TRUE(client.heard().starts_with("HTTP/1.1 405 "));
}

TEST(HttpServer, WhoDoesNotComeToAnEndIsSentAway) {
  const auto server = served("content", {.time_out = 500ms});
  Client silent(*server);
  Client slow(*server);
  slow.say("GET / HT");
  Client deaf(*server);  // hears nothing, and does not go
  deaf.say(get);
  EXPECT_TRUE(slow.heard().starts_with("HTTP/1.1 408 Request Timeout\r\n"));
  EXPECT_EQ(silent.heard(), "");
  EXPECT_TRUE(until([&] { return server->clients() == 0; }));
}

TEST(HttpServer, TheOldestGivesItsPlaceToANewcomer) {
  const auto server = served("content", {.clients_max = 3});
  std::deque<Client> idle;
  for (int i = 0; i < 10; ++i) idle.emplace_back(*server);
  EXPECT_EQ(content_of(answer(*server, get)), "content");
  EXPECT_LE(server->clients(), 3U);
  EXPECT_EQ(idle.front().heard(), "");
}

TEST(HttpServer, ItEndsWhileClientsAreThere) {
  std::string content;
  content.resize(20'000'000, 'x');
  auto server = served(content);
  Client idle(*server);
  Client reading(*server);
  reading.say(get);
  EXPECT_TRUE(until([&] { return server->clients() == 2; }));
  server.reset();
  EXPECT_EQ(idle.heard(), "");
}

TEST(HttpServer, APortThatIsTakenIsRefused) {
  const auto server = served("content");
  const auto other = HttpServer::create(server->address(), "text/plain", "");
  ASSERT_FALSE(other);
  EXPECT_EQ(other.error().line(),
            server->address() + ": Address already in use; choose another address or port");
}

}  // namespace
}  // namespace canvoy::tools::http_server_test
