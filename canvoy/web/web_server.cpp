// The server: who is let in, who gives way, and when there is a turn for all.
#include "canvoy/web/web_server.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <charconv>
#include <utility>
#include <vector>

#include "canvoy/can/host/local_addresses.hpp"
#include "canvoy/gateway/tcp_listener.hpp"
#include "canvoy/web/access.hpp"
#include "canvoy/web/connection.hpp"

namespace canvoy::web {

namespace {

using boost::asio::ip::tcp;

constexpr Duration sweep_period = 1s;
constexpr int keep_alive_seconds = 30;
/// Number of handlers for clients before the loop serves others: a client that always has a next
/// request would block it forever. Some handlers take microseconds, some write a megabyte.
constexpr int handlers_per_turn = 32;
constexpr Duration turn_time = 5ms;

std::uint16_t port_of(std::string_view address) {
  std::uint16_t port = 0;
  const std::string_view digits = address.substr(address.rfind(':') + 1);
  std::from_chars(digits.data(), digits.data() + digits.size(), port);
  return port;
}

std::string host_of(std::string_view address) {
  return std::string(address.substr(0, address.rfind(':')));
}

}  // namespace

class WebServer::Hub : public ConnectionOwner {
 public:
  Hub(host::EventLoop& event_loop, std::unique_ptr<gateway::TcpListener> listener,
      const WebOptions& options, WebApplication& served)
      : ConnectionOwner(event_loop, served, options,
                        {.port = port_of(listener->address()),
                         .is_loopback = listener->is_loopback(),
                         .host = host_of(listener->address()),
                         .token = options.token.empty() ? make_token() : options.token}),
        listener_(std::move(listener)) {
    listener_->on_client(
        [this](host::Descriptor client, const std::string&) { admit(std::move(client)); });
  }
  ~Hub() override;
  Hub(const Hub&) = delete;
  Hub& operator=(const Hub&) = delete;

  bool make_unread_room(std::size_t bytes) override;
  void turn_soon() override;
  void make_live_room() override;

  const std::string& address() const { return listener_->address(); }
  std::string url() const { return url_at(address()); }
  std::vector<std::string> urls() const {
    std::vector<std::string> all;
    if (rules.host == "0.0.0.0") {
      for (const std::string& each : host::outside_addresses()) {
        all.push_back(url_at(fmt::format("{}:{}", each, rules.port)));
      }
    }
    if (all.empty()) all.push_back(url());
    return all;
  }
  bool is_loopback() const { return rules.is_loopback; }
  const std::string& token() const { return rules.token; }
  void offer();
  std::size_t clients() const { return connections_.size(); }
  std::size_t live_clients() const;

 private:
  std::string url_at(std::string_view where) const {
    return fmt::format("http://{}/{}{}", where,
                       is_public ? "" : "?token=", is_public ? "" : token());
  }
  void admit(host::Descriptor client);
  void make_room();
  /// Performs what is possible at once, or a part of it, and sets what is waited for.
  void turn();
  /// Performs the work of one turn; true if nothing is left that is possible at once.
  bool work();
  void sweep();
  void sweep_later();

  std::unique_ptr<gateway::TcpListener> listener_;
  boost::asio::io_context io_{1};
  std::vector<std::shared_ptr<Connection>> connections_;  ///< oldest first
  host::EventLoop::Id turning_ = 0;
  host::EventLoop::Id sweeping_ = 0;
};

WebServer::Hub::~Hub() {
  if (turning_ != 0) loop.cancel(turning_);
  if (sweeping_ != 0) loop.cancel(sweeping_);
  for (const auto& connection : connections_) connection->end();
}

std::size_t WebServer::Hub::live_clients() const {
  return static_cast<std::size_t>(
      std::ranges::count_if(connections_, [](const auto& each) { return each->is_live(); }));
}

void WebServer::Hub::admit(host::Descriptor client) {
  make_room();
  if (connections_.size() >= limits.clients_max) return;
  ::setsockopt(client.get(), SOL_SOCKET, SO_SNDBUF, &limits.send_buffer, sizeof limits.send_buffer);
  sockaddr_storage peer{};
  socklen_t length = sizeof peer;
  if (::getsockname(client.get(), reinterpret_cast<sockaddr*>(&peer), &length) != 0) return;
  // Asio closes its descriptor, and so does the owner.
  const int own = ::fcntl(client.get(), F_DUPFD_CLOEXEC, 0);
  if (own < 0) return;
  tcp::socket socket(io_);
  boost::system::error_code failed;
  socket.assign(peer.ss_family == AF_INET6 ? tcp::v6() : tcp::v4(), own, failed);
  if (failed) {
    ::close(own);
    return;
  }
  socket.set_option(tcp::no_delay(true), failed);
  socket.non_blocking(true, failed);
  // Detects a client that is gone without notice while nothing is sent to it.
  socket.set_option(boost::asio::socket_base::keep_alive(true), failed);
  ::setsockopt(own, IPPROTO_TCP, TCP_KEEPIDLE, &keep_alive_seconds, sizeof keep_alive_seconds);
  const auto connection = make_connection(*this, std::move(socket));
  if (!connection->begin()) return;
  connections_.push_back(connection);
  sweep_later();
  turn_soon();
}

bool WebServer::Hub::make_unread_room(std::size_t bytes) {
  const auto since = [](const auto& each) {
    return each->unread() == 0 ? Time::max() : each->sending_since();
  };
  while (true) {
    std::size_t held = 0;
    for (const auto& each : connections_) held += each->unread();
    if (held == 0 || held + bytes <= limits.unread_max) return true;
    const auto longest = std::ranges::min_element(connections_, {}, since);
    if (since(*longest) > loop.now() - limits.unread_for_others) return false;
    (*longest)->end();
  }
}

/// The viewer that was silent for longest is removed before a new one is refused.
void WebServer::Hub::make_live_room() {
  if (live_clients() < limits.live_clients_max) return;
  std::shared_ptr<Connection> longest;
  for (const auto& each : connections_) {
    if (each->is_live() && (!longest || each->heard_at() < longest->heard_at())) longest = each;
  }
  longest->give_way();
}

/// The oldest connection without a WebSocket is removed before a new one is refused.
void WebServer::Hub::make_room() {
  std::erase_if(connections_, [](const auto& each) { return each->is_over(); });
  if (connections_.size() < limits.clients_max) return;
  const auto oldest =
      std::ranges::find_if(connections_, [](const auto& each) { return !each->is_live(); });
  if (oldest == connections_.end()) return;
  (*oldest)->end();
  connections_.erase(oldest);
}

bool WebServer::Hub::work() {
  const Time end = loop.now() + turn_time;
  for (int i = 0; i < handlers_per_turn && loop.now() < end; ++i) {
    if (io_.poll_one() == 0) return true;
  }
  return false;
}

void WebServer::Hub::turn() {
  io_.restart();
  if (!work()) turn_soon();
  for (const auto& connection : connections_) connection->rewatch();
  std::erase_if(connections_, [](const auto& each) { return each->is_over(); });
}

void WebServer::Hub::turn_soon() {
  if (turning_ != 0) return;
  turning_ = loop.at(loop.now(), [this](Time) {
    turning_ = 0;
    turn();
  });
}

void WebServer::Hub::offer() {
  for (const auto& connection : connections_) connection->offer();
}

void WebServer::Hub::sweep() {
  for (const auto& connection : connections_) {
    if (connection->is_late()) connection->time_out();
  }
  turn();
  if (!connections_.empty()) sweep_later();
}

void WebServer::Hub::sweep_later() {
  if (sweeping_ != 0) return;
  sweeping_ = loop.at(loop.now() + sweep_period, [this](Time) {
    sweeping_ = 0;
    sweep();
  });
}

WebServer::WebServer(std::unique_ptr<Hub> hub) : hub_(std::move(hub)) {}

WebServer::~WebServer() = default;

host::Result<std::unique_ptr<WebServer>> WebServer::create(host::EventLoop& loop,
                                                           const WebOptions& options,
                                                           WebApplication& application) {
  auto listener = gateway::TcpListener::create(loop, options.address);
  if (!listener) return listener.error();
  return std::unique_ptr<WebServer>(
      new WebServer(std::make_unique<Hub>(loop, *std::move(listener), options, application)));
}

const std::string& WebServer::address() const {
  return hub_->address();
}

std::string WebServer::url() const {
  return hub_->url();
}

std::vector<std::string> WebServer::urls() const {
  return hub_->urls();
}

bool WebServer::is_loopback() const {
  return hub_->is_loopback();
}

const std::string& WebServer::token() const {
  return hub_->token();
}

void WebServer::offer() {
  hub_->offer();
}

std::size_t WebServer::clients() const {
  return hub_->clients();
}

std::size_t WebServer::live_clients() const {
  return hub_->live_clients();
}

}  // namespace canvoy::web
