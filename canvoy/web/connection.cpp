// The only source that includes Boost.Beast, which takes as long to compile as twenty others.
#include "canvoy/web/connection.hpp"

#include <fmt/format.h>

#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>
#include <optional>
#include <utility>

#include "canvoy/can/check_invariant.hpp"
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

constexpr Duration last_words_time = 1s;  ///< to take an answer or a status before the end
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

class WebConnection : public Connection, public std::enable_shared_from_this<WebConnection> {
 public:
  WebConnection(ConnectionOwner& owner, tcp::socket socket)
      : owner_(owner), socket_(std::move(socket)) {}

  bool begin() override {
    const auto watch = owner_.loop.watch(socket_.native_handle(), {.readable = true},
                                         host::EventLoop::Ready::to<&WebConnection::ready>(*this));
    if (!watch) return false;
    watch_ = *watch;
    read(owner_.limits.request_time_out);
    return true;
  }
  void end() override {
    if (std::exchange(is_over_, true)) return;
    owner_.loop.unwatch(watch_);
    Failed ignored;
    socket().close(ignored);
    client_.reset();
  }
  bool is_over() const override { return is_over_; }
  bool is_live() const override { return client_ != nullptr; }
  std::size_t unread() const override {
    return is_writing_ && !is_over_ ? response_.body().size() + message_.size() : std::size_t{0};
  }
  Time sending_since() const override { return sending_since_; }
  Time heard_at() const override { return heard_at_; }
  void give_way() override {
    client_.reset();
    if (!stream_) return end();
    if (is_writing_) return;  // once that is sent
    is_writing_ = true;
    deadline_ = owner_.loop.now() + last_words_time;
    stream_->async_close({websocket::close_code::try_again_later, "a newer viewer has this place"},
                         [self = shared_from_this()](const Failed&) { self->end(); });
    owner_.turn_soon();
  }
  bool is_late() const override { return owner_.loop.now() >= deadline_; }
  void time_out() override {
    if (!std::exchange(is_awaited_, false)) return end();
    respond_last(told(504, "there was no answer in time"));
  }
  void rewatch() override {
    const host::Readiness wanted{.readable = is_reading_, .writable = is_writing_};
    if (is_over_ || wanted == wanted_) return;
    wanted_ = wanted;
    owner_.loop.rewatch(watch_, wanted);
  }
  void offer() override {
    if (client_ == nullptr || is_writing_ || is_over_) return;
    if (!owner_.make_unread_room(1)) return;
    message_ = client_->next();
    if (message_.size() > owner_.limits.answer_max) return end();
    if (!message_.empty()) send_message();
  }

 private:
  tcp::socket& socket() { return stream_ ? stream_->next_layer() : socket_; }

  void ready(host::Readiness readiness) {
    if (readiness.failed && !is_reading_ && !is_writing_) end();
    owner_.turn_soon();  // one for all ready connections
  }

  // HTTP

  void read(Duration time_out) {
    deadline_ = owner_.loop.now() + time_out;
    parser_.emplace();
    parser_->header_limit(owner_.limits.head_max);
    parser_->body_limit(owner_.limits.body_max);
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
                  .authorizations = head.count(http::field::authorization),
                  .types = head.count(http::field::content_type),
                  .socket_keys = head.count(http::field::sec_websocket_key),
                  .coding = view_of(head[http::field::transfer_encoding])});
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
    if (owner_.is_public) return serve(*target, nullptr);
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

  std::string cookie_name() const { return fmt::format("canvoy-{}", owner_.rules.port); }

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
        owner_.rules,
        {.host = target.host.empty() ? view_of(request_[http::field::host]) : target.host,
         .origin = view_of(request_[http::field::origin]),
         .site = is_page ? std::string_view() : view_of(request_["Sec-Fetch-Site"]),
         .token = token});
  }

  void serve(const RequestTarget& target, const PageFile* file) {
    const bool reads =
        request_.method() == http::verb::get || request_.method() == http::verb::head;
    const std::string methods =
        file != nullptr ? "GET, HEAD" : owner_.application.methods(target.path);
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
    deadline_ = owner_.loop.now() + owner_.limits.idle_time_out;
    owner_.application.answer(
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
    if (answer.body.size() > owner_.limits.answer_max) {
      return respond(told(500, "the answer is too long: ask for less"));
    }
    if (!owner_.make_unread_room(answer.body.size())) {
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
                                                         cookie_name(), owner_.rules.token));
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
    begin_to_send();
    http::async_write(socket_, response_,
                      [self = shared_from_this()](const Failed& failed, std::size_t) {
                        self->has_responded(failed);
                      });
    owner_.turn_soon();
  }

  void begin_to_send() {
    is_writing_ = true;
    sending_since_ = owner_.loop.now();
    deadline_ = sending_since_ + owner_.limits.message_time_out;
  }

  void has_responded(const Failed& failed) {
    is_writing_ = false;
    if (is_over_) return;
    if (failed) return end();
    response_ = {};  // frees the memory of what was sent
    if (!is_last_) return read(owner_.limits.idle_time_out);
    Failed ignored;
    socket_.shutdown(tcp::socket::shutdown_send, ignored);
    is_reading_ = true;
    deadline_ = owner_.loop.now() + last_words_time;
    drain();
  }

  /// Closing a socket with unread data would discard the answer.
  void drain() {
    if (is_late()) return end();
    buffer_.clear();
    socket_.async_read_some(buffer_.prepare(owner_.limits.head_max),
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
    owner_.make_live_room();
    heard_at_ = owner_.loop.now();
    client_ = owner_.application.connect(target);
    stream_.emplace(std::move(socket_));
    stream_->read_message_max(owner_.limits.body_max);
    stream_->text(true);
    websocket::permessage_deflate small;
    small.server_enable = true;
    stream_->set_option(small);
    // Each ping is answered, so it counts like a message.
    stream_->control_callback([this](websocket::frame_type, boost::beast::string_view) {
      if (says_too_much()) end();
    });
    is_writing_ = true;
    deadline_ = owner_.loop.now() + owner_.limits.message_time_out;
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
    const Time now = owner_.loop.now();
    heard_at_ = now;
    if (now - second_ >= Duration(1s)) {
      second_ = now;
      said_ = 0;
    }
    return ++said_ > owner_.limits.said_max_per_second;
  }

  void send_message() {
    check_invariant(stream_.has_value());
    begin_to_send();
    stream_->async_write(
        boost::asio::buffer(message_),
        [self = shared_from_this()](const Failed& failed, std::size_t) { self->has_sent(failed); });
    owner_.turn_soon();
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

  ConnectionOwner& owner_;
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
  Time second_{};  ///< start of the count of messages
  Time sending_since_{};
  Time heard_at_{};  ///< time of the last message of the client
  unsigned said_ = 0;
  bool is_reading_ = false;
  bool is_writing_ = false;
  bool is_last_ = false;  ///< this answer
  bool gives_cookie_ = false;
  bool is_awaited_ = false;  ///< the application has not answered yet
  bool is_over_ = false;
};

}  // namespace

std::shared_ptr<Connection> make_connection(ConnectionOwner& owner, tcp::socket socket) {
  return std::make_shared<WebConnection>(owner, std::move(socket));
}

}  // namespace canvoy::web
