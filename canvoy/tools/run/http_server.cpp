#include "canvoy/tools/run/http_server.hpp"

#include <fmt/format.h>
#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <mutex>
#include <utility>
#include <vector>

#include "canvoy/gateway/tcp_listener.hpp"
#include "canvoy/tools/run/http_request.hpp"
#include "canvoy/web/http_date.hpp"

namespace canvoy::tools {

namespace {

constexpr std::size_t chunk = 4096;  ///< bytes of one client in one turn

std::string response(HttpStatus status, bool is_head, std::string_view content_type,
                     std::string_view content) {
  std::string text = fmt::format("HTTP/1.1 {} {}\r\nDate: {}\r\nConnection: close\r\n",
                                 static_cast<int>(status), reason_of(status), web::http_date());
  const std::string explained = fmt::format("{}\n", reason_of(status));
  if (status == HttpStatus::ok) {
    text += "Cache-Control: no-cache\r\n";
  } else {
    content_type = "text/plain";
    content = explained;
  }
  if (status == HttpStatus::method_not_allowed) text += "Allow: GET, HEAD\r\n";
  text +=
      fmt::format("Content-Type: {}\r\nContent-Length: {}\r\n\r\n", content_type, content.size());
  if (!is_head) text += content;
  return text;
}

}  // namespace

/// All of it belongs to the thread of the server but publish() and clients().
class HttpServer::Listener {
 public:
  Listener(host::EventLoop& loop, std::unique_ptr<gateway::TcpListener> socket,
           std::string_view content_type, std::string content, const HttpLimits& limits)
      : loop_(loop),
        socket_(std::move(socket)),
        content_type_(content_type),
        limits_(limits),
        content_(std::move(content)) {
    socket_->on_client(
        [this](host::Descriptor client, const std::string&) { admit(std::move(client)); });
  }
  ~Listener() {
    if (sweeping_ != 0) loop_.cancel(sweeping_);
  }
  Listener(const Listener&) = delete;
  Listener& operator=(const Listener&) = delete;

  const std::string& address() const { return socket_->address(); }
  void publish(std::string content) {
    const std::scoped_lock lock(mutex_);
    content_ = std::move(content);
  }
  std::size_t clients() const { return count_; }

 private:
  class Connection;

  void admit(host::Descriptor client);
  std::string answer(HttpStatus status, bool is_head) const {
    const std::scoped_lock lock(mutex_);
    return response(status, is_head, content_type_, content_);
  }
  void sweep_later() {
    if (sweeping_ == 0) sweeping_ = loop_.at(loop_.now(), [this](Time) { sweep(); });
  }
  void sweep();

  host::EventLoop& loop_;
  std::unique_ptr<gateway::TcpListener> socket_;
  std::string content_type_;
  HttpLimits limits_;
  mutable std::mutex mutex_;
  std::string content_;
  std::vector<std::unique_ptr<Connection>> connections_;  ///< the oldest first
  std::atomic<std::size_t> count_ = 0;
  host::EventLoop::Id sweeping_ = 0;
};

/// A client: its request is read, then its answer is sent, then it is waited for until it goes. A
/// socket that is closed while something of the client is unread would take the answer along.
class HttpServer::Listener::Connection {
 public:
  Connection(Listener& server, host::Descriptor socket)
      : server_(server), socket_(std::move(socket)) {}
  ~Connection() {
    if (watch_ != 0) server_.loop_.unwatch(watch_);
    if (timer_ != 0) server_.loop_.cancel(timer_);
  }
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  bool begin() {
    const auto watch = server_.loop_.watch(socket_.get(), {.readable = true},
                                           host::EventLoop::Ready::to<&Connection::ready>(*this));
    if (!watch) return false;
    watch_ = *watch;
    timer_ = server_.loop_.at(server_.loop_.now() + server_.limits_.time_out,
                              [this](Time) { time_over(); });
    return true;
  }
  bool is_over() const { return is_over_; }

 private:
  void ready(host::Readiness readiness) {
    if (readiness.failed) return end();
    if (readiness.readable) receive();
    if (!is_over_ && request_.is_known()) send();
  }

  void receive() {
    std::array<char, chunk> bytes;
    const ssize_t size = ::recv(socket_.get(), bytes.data(), bytes.size(), 0);
    if (size < 0) {
      if (!gateway::is_passing(errno)) end();
      return;
    }
    if (size == 0) {
      // It may have said its last and wait for the answer.
      is_silent_ = true;
      if (!request_.is_known()) end();
      return;
    }
    const bool was_known = request_.is_known();
    if (!was_known && request_.append({bytes.data(), static_cast<std::size_t>(size)})) {
      output_ = server_.answer(request_.status(), request_.is_head());
    }
  }

  void send() {
    while (sent_ < output_.size()) {
      const ssize_t size =
          ::send(socket_.get(), output_.data() + sent_, output_.size() - sent_, MSG_NOSIGNAL);
      if (size < 0 && errno == EINTR) continue;
      if (size < 0 && !gateway::is_passing(errno)) return end();
      if (size < 0) break;
      sent_ += static_cast<std::size_t>(size);
    }
    const bool is_sent = sent_ == output_.size();
    if (is_sent && is_silent_) return end();
    if (is_sent && !std::exchange(is_closing_, true)) ::shutdown(socket_.get(), SHUT_WR);
    server_.loop_.rewatch(watch_, {.readable = !is_silent_, .writable = !is_sent});
  }

  void time_over() {
    timer_ = 0;
    if (!request_.is_known() && request_.has_begun()) {
      // As far as the socket takes it at once.
      output_ = server_.answer(HttpStatus::request_time_out, false);
      [[maybe_unused]] const ssize_t size =
          ::send(socket_.get(), output_.data(), output_.size(), MSG_NOSIGNAL);
    }
    end();
  }

  void end() {
    if (std::exchange(is_over_, true)) return;
    if (watch_ != 0) server_.loop_.unwatch(std::exchange(watch_, 0));
    server_.sweep_later();
  }

  Listener& server_;
  host::Descriptor socket_;
  HttpRequest request_;
  std::string output_;
  std::size_t sent_ = 0;
  host::EventLoop::Id watch_ = 0;
  host::EventLoop::Id timer_ = 0;
  bool is_silent_ = false;   ///< the client says no more
  bool is_closing_ = false;  ///< it was told that there is no more
  bool is_over_ = false;     ///< until the next turn of the loop
};

void HttpServer::Listener::admit(host::Descriptor client) {
  sweep();
  if (connections_.size() >= limits_.clients_max) connections_.erase(connections_.begin());
  auto connection = std::make_unique<Connection>(*this, std::move(client));
  if (connection->begin()) connections_.push_back(std::move(connection));
  count_ = connections_.size();
}

void HttpServer::Listener::sweep() {
  if (sweeping_ != 0) loop_.cancel(std::exchange(sweeping_, 0));
  std::erase_if(connections_, [](const auto& connection) { return connection->is_over(); });
  count_ = connections_.size();
}

HttpServer::HttpServer(std::unique_ptr<host::EventLoop> loop, std::unique_ptr<Listener> listener)
    : loop_(std::move(loop)), listener_(std::move(listener)) {
  // Signals are those of the thread that plays.
  sigset_t all;
  sigset_t before;
  ::sigfillset(&all);
  ::pthread_sigmask(SIG_SETMASK, &all, &before);
  thread_ = std::thread([this] { loop_->run(); });
  ::pthread_sigmask(SIG_SETMASK, &before, nullptr);
}

HttpServer::~HttpServer() {
  loop_->stop();
  thread_.join();
}

host::Result<std::unique_ptr<HttpServer>> HttpServer::create(std::string_view address,
                                                             std::string_view content_type,
                                                             std::string content,
                                                             const HttpLimits& limits) {
  host::Result<std::unique_ptr<host::EventLoop>> loop = host::EventLoop::create();
  if (!loop) return loop.error();
  auto socket = gateway::TcpListener::create(**loop, address);
  if (!socket) return socket.error();
  auto listener = std::make_unique<Listener>(**loop, *std::move(socket), content_type,
                                             std::move(content), limits);
  return std::unique_ptr<HttpServer>(new HttpServer(*std::move(loop), std::move(listener)));
}

const std::string& HttpServer::address() const {
  return listener_->address();
}

void HttpServer::publish(std::string content) {
  listener_->publish(std::move(content));
}

std::size_t HttpServer::clients() const {
  return listener_->clients();
}

}  // namespace canvoy::tools
