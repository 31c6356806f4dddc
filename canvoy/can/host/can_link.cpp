#include "canvoy/can/host/can_link.hpp"

#include <linux/can/netlink.h>
#include <linux/if_link.h>
#include <linux/rtnetlink.h>
#include <net/if.h>
#include <sys/socket.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <string>

#include "canvoy/can/host/descriptor.hpp"

// From net/if.h, which conflicts with linux/if.h.
extern "C" unsigned int if_nametoindex(const char* name) noexcept;

namespace canvoy::host {

namespace {

using Bytes = std::span<const std::uint8_t>;

constexpr std::string_view kind_of_controllers = "can";
constexpr std::size_t header_size = sizeof(nlmsghdr) + sizeof(ifinfomsg);

template <class Value>
void append(LinkMessage& message, const Value& value) {
  const std::size_t at = message.size();
  message.resize(at + sizeof value);
  std::memcpy(&message[at], &value, sizeof value);
}

/// Value at the start of `bytes`; zeros if they are too short.
template <class Value>
Value value_of(Bytes bytes) {
  Value value{};
  if (bytes.size() >= sizeof value) std::memcpy(&value, bytes.data(), sizeof value);
  return value;
}

/// An attribute that ends at the present end of the message: it may contain others.
class Attribute {
 public:
  Attribute(LinkMessage& message, unsigned short type) : message_(message), at_(message.size()) {
    append(message, rtattr{.rta_len = 0, .rta_type = type});
  }
  ~Attribute() {
    const auto length = static_cast<unsigned short>(message_.size() - at_);
    std::memcpy(&message_[at_], &length, sizeof length);
    message_.resize(at_ + RTA_ALIGN(length));
  }
  Attribute(const Attribute&) = delete;
  Attribute& operator=(const Attribute&) = delete;

 private:
  LinkMessage& message_;
  std::size_t at_;
};

LinkMessage begin_message(unsigned short type, unsigned short flags, int interface_index,
                          std::uint32_t sequence, unsigned up_flags, unsigned change) {
  LinkMessage message;
  append(message, nlmsghdr{.nlmsg_len = 0,
                           .nlmsg_type = type,
                           .nlmsg_flags = flags,
                           .nlmsg_seq = sequence,
                           .nlmsg_pid = 0});
  append(message, ifinfomsg{.ifi_family = AF_UNSPEC,
                            .__ifi_pad = 0,
                            .ifi_type = 0,
                            .ifi_index = interface_index,
                            .ifi_flags = up_flags,
                            .ifi_change = change});
  return message;
}

LinkMessage finished(LinkMessage message) {
  const auto length = static_cast<std::uint32_t>(message.size());
  std::memcpy(message.data(), &length, sizeof length);
  return message;
}

/// Payload of the first attribute of this type; empty if there is none.
Bytes attribute(Bytes attributes, unsigned type) {
  while (attributes.size() >= sizeof(rtattr)) {
    const auto head = value_of<rtattr>(attributes);
    if (head.rta_len < sizeof(rtattr) || head.rta_len > attributes.size()) return {};
    if ((head.rta_type & NLA_TYPE_MASK) == type) {
      return attributes.subspan(sizeof(rtattr), head.rta_len - sizeof(rtattr));
    }
    attributes =
        attributes.subspan(std::min<std::size_t>(RTA_ALIGN(head.rta_len), attributes.size()));
  }
  return {};
}

std::optional<BusState> bus_state(Bytes state) {
  if (state.size() < sizeof(std::uint32_t)) return std::nullopt;
  switch (value_of<std::uint32_t>(state)) {
    case CAN_STATE_ERROR_ACTIVE:
      return BusState::error_active;
    case CAN_STATE_ERROR_WARNING:
      return BusState::error_warning;
    case CAN_STATE_ERROR_PASSIVE:
      return BusState::error_passive;
    case CAN_STATE_BUS_OFF:
      return BusState::bus_off;
    default:
      return std::nullopt;
  }
}

/// Sends a request and waits for the kernel's answer, which comes at once.
class LinkSocket {
 public:
  LinkSocket() : socket_(::socket(AF_NETLINK, SOCK_RAW | SOCK_CLOEXEC, NETLINK_ROUTE)) {}

  /// Returns 0 or an errno; `answer` is the message in place of an acknowledgement.
  int ask(const LinkMessage& request, LinkMessage* answer = nullptr) const {
    std::array<std::uint8_t, 32 * 1024> buffer;
    if (!socket_ || ::send(socket_.get(), request.data(), request.size(), 0) < 0) return errno;
    const ssize_t size = ::recv(socket_.get(), buffer.data(), buffer.size(), 0);
    if (size < 0) return errno;
    const Bytes bytes(buffer.data(), static_cast<std::size_t>(size));
    if (value_of<nlmsghdr>(bytes).nlmsg_type == NLMSG_ERROR && bytes.size() >= header_size) {
      return -value_of<int>(bytes.subspan(sizeof(nlmsghdr)));
    }
    if (answer != nullptr) answer->assign(bytes.begin(), bytes.end());
    return 0;
  }

 private:
  Descriptor socket_;
};

Error failed(std::string_view interface, int error) {
  if (error == EPERM) {
    return {std::string(interface), "its bit rate may not be set",
            "run it as root, or with CAP_NET_ADMIN"};
  }
  if (error == EOPNOTSUPP) {
    return {std::string(interface), "it has no bit rate or no listen-only mode",
            "a virtual interface has neither"};
  }
  return {std::string(interface), std::strerror(error), ""};
}

}  // namespace

LinkMessage up_message(int interface_index, bool up, std::uint32_t sequence) {
  return finished(begin_message(RTM_NEWLINK, NLM_F_REQUEST | NLM_F_ACK, interface_index, sequence,
                                up ? unsigned{IFF_UP} : 0U, IFF_UP));
}

LinkMessage bit_rate_message(int interface_index, std::uint32_t bit_rate, bool listen_only,
                             std::uint32_t sequence, bool reports_errors) {
  LinkMessage message =
      begin_message(RTM_NEWLINK, NLM_F_REQUEST | NLM_F_ACK, interface_index, sequence, 0, 0);
  {
    const Attribute info(message, IFLA_LINKINFO);
    {
      const Attribute kind(message, IFLA_INFO_KIND);
      for (const char letter : kind_of_controllers) append(message, letter);
    }
    const Attribute data(message, IFLA_INFO_DATA);
    {
      const Attribute timing(message, IFLA_CAN_BITTIMING);
      can_bittiming wanted{};
      wanted.bitrate = bit_rate;
      append(message, wanted);
    }
    const Attribute mode(message, IFLA_CAN_CTRLMODE);
    const std::uint32_t reports = reports_errors ? CAN_CTRLMODE_BERR_REPORTING : 0U;
    const std::uint32_t listens = CAN_CTRLMODE_LISTENONLY | reports;
    append(message, can_ctrlmode{.mask = listens, .flags = listen_only ? listens : 0U});
  }
  return finished(std::move(message));
}

std::optional<CanLink> parse_link_message(std::span<const std::uint8_t> message) {
  const auto header = value_of<nlmsghdr>(message);
  if (message.size() < header_size || header.nlmsg_type != RTM_NEWLINK ||
      header.nlmsg_len > message.size() || header.nlmsg_len < header_size) {
    return std::nullopt;
  }
  const Bytes all = message.first(header.nlmsg_len);
  const Bytes info = attribute(all.subspan(header_size), IFLA_LINKINFO);
  const Bytes kind = attribute(info, IFLA_INFO_KIND);
  const Bytes data = attribute(info, IFLA_INFO_DATA);
  const auto mode = value_of<can_ctrlmode>(attribute(data, IFLA_CAN_CTRLMODE));
  // The kernel terminates the name with a zero.
  const std::string_view name(reinterpret_cast<const char*>(kind.data()), kind.size());
  CanLink link;
  link.has_controller = name.substr(0, name.find('\0')) == kind_of_controllers;
  link.is_up = (value_of<ifinfomsg>(all.subspan(sizeof(nlmsghdr))).ifi_flags & IFF_UP) != 0;
  link.listens_only = (mode.flags & CAN_CTRLMODE_LISTENONLY) != 0;
  link.bit_rate = value_of<std::uint32_t>(attribute(data, IFLA_CAN_BITTIMING));
  link.state = bus_state(attribute(data, IFLA_CAN_STATE));
  return link;
}

Result<CanLink> read_can_link(std::string_view interface) {
  const auto index = static_cast<int>(if_nametoindex(std::string(interface).c_str()));
  if (index == 0) return failed(interface, errno);
  LinkMessage answer;
  const LinkMessage request = finished(begin_message(RTM_GETLINK, NLM_F_REQUEST, index, 1, 0, 0));
  const int error = LinkSocket().ask(request, &answer);
  if (error != 0) return failed(interface, error);
  const std::optional<CanLink> link = parse_link_message(answer);
  if (!link) return failed(interface, EPROTO);
  return *link;
}

namespace {

/// Returns 0 or an errno.
int restart(const LinkSocket& socket, int index, std::uint32_t bit_rate, bool listen_only,
            bool comes_up) {
  int error = socket.ask(up_message(index, false, 1));
  if (error != 0) return error;
  error = socket.ask(bit_rate_message(index, bit_rate, listen_only, 2));
  // Not all controllers report errors of the bus.
  if (error == EOPNOTSUPP) {
    error = socket.ask(bit_rate_message(index, bit_rate, listen_only, 3, false));
  }
  return error != 0 || !comes_up ? error : socket.ask(up_message(index, true, 4));
}

/// Restores an interface. One without a bit rate could not be up.
int put_back(const LinkSocket& socket, int index, const CanLink& before) {
  if (before.bit_rate == 0) return socket.ask(up_message(index, false, 1));
  return restart(socket, index, before.bit_rate, before.listens_only, before.is_up);
}

}  // namespace

Result<void> restart_can_link(std::string_view interface, std::uint32_t bit_rate,
                              bool listen_only) {
  const auto index = static_cast<int>(if_nametoindex(std::string(interface).c_str()));
  if (index == 0) return failed(interface, errno);
  const Result<CanLink> link = read_can_link(interface);
  if (!link) return link.error();
  if (!link->has_controller) return failed(interface, EOPNOTSUPP);
  const LinkSocket socket;
  const int error = restart(socket, index, bit_rate, listen_only, true);
  if (error == 0) return {};
  put_back(socket, index, *link);
  return failed(interface, error);
}

Result<void> restore_can_link(std::string_view interface, const CanLink& before) {
  const auto index = static_cast<int>(if_nametoindex(std::string(interface).c_str()));
  if (index == 0) return failed(interface, errno);
  if (!before.has_controller) return failed(interface, EOPNOTSUPP);
  const int error = put_back(LinkSocket(), index, before);
  if (error != 0) return failed(interface, error);
  return {};
}

}  // namespace canvoy::host
