#include "canvoy/gateway/tcp_server.hpp"

#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <utility>

#include "canvoy/gateway/tcp_address.hpp"

namespace canvoy::gateway {

namespace {

constexpr std::size_t chunk = 4096;  ///< bytes of one client in one turn
constexpr int backlog = 16;
constexpr int send_buffer = 64 * 1024;  ///< bytes that the kernel holds for one client
constexpr std::string_view full = "# too many clients: try again later\r\n";

void set_option(const host::Descriptor& socket, int level, int option, int value = 1) {
  ::setsockopt(socket.get(), level, option, &value, sizeof value);
}

/// A call that would have had to wait, or was interrupted.
bool is_passing(int error) {
  return error == EAGAIN || error == EWOULDBLOCK || error == EINTR;
}

}  // namespace

/// One client: its socket and its session.
class TcpServer::Connection {
 public:
  Connection(TcpServer& server, host::Descriptor socket, std::string peer)
      : server_(server),
        socket_(std::move(socket)),
        peer_(std::move(peer)),
        session_(server_.gateway_.open()) {}
  ~Connection() {
    if (watch_ != 0) server_.loop_.unwatch(watch_);
    server_.gateway_.close(session_);
  }
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  host::Result<void> watch() {
    const auto watch = server_.loop_.watch(socket_.get(), {.readable = true},
                                           host::EventLoop::Ready::to<&Connection::ready>(*this));
    if (!watch) return watch.error();
    watch_ = *watch;
    return {};
  }

  /// Sends what there is to say, and waits for what can be done next.
  void serve() {
    if (dead_) return;
    send();
    if (session_.is_too_slow()) return die("dropped: it does not read its events");
    if (ended_ && session_.idle()) return die("left");
    server_.loop_.rewatch(watch_, {.readable = !ended_ && session_.wants_input(),
                                   .writable = !session_.output().empty()});
  }
  bool is_dead() const { return dead_; }
  const std::string& peer() const { return peer_; }

 private:
  void ready(host::Readiness readiness) {
    if (dead_) return;
    if (readiness.failed) return die("left");
    const bool blocked = !session_.output().empty();
    if (readiness.readable) receive();
    if (dead_) return;
    if (readiness.writable && blocked) send();
    server_.gateway_.settle(server_.loop_.now());
  }

  void receive() {
    std::array<char, chunk> bytes;
    const ssize_t size = ::recv(socket_.get(), bytes.data(), bytes.size(), 0);
    if (size > 0) {
      session_.receive({bytes.data(), static_cast<std::size_t>(size)});
    } else if (size == 0) {
      ended_ = true;
    } else if (!is_passing(errno)) {
      die("left");
    }
  }

  void send() {
    while (!session_.output().empty()) {
      const std::string_view output = session_.output();
      const ssize_t size = ::send(socket_.get(), output.data(), output.size(), MSG_NOSIGNAL);
      if (size < 0) {
        if (!is_passing(errno)) die("left");
        return;
      }
      session_.consume(static_cast<std::size_t>(size));
    }
  }

  void die(const std::string& reason) {
    if (std::exchange(dead_, true)) return;
    server_.loop_.unwatch(std::exchange(watch_, 0));
    server_.note("client " + peer_ + " " + reason);
    server_.sweep_later();
  }

  TcpServer& server_;
  host::Descriptor socket_;
  std::string peer_;
  Session& session_;
  host::EventLoop::Id watch_ = 0;
  bool ended_ = false;  ///< the client says no more
  bool dead_ = false;   ///< until the next turn of the loop
};

TcpServer::TcpServer(host::EventLoop& loop, Gateway& gateway, host::Descriptor socket)
    : loop_(loop), gateway_(gateway), socket_(std::move(socket)) {
  gateway_.on_settled([this] { serve_all(); });
  host::Task task;
  task.deadline = Callback<Time()>::to<&Gateway::deadline>(gateway_);
  task.advance = Callback<void(Time)>::to<&Gateway::advance>(gateway_);
  task_ = loop_.add(task);
}

TcpServer::~TcpServer() {
  gateway_.on_settled({});
  loop_.remove(task_);
  if (watch_ != 0) loop_.unwatch(watch_);
  if (sweeping_ != 0) loop_.cancel(sweeping_);
}

host::Result<std::unique_ptr<TcpServer>> TcpServer::create(host::EventLoop& loop, Gateway& gateway,
                                                           std::string_view address) {
  const host::Result<TcpAddress> parsed = parse_tcp_address(address);
  if (!parsed) return parsed.error();
  host::Descriptor socket{
      ::socket(parsed->storage.ss_family, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0)};
  const auto failed = [&](const char* remedy) {
    return host::Error{std::string(address), std::strerror(errno), remedy};
  };
  if (!socket) return failed("close some files, or raise `ulimit -n`");
  set_option(socket, SOL_SOCKET, SO_REUSEADDR);
  if (::bind(socket.get(), parsed->get(), parsed->length) != 0 ||
      ::listen(socket.get(), backlog) != 0) {
    return failed("choose another address or port");
  }
  std::unique_ptr<TcpServer> server(new TcpServer(loop, gateway, std::move(socket)));
  const host::Result<void> listening = server->listen();
  if (!listening) return listening.error();
  return server;
}

host::Result<void> TcpServer::listen() {
  TcpAddress own;
  own.length = sizeof own.storage;
  ::getsockname(socket_.get(), reinterpret_cast<sockaddr*>(&own.storage), &own.length);
  address_ = own.text();
  loopback_ = own.is_loopback();
  const auto watch = loop_.watch(socket_.get(), {.readable = true},
                                 host::EventLoop::Ready::to<&TcpServer::accept_ready>(*this));
  if (!watch) return watch.error();
  watch_ = *watch;
  return {};
}

void TcpServer::accept_ready(host::Readiness) {
  TcpAddress peer;
  peer.length = sizeof peer.storage;
  host::Descriptor socket{::accept4(socket_.get(), reinterpret_cast<sockaddr*>(&peer.storage),
                                    &peer.length, SOCK_NONBLOCK | SOCK_CLOEXEC)};
  if (!socket) return;
  set_option(socket, IPPROTO_TCP, TCP_NODELAY);
  set_option(socket, SOL_SOCKET, SO_KEEPALIVE);
  set_option(socket, SOL_SOCKET, SO_SNDBUF, send_buffer);
  admit(std::move(socket), peer.text());
}

void TcpServer::admit(host::Descriptor socket, std::string peer) {
  if (connections_.size() >= clients_max) {
    [[maybe_unused]] const ssize_t size =
        ::send(socket.get(), full.data(), full.size(), MSG_NOSIGNAL);
    return note("client " + peer + " refused: there are " + std::to_string(clients_max));
  }
  auto connection = std::make_unique<Connection>(*this, std::move(socket), std::move(peer));
  const host::Result<void> watched = connection->watch();
  if (!watched) return note("client " + connection->peer() + " refused: " + watched.error().what);
  note("client " + connection->peer() + " came");
  connections_.push_back(std::move(connection));
}

void TcpServer::serve_all() {
  for (const auto& connection : connections_) connection->serve();
}

/// A connection may be at work itself when it dies.
void TcpServer::sweep_later() {
  if (sweeping_ != 0) return;
  sweeping_ = loop_.at(loop_.now(), [this](Time) { sweep(); });
}

void TcpServer::sweep() {
  sweeping_ = 0;
  std::erase_if(connections_, [](const auto& connection) { return connection->is_dead(); });
}

}  // namespace canvoy::gateway
