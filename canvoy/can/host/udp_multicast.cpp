#include "canvoy/can/host/udp_multicast.hpp"

#include <arpa/inet.h>
#include <sys/socket.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <utility>

#include "canvoy/can/host/msgpack_frame.hpp"

namespace canvoy::host {

namespace {

constexpr Duration retry_interval = 100ms;

in_addr address_of(const UdpGroup& group) {
  in_addr address{};
  static_assert(sizeof address == sizeof group.group);
  std::memcpy(&address, group.group.data(), sizeof address);
  return address;
}

sockaddr_in socket_address(const UdpGroup& group) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(group.port);
  address.sin_addr = address_of(group);
  return address;
}

const sockaddr* generic(const sockaddr_in& address) {
  return reinterpret_cast<const sockaddr*>(&address);
}

Descriptor datagram_socket() {
  return Descriptor{::socket(AF_INET, SOCK_DGRAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0)};
}

template <class Value>
bool set_ip_option(const Descriptor& socket, int option, Value value) {
  return setsockopt(socket.get(), IPPROTO_IP, option, &value, sizeof value) == 0;
}

}  // namespace

Result<std::unique_ptr<Carrier>> UdpMulticast::open(EventLoop& loop, const UdpGroup& group) {
  std::unique_ptr<UdpMulticast> carrier(new UdpMulticast(loop, group));
  if (!carrier->open_receiver() || !carrier->open_sender()) return carrier->failure(errno);
  const Result<void> watched = carrier->watch();
  if (!watched) return watched.error();
  return std::unique_ptr<Carrier>(std::move(carrier));
}

UdpMulticast::UdpMulticast(EventLoop& loop, const UdpGroup& group)
    : loop_(loop),
      group_(group),
      name_(to_string({.kind = BusType::udp_multicast, .udp = group})) {}

UdpMulticast::~UdpMulticast() {
  loop_.unwatch(receive_watch_);
  loop_.unwatch(send_watch_);
  loop_.cancel(retry_);
  loop_.cancel(telling_);
}

// Bound to the group, not to the port alone, which would let the groups of other programs in.
bool UdpMulticast::open_receiver() {
  receiver_ = datagram_socket();
  const int on = 1;
  const sockaddr_in address = socket_address(group_);
  ip_mreqn membership{};
  membership.imr_multiaddr = address.sin_addr;
  if (!receiver_ || setsockopt(receiver_.get(), SOL_SOCKET, SO_REUSEADDR, &on, sizeof on) != 0)
    return false;
  ReceiveBatch::request_details(receiver_.get());
  return ::bind(receiver_.get(), generic(address), sizeof address) == 0 &&
         set_ip_option(receiver_, IP_ADD_MEMBERSHIP, membership);
}

// Own datagrams are recognised by their address, that of a socket which is connected to the group,
// and by their port. A connected socket would send on the interface that has the address, and not
// on the one that has the route.
bool UdpMulticast::open_sender() {
  sender_ = datagram_socket();
  const Descriptor probe = datagram_socket();
  const sockaddr_in group = socket_address(group_);
  const sockaddr_in any{.sin_family = AF_INET, .sin_port = 0, .sin_addr = {}, .sin_zero = {}};
  sockaddr_in source{};
  socklen_t size = sizeof own_;
  const bool is_open =
      sender_ && probe && set_ip_option(sender_, IP_MULTICAST_TTL, int{group_.ttl}) &&
      set_ip_option(sender_, IP_MULTICAST_LOOP, 1) &&
      ::bind(sender_.get(), generic(any), sizeof any) == 0 &&
      ::getsockname(sender_.get(), reinterpret_cast<sockaddr*>(&own_), &size) == 0 &&
      ::connect(probe.get(), generic(group), sizeof group) == 0 &&
      ::getsockname(probe.get(), reinterpret_cast<sockaddr*>(&source), &size) == 0;
  own_.sin_addr = source.sin_addr;
  return is_open;
}

Result<void> UdpMulticast::watch() {
  const Result<EventLoop::Id> receives =
      loop_.watch(receiver_.get(), {.readable = true},
                  EventLoop::Ready::to<&UdpMulticast::on_receivable>(*this));
  if (!receives) return receives.error();
  receive_watch_ = *receives;
  const Result<EventLoop::Id> sends =
      loop_.watch(sender_.get(), {}, EventLoop::Ready::to<&UdpMulticast::on_sendable>(*this));
  if (!sends) return sends.error();
  send_watch_ = *sends;
  return {};
}

Error UdpMulticast::failure(int error) const {
  if (error == ENETUNREACH || error == ENODEV || error == EHOSTUNREACH || error == ENETDOWN) {
    return {
        name_, "no interface has a route for multicast",
        "within this machine: `ip link set lo up multicast on && ip route add 239.0.0.0/8 dev lo`"};
  }
  if (error == EADDRINUSE)
    return {name_, "another program has the port for itself", "choose another port"};
  return {name_, std::strerror(error), ""};
}

SendResult UdpMulticast::send(const Frame& frame) {
  const std::chrono::duration<double> since_1970 = loop_.epoch() + loop_.now().time_since_epoch();
  const MsgpackFrame datagram(frame, since_1970.count());
  const std::span<const std::uint8_t> bytes = datagram.bytes();
  const sockaddr_in group = socket_address(group_);
  ssize_t sent = 0;
  do {
    sent = ::sendto(sender_.get(), bytes.data(), bytes.size(), 0, generic(group), sizeof group);
  } while (sent < 0 && errno == EINTR);
  if (sent >= 0) {
    in_trouble_ = false;
    return SendResult::sent;
  }
  const int error = errno;
  if (error == EAGAIN) {
    loop_.rewatch(send_watch_, {.writable = true});
    return SendResult::busy;
  }
  loop_.cancel(retry_);
  retry_ = loop_.at(loop_.now() + retry_interval, [this](Time) { events_.writable(); });
  if (error == ENOBUFS) return SendResult::busy;
  if (!std::exchange(in_trouble_, true)) tell_soon(error);
  return SendResult::refused;
}

// The caller of send() does not expect events.
void UdpMulticast::tell_soon(int error) {
  loop_.cancel(telling_);
  telling_ = loop_.at(loop_.now(), [this, error](Time) { events_.trouble(failure(error)); });
}

// An error for an earlier datagram stays at the socket, and would wake the loop forever.
void UdpMulticast::on_sendable(Readiness ready) {
  if (ready.failed) {
    int error = 0;
    socklen_t size = sizeof error;
    getsockopt(sender_.get(), SOL_SOCKET, SO_ERROR, &error, &size);
  }
  if (!ready.writable) return;
  loop_.rewatch(send_watch_, {});
  events_.writable();
}

void UdpMulticast::on_receivable(Readiness) {
  for (int batch = 0; batch < ReceiveBatch::batches_max; ++batch) {
    const int count = batch_.receive(receiver_.get());
    if (count <= 0) return;
    counters_.overrun += batch_.newly_dropped();
    for (int i = 0; i < count; ++i) datagram_arrived(batch_.packet(static_cast<std::size_t>(i)));
  }
}

bool UdpMulticast::is_foreign(const sockaddr_in& sender) {
  if (group_.ttl > 0 || sender.sin_addr.s_addr == own_.sin_addr.s_addr) return false;
  return !local_.contains(sender.sin_addr, loop_.now());
}

void UdpMulticast::tell_foreign(const sockaddr_in& sender) {
  std::array<char, INET_ADDRSTRLEN> text{};
  inet_ntop(AF_INET, &sender.sin_addr, text.data(), text.size());
  events_.trouble({name_, std::string("frames from ") + text.data() + " are not taken",
                   "with ?ttl=1 the bus reaches beyond this machine"});
}

void UdpMulticast::datagram_arrived(const ReceivedPacket& packet) {
  if (is_foreign(*packet.sender)) {
    if (counters_.foreign++ == 0) tell_foreign(*packet.sender);
    return;
  }
  const DecodedFrame decoded = packet.cut_off ? DecodedFrame{} : decode_msgpack_frame(packet.bytes);
  if (decoded.kind == FrameKind::malformed) {
    ++counters_.malformed;
  } else if (decoded.kind == FrameKind::fd) {
    ++counters_.fd;
  } else {
    // The address of this machine may change.
    const sockaddr_in& sender = *packet.sender;
    const bool own =
        sender.sin_port == own_.sin_port && (sender.sin_addr.s_addr == own_.sin_addr.s_addr ||
                                             local_.contains(sender.sin_addr, loop_.now()));
    if (decoded.frame.is_error()) ++counters_.error_frames;
    events_.frame(decoded.frame, loop_.time_of(packet.stamp),
                  own ? Origin::own : Origin::elsewhere);
  }
}

}  // namespace canvoy::host
