// Untrusted bytes to the port of the page: HTTP requests, frames of an open WebSocket, and others.
// For any bytes, the server releases the client when it leaves, keeps nothing of it, and answers
// the next one. The first byte selects the action of the client; `@` in a request is the address of
// the server with the token.
#include <sys/socket.h>

#include <array>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <string>
#include <string_view>

#include "canvoy/can/host/descriptor.hpp"
#include "canvoy/can/host/event_loop.hpp"
#include "canvoy/gateway/tcp_address.hpp"
#include "canvoy/web/web_server.hpp"
#include "require.hpp"

namespace {

using namespace canvoy;
using fuzz::require;

class Application : public web::WebApplication {
 public:
  class Live : public web::LiveClient {
   public:
    explicit Live(Application& application) : application_(application) { ++application_.live; }
    ~Live() override { --application_.live; }
    Live(const Live&) = delete;
    Live& operator=(const Live&) = delete;
    std::string next() override { return "{}"; }
    bool is_behind() const override { return false; }
    void said(std::string_view message) override { require(message.size() <= body_max); }

   private:
    Application& application_;
  };

  static constexpr std::size_t body_max = 1024;

  std::string methods(std::string_view path) const override {
    return path.starts_with("/api") ? "GET, HEAD, POST" : "";
  }
  void answer(const web::WebRequest& request, Answer done) override {
    require(request.target.path.starts_with("/api"));
    require(request.body.size() <= body_max);
    done({.body = request.body});
  }
  std::unique_ptr<web::LiveClient> connect(const web::RequestTarget&) override {
    return std::make_unique<Live>(*this);
  }

  int live = 0;
};

class Server {
 public:
  Server() {
    server_ = *web::WebServer::create(
        *loop_, {.limits = {.head_max = 1024, .body_max = Application::body_max}}, application_);
  }
  const std::string& address() const { return server_->address(); }
  /// A value for a Host field, followed by the token.
  std::string host() const {
    return server_->address() + "\r\nAuthorization: Bearer " + server_->token();
  }

  /// Sends `greeting` first, and waits for its answer.
  void serve(std::string_view greeting, std::string_view bytes, bool ends_output) {
    const auto address = gateway::parse_tcp_address(server_->address());
    host::Descriptor socket(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0));
    const linger at_once{.l_onoff = 1, .l_linger = 0};  // many clients leave no ports behind
    ::setsockopt(socket.get(), SOL_SOCKET, SO_LINGER, &at_once, sizeof at_once);
    require(::connect(socket.get(), address->get(), address->length) == 0);
    if (!greeting.empty()) send(socket, greeting);
    hear(socket);
    const std::size_t half = bytes.size() / 2;
    send(socket, bytes.substr(0, half));
    send(socket, bytes.substr(half));
    if (ends_output) ::shutdown(socket.get(), SHUT_WR);
    turn();
    hear(socket);
    server_->offer();
    turn();
    socket = {};
    for (int turns = 0; server_->clients() > 0; ++turns) {
      require(turns < 1000);  // the client is gone, but still connected
      turn();
    }
    require(application_.live == 0);
  }

 private:
  void send(const host::Descriptor& socket, std::string_view bytes) {
    ::send(socket.get(), bytes.data(), bytes.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
    turn();
  }
  void hear(const host::Descriptor& socket) {
    std::array<char, 4096> heard;
    while (::recv(socket.get(), heard.data(), heard.size(), MSG_DONTWAIT) > 0) turn();
  }
  void turn() {
    for (int i = 0; i < 3; ++i) loop_->run_until(loop_->now());
  }

  Application application_;
  std::unique_ptr<host::EventLoop> loop_ = *host::EventLoop::create();
  std::unique_ptr<web::WebServer> server_;
};

std::string with_address(std::string_view text, std::string_view address) {
  std::string made;
  for (const char each : text) each == '@' ? made.append(address) : made.append(1, each);
  return made;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static Server server;
  if (size == 0) return 0;
  constexpr std::uint8_t opens_web_socket = 1;
  constexpr std::uint8_t ends_output = 2;
  const std::string_view text(reinterpret_cast<const char*>(data) + 1, size - 1);
  const std::string upgrade =
      "GET /live HTTP/1.1\r\nHost: " + server.host() +
      "\r\nUpgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Version: 13\r\n"
      "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n\r\n";
  const bool is_web_socket = (data[0] & opens_web_socket) != 0;
  server.serve(is_web_socket ? upgrade : "",
               is_web_socket ? std::string(text) : with_address(text, server.host()),
               (data[0] & ends_output) != 0);
  return 0;
}
