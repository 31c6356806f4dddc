// The only source that includes Boost.Beast, which takes as long to compile as twenty others.
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
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>
#include <charconv>
#include <optional>
#include <utility>
#include <vector>

#include "canvoy/can/check_invariant.hpp"
#include "canvoy/can/host/local_addresses.hpp"
#include "canvoy/gateway/tcp_listener.hpp"
#include "canvoy/web/access.hpp"
#include "canvoy/web/http_date.hpp"
#include "canvoy/web/page_files.hpp"
#include "canvoy/web/request_head.hpp"

namespace canvoy::web {

namespace {

namespace http = boost::beast::http;
namespace websocket = boost::beast::websocket;
using boost::asio::ip::tcp;
using Failed = boost::system::error_code;
using HttpRequest = http::request<http::string_body>;
using HttpResponse = http::response<http::string_body>;

constexpr Duration sweep_period = 1s;
constexpr int keep_alive_seconds = 30;
/// Number of handlers for clients before the loop serves others: a client that always has a next
/// request would block it forever. Some handlers take microseconds, some write a megabyte.
constexpr int handlers_per_turn = 32;
constexpr Duration turn_time = 5ms;
constexpr std::string_view live_path = "/live";
constexpr std::string_view go_on = "HTTP/1.1 100 Continue\r\n\r\n";
/// The page loads nothing from elsewhere, and cannot be framed by another page.
constexpr const char* content_policy =
    "default-src 'self'; img-src 'self' data:; frame-ancestors 'none'; base-uri 'none'; "
    "form-action "
    "'none'";

std::string_view view_of(boost::beast::string_view text) {
  return {text.data(), text.size()};
}

std::uint16_t port_of(std::string_view address) {
  std::uint16_t port = 0;
  const std::string_view digits = address.substr(address.rfind(':') + 1);
  std::from_chars(digits.data(), digits.data() + digits.size(), port);
  return port;
}

std::string host_of(std::string_view address) {
  return std::string(address.substr(0, address.rfind(':')));
}

/// `text` must not contain a quotation mark or a backslash.
WebResponse told(unsigned status, std::string_view text) {
  return {.status = status, .body = fmt::format("{{\"error\":\"{}\"}}\n", text)};
}

/// The answer to an unreadable request, if the client is still present.
std::optional<WebResponse> answer_to(const Failed& failed) {
  if (failed == http::error::header_limit) return told(431, "the head of the request is too long");
  if (failed == http::error::body_limit) return told(413, "the body of the request is too long");
  const bool is_gone =
      failed == http::error::end_of_stream || failed == http::error::partial_message;
  if (is_gone || failed.category() != http::make_error_code(http::error::bad_method).category()) {
    return std::nullopt;
  }
  return told(400, "this is no request");
}

}  // namespace

class WebServer::Hub {
 public:
  Hub(host::EventLoop& loop, std::unique_ptr<gateway::TcpListener> listener,
      const WebOptions& options, WebApplication& application)
      : loop_(loop),
        limits_(options.limits),
        application_(application),
        is_public_(options.is_public),
        listener_(std::move(listener)),
        rules_{.port = port_of(listener_->address()),
               .is_loopback = listener_->is_loopback(),
               .host = host_of(listener_->address()),
               .token = options.token.empty() ? make_token() : options.token} {
    listener_->on_client(
        [this](host::Descriptor client, const std::string&) { admit(std::move(client)); });
  }
  ~Hub();
  Hub(const Hub&) = delete;
  Hub& operator=(const Hub&) = delete;

  const std::string& address() const { return listener_->address(); }
  std::string url() const { return url_at(address()); }
  std::vector<std::string> urls() const {
    std::vector<std::string> all;
    if (rules_.host == "0.0.0.0") {
      for (const std::string& each : host::outside_addresses()) {
        all.push_back(url_at(fmt::format("{}:{}", each, rules_.port)));
      }
    }
    if (all.empty()) all.push_back(url());
    return all;
  }
  bool is_loopback() const { return rules_.is_loopback; }
  const std::string& token() const { return rules_.token; }
  void offer();
  std::size_t clients() const { return connections_.size(); }
  std::size_t live_clients() const;

 private:
  class Connection;

  std::string url_at(std::string_view where) const {
    return fmt::format("http://{}/{}{}", where,
                       is_public_ ? "" : "?token=", is_public_ ? "" : token());
  }
  void admit(host::Descriptor client);
  void make_room();
  void make_live_room();
  /// Bytes of answers and messages that clients have not received yet.
  std::size_t unread() const;
  /// Performs what is possible at once, or a part of it, and sets what is waited for.
  void turn();
  /// Calls turn() in this turn of the loop or in the next one.
  void turn_soon();
  /// Performs the work of one turn; true if nothing is left that is possible at once.
  bool work();
  void sweep();
  void sweep_later();

  host::EventLoop& loop_;
  WebLimits limits_;
  WebApplication& application_;
  bool is_public_;  ///< for any client, without the page
  std::unique_ptr<gateway::TcpListener> listener_;
  AccessRules rules_;
  boost::asio::io_context io_{1};
  std::vector<std::shared_ptr<Connection>> connections_;  ///< oldest first
  host::EventLoop::Id turning_ = 0;
  host::EventLoop::Id sweeping_ = 0;
};

/// A client: its requests in sequence, or its WebSocket.
class WebServer::Hub::Connection : public std::enable_shared_from_this<Connection> {
 public:
  Connection(Hub& hub, tcp::socket socket) : hub_(hub), socket_(std::move(socket)) {}
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;
  ~Connection() = default;

  bool begin() {
    const auto watch = hub_.loop_.watch(socket_.native_handle(), {.readable = true},
                                        host::EventLoop::Ready::to<&Connection::ready>(*this));
    if (!watch) return false;
    watch_ = *watch;
    read(hub_.limits_.request_time_out);
    return true;
  }
  void end() {
    if (std::exchange(is_over_, true)) return;
    hub_.loop_.unwatch(watch_);
    Failed ignored;
    socket().close(ignored);
    client_.reset();
  }
  bool is_over() const { return is_over_; }
  bool is_live() const { return client_ != nullptr; }
  std::size_t unread() const {
    return is_writing_ ? response_.body().size() + message_.size() : std::size_t{0};
  }
  Time heard_at() const { return heard_at_; }
  /// Ends the WebSocket with a status that tells the page not to reconnect by itself.
  void give_way() {
    client_.reset();
    if (!stream_) return end();
    if (is_writing_) return;  // once that is sent
    is_writing_ = true;
    deadline_ = hub_.loop_.now() + sweep_period;
    stream_->async_close({websocket::close_code::try_again_later, "a newer viewer has this place"},
                         [self = shared_from_this()](const Failed&) { self->end(); });
    hub_.turn_soon();
  }
  bool is_late() const { return hub_.loop_.now() >= deadline_; }
  /// A client that waits for an answer gets a refusal and is disconnected, so that a late answer is
  /// not taken for that of another request; other clients are disconnected at once.
  void time_out() {
    if (!std::exchange(is_awaited_, false)) return end();
    respond_last(told(504, "there was no answer in time"));
  }
  void rewatch() {
    const host::Readiness wanted{.readable = is_reading_, .writable = is_writing_};
    if (is_over_ || wanted == wanted_) return;
    wanted_ = wanted;
    hub_.loop_.rewatch(watch_, wanted);
  }
  void offer() {
    if (client_ == nullptr || is_writing_ || is_over_) return;
    if (hub_.unread() >= hub_.limits_.unread_max) return;
    message_ = client_->next();
    if (message_.size() > hub_.limits_.answer_max) return end();
    if (!message_.empty()) send_message();
  }

 private:
  tcp::socket& socket() { return stream_ ? stream_->next_layer() : socket_; }

  void ready(host::Readiness readiness) {
    if (readiness.failed && !is_reading_ && !is_writing_) end();
    hub_.turn_soon();  // one for all ready connections
  }

  // HTTP

  void read(Duration time_out) {
    deadline_ = hub_.loop_.now() + time_out;
    parser_.emplace();
    parser_->header_limit(hub_.limits_.head_max);
    parser_->body_limit(hub_.limits_.body_max);
    request_ = {};
    is_reading_ = true;
    http::async_read_header(socket_, buffer_, *parser_,
                            [self = shared_from_this()](const Failed& failed, std::size_t) {
                              self->has_read_head(failed);
                            });
  }

  void has_read_head(const Failed& failed) {
    is_reading_ = false;
    if (is_over_) return;
    if (failed) return cannot_read(failed);
    const auto& head = parser_->get();
    const std::string_view fault =
        fault_of({.is_1_1 = head.version() == 11,
                  .hosts = head.count(http::field::host),
                  .origins = head.count(http::field::origin),
                  .sites = head.count("Sec-Fetch-Site"),
                  .authorizations = head.count(http::field::authorization)});
    if (!fault.empty()) return respond_last(told(400, fault));
    const boost::beast::string_view expected = head[http::field::expect];
    // Expect is ignored for HTTP/1.0 (RFC 9110, 10.1.1).
    if (expected.empty() || head.version() < 11 || parser_->is_done()) return read_body();
    if (!boost::beast::iequals(expected, "100-continue")) {
      return respond_last(told(417, "nothing but 100-continue can be expected"));
    }
    is_writing_ = true;
    boost::asio::async_write(socket_, boost::asio::buffer(go_on),
                             [self = shared_from_this()](const Failed& gone, std::size_t) {
                               self->is_writing_ = false;
                               if (self->is_over_) return;
                               gone ? self->end() : self->read_body();
                             });
  }

  void read_body() {
    is_reading_ = true;
    http::async_read(
        socket_, buffer_, *parser_,
        [self = shared_from_this()](const Failed& failed, std::size_t) { self->has_read(failed); });
  }

  void has_read(const Failed& failed) {
    is_reading_ = false;
    if (is_over_) return;
    if (failed) return cannot_read(failed);
    request_ = parser_->release();
    is_last_ = !request_.keep_alive();
    if (request_.target().size() > target_length_max) {
      return respond(told(414, "the target of the request is too long"));
    }
    const std::optional<RequestTarget> target = parse_target(view_of(request_.target()));
    if (!target) return respond(told(400, "this target is none"));
    if (hub_.is_public_) return serve(*target, nullptr);
    const std::string_view refusal = refusal_of(*target);
    if (!refusal.empty()) return respond(told(403, refusal));
    if (target->path == live_path) return upgrade(*target);
    serve(*target, find_page_file(target->path));
  }

  void cannot_read(const Failed& failed) {
    const std::optional<WebResponse> answer = answer_to(failed);
    if (!answer) return end();
    respond_last(*answer);
  }

  void respond_last(const WebResponse& answer) {
    is_last_ = true;
    respond(answer);
  }

  std::string cookie_name() const { return fmt::format("canvoy-{}", hub_.rules_.port); }

  std::string_view refusal_of(const RequestTarget& target) {
    constexpr std::string_view bearer = "Bearer ";
    const std::string_view authorization = view_of(request_[http::field::authorization]);
    std::string_view token = cookie_of(view_of(request_[http::field::cookie]), cookie_name());
    if (authorization.starts_with(bearer)) token = authorization.substr(bearer.size());
    if (const auto given = target.value("token")) token = *given;
    gives_cookie_ = target.value("token").has_value();
    // A link from elsewhere may lead to the page, which has no effect by itself.
    const bool is_page = find_page_file(target.path) != nullptr;
    return web::refusal_of(
        hub_.rules_,
        {.host = target.host.empty() ? view_of(request_[http::field::host]) : target.host,
         .origin = view_of(request_[http::field::origin]),
         .site = is_page ? std::string_view() : view_of(request_["Sec-Fetch-Site"]),
         .token = token});
  }

  void serve(const RequestTarget& target, const PageFile* file) {
    const bool reads =
        request_.method() == http::verb::get || request_.method() == http::verb::head;
    const std::string methods =
        file != nullptr ? "GET, HEAD" : hub_.application_.methods(target.path);
    if (methods.empty()) return respond(told(404, "there is nothing of this name"));
    const bool writes = request_.method() == http::verb::post;
    const bool can_read = methods.starts_with("GET");
    const bool can_write = methods.ends_with("POST");
    if (!(reads && can_read) && !(writes && can_write)) {
      const WebResponse answer = told(405, "this is not done with this method");
      return respond_with(answer, http::field::allow, methods);
    }
    if (file != nullptr) return respond(*file);
    if (writes && !is_json(view_of(request_[http::field::content_type]))) {
      return respond(told(415, "a POST has to have application/json"));
    }
    is_awaited_ = true;
    deadline_ = hub_.loop_.now() + hub_.limits_.idle_time_out;
    hub_.application_.answer(
        {.method = writes ? "POST" : "GET", .target = target, .body = request_.body()},
        [weak = weak_from_this()](const WebResponse& response) {
          if (const auto self = weak.lock()) self->respond_awaited(response);
        });
  }

  /// The answer of the application; a second one is ignored.
  void respond_awaited(const WebResponse& answer) {
    if (std::exchange(is_awaited_, false)) respond(answer);
  }

  /// A file of the page: compressed if the client accepts it, and not sent to a client that has it.
  void respond(const PageFile& file) {
    const bool is_known = view_of(request_[http::field::if_none_match]) == file.tag;
    const bool is_small = accepts_gzip(view_of(request_[http::field::accept_encoding]));
    begin_response(is_known ? 304 : 200, file.type);
    response_.set(http::field::cache_control, "no-cache");
    response_.set(http::field::etag, std::string(file.tag));
    response_.set(http::field::vary, "Accept-Encoding");
    if (!is_known && is_small) response_.set(http::field::content_encoding, "gzip");
    if (!is_known) response_.body() = is_small ? file.gzip : file.content;
    send_response();
  }

  void respond(const WebResponse& answer) {
    if (is_over_ || is_writing_) return;
    if (answer.body.size() > hub_.limits_.answer_max) {
      return respond(told(500, "the answer is too long: ask for less"));
    }
    const std::size_t unread = hub_.unread();
    if (unread != 0 && unread + answer.body.size() > hub_.limits_.unread_max) {
      const WebResponse busy = told(503, "others have not taken their answers yet");
      return respond_with(busy, http::field::retry_after, "1");
    }
    begin_response(answer.status, answer.type);
    response_.body() = answer.body;
    send_response();
  }

  void respond_with(const WebResponse& answer, http::field field, std::string_view value) {
    begin_response(answer.status, answer.type);
    response_.set(field, std::string(value));
    response_.body() = answer.body;
    send_response();
  }

  void begin_response(unsigned status, std::string_view type) {
    response_ = HttpResponse(http::int_to_status(status), 11);
    response_.set(http::field::date, http_date());
    response_.set(http::field::content_type, std::string(type));
    response_.set(http::field::cache_control, "no-store");
    response_.set("X-Content-Type-Options", "nosniff");
    response_.set("Referrer-Policy", "no-referrer");
    response_.set("Content-Security-Policy", content_policy);
    if (gives_cookie_ && status < 400) {
      response_.set(http::field::set_cookie, fmt::format("{}={}; HttpOnly; SameSite=Strict; Path=/",
                                                         cookie_name(), hub_.rules_.token));
    }
  }

  void send_response() {
    response_.keep_alive(!is_last_);
    if (response_.result() == http::status::upgrade_required) {
      response_.set(http::field::connection, is_last_ ? "Upgrade, close" : "Upgrade");
    }
    response_.prepare_payload();
    // A length would be that of the cached content (RFC 9110, 8.6).
    if (response_.result() == http::status::not_modified) {
      response_.erase(http::field::content_length);
    }
    if (request_.method() == http::verb::head) response_.body().clear();
    is_writing_ = true;
    deadline_ = hub_.loop_.now() + hub_.limits_.message_time_out;
    http::async_write(socket_, response_,
                      [self = shared_from_this()](const Failed& failed, std::size_t) {
                        self->has_responded(failed);
                      });
    hub_.turn_soon();
  }

  void has_responded(const Failed& failed) {
    is_writing_ = false;
    if (is_over_) return;
    if (failed) return end();
    response_ = {};  // frees the memory of what was sent
    if (!is_last_) return read(hub_.limits_.idle_time_out);
    Failed ignored;
    socket_.shutdown(tcp::socket::shutdown_send, ignored);
    is_reading_ = true;
    deadline_ = hub_.loop_.now() + sweep_period;
    drain();
  }

  /// Closing a socket with unread data would discard the answer.
  void drain() {
    if (is_late()) return end();
    buffer_.clear();
    socket_.async_read_some(buffer_.prepare(hub_.limits_.head_max),
                            [self = shared_from_this()](const Failed& failed, std::size_t) {
                              if (failed) return self->end();
                              if (!self->is_over_) self->drain();
                            });
  }

  // WebSocket

  void upgrade(const RequestTarget& target) {
    if (!websocket::is_upgrade(request_)) {
      // The answer with this status names the protocol (RFC 9110, 15.5.22).
      return respond_with(told(426, "this is a WebSocket"), http::field::upgrade, "websocket");
    }
    if (!is_socket_key(view_of(request_[http::field::sec_websocket_key]))) {
      return respond(told(400, "Sec-WebSocket-Key is 16 bytes in base64"));
    }
    hub_.make_live_room();
    heard_at_ = hub_.loop_.now();
    client_ = hub_.application_.connect(target);
    stream_.emplace(std::move(socket_));
    stream_->read_message_max(hub_.limits_.body_max);
    stream_->text(true);
    websocket::permessage_deflate small;
    small.server_enable = true;
    stream_->set_option(small);
    // Each ping is answered, so it counts like a message.
    stream_->control_callback([this](websocket::frame_type, boost::beast::string_view) {
      if (says_too_much()) end();
    });
    is_writing_ = true;
    deadline_ = hub_.loop_.now() + hub_.limits_.message_time_out;
    stream_->async_accept(request_, [self = shared_from_this()](const Failed& failed) {
      self->has_upgraded(failed);
    });
  }

  void has_upgraded(const Failed& failed) {
    is_writing_ = false;
    if (is_over_) return;
    if (failed) return end();
    if (client_ == nullptr) return give_way();
    deadline_ = never;
    listen();
    offer();
  }

  void listen() {
    is_reading_ = true;
    buffer_.clear();
    stream_->async_read(buffer_, [self = shared_from_this()](const Failed& failed, std::size_t) {
      self->has_heard(failed);
    });
  }

  void has_heard(const Failed& failed) {
    is_reading_ = false;
    if (is_over_) return;
    if (failed || client_ == nullptr || !stream_->got_text() || says_too_much()) return end();
    const auto bytes = buffer_.data();
    client_->said({static_cast<const char*>(bytes.data()), bytes.size()});
    listen();
    offer();
  }

  bool says_too_much() {
    const Time now = hub_.loop_.now();
    heard_at_ = now;
    if (now - second_ >= Duration(1s)) {
      second_ = now;
      said_ = 0;
    }
    return ++said_ > hub_.limits_.said_max_per_second;
  }

  void send_message() {
    check_invariant(stream_.has_value());
    is_writing_ = true;
    deadline_ = hub_.loop_.now() + hub_.limits_.message_time_out;
    stream_->async_write(
        boost::asio::buffer(message_),
        [self = shared_from_this()](const Failed& failed, std::size_t) { self->has_sent(failed); });
    hub_.turn_soon();
  }

  void has_sent(const Failed& failed) {
    is_writing_ = false;
    if (is_over_) return;
    if (failed) return end();
    deadline_ = never;
    message_ = {};  // frees the memory of what was sent
    if (client_ == nullptr) return give_way();
    if (client_->is_behind()) offer();
  }

  Hub& hub_;
  tcp::socket socket_;
  boost::beast::flat_buffer buffer_;
  std::optional<http::request_parser<http::string_body>> parser_;
  HttpRequest request_;
  HttpResponse response_;
  std::optional<websocket::stream<tcp::socket>> stream_;
  std::unique_ptr<LiveClient> client_;
  std::string message_;
  host::EventLoop::Id watch_ = 0;
  host::Readiness wanted_{.readable = true};
  Time deadline_ = never;
  Time second_{};    ///< start of the count of messages
  Time heard_at_{};  ///< time of the last message of the client
  unsigned said_ = 0;
  bool is_reading_ = false;
  bool is_writing_ = false;
  bool is_last_ = false;  ///< this answer
  bool gives_cookie_ = false;
  bool is_awaited_ = false;  ///< the application has not answered yet
  bool is_over_ = false;
};

WebServer::Hub::~Hub() {
  if (turning_ != 0) loop_.cancel(turning_);
  if (sweeping_ != 0) loop_.cancel(sweeping_);
  for (const auto& connection : connections_) connection->end();
}

std::size_t WebServer::Hub::live_clients() const {
  return static_cast<std::size_t>(
      std::ranges::count_if(connections_, [](const auto& each) { return each->is_live(); }));
}

void WebServer::Hub::admit(host::Descriptor client) {
  make_room();
  if (connections_.size() >= limits_.clients_max) return;
  ::setsockopt(client.get(), SOL_SOCKET, SO_SNDBUF, &limits_.send_buffer,
               sizeof limits_.send_buffer);
  sockaddr_storage peer{};
  socklen_t length = sizeof peer;
  if (::getsockname(client.get(), reinterpret_cast<sockaddr*>(&peer), &length) != 0) return;
  // Asio closes its descriptor, and so does the owner.
  const int own = ::fcntl(client.get(), F_DUPFD_CLOEXEC, 0);
  if (own < 0) return;
  tcp::socket socket(io_);
  Failed failed;
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
  const auto connection = std::make_shared<Connection>(*this, std::move(socket));
  if (!connection->begin()) return;
  connections_.push_back(connection);
  sweep_later();
  turn_soon();
}

std::size_t WebServer::Hub::unread() const {
  std::size_t bytes = 0;
  for (const auto& connection : connections_) bytes += connection->unread();
  return bytes;
}

/// The viewer that was silent for longest is removed before a new one is refused.
void WebServer::Hub::make_live_room() {
  if (live_clients() < limits_.live_clients_max) return;
  std::shared_ptr<Connection> longest;
  for (const auto& each : connections_) {
    if (each->is_live() && (!longest || each->heard_at() < longest->heard_at())) longest = each;
  }
  longest->give_way();
}

/// The oldest connection without a WebSocket is removed before a new one is refused.
void WebServer::Hub::make_room() {
  std::erase_if(connections_, [](const auto& each) { return each->is_over(); });
  if (connections_.size() < limits_.clients_max) return;
  const auto oldest =
      std::ranges::find_if(connections_, [](const auto& each) { return !each->is_live(); });
  if (oldest == connections_.end()) return;
  (*oldest)->end();
  connections_.erase(oldest);
}

bool WebServer::Hub::work() {
  const Time end = loop_.now() + turn_time;
  for (int i = 0; i < handlers_per_turn && loop_.now() < end; ++i) {
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
  turning_ = loop_.at(loop_.now(), [this](Time) {
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
  sweeping_ = loop_.at(loop_.now() + sweep_period, [this](Time) {
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
