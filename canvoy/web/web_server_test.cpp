// Uses real sockets on the loopback interface.
#include "canvoy/web/web_server.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <thread>
#include <utility>

#include "canvoy/web/http_client_test.hpp"

namespace canvoy::web::web_server_test {
namespace {

using testing::Client;

/// The application: the WebSocket of a client gets this number of bytes at each call.
class Application : public WebApplication {
 public:
  class Live : public LiveClient {
   public:
    explicit Live(Application& application) : application_(application) { ++application_.live; }
    ~Live() override { --application_.live; }
    Live(const Live&) = delete;
    Live& operator=(const Live&) = delete;

    std::string next() override { return application_.message; }
    bool is_behind() const override { return application_.is_behind; }
    void said(std::string_view message) override { application_.heard += message; }

   private:
    Application& application_;
  };

  std::string methods(std::string_view path) const override {
    if (path == "/api/get") return "GET, HEAD";
    if (path == "/api/post") return "POST";
    return path.starts_with("/api/") ? "GET, HEAD, POST" : "";
  }
  void answer(const WebRequest& request, Answer done) override {
    if (on_request) on_request();
    if (request.target.path == "/api/later") {
      later = std::move(done);
    } else {
      done({.body = fmt::format("{} {} {}", request.method, request.target.path, request.body) +
                    std::string(answer_size, 'x')});
    }
  }
  std::unique_ptr<LiveClient> connect(const RequestTarget&) override {
    return std::make_unique<Live>(*this);
  }

  std::string message = "{}";
  bool is_behind = false;
  std::size_t answer_size = 0;  ///< bytes in addition to the echo
  std::string heard;
  int live = 0;
  Answer later;
  std::function<void()> on_request;
};

class WebServerTest : public ::testing::Test {
 protected:
  void serve(const WebLimits& limits = {}, const std::string& at = "127.0.0.1:0") {
    loop_ = *host::EventLoop::create();
    server_ = *WebServer::create(*loop_, {.address = at, .limits = limits, .token = token_},
                                 application_);
  }
  /// Runs the client while the loop serves it.
  void play(const std::function<void()>& client) {
    std::thread thread([&] {
      client();
      loop_->stop();
    });
    loop_->run();
    thread.join();
  }
  /// Serves what has come before the client's end: that connections are gone is seen then.
  void serve_rest() { loop_->run_until(loop_->now() + Duration(50ms)); }
  std::string request(std::string_view first_line,
                      std::string_view rest = "Connection: close\r\n\r\n") {
    return fmt::format("{} HTTP/1.1\r\nHost: {}\r\nAuthorization: Bearer {}\r\n{}", first_line,
                       server_->address(), token_, rest);
  }
  std::string upgrade() {
    return request("GET /live",
                   "Upgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Version: 13\r\n"
                   "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n\r\n");
  }
  std::string answer(const std::string& text) {
    std::string all;
    play([&] {
      Client client(server_->address());
      client.say(text);
      all = client.heard();
    });
    return all;
  }

  const std::string token_ = "0123456789abcdef";
  Application application_;
  std::unique_ptr<host::EventLoop> loop_;
  std::unique_ptr<WebServer> server_;
};

bool has(std::string_view text, std::string_view part) {
  return text.find(part) != std::string_view::npos;
}

TEST_F(WebServerTest, AnswersRequestsOneAfterTheOther) {
  serve();
  std::string all;
  play([&] {
    Client client(server_->address());
    client.say(request("GET /api/a", "\r\n"));
    all = client.heard("GET /api/a ");
    client.say(request("POST /api/b",
                       "Content-Type: application/json\r\nContent-Length: 2\r\n"
                       "Connection: close\r\n\r\n{}"));
    all += client.heard();
  });
  EXPECT_TRUE(has(all, "GET /api/a ")) << all;
  EXPECT_TRUE(has(all, "POST /api/b {}")) << all;
}

// All of 127.0.0.0/8 is this machine.
TEST_F(WebServerTest, AnswersAtTheAddressThatItTells) {
  serve({}, "127.0.0.2:0");
  EXPECT_TRUE(has(answer(request("GET /api/a")), "GET /api/a "));
  const std::string foreign =
      "GET /api/a HTTP/1.1\r\nHost: evil.example\r\nConnection: close\r\n\r\n";
  EXPECT_TRUE(has(answer(foreign), "HTTP/1.1 403 "));
}

TEST_F(WebServerTest, AnAnswerMayComeLaterOrWhenNobodyWaitsAnyMore) {
  serve();
  std::string all;
  const std::function<void(Time)> tell = [&](Time now) {
    if (application_.later) return application_.later({.body = "late"});
    loop_->at(now + Duration(10ms), tell);  // it was not called yet
  };
  loop_->at(loop_->now() + Duration(30ms), tell);
  play([&] {
    Client client(server_->address());
    client.say(request("GET /api/later"));
    all = client.heard();
  });
  EXPECT_TRUE(has(all, "late"));
  play([&] { Client(server_->address()).say(request("GET /api/later")); });
  play([] {});
  if (application_.later) application_.later({.body = "nobody"});
  play([] {});
}

TEST_F(WebServerTest, WhoWaitsTooLongIsTold) {
  serve({.idle_time_out = 200ms});
  std::string all;
  play([&] {
    Client client(server_->address());
    client.say(request("GET /api/later", "\r\n") + request("GET /api/a", "\r\n"));
    all = client.heard();
  });
  EXPECT_TRUE(all.starts_with("HTTP/1.1 504 ")) << all;
  EXPECT_FALSE(has(all, "GET /api/a ")) << "a late answer would be taken for this one's";
  ASSERT_TRUE(application_.later);
  application_.later({.body = "late"});
}

// RFC 9110, 10.2.1 and 15.5.6
TEST_F(WebServerTest, MethodsAreThoseOfTheApplication) {
  serve();
  const std::string json = "Content-Type: application/json\r\nContent-Length: 2\r\n";
  const std::string body = json + "Connection: close\r\n\r\n{}";
  EXPECT_TRUE(has(answer(request("POST /api/post", body)), "HTTP/1.1 200 "));
  EXPECT_TRUE(has(answer(request("GET /api/post")), "HTTP/1.1 405 "));
  EXPECT_TRUE(has(answer(request("GET /api/post")), "Allow: POST\r\n"));
  EXPECT_TRUE(has(answer(request("HEAD /api/get")), "HTTP/1.1 200 "));
  EXPECT_TRUE(has(answer(request("POST /api/get", body)), "Allow: GET, HEAD\r\n"));
  EXPECT_TRUE(has(answer(request("PUT /page.js", body)), "Allow: GET, HEAD\r\n"));
  EXPECT_TRUE(has(answer(request("POST /nothing", body)), "HTTP/1.1 404 "));
}

// The key of the example, and its answer (RFC 6455, 1.3).
TEST_F(WebServerTest, OpensAWebSocketAndTellsTheFirstMessageAtOnce) {
  serve();
  std::string all;
  play([&] {
    Client client(server_->address());
    client.say(upgrade());
    all = client.heard("{}");
    // "Hello", masked (RFC 6455, 5.7).
    client.say("\x81\x85\x37\xfa\x21\x3d\x7f\x9f\x4d\x51\x58");
    all += client.heard("{}");
  });
  EXPECT_TRUE(has(all, "s3pPLMBiTxaQ9kYGzzhZRbK+xOo=")) << all;
  EXPECT_TRUE(has(all, "\x81\x02{}"));
  EXPECT_EQ(application_.heard, "Hello");
}

TEST_F(WebServerTest, WhoReadsNothingIsLetGo) {
  serve({.send_buffer = 4096, .message_time_out = 200ms});
  application_.message = std::string(8 << 20, 'x');
  std::string all;
  play([&] {
    Client client(server_->address());
    client.say(upgrade());
    std::this_thread::sleep_for(std::chrono::milliseconds(2500));
    all = client.heard();
  });
  EXPECT_NE(all, "timed out");
  EXPECT_LT(all.size(), application_.message.size());
  serve_rest();
  EXPECT_EQ(application_.live, 0);
}

TEST_F(WebServerTest, WhoNeverEndsHisRequestIsLetGo) {
  serve({.request_time_out = 200ms});
  EXPECT_NE(answer("GET / HTTP/1.1\r\nHost: "), "timed out");
}

TEST_F(WebServerTest, WhoTricklesHisRequestIsLetGo) {
  serve({.request_time_out = 300ms});
  std::string all;
  int said = 0;
  play([&] {
    Client client(server_->address());
    client.say("GET /api/a HTTP/1.1\r\nX: ");
    // Each byte comes soon after the previous one, for ten times the permitted time.
    for (; said < 60 && client.try_say("x"); ++said) {
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
    all = client.heard();
  });
  EXPECT_LT(said, 60);
  EXPECT_FALSE(has(all, "200 OK"));
}

// A message may come in any number of frames (RFC 6455, 5.4).
TEST_F(WebServerTest, AMessageThatNeverEndsHasAnEnd) {
  serve({.body_max = 1000});
  std::string all;
  play([&] {
    Client client(server_->address());
    client.say(upgrade());
    client.heard("{}");
    const std::string first = "\x01\xfd" + std::string(4, '\0') + std::string(125, 'x');
    const std::string more =
        std::string(1, '\0') + "\xfd" + std::string(4, '\0') + std::string(125, 'x');
    client.say(first);
    for (int i = 0; i < 20 && client.try_say(more); ++i) {
    }
    all = client.heard();
  });
  EXPECT_NE(all, "timed out");
  EXPECT_EQ(application_.heard, "");
  serve_rest();
  EXPECT_EQ(application_.live, 0);
}

TEST_F(WebServerTest, AFrameThatNeverEndsKeepsNobodyWaiting) {
  serve();
  std::string all;
  play([&] {
    Client half(server_->address());
    half.say(upgrade());
    half.heard("{}");
    half.say(std::string("\x81\xfe\xff\xff", 4) + std::string(4, '\0') + "x");
    Client other(server_->address());
    other.say(request("GET /api/a"));
    all = other.heard();
  });
  EXPECT_TRUE(has(all, "GET /api/a ")) << all;
}

TEST_F(WebServerTest, WhoAsksWithoutEndLeavesTheLoopToOthers) {
  serve();
  constexpr int many = 5000;
  Client client(server_->address());
  const std::string next = request("GET /api/a", "\r\n");
  int asked = 0;
  // Each request arrives before the previous one is answered: the server is never idle.
  application_.on_request = [&] {
    client.forget_heard();
    if (++asked == many) return loop_->stop();
    client.say(next);
  };
  client.say(next);
  int turns = 0;
  std::function<void(Time)> count = [&](Time now) {
    ++turns;
    loop_->at(now, count);
  };
  count(loop_->now());
  loop_->run_until(loop_->now() + Duration(60s));
  EXPECT_EQ(asked, many);
  EXPECT_GT(turns, many / 100);
}

// Each is answered with a pong (RFC 6455, 5.5.2).
TEST_F(WebServerTest, WhoPingsTooMuchIsLetGo) {
  serve({.said_max_per_second = 10});
  std::string all;
  play([&] {
    Client client(server_->address());
    client.say(upgrade());
    client.heard("{}");
    const std::string ping = "\x89\x80" + std::string(4, '\0');
    for (int i = 0; i < 200 && client.try_say(ping); ++i) continue;
    all = client.heard();
  });
  EXPECT_NE(all, "timed out");
  serve_rest();
  EXPECT_EQ(application_.live, 0);
}

TEST_F(WebServerTest, APingIsAnswered) {
  serve();
  std::string all;
  play([&] {
    Client client(server_->address());
    client.say(upgrade());
    client.heard("{}");
    client.say("\x89\x81" + std::string(4, '\0') + "a");
    all = client.heard("a");
  });
  EXPECT_EQ(all, "\x8a\1a");
}

TEST_F(WebServerTest, ANewcomerTakesThePlaceOfWhoIsThereLongestWithoutAWebSocket) {
  serve({.clients_max = 2});
  std::string first;
  std::string third;
  play([&] {
    Client live(server_->address());
    live.say(upgrade());
    live.heard("{}");
    Client idle(server_->address());
    idle.say("GET");
    Client newcomer(server_->address());
    newcomer.say(request("GET /api/c"));
    third = newcomer.heard();
    first = idle.heard();
  });
  EXPECT_TRUE(has(third, "GET /api/c ")) << third;
  EXPECT_EQ(first, "");
}

TEST_F(WebServerTest, WithoutTheTokenNothingIsAnswered) {
  serve();
  const std::string head = fmt::format("Host: {}\r\nConnection: close\r\n\r\n", server_->address());
  for (const char* target : {"/api/a", "/", "/page.js", "/live", "/api/a?token=x"}) {
    EXPECT_TRUE(has(answer(fmt::format("GET {} HTTP/1.1\r\n{}", target, head)), "HTTP/1.1 403 "))
        << target;
  }
  const std::string page =
      answer(fmt::format("GET /?token={} HTTP/1.1\r\n{}", server_->token(), head));
  EXPECT_TRUE(has(page, "HTTP/1.1 200 ")) << page;
  EXPECT_TRUE(has(page, fmt::format("={}; HttpOnly; SameSite=Strict; Path=/", token_))) << page;
}

// An image of a foreign page has no Origin; present browsers send the relation of the requesting
// page.
TEST_F(WebServerTest, WhatAForeignPageLoadsIsRefused) {
  serve();
  const std::string foreign = "Sec-Fetch-Site: cross-site\r\nConnection: close\r\n\r\n";
  EXPECT_TRUE(has(answer(request("GET /api/a", foreign)), "HTTP/1.1 403 "));
  EXPECT_TRUE(has(answer(request("GET /live", foreign)), "HTTP/1.1 403 "));
  EXPECT_TRUE(has(answer(request("GET /", foreign)), "HTTP/1.1 200 ")) << "a link to the page";
}

// RFC 9112, 3.2 and RFC 9110, 10.1.1
TEST_F(WebServerTest, HeadsThatCanBeReadInTwoWaysAreRefused) {
  serve();
  const std::string host = fmt::format("Host: {}\r\n", server_->address());
  const std::string close = "Connection: close\r\n\r\n";
  EXPECT_TRUE(has(answer(request("GET /api/a", host + close)), "HTTP/1.1 400 "));
  EXPECT_TRUE(has(answer("GET /api/a HTTP/1.1\r\n" + close), "HTTP/1.1 400 "));
  EXPECT_TRUE(
      has(answer(request("GET /api/a", "Origin: a\r\nOrigin: b\r\n" + close)), "HTTP/1.1 400 "));
  EXPECT_TRUE(has(answer(request("POST /api/a", "Expect: more\r\nContent-Length: 2\r\n" + close)),
                  "HTTP/1.1 417 "));
  std::string upgrading = upgrade();
  upgrading.replace(upgrading.find("dGhl"), 24, "AAAA");
  upgrading.replace(upgrading.find("Connection: Upgrade"), 19, "Connection: Upgrade, close");
  EXPECT_TRUE(has(answer(upgrading), "HTTP/1.1 400 "));
}

TEST_F(WebServerTest, WhoExpectsToBeToldToGoOnIsTold) {
  serve();
  std::string all;
  play([&] {
    Client client(server_->address());
    client.say(request("POST /api/b",
                       "Content-Type: application/json\r\nContent-Length: 2\r\n"
                       "Expect: 100-continue\r\nConnection: close\r\n\r\n"));
    all = client.heard("\r\n\r\n");
    client.say("{}");
    all += client.heard();
  });
  EXPECT_TRUE(all.starts_with("HTTP/1.1 100 ")) << all;
  EXPECT_TRUE(has(all, "POST /api/b {}")) << all;
}

TEST_F(WebServerTest, TheHostOfTheAbsoluteFormCounts) {
  serve();
  const std::string own = fmt::format("GET http://{}/api/a", server_->address());
  EXPECT_TRUE(has(answer(request(own)), "GET /api/a "));
  EXPECT_TRUE(has(answer(request("GET http://evil.example/api/a")), "HTTP/1.1 403 "));
}

TEST_F(WebServerTest, AViewerTakesThePlaceOfTheOneThatHasSaidNothingForLongest) {
  serve({.live_clients_max = 2});
  std::string silent_heard;
  std::string newcomer_heard;
  play([&] {
    Client silent(server_->address());
    silent.say(upgrade());
    silent.heard("{}");
    Client other(server_->address());
    other.say(upgrade());
    other.heard("{}");
    other.say("\x81\x85\x37\xfa\x21\x3d\x7f\x9f\x4d\x51\x58");
    other.heard("{}");
    Client newcomer(server_->address());
    newcomer.say(upgrade());
    newcomer_heard = newcomer.heard("{}");
    silent_heard = silent.heard("\x03\xf5");  // 1013, try again later (RFC 6455, 7.4)
  });
  EXPECT_TRUE(has(newcomer_heard, "HTTP/1.1 101 ")) << newcomer_heard;
  EXPECT_TRUE(has(silent_heard, "\x88")) << silent_heard;
}

TEST_F(WebServerTest, WhoTakesNothingLeavesWhereOthersNeedTheBudget) {
  serve({.send_buffer = 4096, .unread_max = 1 << 20, .unread_for_others = 0s});
  application_.answer_size = 800 << 10;
  std::string first_heard;
  std::string second;
  play([&] {
    Client first(server_->address());
    first.say(request("GET /api/a"));
    first_heard = first.heard("HTTP/1.1 200 ");
    Client other(server_->address());
    other.say(request("GET /api/a"));
    second = other.heard();
    first_heard += first.heard();
  });
  EXPECT_TRUE(has(second, "HTTP/1.1 200 ")) << second.substr(0, 200);
  EXPECT_LT(first_heard.size(), std::size_t{800} << 10) << "it was cut";
}

TEST_F(WebServerTest, AnswersThatNobodyTakesHaveABudget) {
  serve({.send_buffer = 4096, .unread_max = 1 << 20, .unread_for_others = 1h});
  application_.answer_size = 800 << 10;
  std::string second;
  play([&] {
    Client first(server_->address());
    first.say(request("GET /api/a"));
    first.heard("HTTP/1.1 200 ");  // and no more
    Client other(server_->address());
    other.say(request("GET /api/a"));
    second = other.heard();
  });
  EXPECT_TRUE(has(second, "HTTP/1.1 503 ")) << second.substr(0, 200);
  EXPECT_TRUE(has(second, "Retry-After: 1"));
  application_.answer_size = 0;
  EXPECT_TRUE(has(answer(request("GET /api/a")), "GET /api/a "));
}

TEST_F(WebServerTest, OneClientHasABudgetToo) {
  serve({.answer_max = 1000});
  application_.answer_size = 1000;
  EXPECT_TRUE(has(answer(request("GET /api/a")), "HTTP/1.1 500 "));
  application_.answer_size = 900;
  EXPECT_TRUE(has(answer(request("GET /api/a")), "HTTP/1.1 200 "));
  application_.message = std::string(1001, 'x');
  EXPECT_FALSE(has(answer(upgrade()), "xxx"));
  application_.message = std::string(1000, 'x');
  std::string heard;
  play([&] {
    Client client(server_->address());
    client.say(upgrade());
    heard = client.heard("xxx");
  });
  EXPECT_TRUE(has(heard, "xxx")) << heard;
}

TEST_F(WebServerTest, ThePageIsCompressedAndNotSentTwice) {
  serve();
  const std::string close = "Connection: close\r\n\r\n";
  const std::string plain = answer(request("GET /page.js"));
  const std::string small = answer(request("GET /page.js", "Accept-Encoding: gzip\r\n" + close));
  EXPECT_FALSE(has(plain, "Content-Encoding"));
  EXPECT_TRUE(has(small, "Content-Encoding: gzip"));
  EXPECT_LT(small.size() * 2, plain.size());
  const std::size_t tag = plain.find("ETag: ") + 6;
  const std::string known = plain.substr(tag, plain.find('\r', tag) - tag);
  const std::string again =
      answer(request("GET /page.js", fmt::format("If-None-Match: {}\r\n{}", known, close)));
  EXPECT_TRUE(has(again, "HTTP/1.1 304 ")) << again.substr(0, 100);
  EXPECT_LT(again.size(), 1000U);
}

TEST_F(WebServerTest, EndsWhileClientsAreThere) {
  serve();
  application_.message = std::string(8 << 20, 'x');
  Client client(server_->address());
  Client idle(server_->address());
  client.say(upgrade());
  serve_rest();
  EXPECT_EQ(application_.live, 1);
  server_.reset();
  EXPECT_EQ(application_.live, 0);
}

}  // namespace
}  // namespace canvoy::web::web_server_test
