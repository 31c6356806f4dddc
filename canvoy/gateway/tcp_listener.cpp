#include "canvoy/gateway/tcp_listener.hpp"

#include <sys/socket.h>

#include <cstring>
#include <utility>

#include "canvoy/gateway/tcp_address.hpp"

namespace canvoy::gateway {

namespace {

/// Clients that connect while another is served, without a further try.
constexpr int backlog = 128;
constexpr Duration accept_retry = 100ms;

}  // namespace

TcpListener::TcpListener(host::EventLoop& loop, host::Descriptor socket)
    : loop_(loop), socket_(std::move(socket)) {}

TcpListener::~TcpListener() {
  if (watch_ != 0) loop_.unwatch(watch_);
  if (accepting_ != 0) loop_.cancel(accepting_);
}

host::Result<std::unique_ptr<TcpListener>> TcpListener::create(host::EventLoop& loop,
                                                               std::string_view address) {
  const host::Result<TcpAddress> parsed = parse_tcp_address(address);
  if (!parsed) return parsed.error();
  host::Descriptor socket{
      ::socket(parsed->storage.ss_family, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0)};
  const auto failed = [&](const char* remedy) {
    return host::Error{std::string(address), std::strerror(errno), remedy};
  };
  if (!socket) return failed("close some files, or raise `ulimit -n`");
  const int yes = 1;
  ::setsockopt(socket.get(), SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
  if (::bind(socket.get(), parsed->get(), parsed->length) != 0 ||
      ::listen(socket.get(), backlog) != 0) {
    return failed("choose another address or port");
  }
  std::unique_ptr<TcpListener> listener(new TcpListener(loop, std::move(socket)));
  const host::Result<void> listening = listener->listen();
  if (!listening) return listening.error();
  return listener;
}

host::Result<void> TcpListener::listen() {
  TcpAddress own;
  own.length = sizeof own.storage;
  ::getsockname(socket_.get(), reinterpret_cast<sockaddr*>(&own.storage), &own.length);
  address_ = own.text();
  loopback_ = own.is_loopback();
  const auto watch = loop_.watch(socket_.get(), {.readable = true},
                                 host::EventLoop::Ready::to<&TcpListener::accept_ready>(*this));
  if (!watch) return watch.error();
  watch_ = *watch;
  return {};
}

void TcpListener::accept_ready(host::Readiness) {
  TcpAddress peer;
  peer.length = sizeof peer.storage;
  host::Descriptor socket{::accept4(socket_.get(), reinterpret_cast<sockaddr*>(&peer.storage),
                                    &peer.length, SOCK_NONBLOCK | SOCK_CLOEXEC)};
  if (!socket) return accept_failed(errno);
  trouble_ = 0;
  if (on_client_) on_client_(std::move(socket), peer.text());
}

/// A client that cannot be accepted stays, and would wake the loop forever.
void TcpListener::accept_failed(int error) {
  if (is_passing(error) || error == ECONNABORTED) return;
  if (std::exchange(trouble_, error) != error && on_trouble_) {
    on_trouble_(std::string("no client can come: ") + std::strerror(error));
  }
  loop_.rewatch(watch_, {});
  accepting_ = loop_.at(loop_.now() + accept_retry, [this](Time) { accept_again(); });
}

void TcpListener::accept_again() {
  accepting_ = 0;
  loop_.rewatch(watch_, {.readable = true});
}

}  // namespace canvoy::gateway
