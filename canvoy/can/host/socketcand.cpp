#include "canvoy/can/host/socketcand.hpp"

#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <utility>

namespace canvoy::host {

namespace {

constexpr Duration open_time_out = 3s;
constexpr std::string_view no_answer = "no answer within 3 s";
constexpr Duration reconnect_interval = 1s;
/// Limit of unsent data: a server that takes no data blocks the sender, but does not fill the
/// memory.
constexpr std::size_t unsent_max = 64UL * 1024;

// A server without power, or behind a cut cable, does not close the connection. TCP by itself would
// wait two hours before it probes a silent one, and repeat sent data for a quarter of an hour. In
// less than ten seconds a busy network, or a radio link, may recover.
constexpr int seconds_until_probe = 5;  ///< without received data
constexpr int seconds_between_probes = 1;
constexpr int probes_max = 5;
constexpr int milliseconds_unanswered_max = 10'000;

/// As far as the system supports it; otherwise the loss is noticed later.
void notice_loss(const Descriptor& socket) {
  const auto set = [&](int level, int option, int value) {
    setsockopt(socket.get(), level, option, &value, sizeof value);
  };
  set(SOL_SOCKET, SO_KEEPALIVE, 1);
  set(IPPROTO_TCP, TCP_KEEPIDLE, seconds_until_probe);
  set(IPPROTO_TCP, TCP_KEEPINTVL, seconds_between_probes);
  set(IPPROTO_TCP, TCP_KEEPCNT, probes_max);
  set(IPPROTO_TCP, TCP_USER_TIMEOUT, milliseconds_unanswered_max);
}

}  // namespace

Result<std::unique_ptr<Carrier>> Socketcand::open(EventLoop& loop, const BusAddress& address) {
  std::unique_ptr<Socketcand> carrier(new Socketcand(loop, address));
  for (const auto step : {&Socketcand::resolve, &Socketcand::connect, &Socketcand::wait_until_up,
                          &Socketcand::watch}) {
    const Result<void> done = (carrier.get()->*step)();
    if (!done) return done.error();
  }
  carrier->is_open_ = true;
  return std::unique_ptr<Carrier>(std::move(carrier));
}

Socketcand::Socketcand(EventLoop& loop, const BusAddress& address)
    : loop_(loop), address_(address), name_(to_string(address)) {}

Socketcand::~Socketcand() {
  loop_.unwatch(watch_);
  for (const EventLoop::Id timer : {retry_, confirmation_}) loop_.cancel(timer);
}

Error Socketcand::failure(std::string_view what) const {
  return {name_, std::string(what),
          "a socketcand has to serve " + address_.interface + " there: `socketcand -i " +
              address_.interface + " -l eth0`"};
}

Result<void> Socketcand::resolve() {
  addrinfo hints{};
  hints.ai_socktype = SOCK_STREAM;
  addrinfo* found = nullptr;
  const std::string port = std::to_string(address_.tcp.port);
  const int error = getaddrinfo(address_.tcp.host.c_str(), port.c_str(), &hints, &found);
  if (error != 0) {
    return Error{name_, gai_strerror(error), "check the name of the server, or give its address"};
  }
  server_size_ = found->ai_addrlen;
  std::memcpy(&server_, found->ai_addr, server_size_);
  freeaddrinfo(found);
  return {};
}

/// Begins to connect.
Result<void> Socketcand::connect() {
  stage_ = Stage::connecting;
  messages_.clear();
  unsent_.clear();
  socket_ = Descriptor{
      ::socket(server_.ss_family, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, IPPROTO_TCP)};
  const int on = 1;
  setsockopt(socket_.get(), IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
  notice_loss(socket_);
  const auto* address = reinterpret_cast<const sockaddr*>(&server_);
  if (::connect(socket_.get(), address, server_size_) == 0 || errno == EINPROGRESS) return {};
  return failure(std::strerror(errno));
}

/// Waits, since the loop does not run yet.
Result<void> Socketcand::wait_until_up() {
  const Time end = loop_.now() + open_time_out;
  while (stage_ != Stage::up) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - loop_.now());
    const bool is_connecting = stage_ == Stage::connecting || !unsent_.empty();
    pollfd wanted{socket_.get(), static_cast<short>(is_connecting ? POLLOUT : POLLIN), 0};
    if (left.count() <= 0 || ::poll(&wanted, 1, static_cast<int>(left.count())) == 0) {
      return failure(no_answer);
    }
    on_ready({.readable = (wanted.revents & POLLIN) != 0,
              .writable = (wanted.revents & POLLOUT) != 0,
              .failed = (wanted.revents & (POLLERR | POLLHUP)) != 0});
    if (!refusal_.empty()) return failure(refusal_);
  }
  return {};
}

Result<void> Socketcand::watch() {
  const Result<EventLoop::Id> watched =
      loop_.watch(socket_.get(), {.readable = true, .writable = stage_ == Stage::connecting},
                  EventLoop::Ready::to<&Socketcand::on_ready>(*this));
  if (!watched) return watched.error();
  watch_ = *watched;
  return {};
}

void Socketcand::on_ready(Readiness ready) {
  if (stage_ == Stage::connecting) {
    if (!finish_connecting()) return;
  }
  if (ready.readable || ready.failed) receive();
  if (ready.writable && socket_) flush();
}

bool Socketcand::finish_connecting() {
  int error = 0;
  socklen_t size = sizeof error;
  getsockopt(socket_.get(), SOL_SOCKET, SO_ERROR, &error, &size);
  if (error != 0) {
    lost(std::strerror(error));
    return false;
  }
  stage_ = Stage::greeting;
  if (is_open_) loop_.rewatch(watch_, {.readable = true});
  return true;
}

void Socketcand::receive() {
  constexpr std::size_t bytes_max = 4096;
  std::array<char, bytes_max> bytes;
  const ssize_t size = ::recv(socket_.get(), bytes.data(), bytes_max, 0);
  if (size < 0 && (errno == EAGAIN || errno == EINTR)) return;
  if (size <= 0) return lost(size == 0 ? "the server has closed the connection" : strerror(errno));
  messages_.add({bytes.data(), static_cast<std::size_t>(size)});
  while (socket_) {
    const auto message = messages_.next();
    if (!message) break;
    message_arrived(*message);
  }
  counters_.malformed += messages_.take_malformed();
}

void Socketcand::message_arrived(std::string_view message) {
  if (stage_ != Stage::up) return answer(message);
  if (const std::optional<Frame> frame = parse_socketcand_frame(message)) {
    if (frame->is_error()) ++counters_.error_frames;
    return events_.frame(*frame, loop_.now(), Origin::elsewhere);
  }
  ++counters_.malformed;
}

/// Handles an answer of the server, before the bus is open.
void Socketcand::answer(std::string_view message) {
  const std::string_view wanted = stage_ == Stage::greeting ? "hi" : "ok";
  if (message != wanted) {
    return lost(stage_ == Stage::greeting ? "this is no socketcand"
                                          : "the server says \"" + std::string(message) + '"');
  }
  if (stage_ == Stage::greeting) {
    stage_ = Stage::opening;
    return say("< open " + address_.interface + " >");
  }
  if (stage_ == Stage::opening) {
    stage_ = Stage::choosing_raw;
    return say("< rawmode >");
  }
  stage_ = Stage::up;
  loop_.cancel(retry_);
  if (std::exchange(is_down_, false)) events_.state(BusState::error_active, loop_.now());
}

void Socketcand::say(std::string_view text) {
  unsent_ += text;
  flush();
}

void Socketcand::flush() {
  while (!unsent_.empty()) {
    const ssize_t sent = ::send(socket_.get(), unsent_.data(), unsent_.size(), MSG_NOSIGNAL);
    if (sent < 0 && errno == EINTR) continue;
    if (sent < 0) break;  // receive() detects the error
    unsent_.erase(0, static_cast<std::size_t>(sent));
  }
  if (watch_ != 0) loop_.rewatch(watch_, {.readable = true, .writable = !unsent_.empty()});
  if (!unsent_.empty() || stage_ != Stage::up || !is_open_) return;
  if (confirmation_ == 0) {
    confirmation_ = loop_.at(loop_.now(), [this](Time) {
      confirmation_ = 0;
      confirm();
    });
  }
}

/// Data passed to the connection counts as having been on the bus.
void Socketcand::confirm() {
  while (!unconfirmed_.empty()) {
    const Frame frame = unconfirmed_.front();
    unconfirmed_.pop_front();
    events_.frame(frame, loop_.now(), Origin::own);
  }
  events_.writable();
}

SendResult Socketcand::send(const Frame& frame) {
  if (stage_ != Stage::up || frame.is_error()) return SendResult::refused;
  if (unsent_.size() > unsent_max) return SendResult::busy;
  unconfirmed_.push_back(frame);
  say(socketcand_send_message(frame));
  return SendResult::sent;
}

void Socketcand::lost(std::string_view what) {
  refusal_ = what;
  if (!is_open_) return;
  loop_.unwatch(std::exchange(watch_, 0));
  socket_ = Descriptor{};
  stage_ = Stage::connecting;
  unconfirmed_.clear();
  loop_.cancel(retry_);
  retry_ = loop_.at(loop_.now() + reconnect_interval, [this](Time) { try_again(); });
  if (std::exchange(is_down_, true)) return;
  events_.trouble(failure(what));
  events_.state(BusState::bus_off, loop_.now());
}

void Socketcand::try_again() {
  if (const Result<void> begun = connect(); !begun || !watch()) return lost("no connection");
  retry_ = loop_.at(loop_.now() + open_time_out, [this](Time) { lost(no_answer); });
}

}  // namespace canvoy::host
