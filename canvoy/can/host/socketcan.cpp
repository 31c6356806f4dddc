#include "canvoy/can/host/socketcan.hpp"

#include <linux/can.h>
#include <linux/can/error.h>
#include <linux/can/raw.h>
#include <net/if.h>
#include <sys/ioctl.h>
#include <sys/socket.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <span>
#include <utility>

#include "canvoy/can/host/can_link.hpp"
#include "canvoy/can/host/socketcan_frame.hpp"

namespace canvoy::host {

namespace {

// The transmit queue of the interface does not signal that it has room again.
constexpr Duration full_queue_retry = 1ms;
constexpr Duration search_interval = 100ms;
// One round reads up to this many times 32 frames from a socket: time must not overtake the frames
// that wait in it.

Descriptor open_socket() {
  return Descriptor{::socket(PF_CAN, SOCK_RAW | SOCK_NONBLOCK | SOCK_CLOEXEC, CAN_RAW)};
}

ifreq request_for(std::string_view interface) {
  ifreq request{};
  std::copy_n(interface.begin(), std::min<std::size_t>(interface.size(), IFNAMSIZ - 1),
              request.ifr_name);
  return request;
}

bool is_up(int socket, std::string_view interface) {
  ifreq request = request_for(interface);
  return ioctl(socket, SIOCGIFFLAGS, &request) == 0 && (request.ifr_flags & IFF_UP) != 0;
}

int bind_to(int socket, std::string_view interface) {
  ifreq request = request_for(interface);
  if (ioctl(socket, SIOCGIFINDEX, &request) != 0) return errno;
  sockaddr_can address{};
  address.can_family = AF_CAN;
  address.can_ifindex = request.ifr_ifindex;
  return ::bind(socket, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0 ? 0
                                                                                          : errno;
}

Error no_interface(std::string_view interface) {
  return {std::string(interface), "there is no such interface",
          "`ip -br link` lists what there is; `ip link add vcan0 type vcan` makes a virtual one"};
}

Error down(std::string_view interface) {
  return {std::string(interface), "the interface is down",
          "bring it up: `ip link set " + std::string(interface) +
              " up`, a real one with `type can bitrate 125000`"};
}

}  // namespace

Result<std::unique_ptr<Carrier>> SocketCan::open(EventLoop& loop, std::string_view interface) {
  Descriptor socket = open_socket();
  if (!socket) {
    const bool missing = errno == EAFNOSUPPORT || errno == EPROTONOSUPPORT;
    return Error{std::string(interface),
                 missing ? "this kernel has no CAN sockets" : std::strerror(errno),
                 missing ? "load them by `modprobe can_raw`, or use udp: instead" : ""};
  }
  std::unique_ptr<SocketCan> carrier(new SocketCan(loop, interface, std::move(socket)));
  const Result<void> configured = carrier->configure();
  if (!configured) return configured.error();
  return std::unique_ptr<Carrier>(std::move(carrier));
}

SocketCan::SocketCan(EventLoop& loop, std::string_view interface, Descriptor socket)
    : loop_(loop), interface_(interface), socket_(std::move(socket)) {}

SocketCan::~SocketCan() {
  loop_.unwatch(watch_);
  loop_.cancel(retry_);
  loop_.cancel(search_);
  loop_.cancel(report_);
}

// The options are set before the address: no frame arrives without its time, and no error frame is
// missed.
Result<void> SocketCan::configure() {
  const int on = 1;
  const can_err_mask_t errors = CAN_ERR_MASK;
  setsockopt(socket_.get(), SOL_CAN_RAW, CAN_RAW_RECV_OWN_MSGS, &on, sizeof on);
  setsockopt(socket_.get(), SOL_CAN_RAW, CAN_RAW_ERR_FILTER, &errors, sizeof errors);
  ReceiveBatch::request_details(socket_.get());
  if (!filters_.empty()) set_filters();

  const int error = bind_to(socket_.get(), interface_);
  if (error == ENODEV && if_nametoindex(interface_.c_str()) != 0) {
    return Error{interface_, "this is no CAN interface", "`ip -br link show type can` lists those"};
  }
  if (error == ENODEV) return no_interface(interface_);
  if (error != 0) return Error{interface_, std::strerror(error), ""};
  if (!is_up(socket_.get(), interface_)) return down(interface_);
  report_present_state();
  return watch();
}

/// Reports the present state, since error frames report changes only.
void SocketCan::report_present_state() {
  const Result<CanLink> link = read_can_link(interface_);
  const BusState present =
      link ? link->state.value_or(BusState::error_active) : BusState::error_active;
  if (present == BusState::error_active) return;
  loop_.cancel(report_);
  report_ = loop_.at(loop_.now(), [this, present](Time now) { events_.state(present, now); });
}

Result<void> SocketCan::watch() {
  const Result<EventLoop::Id> watched = loop_.watch(
      socket_.get(), {.readable = true}, EventLoop::Ready::to<&SocketCan::on_ready>(*this));
  if (!watched) return watched.error();
  watch_ = *watched;
  return {};
}

// Remote frames pass like data frames. With more identifiers than the kernel supports, all pass.
void SocketCan::accept(const AcceptedIds* ids) {
  filters_.clear();
  if (ids != nullptr && ids->count() < CAN_RAW_FILTER_MAX) {
    filters_.push_back({.can_id = CAN_EFF_FLAG, .can_mask = CAN_EFF_FLAG});
    for (canid_t id = 0; id < ids->size(); ++id) {
      if ((*ids)[id]) filters_.push_back({.can_id = id, .can_mask = CAN_SFF_MASK | CAN_EFF_FLAG});
    }
  }
  set_filters();
}

void SocketCan::set_filters() {
  constexpr can_filter everything{.can_id = 0, .can_mask = 0};
  const std::span<const can_filter> filters =
      filters_.empty() ? std::span(&everything, 1) : std::span<const can_filter>(filters_);
  setsockopt(socket_.get(), SOL_CAN_RAW, CAN_RAW_FILTER, filters.data(),
             static_cast<socklen_t>(filters.size_bytes()));
}

SendResult SocketCan::send(const Frame& frame) {
  const can_frame raw = to_kernel(frame);
  ssize_t written = 0;
  do {
    written = ::write(socket_.get(), &raw, sizeof raw);
  } while (written < 0 && errno == EINTR);
  if (written == sizeof raw) return SendResult::sent;
  if (errno == EAGAIN) {
    loop_.rewatch(watch_, {.readable = true, .writable = true});
    return SendResult::busy;
  }
  if (errno == ENOBUFS) {
    loop_.cancel(retry_);
    retry_ = loop_.at(loop_.now() + full_queue_retry, [this](Time) { events_.writable(); });
    return SendResult::busy;
  }
  search_soon(errno);
  return SendResult::refused;
}

void SocketCan::on_ready(Readiness ready) {
  if (ready.readable || ready.failed) receive();
  if (!ready.writable || down_) return;
  loop_.rewatch(watch_, {.readable = true});
  events_.writable();
}

// The kernel reports once that the interface is gone, before the remaining frames.
void SocketCan::receive() {
  int error = 0;
  for (int batch = 0; batch < ReceiveBatch::batches_max; ++batch) {
    const int count = batch_.receive(socket_.get());
    if (count == 0) break;
    if (count < 0) error = -count;
    counters_.overrun += batch_.newly_dropped();
    for (int i = 0; i < count; ++i) packet_arrived(batch_.packet(static_cast<std::size_t>(i)));
  }
  if (error != 0) went_down(error);
}

void SocketCan::packet_arrived(const ReceivedPacket& packet) {
  if (packet.bytes.size() != CAN_MTU) {
    ++counters_.fd;
    return;
  }
  can_frame raw{};
  std::memcpy(&raw, packet.bytes.data(), sizeof raw);
  const Frame frame = from_kernel(raw);
  const Time time = loop_.time_of(packet.stamp);
  events_.frame(frame, time, packet.confirms ? Origin::own : Origin::elsewhere);
  if (!frame.is_error()) return;
  ++counters_.error_frames;
  if (reports_overrun(frame)) ++counters_.overrun;
  if (const std::optional<BusState> state = reported_state(frame)) events_.state(*state, time);
}

// Called from send(): its caller does not expect events.
void SocketCan::search_soon(int error) {
  if (down_) return;
  loop_.cancel(search_);
  search_ = loop_.at(loop_.now(), [this, error](Time) { went_down(error); });
}

void SocketCan::went_down(int error) {
  if (down_) return;
  down_ = true;
  loop_.unwatch(watch_);
  const bool still_there = if_nametoindex(interface_.c_str()) != 0;
  if (error != ENETDOWN && error != ENODEV && error != ENXIO) {
    events_.trouble({interface_, std::strerror(error), ""});
  } else {
    events_.trouble(still_there ? down(interface_) : no_interface(interface_));
  }
  events_.state(BusState::bus_off, loop_.now());
  loop_.cancel(search_);
  search_ = loop_.at(loop_.now() + search_interval, [this](Time) { look_for_interface(); });
}

// Uses a new socket, since the kernel removes the filters of a socket when its interface vanishes.
void SocketCan::look_for_interface() {
  socket_ = open_socket();
  if (!socket_ || !configure()) {
    search_ = loop_.at(loop_.now() + search_interval, [this](Time) { look_for_interface(); });
    return;
  }
  batch_.begin_anew();
  down_ = false;
  events_.state(BusState::error_active, loop_.now());
}

}  // namespace canvoy::host
