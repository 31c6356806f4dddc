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

/// Of a socket that does not block: the call would have had to wait, or was interrupted.
inline bool is_passing(int error) {
  return error == EAGAIN || error == EWOULDBLOCK || error == EINTR;
}

/// While there is no file descriptor for a newcomer, it waits.
class TcpListener {
 public:
  using OnClient = std::function<void(host::Descriptor socket, std::string peer)>;

  /// `address` is `127.0.0.1:60000`, `[::1]:60000`, or with 0 as the port a free one. `loop` must
  /// outlive the listener.
  static host::Result<std::unique_ptr<TcpListener>> create(host::EventLoop& loop,
                                                           std::string_view address);
  ~TcpListener();
  TcpListener(const TcpListener&) = delete;
  TcpListener& operator=(const TcpListener&) = delete;

  /// Where it listens, with the port that was free.
  const std::string& address() const { return address_; }
  /// Whether only programs on this machine reach it.
  bool is_loopback() const { return loopback_; }
  /// Who comes: a socket that does not block, and its address. Without a handler they are sent
  /// away.
  void on_client(OnClient handler) { on_client_ = std::move(handler); }
  /// A line when nobody can come, once until somebody can.
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
  host::EventLoop::Id accepting_ = 0;  ///< again, after it failed
  int trouble_ = 0;                    ///< the error of the last newcomer, until one is taken
  std::string address_;
  bool loopback_ = false;
  OnClient on_client_;
  std::function<void(std::string_view)> on_trouble_;
};

}  // namespace canvoy::gateway
