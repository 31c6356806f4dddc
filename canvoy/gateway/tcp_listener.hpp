// Listens for clients over TCP, on the event loop of the process.
//
//     auto listener = TcpListener::create(*loop, "127.0.0.1:60000");
//     if (!listener) return fail(listener.error().line());
//     (*listener)->on_client([](host::Descriptor socket, std::string peer) { serve(...); });
#pragma once

#include <cerrno>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "canvoy/can/host/descriptor.hpp"
#include "canvoy/can/host/event_loop.hpp"
#include "canvoy/can/host/result.hpp"

namespace canvoy::gateway {

/// True for an error of a non-blocking socket that passes: the call would have had to wait, or was
/// interrupted.
inline bool is_passing(int error) {
  return error == EAGAIN || error == EWOULDBLOCK || error == EINTR;
}

/// A listening socket. A new client waits while there is no file descriptor for it.
class TcpListener {
 public:
  /// Takes the socket of a new client, and its address for messages.
  using OnClient = std::function<void(host::Descriptor socket, std::string peer)>;

  /// Listens on `address`: `127.0.0.1:60000`, `[::1]:60000`, or port 0 for a free port. `loop` must
  /// outlive the listener.
  static host::Result<std::unique_ptr<TcpListener>> create(host::EventLoop& loop,
                                                           std::string_view address);
  ~TcpListener();

  /// Address that it listens on, with the port that was free.
  const std::string& address() const { return address_; }
  /// True if only programs on this machine can reach it.
  bool is_loopback() const { return loopback_; }
  /// Sets the handler of new clients, which takes a non-blocking socket and its address. Without a
  /// handler new clients are disconnected.
  void on_client(OnClient handler) { on_client_ = std::move(handler); }
  /// Sets the handler of trouble: one line when new clients cannot be accepted, and no more until
  /// one is accepted again.
  void on_trouble(std::function<void(std::string_view)> handler) {
    on_trouble_ = std::move(handler);
  }

 private:
  TcpListener(host::EventLoop& loop, host::Descriptor socket);
  host::Result<void> listen();
  void accept_ready(host::Readiness readiness);
  void accept_failed(int error);
  void accept_again();

  host::EventLoop& loop_;
  host::Descriptor socket_;
  host::EventLoop::Id watch_ = 0;
  host::EventLoop::Id accepting_ = 0;  ///< timer of the next try to accept, after a failure
  int trouble_ = 0;                    ///< error of the last attempt to accept, until one succeeds
  std::string address_;
  bool loopback_ = false;
  OnClient on_client_;
  std::function<void(std::string_view)> on_trouble_;
};

}  // namespace canvoy::gateway
