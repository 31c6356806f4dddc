// Serves clients of the gateway over TCP, on the event loop of the process (CiA 309-3).
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

/// Limits for all clients together. A client is idle while it sends nothing and none of its
/// commands is under way, whatever it receives.
struct TcpLimits {
  std::size_t clients_max = 16;  ///< at a time
  Duration idle_max = 1h;        ///< an idle client is dropped after this time
  /// Time since the latest command after which a client may be dropped for a new one that has no
  /// place; the client with the oldest command goes first. Empty lines and comments are not
  /// commands.
  Duration idle_for_others = 10s;
  /// Bytes held for all clients; beyond, the client that holds most is dropped.
  std::size_t bytes_max = 32 * 1024 * 1024;
};

/// A server. A client that sends faster than it is served stays in its socket; a client that does
/// not read its output is dropped. Neither holds up the others. A client that ends its half of the
/// connection is served to the end. Text behind its last line end is dropped: half a command is not
/// a command. A client that speaks HTTP or TLS is dropped before any of it is carried out. A new
/// client waits while there is no file descriptor for it.
class TcpServer {
 public:
  /// Listens on `address`: `127.0.0.1:60000`, `[::1]:60000`, or port 0 for a free port. `loop` and
  /// `gateway` must outlive the server.
  static host::Result<std::unique_ptr<TcpServer>> create(host::EventLoop& loop, Gateway& gateway,
                                                         std::string_view address,
                                                         const TcpLimits& limits = {});
  ~TcpServer();

  /// Address that it listens on, with the port that was free.
  const std::string& address() const { return listener_->address(); }
  /// True if only programs on this machine can reach it.
  bool is_loopback() const { return listener_->is_loopback(); }
  /// Clients at present.
  std::size_t clients() const { return connections_.size(); }
  /// Sets the handler of notes: a line for each client that connects, disconnects or is dropped, 30
  /// in a minute; then one line with the number of those left out.
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
  host::EventLoop::Id idling_ = 0;  ///< timer until the next client is idle for too long
  host::EventLoop::Id task_ = 0;
  host::EventLoop::Id sweeping_ = 0;
  std::function<void(std::string_view)> note_;
  Time minute_{};  ///< time at which the count of notes began
  unsigned noted_ = 0;
  std::vector<std::unique_ptr<Connection>> connections_;
};

}  // namespace canvoy::gateway
