// Clients of the gateway over TCP (CiA 309-3), on the event loop of the process.
//
//     auto server = TcpServer::create(*loop, gateway, "127.0.0.1:60000");
//     if (!server) return fail(server.error().line());
//     (*server)->on_note([](std::string_view line) { print(line); });
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "canvoy/can/host/descriptor.hpp"
#include "canvoy/can/host/event_loop.hpp"
#include "canvoy/can/host/result.hpp"
#include "canvoy/gateway/gateway.hpp"

namespace canvoy::gateway {

/// A client that sends faster than it is served is left in its socket; one that does not read what
/// it is told is dropped. Neither holds up the others. One that ends its half of the connection is
/// served to the end. What stands behind its last end of a line is dropped: half a command is none.
class TcpServer {
 public:
  static constexpr std::size_t clients_max = 16;

  /// `address` is `127.0.0.1:60000`, `[::1]:60000`, or with 0 as the port a free one. `loop` and
  /// `gateway` must outlive the server.
  static host::Result<std::unique_ptr<TcpServer>> create(host::EventLoop& loop, Gateway& gateway,
                                                         std::string_view address);
  ~TcpServer();
  TcpServer(const TcpServer&) = delete;
  TcpServer& operator=(const TcpServer&) = delete;

  /// Where it listens, with the port that was free.
  const std::string& address() const { return address_; }
  /// Whether only programs on this machine reach it.
  bool is_loopback() const { return loopback_; }
  std::size_t clients() const { return connections_.size(); }
  /// Clients that come, go, and are dropped: a line for each.
  void on_note(std::function<void(std::string_view)> handler) { note_ = std::move(handler); }

 private:
  class Connection;

  TcpServer(host::EventLoop& loop, Gateway& gateway, host::Descriptor socket);
  host::Result<void> listen();
  void accept_ready(host::Readiness readiness);
  void admit(host::Descriptor socket, std::string peer);
  void serve_all();
  void sweep_later();
  void sweep();
  void note(const std::string& line) const {
    if (note_) note_(line);
  }

  host::EventLoop& loop_;
  Gateway& gateway_;
  host::Descriptor socket_;
  host::EventLoop::Id watch_ = 0;
  host::EventLoop::Id task_ = 0;
  host::EventLoop::Id sweeping_ = 0;
  std::string address_;
  bool loopback_ = false;
  std::function<void(std::string_view)> note_;
  std::vector<std::unique_ptr<Connection>> connections_;
};

}  // namespace canvoy::gateway
