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
#include "canvoy/can/time.hpp"
#include "canvoy/gateway/gateway.hpp"
#include "canvoy/gateway/tcp_listener.hpp"

namespace canvoy::gateway {

/// What all clients together may take. A client is idle while it says nothing and none of its
/// commands is under way, whatever it is told.
struct TcpLimits {
  std::size_t clients_max = 16;
  Duration idle_max = 1h;  ///< who is idle for longer is dropped
  /// So is the one whose latest command is longest ago, and as long as this, where a newcomer has
  /// no place. Empty lines and comments are no commands.
  Duration idle_for_others = 10s;
  std::size_t bytes_max = 32 * 1024 * 1024;  ///< held for all of them; beyond, who holds most goes
};

/// A client that sends faster than it is served is left in its socket; one that does not read what
/// it is told is dropped. Neither holds up the others. One that ends its half of the connection is
/// served to the end. What stands behind its last end of a line is dropped: half a command is none.
/// One that speaks HTTP or TLS is dropped before anything of it is carried out. While there is no
/// file descriptor for a newcomer, it waits.
class TcpServer {
 public:
  /// `address` is `127.0.0.1:60000`, `[::1]:60000`, or with 0 as the port a free one. `loop` and
  /// `gateway` must outlive the server.
  static host::Result<std::unique_ptr<TcpServer>> create(host::EventLoop& loop, Gateway& gateway,
                                                         std::string_view address,
                                                         const TcpLimits& limits = {});
  ~TcpServer();
  TcpServer(const TcpServer&) = delete;
  TcpServer& operator=(const TcpServer&) = delete;

  /// Where it listens, with the port that was free.
  const std::string& address() const { return listener_->address(); }
  /// Whether only programs on this machine reach it.
  bool is_loopback() const { return listener_->is_loopback(); }
  std::size_t clients() const { return connections_.size(); }
  /// Clients that come, go, and are dropped: a line for each, 30 in a minute; then one that counts
  /// those that were left out.
  void on_note(std::function<void(std::string_view)> handler) { note_ = std::move(handler); }

 private:
  class Connection;

  TcpServer(host::EventLoop& loop, Gateway& gateway, std::unique_ptr<TcpListener> listener,
            const TcpLimits& limits);
  void admit(host::Descriptor socket, std::string peer);
  bool make_room();
  void serve_all();
  void bound_memory();
  void drop_idle();
  void sweep_later();
  void sweep();
  void note(const std::string& line);

  host::EventLoop& loop_;
  Gateway& gateway_;
  TcpLimits limits_;
  std::unique_ptr<TcpListener> listener_;
  host::EventLoop::Id idling_ = 0;  ///< until the next client is idle for too long
  host::EventLoop::Id task_ = 0;
  host::EventLoop::Id sweeping_ = 0;
  std::function<void(std::string_view)> note_;
  Time minute_{};  ///< when the notes began to be counted
  unsigned noted_ = 0;
  std::vector<std::unique_ptr<Connection>> connections_;
};

}  // namespace canvoy::gateway
