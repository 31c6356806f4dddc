// Serves one document by HTTP to whoever asks, in a thread of its own: the newest of what its owner
// publishes.
//
//     auto server = HttpServer::create("[::]:8080", "application/x-protobuf", bytes);
//     if (!server) return fail(server.error().line());
//     (*server)->publish(newer_bytes);
#pragma once

#include <atomic>
#include <memory>
#include <string>
#include <string_view>
#include <thread>

#include "canvoy/can/host/event_loop.hpp"
#include "canvoy/can/host/result.hpp"

namespace canvoy::tools {

/// What all clients together may take.
struct HttpLimits {
  std::size_t clients_max = 64;  ///< beyond, a newcomer takes the place of who is there longest
  Duration time_out = 10s;       ///< from when a client comes until it has its answer and has gone
};

/// One request for each connection. GET and HEAD of any path are answered, other methods by 405,
/// what is no request by 400, one whose head is too long by 431, one that does not come to its end
/// in time by 408. What a client sends behind its request is thrown away.
class HttpServer {
 public:
  /// `address` as of TcpListener; the media type of the content holds for what is published, too.
  static host::Result<std::unique_ptr<HttpServer>> create(std::string_view address,
                                                          std::string_view content_type,
                                                          std::string content,
                                                          const HttpLimits& limits = {});
  ~HttpServer();
  HttpServer(const HttpServer&) = delete;
  HttpServer& operator=(const HttpServer&) = delete;

  /// Where it listens, with the port that was free.
  const std::string& address() const;
  /// From any thread. Who is being answered gets the old content whole.
  void publish(std::string content);
  /// Connections that are open now.
  std::size_t clients() const;

 private:
  class Listener;

  HttpServer(std::unique_ptr<host::EventLoop> loop, std::unique_ptr<Listener> listener);

  std::unique_ptr<host::EventLoop> loop_;
  std::unique_ptr<Listener> listener_;
  std::thread thread_;
};

}  // namespace canvoy::tools
