// Serves a page, an API and live clients by HTTP and WebSocket, on the event loop of the process:
// no operation blocks, and no client delays the rest of the loop.
//
//     auto server = WebServer::create(*loop, {.address = "127.0.0.1:8080"}, application);
//     if (!server) return fail(server.error().line());
//     fmt::print("{}\n", (*server)->url());
//     (*server)->offer();  // whenever something may be new
//
// The event loop of the project watches the sockets; Boost.Asio and Beast read and write ready
// sockets without waiting.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "canvoy/can/host/event_loop.hpp"
#include "canvoy/can/host/result.hpp"
#include "canvoy/web/request_target.hpp"

namespace canvoy::web {

/// A request that is not for a file of the page.
struct WebRequest {
  std::string method;  ///< `GET`, also for HEAD; `POST`
  RequestTarget target;
  std::string body;
};

struct WebResponse {
  unsigned status = 200;
  std::string type = "application/json";
  std::string body{};
};

/// Server side of one client with a WebSocket. Messages are JSON.
class LiveClient {
 public:
  LiveClient() = default;
  virtual ~LiveClient() = default;
  LiveClient(const LiveClient&) = delete;
  LiveClient& operator=(const LiveClient&) = delete;

  /// Changes since the last call, as one message; empty: none. Called only when the last message
  /// was sent: for a slow client, two changes are combined.
  virtual std::string next() = 0;
  /// True if there is more than the last message took: next() is called again at once.
  virtual bool is_behind() const = 0;
  virtual void said(std::string_view message) = 0;
};

/// The application that is served.
class WebApplication {
 public:
  using Answer = std::function<void(WebResponse)>;

  WebApplication() = default;
  virtual ~WebApplication() = default;
  WebApplication(const WebApplication&) = delete;
  WebApplication& operator=(const WebApplication&) = delete;

  /// Methods for a path outside the page, in the form of Allow: `GET, HEAD`, `POST`, or both;
  /// empty: no such path (RFC 9110, 10.2.1).
  virtual std::string methods(std::string_view path) const = 0;
  /// Takes a request that matches methods(). Calls `done` once, at once or later, even after the
  /// client has gone.
  virtual void answer(const WebRequest& request, Answer done) = 0;
  /// `target` is that of the WebSocket; its query is for the application.
  virtual std::unique_ptr<LiveClient> connect(const RequestTarget& target) = 0;
};

/// Limits for all clients together.
struct WebLimits {
  std::size_t clients_max = 64;  ///< connections; further ones are refused
  /// Number of them with a WebSocket: a new one replaces the one that was silent for longest.
  std::size_t live_clients_max = 16;
  std::uint32_t head_max = 8 * 1024;   ///< bytes of the first line and the headers of a request
  std::uint64_t body_max = 64 * 1024;  ///< bytes of a request body, and of a client message
  int send_buffer = 128 * 1024;        ///< bytes in the buffer of the system for a client
  Duration request_time_out = 10s;     ///< from its first byte to its answer
  Duration idle_time_out = 30s;        ///< between two requests
  Duration message_time_out = 20s;     ///< to receive a message; else the client is disconnected
  /// Bytes of answers and messages that were not yet received, for all clients together. Beyond,
  /// after `unread_for_others`, a request gets 503, and messages of WebSockets wait.
  std::size_t unread_max = std::size_t{64} << 20;
  /// Where `unread_max` is reached, the client that has left something unread longest is
  /// disconnected, if for so long.
  Duration unread_for_others = 2s;
  /// Bytes of one answer or message: a longer answer becomes a 500, a longer message ends its
  /// WebSocket. A client has one of them at a time, so this limits the memory for one client.
  std::size_t answer_max = std::size_t{32} << 20;
  unsigned said_max_per_second = 100;  ///< messages and pings; beyond, the client is closed
};

struct WebOptions {
  std::string address = "127.0.0.1:0";  ///< port 0: a free one
  WebLimits limits{};
  std::string token{};  ///< required in requests; empty: a random one
  /// Public answers: no token, no page and no WebSocket, and any host name is accepted.
  bool is_public = false;
};

class WebServer {
 public:
  /// `application` must outlive the server.
  static host::Result<std::unique_ptr<WebServer>> create(host::EventLoop& loop,
                                                         const WebOptions& options,
                                                         WebApplication& application);
  ~WebServer();
  WebServer(const WebServer&) = delete;
  WebServer& operator=(const WebServer&) = delete;

  /// `127.0.0.1:8080`, with the actual port.
  const std::string& address() const;
  /// URL for a browser, with the token if required.
  std::string url() const;
  const std::string& token() const;
  /// URLs for other machines: one for each address of the server, if it listens at all of them;
  /// else url().
  std::vector<std::string> urls() const;
  bool is_loopback() const;  ///< reachable from this machine only
  /// Calls next() of all clients that can take a message.
  void offer();
  /// Number of connections, and of those with a WebSocket.
  std::size_t clients() const;
  std::size_t live_clients() const;

 private:
  class Hub;

  explicit WebServer(std::unique_ptr<Hub> hub);

  std::unique_ptr<Hub> hub_;
};

}  // namespace canvoy::web
