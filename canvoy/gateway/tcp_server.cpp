#include "canvoy/gateway/tcp_server.hpp"

#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <iterator>
#include <utility>

#include "canvoy/can/check_invariant.hpp"
#include "canvoy/gateway/first_line.hpp"

namespace canvoy::gateway {

namespace {

constexpr std::size_t chunk = 4096;     ///< bytes of one client in one turn
constexpr int send_buffer = 64 * 1024;  ///< bytes that the kernel holds for one client
constexpr unsigned notes_max = 30;      ///< in a minute
constexpr std::string_view full = "# too many clients: try again later\r\n";

void set_option(const host::Descriptor& socket, int level, int option, int value = 1) {
  ::setsockopt(socket.get(), level, option, &value, sizeof value);
}

}  // namespace

/// One client: its socket and its session.
class TcpServer::Connection {
 public:
  Connection(TcpServer& server, host::Descriptor socket, std::string peer)
      : server_(server),
        socket_(std::move(socket)),
        peer_(std::move(peer)),
        session_(server_.gateway_.open()),
        busy_at_(server_.loop_.now()),
        asked_at_(busy_at_) {}
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

  /// Sends waiting output, and waits for the next possible step.
  void serve() {
    if (dead_) return;
    if (session_.is_busy()) busy_at_ = asked_at_ = server_.loop_.now();
    send();
    if (session_.is_too_slow()) return die("dropped: it does not read its events");
    if (ended_ && session_.idle()) return die("left");
    server_.loop_.rewatch(watch_, {.readable = !ended_ && session_.wants_input(),
                                   .writable = !session_.output().empty()});
  }
  void drop(const std::string& why) { die("dropped: " + why); }
  bool is_dead() const { return dead_; }
  const std::string& peer() const { return peer_; }
  /// Time since it is idle; the present time while it is not.
  Time busy_at() const { return session_.is_busy() ? server_.loop_.now() : busy_at_; }
  /// Time of its latest command; the present time while one is under way.
  Time asked_at() const { return session_.is_busy() ? server_.loop_.now() : asked_at_; }
  std::size_t held_bytes() const { return dead_ ? 0 : session_.held_bytes(); }

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
    const ssize_t size = ::recv(socket_.get(), bytes.data(), chunk, 0);
    if (size > 0) {
      take({bytes.data(), static_cast<std::size_t>(size)});
    } else if (size == 0) {
      ended_ = true;
    } else if (!is_passing(errno)) {
      die("left");
    }
  }

  void take(std::string_view bytes) {
    const std::string_view protocol = first_line_.append(bytes);
    if (!protocol.empty()) return drop("it speaks " + std::string(protocol));
    busy_at_ = server_.loop_.now();
    session_.receive(bytes);
    if (session_.is_busy() || !session_.output().empty()) asked_at_ = busy_at_;
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
    check_invariant(watch_ != 0);
    server_.loop_.unwatch(std::exchange(watch_, 0));
    server_.note("client " + peer_ + " " + reason);
    server_.sweep_later();
  }

  TcpServer& server_;
  host::Descriptor socket_;
  std::string peer_;
  Session& session_;
  FirstLine first_line_;
  Time busy_at_;   ///< time of the last input, or of a command under way
  Time asked_at_;  ///< time of the last command, or of one under way
  host::EventLoop::Id watch_ = 0;
  bool ended_ = false;  ///< the client has ended its input
  bool dead_ = false;   ///< until the next turn of the loop
};

TcpServer::TcpServer(host::EventLoop& loop, Gateway& gateway, std::unique_ptr<TcpListener> listener,
                     const TcpLimits& limits)
    : loop_(loop), gateway_(gateway), limits_(limits), listener_(std::move(listener)) {
  listener_->on_client([this](host::Descriptor socket, std::string peer) {
    set_option(socket, IPPROTO_TCP, TCP_NODELAY);
    set_option(socket, SOL_SOCKET, SO_KEEPALIVE);
    set_option(socket, SOL_SOCKET, SO_SNDBUF, send_buffer);
    admit(std::move(socket), std::move(peer));
  });
  listener_->on_trouble([this](std::string_view line) { note(std::string(line)); });
  gateway_.on_settled([this] { serve_all(); });
  host::Task task;
  task.deadline = callback<&Gateway::deadline>(gateway_);
  task.advance = callback<&Gateway::advance>(gateway_);
  task_ = loop_.add(task);
}

TcpServer::~TcpServer() {
  gateway_.on_settled({});
  loop_.remove(task_);
  for (const host::EventLoop::Id timer : {sweeping_, idling_}) {
    if (timer != 0) loop_.cancel(timer);
  }
}

host::Result<std::unique_ptr<TcpServer>> TcpServer::create(host::EventLoop& loop, Gateway& gateway,
                                                           std::string_view address,
                                                           const TcpLimits& limits) {
  host::Result<std::unique_ptr<TcpListener>> listener = TcpListener::create(loop, address);
  if (!listener) return listener.error();
  return std::unique_ptr<TcpServer>(new TcpServer(loop, gateway, *std::move(listener), limits));
}

void TcpServer::admit(host::Descriptor socket, std::string peer) {
  if (!make_room()) {
    [[maybe_unused]] const ssize_t size =
        ::send(socket.get(), full.data(), full.size(), MSG_NOSIGNAL);
    return note("client " + peer + " refused: there are " + std::to_string(limits_.clients_max));
  }
  auto connection = std::make_unique<Connection>(*this, std::move(socket), std::move(peer));
  const host::Result<void> watched = connection->watch();
  if (!watched) return note("client " + connection->peer() + " refused: " + watched.error().what);
  note("client " + connection->peer() + " came");
  connections_.push_back(std::move(connection));
  if (idling_ == 0) drop_idle();
}

/// Drops the client with the oldest latest command for a new one.
bool TcpServer::make_room() {
  sweep();
  if (connections_.size() < limits_.clients_max) return true;
  const auto idlest = std::ranges::min_element(
      connections_, {}, [](const auto& connection) { return connection->asked_at(); });
  if ((*idlest)->asked_at() + limits_.idle_for_others > loop_.now()) return false;
  (*idlest)->drop("it is idle, and others wait");
  sweep();
  return true;
}

/// Limits the notes, so that a client that connects again and again does not fill the disk.
void TcpServer::note(const std::string& line) {
  if (!note_) return;
  if (loop_.now() - minute_ >= Duration(1min)) {
    minute_ = loop_.now();
    if (noted_ > notes_max) {
      note_(std::to_string(noted_ - notes_max) + " more lines on clients were left out");
    }
    noted_ = 0;
  }
  if (++noted_ <= notes_max) note_(line);
}

void TcpServer::serve_all() {
  for (const auto& connection : connections_) connection->serve();
  bound_memory();
}

void TcpServer::bound_memory() {
  const auto held = [](const auto& connection) { return connection->held_bytes(); };
  std::size_t sum = 0;
  for (const auto& connection : connections_) sum += held(connection);
  while (sum > limits_.bytes_max) {
    const auto most = std::ranges::max_element(connections_, {}, held);
    const std::size_t freed = held(*most);
    check_invariant(freed > 0 && freed <= sum);
    sum -= freed;
    (*most)->drop("it holds most of the memory of all clients");
  }
}

/// Drops idle clients, and schedules the next check.
void TcpServer::drop_idle() {
  Time next = loop_.now() + limits_.idle_max;
  for (const auto& connection : connections_) {
    const Time until = connection->busy_at() + limits_.idle_max;
    if (until <= loop_.now()) {
      connection->drop("it is idle");
    } else {
      next = std::min(next, until);
    }
  }
  idling_ = loop_.at(next, [this](Time) { drop_idle(); });
}

/// Postponed: a connection may be at work when it ends.
void TcpServer::sweep_later() {
  if (sweeping_ != 0) return;
  sweeping_ = loop_.at(loop_.now(), [this](Time) { sweep(); });
}

void TcpServer::sweep() {
  if (sweeping_ != 0) loop_.cancel(std::exchange(sweeping_, 0));
  // The cancellations of a closed connection let others continue, which need all connections in
  // their places.
  const auto dead =
      std::stable_partition(connections_.begin(), connections_.end(),
                            [](const auto& connection) { return !connection->is_dead(); });
  const std::vector<std::unique_ptr<Connection>> gone(std::make_move_iterator(dead),
                                                      std::make_move_iterator(connections_.end()));
  connections_.erase(dead, connections_.end());
}

}  // namespace canvoy::gateway
