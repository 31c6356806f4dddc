// Serves a page, an API and live clients by HTTP and WebSocket, on the event loop of the process:
// nothing of it blocks, and no client slows what else the loop does.
//
//     auto server = WebServer::create(*loop, {.address = "127.0.0.1:8080"}, application);
//     if (!server) return fail(server.error().line());
//     fmt::print("{}\n", (*server)->url());
//     (*server)->offer();  // whenever something may be new
//
// Sockets are watched by the project's own loop; what is to be done when one is ready is
// Boost.Asio's and Beast's, who are asked to do what can be done at once, and never to wait.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "canvoy/can/host/event_loop.hpp"
#include "canvoy/can/host/result.hpp"
#include "canvoy/web/request_target.hpp"

namespace canvoy::web {

/// A request for something other than the page.
struct WebRequest {
  std::string method;  ///< `GET`, also of HEAD; `POST`
  RequestTarget target;
  std::string body;
};

struct WebResponse {
  unsigned status = 200;
  std::string type = "application/json";
  std::string body{};
};

/// What one client with a WebSocket sees and says. Messages are JSON.
class LiveClient {
 public:
  LiveClient() = default;
  virtual ~LiveClient() = default;
  LiveClient(const LiveClient&) = delete;
  LiveClient& operator=(const LiveClient&) = delete;

  /// What is new since the last call, as one message; empty: nothing. It is asked for only when the
  /// last one has gone: for who is slow, what has changed twice is told once.
  virtual std::string next() = 0;
  /// There is more than the last message took: it is asked for at once.
  virtual bool is_behind() const = 0;
  virtual void said(std::string_view message) = 0;
};

/// What is served.
class WebApplication {
 public:
  using Answer = std::function<void(WebResponse)>;

  WebApplication() = default;
  virtual ~WebApplication() = default;
  WebApplication(const WebApplication&) = delete;
  WebApplication& operator=(const WebApplication&) = delete;

  /// What can be done with a path that is none of the page's, as Allow has it (RFC 9110, 10.2.1):
  /// `GET, HEAD`, `POST`, or both; empty: there is nothing there.
  virtual std::string methods(std::string_view path) const = 0;
  /// A request that fits methods(). It answers once, at once or later; later than the client waits
  /// does no harm.
  virtual void answer(const WebRequest& request, Answer done) = 0;
  /// `target` is that of the WebSocket: what its query has is the application's.
  virtual std::unique_ptr<LiveClient> connect(const RequestTarget& target) = 0;
};

/// What all clients together may take.
struct WebLimits {
  std::size_t clients_max = 64;  ///< connections; a newcomer beyond is sent away
  /// Of them, those with a WebSocket: a newcomer takes the place of the one that has said nothing
  /// for longest.
  std::size_t live_clients_max = 16;
  std::uint32_t head_max = 8 * 1024;   ///< bytes of a request's first line and headers
  std::uint64_t body_max = 64 * 1024;  ///< bytes of a request's body, and of a client's message
  int send_buffer = 128 * 1024;        ///< bytes that the system keeps for a client
  Duration request_time_out = 10s;     ///< from its first byte to its answer
  Duration idle_time_out = 30s;        ///< between two requests
  Duration message_time_out = 20s;     ///< until a client has taken a message; else it is let go
  /// Bytes of answers and messages that clients have not taken yet, of all together. Beyond, a
  /// request is answered with 503, and what a WebSocket would be told waits.
  std::size_t unread_max = std::size_t{64} << 20;
  unsigned said_max_per_second = 100;  ///< messages and pings of a client; beyond, it is let go
};

struct WebOptions {
  std::string address = "127.0.0.1:0";  ///< with 0 as the port, a free one
  WebLimits limits{};
  std::string token{};  ///< what requests have to know; empty: one by chance
};

class WebServer {
 public:
  /// `application` has to outlive it.
  static host::Result<std::unique_ptr<WebServer>> create(host::EventLoop& loop,
                                                         const WebOptions& options,
                                                         WebApplication& application);
  ~WebServer();
  WebServer(const WebServer&) = delete;
  WebServer& operator=(const WebServer&) = delete;

  /// `127.0.0.1:8080`, with the port that was free.
  const std::string& address() const;
  /// What a browser opens, with the token.
  std::string url() const;
  const std::string& token() const;
  /// Asks all clients that can take a message for their next one.
  void offer();
  /// Connections, and those of them with a WebSocket.
  std::size_t clients() const;
  std::size_t live_clients() const;

 private:
  class Hub;

  explicit WebServer(std::unique_ptr<Hub> hub);

  std::unique_ptr<Hub> hub_;
};

}  // namespace canvoy::web
